/// Mouse, wheel and keys of the motion plots.

#include <cmath>

#include "plots/profile_plot.h"

namespace toolpace::ui {

double ProfilePlot::timeAt(double x) const { return time_axes_.front()->pixelToCoord(x); }

std::optional<std::size_t> ProfilePlot::measureAt(double x) const {
  for (std::size_t i = 0; i < 2; ++i) {
    if (cursor_->measures[i] && std::abs(cursor_->xOf(*cursor_->measures[i]) - x) < 6) return i;
  }
  return std::nullopt;
}

void ProfilePlot::wheelEvent(QWheelEvent* event) {
  const QPoint delta = event->angleDelta();
  const double x = event->position().x();
  event->accept();
  if (delta.x() != 0 || (event->modifiers() & Qt::ShiftModifier)) {
    const double notches = (delta.x() != 0 ? delta.x() : delta.y()) / 120.0, step = range().size() * 0.1 * notches;
    return setRange(range().lower - step, range().upper - step);
  }
  if (x < edges().first) {
    setHeightsHeld(true);
    const auto factor = static_cast<float>(std::pow(0.85, delta.y() / 120.0));
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const QRect area = rows_[i].rect()->rect();
      if (event->position().y() < area.top() || event->position().y() > area.bottom()) continue;
      heights_[i].low *= factor;
      heights_[i].high *= factor;
    }
    return refill();
  }
  zoom(std::pow(1.3, delta.y() / 120.0), timeAt(x));
}

void ProfilePlot::mousePressEvent(QMouseEvent* event) {
  pressed_at_ = event->position();
  pressed_begin_ = range().lower;
  dragging_ = false;
  dragged_measure_ = event->button() == Qt::LeftButton ? measureAt(event->position().x()) : std::nullopt;
  setFocus(Qt::MouseFocusReason);
}

void ProfilePlot::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x();
  if (event->buttons() == Qt::NoButton) return setCursor(measureAt(x) ? Qt::SizeHorCursor : Qt::ArrowCursor);
  if (!dragging_ && (event->position() - pressed_at_).manhattanLength() < 4) return;
  dragging_ = true;
  if (dragged_measure_) {
    cursor_->measures[*dragged_measure_] = std::clamp(timeAt(x), 0.0, duration());
    layer(kCursorLayer)->replot();
    if (cursor_->measures[0] && cursor_->measures[1]) emit measured(*cursor_->measures[0], *cursor_->measures[1]);
    return;
  }
  const double width = range().size(), shift = (x - pressed_at_.x()) / (edges().second - edges().first) * width;
  setRange(pressed_begin_ - shift, pressed_begin_ - shift + width);
}

void ProfilePlot::mouseReleaseEvent(QMouseEvent* event) {
  const double x = event->position().x();
  const bool clicked = !dragging_ && event->button() == Qt::LeftButton && x >= edges().first && x <= edges().second;
  dragging_ = false;
  if (clicked && !dragged_measure_ && series_ && !series_->is_empty()) {
    emit timeClicked(std::clamp(timeAt(x), 0.0, duration()));
  }
  dragged_measure_.reset();
}

void ProfilePlot::mouseDoubleClickEvent(QMouseEvent*) {
  setHeightsHeld(false);
  fit();
}

void ProfilePlot::keyPressEvent(QKeyEvent* event) {
  const QCPRange now = range();
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: return zoom(1.5, cursor_->time.value_or(now.center()));
    case Qt::Key_Minus: return zoom(1 / 1.5, cursor_->time.value_or(now.center()));
    case Qt::Key_PageUp: return setRange(now.lower - now.size() / 2, now.upper - now.size() / 2);
    case Qt::Key_PageDown: return setRange(now.lower + now.size() / 2, now.upper + now.size() / 2);
    case Qt::Key_F: return fit();
    default: QCustomPlot::keyPressEvent(event);
  }
}

}  // namespace toolpace::ui
