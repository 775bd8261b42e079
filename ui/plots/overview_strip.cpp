#include "plots/overview_strip.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "drawing/profile_curves.h"

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

double OverviewStrip::duration() const {
  const double longest = std::max(series_ && !series_->is_empty() ? series_->duration() : 0.0, other_);
  return longest > 0 ? longest : 1.0;
}

void OverviewStrip::setOtherDuration(double duration) {
  if (std::exchange(other_, duration) != duration) refresh();
}

void OverviewStrip::setCursorTime(std::optional<double> time) {
  cursor_ = time;
  update();
}

double OverviewStrip::xOf(double time) const { return left_ + (time - first()) / span() * (right_ - left_); }

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
  const double top = series_->whole[kSpeedTrack].high, floor = height() - 4.0;
  if (!(top > 0)) return;
  const double pixel = 1 / ratio, wide = right_ - left_;
  const int columns = std::max(static_cast<int>(wide * ratio), 1);
  const auto extents = speed_extents(*series_, {first(), first() + span(), columns});
  const auto y_of = [&](double v) { return floor - std::max(v, 0.0) / top * (floor - kTop); };
  QPainter painter(&miniature_);
  QColor tint = theme_.secondary;
  tint.setAlphaF(0.22f);
  // Column by column: a path of as many corners would take a hundred times as long.
  for (int column = 0; column < columns; ++column) {
    const Extent& speed = extents[static_cast<std::size_t>(column)];
    if (speed.is_empty()) continue;
    const double x = left_ + column * pixel, high = y_of(speed.high), low = y_of(speed.low);
    painter.fillRect(QRectF(x, high, pixel, floor - high), tint);
    painter.fillRect(QRectF(x, high, pixel, std::max(low - high, pixel)), theme_.secondary);
  }
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
