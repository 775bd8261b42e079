#include "drawing/sample_series.h"

#include <algorithm>

namespace toolpace::ui {

SampleSeries::SampleSeries(const std::shared_ptr<const ErrorTrace>& trace) {
  if (!trace) return;
  *this = SampleSeries(std::shared_ptr<const std::vector<double>>(trace, &trace->time),
                       std::shared_ptr<const std::vector<float>>(trace, &trace->error));
}

SampleSeries::SampleSeries(std::shared_ptr<const std::vector<double>> time,
                           std::shared_ptr<const std::vector<float>> value)
    : time_(std::move(time)), value_(std::move(value)) {
  if (is_empty()) return;
  const std::size_t count = std::min(time_->size(), value_->size());
  const auto part = [this](std::size_t first, std::size_t last) { return scan(first, last); };
  pyramid_ = Pyramid<Extent>(count, part);
  extent_ = pyramid_.query(0, count, part);
}

Extent SampleSeries::scan(std::size_t first, std::size_t last) const {
  Extent extent;
  for (std::size_t i = first; i < last; ++i) extent.add((*value_)[i]);
  return extent;
}

std::size_t SampleSeries::index_at(double time) const {
  const auto after = std::upper_bound(time_->begin(), time_->end(), time);
  return std::min(static_cast<std::size_t>(after - time_->begin()), pyramid_.size());
}

double SampleSeries::at(double time) const {
  const std::size_t after = index_at(time);
  return (*value_)[after > 0 ? after - 1 : 0];
}

Curve SampleSeries::curve(const TimeWindow& window) const {
  Curve curve;
  if (is_empty() || !(window.end > window.begin)) return curve;
  // One sample beyond each edge, so that the line reaches it.
  const std::size_t begin = index_at(window.begin), first = begin > 0 ? begin - 1 : 0;
  const std::size_t last = std::min(index_at(window.end) + 1, pyramid_.size());
  if (last - first <= 2 * static_cast<std::size_t>(window.columns)) {
    for (std::size_t i = first; i < last; ++i) curve.add((*time_)[i], (*value_)[i]);
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
