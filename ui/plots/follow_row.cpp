#include "plots/follow_row.h"

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

FollowRow::FollowRow(QCustomPlot* plot) : rect_(new_row_rect(plot, static_cast<int>(kMotionTrackCount) + 1)) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    curves_[axis] = new DashedGraph(time(), value());  // the plot's
    curves_[axis]->setName(QString("f.%1").arg(QLatin1Char(kAxisNames[axis])));
    curves_[axis]->setSelectable(QCP::stNone);
  }
  value()->ticker()->setTickCount(4);
  setShown(false);
}

void FollowRow::setShown(bool shown) {
  rect_->setVisible(shown);
  for (auto* curve : curves_) curve->setVisible(shown);
}

void FollowRow::setTrace(const std::shared_ptr<const MeasuredTrace>& trace) {
  whole_ = {};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    errors_[axis] = SampleSeries(nullptr);
    if (!trace || trace->following[axis].empty()) continue;
    // Kept alive by the trace that they are a part of.
    errors_[axis] = SampleSeries(std::shared_ptr<const std::vector<double>>(trace, &trace->actual->time),
                                 std::shared_ptr<const std::vector<float>>(trace, &trace->following[axis]));
    const Extent extent = errors_[axis].extent();
    const auto size = static_cast<float>(size_of(axis));
    whole_.add({extent.low * size, extent.high * size});
  }
}

void FollowRow::dress(const Theme& theme, const QFont& font) {
  dress_row(rect_, theme, font);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    QPen pen(axis_pen(axis, theme).color(), 1.2);
    pen.setDashPattern(QList<qreal>{5, 2.0 + static_cast<double>(axis % 3)});
    curves_[axis]->setPen(pen);
  }
}

void FollowRow::scale(Extent extent, Units units) {
  const DisplayUnit unit = error_unit(units);
  factor_ = unit.factor;
  if (extent.is_empty()) extent = whole_;
  extent.add(0.0f);
  const double low = extent.low * factor_, high = extent.high * factor_, height = high > low ? high - low : 1.0;
  value()->setRange(low - kRowMargin * height, high + kRowMargin * height);
  set_row_label(*value(), "f\n" + unit.text);
}

FollowRow::Curves FollowRow::curves(const TimeWindow& window) const {
  Curves curves;
  for (std::size_t axis = 0; isShown() && axis < kAxisCount; ++axis) {
    curves[axis] = errors_[axis].curve(window);
    for (double& value : curves[axis].value) value *= size_of(axis);
  }
  return curves;
}

void FollowRow::show(const Curves& curves) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) fill_graph(curves_[axis], curves[axis], factor_);
}

}  // namespace toolpace::ui
