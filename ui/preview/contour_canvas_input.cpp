// Mouse, wheel and keys of the preview's picture.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "preview/contour_canvas.h"

namespace toolpace::ui {
namespace {

constexpr double kPickRadius = 8;  // px

}  // namespace

void ContourCanvas::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (notches != 0) zoomBy(std::pow(1.25, notches), event->position());
  event->accept();
}

bool ContourCanvas::isTiny(const QPointF& delta) const { return delta.manhattanLength() < 4; }

void ContourCanvas::mousePressEvent(QMouseEvent* event) {
  pressed_at_ = dragged_from_ = event->position();
  dragging_ = false;
  setFocus(Qt::MouseFocusReason);
}

void ContourCanvas::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton) return hover(event->position());
  if (!dragging_ && isTiny(event->position() - pressed_at_)) return;
  dragging_ = true;
  hovered_.reset();
  const QPointF delta = event->position() - dragged_from_;
  dragged_from_ = event->position();
  follows_fit_ = false;
  const bool turns = (event->buttons() & Qt::RightButton) || (event->modifiers() & Qt::ControlModifier);
  if (turns) {
    projection_.orbit(-delta.x() * 0.01, -delta.y() * 0.01);
    emit turned(std::nullopt);
  } else {
    projection_.pan(delta);
  }
  moved();
}

void ContourCanvas::mouseReleaseEvent(QMouseEvent* event) {
  const bool clicked = !dragging_ && event->button() == Qt::LeftButton;
  const bool asked = !dragging_ && event->button() == Qt::RightButton;
  dragging_ = false;
  if (asked) return emit menuRequested(event->position().toPoint());
  if (!clicked || !scene_) return;
  if (const auto hit = pick(*scene_, projection_, event->position(), kPickRadius, rapids_shown_))
    emit cursorTimeRequested(hit->time);
}

std::optional<double> ContourCanvas::timeAt(const QPoint& at) const {
  const auto hit =
      scene_ && scene_->outcome ? pick(*scene_, projection_, at, kPickRadius, rapids_shown_) : std::nullopt;
  return hit ? std::optional(hit->time) : std::nullopt;
}

void ContourCanvas::mouseDoubleClickEvent(QMouseEvent*) { fit(); }

void ContourCanvas::keyPressEvent(QKeyEvent* event) {
  const QPointF middle(width() / 2.0, height() / 2.0);
  const double step = 48;
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: return zoomBy(1.25, middle);
    case Qt::Key_Minus: return zoomBy(0.8, middle);
    case Qt::Key_F: return fit();
    case Qt::Key_X: return setView(View::yz);
    case Qt::Key_Y: return setView(View::xz);
    case Qt::Key_Z:
      if (event->modifiers() == Qt::NoModifier) return setView(View::xy);
      break;
    case Qt::Key_I: return setView(View::iso);
    case Qt::Key_L: return setView(View::zx);
    case Qt::Key_Menu: return emit menuRequested(middle.toPoint());
    default: break;
  }
  // The arrows alone step through the program; with Shift they move the picture.
  if (event->modifiers() == Qt::ShiftModifier) {
    QPointF by;
    if (event->key() == Qt::Key_Left) by = {step, 0};
    if (event->key() == Qt::Key_Right) by = {-step, 0};
    if (event->key() == Qt::Key_Up) by = {0, step};
    if (event->key() == Qt::Key_Down) by = {0, -step};
    if (!by.isNull()) {
      follows_fit_ = false;
      projection_.pan(by);
      return moved();
    }
  }
  QWidget::keyPressEvent(event);
}

void ContourCanvas::leaveEvent(QEvent*) {
  hovered_.reset();
  emit hoverChanged();
  update();
}

void ContourCanvas::hover(const QPointF& at) {
  hover_at_ = at;
  const bool had = hovered_.has_value();
  hovered_.reset();
  if (scene_ && scene_->outcome) {
    if (const auto hit = pick(*scene_, projection_, at, kPickRadius, rapids_shown_))
      hovered_ = instant_at(*scene_->outcome, hit->time);
  }
  if (!had && !hovered_) return;
  emit hoverChanged();
  update();
}

}  // namespace toolpace::ui
