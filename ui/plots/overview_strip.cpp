#include "plots/overview_strip.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "plots/profile_curves.h"

namespace toolpace::ui {
namespace {

constexpr double kGripPixels = 6;
constexpr double kTop = 3;

}  // namespace

OverviewStrip::OverviewStrip(QWidget* parent) : TimeStrip(parent) {
  setObjectName("overviewStrip");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMouseTracking(true);
}

void OverviewStrip::setRange(double begin, double end) {
  begin_ = begin;
  end_ = end;
  update();
}

void OverviewStrip::setCursorTime(std::optional<double> time) {
  cursor_ = time;
  update();
}

void OverviewStrip::refresh() {
  miniature_ = {};
  update();
}

void OverviewStrip::resizeEvent(QResizeEvent*) { refresh(); }

void OverviewStrip::drawMiniature() {
  const double ratio = devicePixelRatioF();
  miniature_ = QPixmap((QSizeF(size()) * ratio).toSize());
  miniature_.setDevicePixelRatio(ratio);
  miniature_.fill(theme_.surface);
  if (!series_ || series_->is_empty()) return;
  const double top = series_->whole.speed.high, floor = height() - 4.0;
  if (!(top > 0)) return;
  const auto curve =
      motion_curves(*series_, {0, duration(), std::max(static_cast<int>((right_ - left_) * ratio), 1)}).speed;
  const auto y_of = [&](double v) { return floor - std::max(v, 0.0) / top * (floor - kTop); };
  QPainterPath outline;
  for (qsizetype i = 0; i < curve.time.size(); ++i) {
    const QPointF point(xOf(curve.time[i]), y_of(curve.value[i]));
    i == 0 ? outline.moveTo(point) : outline.lineTo(point);
  }
  QPainterPath filled = outline;
  if (!curve.time.isEmpty()) {
    filled.lineTo(xOf(curve.time.back()), floor);
    filled.lineTo(xOf(curve.time.front()), floor);
  }
  QPainter painter(&miniature_);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor tint = theme_.secondary;
  tint.setAlphaF(0.22f);
  painter.fillPath(filled, tint);
  painter.strokePath(outline, QPen(theme_.secondary, 0.8));
}

void OverviewStrip::paintEvent(QPaintEvent*) {
  if (miniature_.isNull()) drawMiniature();
  QPainter painter(this);
  painter.drawPixmap(0, 0, miniature_);
  painter.setPen(theme_.secondary);
  painter.drawText(QRectF(0, 0, left_ - 8, height()), Qt::AlignRight | Qt::AlignVCenter, tr("all"));
  const double a = std::clamp(xOf(begin_), left_, right_), b = std::clamp(xOf(end_), left_, right_);
  QColor veil = theme_.surface;
  veil.setAlphaF(0.62f);
  painter.fillRect(QRectF(left_, 0, a - left_, height()), veil);
  painter.fillRect(QRectF(b, 0, right_ - b, height()), veil);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme_.accent, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(QRectF(a, 0.5, std::max(b - a, 2.0), height() - 2.0), 2, 2);
  for (const double x : {a, b}) painter.fillRect(QRectF(x - 1.5, height() / 2.0 - 6, 3, 12), theme_.accent);
  if (cursor_) {
    const double x = xOf(*cursor_);
    painter.drawLine(QPointF(x, 1), QPointF(x, height() - 2));
  }
}

OverviewStrip::Grip OverviewStrip::gripAt(double x) const {
  const double a = xOf(begin_), b = xOf(end_);
  // A narrow window is moved, not stretched.
  const double reach = std::min(kGripPixels, std::max((b - a) / 4, 1.5));
  if (std::abs(x - a) <= reach) return Grip::left;
  if (std::abs(x - b) <= reach) return Grip::right;
  return x > a && x < b ? Grip::window : Grip::none;
}

void OverviewStrip::mousePressEvent(QMouseEvent* event) {
  const double x = event->position().x(), width = end_ - begin_;
  grip_ = gripAt(x);
  if (grip_ == Grip::none) {
    emit rangeRequested(timeAt(x) - width / 2, timeAt(x) + width / 2);
    grip_ = Grip::window;
  }
  grip_offset_ = timeAt(x) - begin_;
}

void OverviewStrip::mouseMoveEvent(QMouseEvent* event) {
  const double time = timeAt(event->position().x()), least = duration() * 1e-6;
  switch (grip_) {
    case Grip::none: {
      const Grip under = gripAt(event->position().x());
      setCursor(under == Grip::none ? Qt::ArrowCursor : under == Grip::window ? Qt::OpenHandCursor : Qt::SizeHorCursor);
      break;
    }
    case Grip::window: emit rangeRequested(time - grip_offset_, time - grip_offset_ + end_ - begin_); break;
    case Grip::left: emit rangeRequested(std::min(time, end_ - least), end_); break;
    case Grip::right: emit rangeRequested(begin_, std::max(time, begin_ + least)); break;
  }
}

void OverviewStrip::mouseReleaseEvent(QMouseEvent*) { grip_ = Grip::none; }

}  // namespace toolpace::ui
