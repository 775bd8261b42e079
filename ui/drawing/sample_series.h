#pragma once
/// Values that are known at instants only, such as a simulated contour error, as a curve of a few points a pixel.

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "drawing/contour_scene.h"
#include "drawing/profile_curves.h"

namespace toolpace::ui {

class SampleSeries {
 public:
  /// Over the contour error of a trace [mm]; null = nothing.
  explicit SampleSeries(const std::shared_ptr<const ErrorTrace>& trace);
  explicit SampleSeries(std::nullptr_t) {}
  SampleSeries() = default;
  /// Over any values, one an instant [s].
  SampleSeries(std::shared_ptr<const std::vector<double>> time, std::shared_ptr<const std::vector<float>> value);

  bool is_empty() const { return !time_ || time_->empty(); }
  float largest() const { return std::max(extent_.high, 0.0f); }  ///< 0 where it is empty
  const Extent& extent() const { return extent_; }

  /// The samples themselves where they can be told apart, least and greatest value a pixel where not.
  Curve curve(const TimeWindow& window) const;
  /// Value of the sample at or before a time; the first one before it begins. Precondition: not empty.
  double at(double time) const;

 private:
  Extent scan(std::size_t first, std::size_t last) const;
  std::size_t index_at(double time) const;  ///< of the first sample after it

  std::shared_ptr<const std::vector<double>> time_;
  std::shared_ptr<const std::vector<float>> value_;
  Pyramid<Extent> pyramid_;
  Extent extent_;
};

}  // namespace toolpace::ui
