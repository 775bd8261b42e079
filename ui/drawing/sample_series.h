#pragma once
/// Values that are known at instants only, such as a simulated contour error, as a curve of a few points a pixel.

#include <memory>

#include "drawing/contour_scene.h"
#include "drawing/profile_curves.h"

namespace toolpace::ui {

class SampleSeries {
 public:
  /// Over the contour error of a trace [mm]; null = nothing.
  explicit SampleSeries(std::shared_ptr<const ErrorTrace> trace);

  bool is_empty() const { return !trace_ || trace_->time.empty(); }
  float largest() const { return largest_; }

  /// The samples themselves where they can be told apart, least and greatest value a pixel where not.
  Curve curve(const TimeWindow& window) const;
  /// Value of the sample at or before a time; the first one before it begins. Precondition: not empty.
  double at(double time) const;

 private:
  Extent scan(std::size_t first, std::size_t last) const;
  std::size_t index_at(double time) const;  ///< of the first sample after it

  std::shared_ptr<const ErrorTrace> trace_;
  Pyramid<Extent> pyramid_;
  float largest_ = 0;
};

}  // namespace toolpace::ui
