#include "plots/limit_ribbon.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <cmath>
#include <numeric>

#include "models/units.h"

namespace toolpace::ui {

LimitRibbon::LimitRibbon(QWidget* parent) : TimeStrip(parent) {
  setObjectName("limitRibbon");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAttribute(Qt::WA_OpaquePaintEvent);
}

void LimitRibbon::setRange(double begin, double end) {
  begin_ = begin;
  end_ = end;
  update();
}

double LimitRibbon::timeAt(double x) const {
  return begin_ + (x - left_) / std::max(right_ - left_, 1.0) * (end_ - begin_);
}

double LimitRibbon::xOf(double time) const {
  return left_ + (time - begin_) / std::max(end_ - begin_, 1e-12) * (right_ - left_);
}

void LimitRibbon::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme_.surface);
  painter.setPen(theme_.secondary);
  painter.drawText(QRectF(0, 0, left_ - 8, height()), Qt::AlignRight | Qt::AlignVCenter, tr("limit"));
  paintInto(painter, QRectF(left_, 4, right_ - left_, height() - 8), begin_, end_);
}

void LimitRibbon::paintInto(QPainter& painter, const QRectF& area, double begin, double end) const {
  if (!series_ || series_->causes.is_empty() || !(end > begin)) return;
  const Ground ground = theme_.dark ? Ground::dark : Ground::light;
  const int columns = std::max(static_cast<int>(std::round(area.width())), 1);
  const double wide = area.width() / columns, pixel = (end - begin) / columns;
  for (int column = 0; column < columns; ++column) {
    const CauseShares shares = series_->causes.between(begin + column * pixel, begin + (column + 1) * pixel);
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    if (!(sum > 0)) continue;
    double y = area.bottom();
    for (std::size_t i = 0; i < kCauseCount; ++i) {
      if (shares[i] <= 0) continue;
      const double tall = area.height() * shares[i] / sum;
      painter.fillRect(QRectF(area.left() + column * wide, y - tall, wide, tall),
                       cause_colour(static_cast<Cause>(i), ground));
      y -= tall;
    }
  }
}

QString LimitRibbon::description(double time, double pixel) const {
  const Restraint* r = series_ ? series_->causes.at(time) : nullptr;
  if (!r) return {};
  if (r->end - r->begin >= 2 * pixel) {
    return tr("%1: %2 to %3 s").arg(cause_title(r->cause)).arg(r->begin, 0, 'f', 3).arg(r->end, 0, 'f', 3);
  }
  const CauseShares shares = series_->causes.between(time - pixel, time + pixel);
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  QStringList parts;
  for (std::size_t i = 0; i < kCauseCount; ++i) {
    if (shares[i] > 0)
      parts << tr("%1 %2 %").arg(cause_title(static_cast<Cause>(i))).arg(100 * shares[i] / sum, 0, 'f', 0);
  }
  return parts.join("\n");
}

void LimitRibbon::mousePressEvent(QMouseEvent* event) {
  const double x = event->position().x();
  if (event->button() == Qt::LeftButton && x >= left_ && x <= right_) emit timeClicked(timeAt(x));
}

bool LimitRibbon::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return TimeStrip::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const double pixel = (end_ - begin_) / std::max(right_ - left_, 1.0);
  const QString text =
      help->pos().x() >= left_ && help->pos().x() <= right_ ? description(timeAt(help->pos().x()), pixel) : QString();
  // Where nothing is planned, nothing holds anything down.
  text.isEmpty() ? QToolTip::hideText() : QToolTip::showText(help->globalPos(), text, this);
  return true;
}

}  // namespace toolpace::ui
