#include "plots/plot_row.h"

#include <algorithm>
#include <cmath>

#include "plots/dashed_graph.h"
#include "plots/row_parts.h"

namespace toolpace::ui {
namespace {

constexpr float kDenseInk = 0.7f;  // of the strokes that stand for many phases: whole blocks of them stay calm
constexpr int kMoreTicks = 3;      // than fit well, where it takes them to have one besides zero

/// "10³ mm/s³" keeps the numbers at the axis short.
double power_of_thousand(double largest) {
  if (!(largest >= 1e4) || !std::isfinite(largest)) return 1.0;
  return std::pow(1000.0, std::floor(std::log10(largest / 10) / 3));
}

QString power_text(double power) {
  if (power == 1.0) return {};
  static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
  QString text = QStringLiteral("10");
  for (const QChar c : QString::number(std::lround(std::log10(power)))) text += digits[c.digitValue()];
  return text + ' ';
}

/// Never so wide apart that zero alone has a number, which tells no height.
class HeightTicker : public QCPAxisTicker {
  double getTickStep(const QCPRange& range) override {
    double step = QCPAxisTicker::getTickStep(range);
    const double farthest = std::max(-range.lower, range.upper);
    for (int more = 1; step > farthest && more <= kMoreTicks; ++more) {
      step = cleanMantissa(range.size() / (tickCount() + more));
    }
    return step;
  }
};

}  // namespace

MotionRow::MotionRow(QCustomPlot* plot, std::size_t track)
    : track_(track), rect_(new_row_rect(plot, static_cast<int>(track))) {
  value()->setTicker(QSharedPointer<HeightTicker>::create());
  value()->ticker()->setTickCount(4);
  value()->setNumberFormat("gb");
  value()->setNumberPrecision(6);
  const auto graph = [&](const char* name) {
    auto* g = new DashedGraph(time(), value());  // the plot's
    g->setName(QString("%1.%2").arg(kMotionTracks[track].symbol).arg(name));
    g->setSelectable(QCP::stNone);
    return g;
  };
  feed_ = graph("feed");
  cap_high_ = graph("cap");
  cap_low_ = graph("cap below");
  ghost_ = graph("ghost");
  ghost_low_ = graph("ghost below");
  for (auto& axis : axis_) axis = graph("axis");
  curve_ = graph("curve");
  word_ = new QCPItemText(plot);
  word_->position->setAxisRect(rect_);
  word_->position->setType(QCPItemPosition::ptAxisRectRatio);
  word_->position->setCoords(1.0, 0.0);
  word_->setPositionAlignment(Qt::AlignRight | Qt::AlignTop);
  word_->setPadding({4, 0, 4, 0});
  word_->setClipAxisRect(rect_);
  word_->setVisible(false);
}

QPen measured_pen(const Theme& theme) {
  QPen pen(theme.text, 1.2);
  pen.setDashPattern({5, 3});
  return pen;
}

QPen axis_pen(std::size_t axis, const Theme& theme) {
  // A turns about X, B about Y, C about Z: their colours, and dashes of their own.
  const std::array colours = {theme.axis_x, theme.axis_y, theme.axis_z};
  QPen pen(colours[axis % 3], axis < 3 ? 1.2 : 1.6);
  constexpr std::array kLinear = {Qt::SolidLine, Qt::DashLine, Qt::DotLine};
  if (axis < 3) {
    pen.setStyle(kLinear[axis]);
  } else {
    pen.setDashPattern(QList<qreal>{6, 2, 1, 2});
  }
  return pen;
}

void MotionRow::dress(const Theme& theme, const QFont& font) {
  dress_row(rect_, theme, font);
  QColor ghost_feed = theme.secondary;
  ghost_feed.setAlphaF(0.4f);
  feed_->setPen(QPen(ghost_feed, 2));
  QPen cap_pen(theme.secondary, 1);
  cap_pen.setDashPattern({6, 4});
  for (auto* cap : {cap_high_, cap_low_}) cap->setPen(cap_pen);
  for (auto* ghost : {ghost_, ghost_low_}) ghost->setPen(QPen(theme.plan_b, 1.3, Qt::DashLine));
  curve_->setPen(QPen(theme.accent, 1.6));
  word_->setColor(theme.secondary);
  word_->setFont(font);
  word_->setBrush(theme.surface);
  for (std::size_t i = 0; i < kPlottedAxes; ++i) axis_[i]->setPen(axis_pen(i, theme));
}

void MotionRow::scale(Extent extent, bool both_ways, bool turns, Units units) {
  const DisplayUnit unit = display_unit(kMotionTracks[track_].quantity, units);
  if (both_ways) extent.low = std::min(extent.low, -extent.high);
  if (both_ways) extent.high = std::max(extent.high, -extent.low);
  double low = extent.low * unit.factor, high = extent.high * unit.factor;
  if (!(high > low) || !std::isfinite(high - low)) (low = 0, high = 1);
  const double power = power_of_thousand(std::max(-low, high)), height = high - low;
  factor_ = unit.factor / power;
  value()->setRange((low - (low < 0 ? kRowMargin : kRowFloor) * height) / power, (high + kRowMargin * height) / power);
  const QString degrees = turns ? ", " + display_unit(rotary(kMotionTracks[track_].quantity), units).text : QString();
  set_row_label(*value(),
                QString("%1\n%2%3").arg(kMotionTracks[track_].symbol, power_text(power), unit.text + degrees));
}

void MotionRow::fill(QCPGraph* graph, const Curve& curve) const { fill_graph(graph, curve, factor_); }

void MotionRow::showOwn(const MotionCurves& curves, bool dense) {
  fill(curve_, curves[track_]);
  QPen pen = curve_->pen();
  pen.setWidthF(dense ? 1.0 : 1.6);
  QColor colour = pen.color();
  colour.setAlphaF(dense ? kDenseInk : 1.0f);
  pen.setColor(colour);
  curve_->setPen(pen);
}

void MotionRow::showOther(const MotionEnvelope& sides) {
  fill(ghost_, sides.high[track_]);
  fill(ghost_low_, sides.low[track_]);
}

void MotionRow::showCaps(const CapCurves& caps) {
  if (kMotionTracks[track_].has_feed) fill(feed_, caps.feed);
  fill(cap_high_, caps.high[track_]);
  fill(cap_low_, caps.low[track_]);
}

void MotionRow::showWord(const QString& word) {
  word_->setText(word);
  word_->setVisible(!word.isEmpty());
}

void MotionRow::showAxis(std::size_t axis, const MotionCurves& curves) { fill(axis_.at(axis), curves[track_]); }

ErrorRow::ErrorRow(QCustomPlot* plot)
    : rect_(new_row_rect(plot, static_cast<int>(kMotionTrackCount))),
      curve_(plot->addGraph(time(), value())),
      measured_curve_(new DashedGraph(time(), value())) {
  curve_->setName("e.curve");
  measured_curve_->setName("e.measured");
  for (QCPGraph* curve : {curve_, measured_curve_}) curve->setSelectable(QCP::stNone);
  setShown(false);
}

void ErrorRow::setShown(bool shown) {
  rect_->setVisible(shown);
  for (QCPGraph* curve : {curve_, measured_curve_}) curve->setVisible(shown);
}

void ErrorRow::dress(const Theme& theme, const QFont& font) {
  dress_row(rect_, theme, font);
  curve_->setPen(QPen(theme.error, 1.2));
  measured_curve_->setPen(measured_pen(theme));
}

void ErrorRow::scale(std::optional<double> largest, Units units) {
  const DisplayUnit unit = error_unit(units);
  factor_ = unit.factor;
  const double most = largest.value_or(std::max(error_.largest(), measured_.largest())) * factor_;
  // Between two simulations the old heights stay, so that the plot does not jump.
  if (!error_.is_empty() || !measured_.is_empty()) {
    value()->setRange(most > 0 ? -kRowFloor * most : -kRowFloor, most > 0 ? (1 + kRowMargin) * most : 1.0);
  }
  set_row_label(*value(), "e\n" + unit.text);
}

Curve ErrorRow::curve(const TimeWindow& window) const { return isShown() ? error_.curve(window) : Curve{}; }

Curve ErrorRow::measured(const TimeWindow& window) const { return isShown() ? measured_.curve(window) : Curve{}; }

void ErrorRow::show(const Curve& curve, const Curve& measured) {
  fill_graph(curve_, curve, factor_);
  fill_graph(measured_curve_, measured, factor_);
}

std::optional<double> ErrorRow::heightAt(double time) const {
  if (error_.is_empty() || !isShown()) return std::nullopt;
  return error_.at(time) * factor_;
}

}  // namespace toolpace::ui
