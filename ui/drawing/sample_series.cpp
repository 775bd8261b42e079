#include "drawing/sample_series.h"

#include <algorithm>

namespace toolpace::ui {

SampleSeries::SampleSeries(std::shared_ptr<const ErrorTrace> trace) : trace_(std::move(trace)) {
  if (is_empty()) return;
  const std::size_t count = std::min(trace_->time.size(), trace_->error.size());
  const auto part = [this](std::size_t first, std::size_t last) { return scan(first, last); };
  pyramid_ = Pyramid<Extent>(count, part);
  largest_ = std::max(pyramid_.query(0, count, part).high, 0.0f);
}

Extent SampleSeries::scan(std::size_t first, std::size_t last) const {
  Extent extent;
  for (std::size_t i = first; i < last; ++i) extent.add(trace_->error[i]);
  return extent;
}

std::size_t SampleSeries::index_at(double time) const {
  const auto after = std::upper_bound(trace_->time.begin(), trace_->time.end(), time);
  return std::min(static_cast<std::size_t>(after - trace_->time.begin()), pyramid_.size());
}

double SampleSeries::at(double time) const {
  const std::size_t after = index_at(time);
  return trace_->error[after > 0 ? after - 1 : 0];
}

Curve SampleSeries::curve(const TimeWindow& window) const {
  Curve curve;
  if (is_empty() || !(window.end > window.begin)) return curve;
  // One sample beyond each edge, so that the line reaches it.
  const std::size_t begin = index_at(window.begin), first = begin > 0 ? begin - 1 : 0;
  const std::size_t last = std::min(index_at(window.end) + 1, pyramid_.size());
  if (last - first <= 2 * static_cast<std::size_t>(window.columns)) {
    for (std::size_t i = first; i < last; ++i) curve.add(trace_->time[i], trace_->error[i]);
    return curve;
  }
  const auto part = [this](std::size_t a, std::size_t b) { return scan(a, b); };
  const double pixel = (window.end - window.begin) / window.columns;
  for (int column = 0; column < window.columns; ++column) {
    const double time = window.begin + column * pixel;
    const Extent extent = pyramid_.query(index_at(time), index_at(time + pixel), part);
    if (extent.is_empty()) continue;
    curve.add(time + pixel / 2, extent.low);
    if (extent.high > extent.low) curve.add(time + pixel / 2, extent.high);
  }
  return curve;
}

}  // namespace toolpace::ui
