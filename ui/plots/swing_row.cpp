#include "plots/swing_row.h"

#include <algorithm>
#include <numbers>

#include "plots/dashed_graph.h"
#include "plots/plot_row.h"
#include "plots/row_parts.h"

namespace toolpace::ui {
namespace {

/// A degree counts as 1 mm.
double size_of(std::size_t axis) { return is_rotary(axis) ? 180 / std::numbers::pi : 1; }

}  // namespace

SwingRow::SwingRow(QCustomPlot* plot, int index, const char* symbol)
    : rect_(new_row_rect(plot, static_cast<int>(kMotionTrackCount) + index)), symbol_(symbol) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    curves_[axis] = new DashedGraph(time(), value());  // the plot's
    curves_[axis]->setName(QString("%1.%2").arg(symbol_).arg(QLatin1Char(kAxisNames[axis])));
    curves_[axis]->setSelectable(QCP::stNone);
  }
  value()->ticker()->setTickCount(4);
  setShown(false);
}

void SwingRow::setShown(bool shown) {
  rect_->setVisible(shown);
  for (auto* curve : curves_) curve->setVisible(shown);
}

void SwingRow::setValues(const std::shared_ptr<const std::vector<double>>& time, const Values* values) {
  whole_ = {};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    offsets_[axis] = SampleSeries(nullptr);
    if (!time || (*values)[axis].empty()) continue;
    // Kept alive by the trace that both are parts of.
    offsets_[axis] = SampleSeries(time, std::shared_ptr<const std::vector<float>>(time, &(*values)[axis]));
    const Extent extent = offsets_[axis].extent();
    const auto size = static_cast<float>(size_of(axis));
    whole_.add({extent.low * size, extent.high * size});
  }
}

void SwingRow::setFollowing(const std::shared_ptr<const MeasuredTrace>& trace) {
  if (!trace) return setValues(nullptr, nullptr);
  setValues(std::shared_ptr<const std::vector<double>>(trace, &trace->actual->time), &trace->following);
}

void SwingRow::setVibration(const std::shared_ptr<const VibrationTrace>& trace) {
  if (!trace) return setValues(nullptr, nullptr);
  setValues(std::shared_ptr<const std::vector<double>>(trace, &trace->time), &trace->displacement);
}

void SwingRow::dress(const Theme& theme, const QFont& font) {
  dress_row(rect_, theme, font);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    QPen pen(axis_pen(axis, theme).color(), 1.2);
    pen.setDashPattern(QList<qreal>{5, 2.0 + static_cast<double>(axis % 3)});
    curves_[axis]->setPen(pen);
  }
}

void SwingRow::scale(Extent extent, Units units) {
  const DisplayUnit unit = error_unit(units);
  factor_ = unit.factor;
  if (extent.is_empty()) extent = whole_;
  extent.add(0.0f);
  const double low = extent.low * factor_, high = extent.high * factor_, height = high > low ? high - low : 1.0;
  value()->setRange(low - kRowMargin * height, high + kRowMargin * height);
  set_row_label(*value(), symbol_ + "\n" + unit.text);
}

SwingRow::Curves SwingRow::curves(const TimeWindow& window) const {
  Curves curves;
  for (std::size_t axis = 0; isShown() && axis < kAxisCount; ++axis) {
    curves[axis] = offsets_[axis].curve(window);
    for (double& value : curves[axis].value) value *= size_of(axis);
  }
  return curves;
}

void SwingRow::show(const Curves& curves) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) fill_graph(curves_[axis], curves[axis], factor_);
}

}  // namespace toolpace::ui
