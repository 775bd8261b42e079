#include "preview/contour_legend.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <cmath>

#include "drawing/cause_style.h"

namespace toolpace::ui {
namespace {

constexpr double kSmallLength = 0.2;  // mm; below it micrometres are read more easily
constexpr double kPad = 12, kRow = 20, kSwatch = 10, kBar = 8, kHeight = 44;

Quantity quantity_of(ColourBy by) {
  switch (by) {
    case ColourBy::speed: return Quantity::speed;
    case ColourBy::acceleration: return Quantity::acceleration;
    case ColourBy::jerk: return Quantity::jerk;
    default: return Quantity::length;
  }
}

/// Three digits of any size: "12.5", "0.00225", "330 000".
QString short_number(double value) {
  return std::abs(value) >= 0.1 || value == 0 ? number_text(value, 3) : QString::number(value, 'g', 3);
}

}  // namespace

QString colour_by_title(ColourBy by) {
  switch (by) {
    case ColourBy::speed: return QCoreApplication::translate("ColourBy", "speed");
    case ColourBy::acceleration: return QCoreApplication::translate("ColourBy", "acceleration");
    case ColourBy::jerk: return QCoreApplication::translate("ColourBy", "jerk");
    case ColourBy::limit: return QCoreApplication::translate("ColourBy", "binding limit");
    case ColourBy::contour_error: break;
  }
  return QCoreApplication::translate("ColourBy", "contour error");
}

ContourLegend::ContourLegend(const ContourCanvas& canvas, QWidget* parent) : QWidget(parent), canvas_(canvas) {
  setObjectName("contourLegend");
  setAccessibleName(tr("Legend of the contour preview"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

bool ContourLegend::isCategorical() const { return canvas_.colourBy() == ColourBy::limit; }

void ContourLegend::refresh() {
  present_.assign(kCauseCount, false);
  if (canvas_.scene() && canvas_.scene()->outcome) {
    const auto& shares = canvas_.scene()->outcome->summary.time_by_cause;
    bool any = false;
    for (std::size_t i = 0; i < kCauseCount; ++i) any |= present_[i] = shares[i] > 0;
    if (!any) {
      for (const auto& r : canvas_.scene()->outcome->restraints) present_[index_of(r.cause)] = true;
    }
  }
  setFixedHeight(heightFor(width()));
  update();
}

void ContourLegend::resizeEvent(QResizeEvent*) { setFixedHeight(heightFor(width())); }

int ContourLegend::heightFor(int width) const {
  if (!isCategorical()) return static_cast<int>(kHeight);
  const auto list = entries(width);
  return static_cast<int>(list.empty() ? kHeight : std::max(list.back().area.bottom() + 6, kHeight));
}

std::vector<ContourLegend::Entry> ContourLegend::entries(double width) const {
  std::vector<Entry> list;
  const QFontMetricsF metrics(font());
  double x = kPad, y = 6;
  for (std::size_t i = 0; i < present_.size(); ++i) {
    if (!present_[i]) continue;
    const QString title = cause_title(static_cast<Cause>(i));
    const double wide = kSwatch + 6 + metrics.horizontalAdvance(title) + 14;
    if (x > kPad && x + wide > width - kPad + 14) {
      x = kPad;
      y += kRow;
    }
    list.push_back({title, QColor(canvas_.colours()[i]), QRectF(x, y, wide, kRow)});
    x += wide;
  }
  // A single row stands in the middle of the strip.
  if (!list.empty() && list.back().area.top() == list.front().area.top()) {
    for (auto& entry : list) entry.area.moveTop((kHeight - kRow) / 2);
  }
  return list;
}

/// The ends of the scale, and round numbers between them as far as there is room.
void ContourLegend::drawTicks(QPainter& painter, const QRectF& bar, const Interval& shown) const {
  const QFontMetricsF metrics(font());
  const auto text_of = [](double value) { return short_number(value); };
  const double width = shown.high - shown.low;
  const QString first = text_of(shown.low), last = text_of(shown.high);
  painter.drawText(QRectF(bar.left(), 20, bar.width(), 18), Qt::AlignLeft | Qt::AlignVCenter, first);
  if (!(width > 0) || !std::isfinite(width)) return;
  painter.drawText(QRectF(bar.left(), 20, bar.width(), 18), Qt::AlignRight | Qt::AlignVCenter, last);
  constexpr int kMostSteps = 6;
  const double power = std::pow(10.0, std::floor(std::log10(width / kMostSteps)));
  const double share = width / kMostSteps / power, step = power * (share <= 1   ? 1
                                                                   : share <= 2 ? 2
                                                                   : share <= 5 ? 5
                                                                                : 10);
  double free = bar.left() + metrics.horizontalAdvance(first) + 8;
  const double end = bar.right() - metrics.horizontalAdvance(last) - 8;
  for (double k = std::ceil(shown.low / step); k * step < shown.high; ++k) {
    const QString text = text_of(k * step);
    const double at = bar.left() + bar.width() * (k * step - shown.low) / width;
    const double half = metrics.horizontalAdvance(text) / 2;
    if (at - half < free || at + half > end) continue;
    painter.drawLine(QPointF(at, bar.bottom()), QPointF(at, bar.bottom() + 3));
    painter.drawText(QRectF(at - half - 1, 20, 2 * half + 2, 18), Qt::AlignCenter, text);
    free = at + half + 8;
  }
}

std::optional<double> ContourLegend::hoveredValue() const {
  const auto& place = canvas_.hovered();
  if (!place) return std::nullopt;
  switch (canvas_.colourBy()) {
    case ColourBy::speed: return place->state.speed;
    case ColourBy::acceleration: return place->state.acceleration;
    case ColourBy::jerk: return place->state.jerk;
    default: return std::nullopt;
  }
}

void ContourLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), canvas_.theme().surface);
  painter.setPen(canvas_.theme().line);
  painter.drawLine(0, 0, width(), 0);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!canvas_.scene() || !canvas_.scene()->can_colour_by(canvas_.colourBy())) return;
  isCategorical() ? drawEntries(painter) : drawScale(painter);
}

void ContourLegend::drawEntries(QPainter& painter) const {
  for (const auto& entry : entries(width())) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(entry.colour);
    painter.drawRoundedRect(QRectF(entry.area.left(), entry.area.center().y() - kSwatch / 2, kSwatch, kSwatch), 2, 2);
    painter.setPen(canvas_.theme().text);
    painter.drawText(entry.area.adjusted(kSwatch + 6, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, entry.title);
  }
}

void ContourLegend::drawScale(QPainter& painter) const {
  const Theme& theme = canvas_.theme();
  const ColourBy by = canvas_.colourBy();
  const Interval range = canvas_.scene()->range(by);
  DisplayUnit unit = display_unit(quantity_of(by), canvas_.unit());
  if (by == ColourBy::contour_error && !canvas_.unit().inch && range.high < kSmallLength) {
    unit = {1000.0, QStringLiteral("µm")};
  }
  const QFontMetricsF metrics(font());
  const QString title = colour_by_title(by) + "  ";
  const double wide = metrics.horizontalAdvance(title), unit_wide = metrics.horizontalAdvance(unit.text);
  painter.setPen(theme.text);
  painter.drawText(QRectF(kPad, 4, wide, 18), Qt::AlignLeft | Qt::AlignVCenter, title);
  painter.setPen(theme.secondary);
  painter.drawText(QRectF(kPad, 22, std::max(wide, unit_wide + 4), 18), Qt::AlignLeft | Qt::AlignVCenter, unit.text);

  const double left = kPad + std::max(wide, unit_wide) + 16;
  const QRectF bar(left, 9, std::max(width() - kPad - 8 - left, 40.0), kBar);
  for (int x = 0; x < static_cast<int>(bar.width()); ++x) {
    const auto level = static_cast<std::size_t>(255 * x / std::max(bar.width() - 1, 1.0));
    painter.fillRect(QRectF(bar.left() + x, bar.top(), 1.5, kBar),
                     QColor(canvas_.colours()[std::min<std::size_t>(level, 255)]));
  }
  painter.setPen(theme.secondary);
  drawTicks(painter, bar, {range.low * unit.factor, range.high * unit.factor});
  const auto value = hoveredValue();
  if (!value || !(range.high > range.low)) return;
  const double at = bar.left() + bar.width() * std::clamp((*value - range.low) / (range.high - range.low), 0.0, 1.0);
  painter.setPen(QPen(theme.surface, 1));
  painter.setBrush(theme.text);
  painter.drawPolygon(QPolygonF({{at, bar.top() + 2}, {at - 5, bar.top() - 6}, {at + 5, bar.top() - 6}}));
}

}  // namespace toolpace::ui
