#include "toolpace/plan/retime/path_sampler.h"

#include <algorithm>

namespace toolpace::detail::retime {
namespace {

constexpr double kMostSlope = 4.0;  // keeps the cubic from running back

double slope(const Path& path, std::size_t segment, double share) {
  const double speed = parameter_speed(path, segment, share);
  return speed * kMostSlope > path.length[segment] ? path.length[segment] / speed : kMostSlope;
}

}  // namespace

PathSampler::PathSampler(const Path& path, std::size_t begin) : path_(path), segment_(begin) { enter(); }

void PathSampler::go(double position) {
  while (segment_ + 1 < path_.size() && position - start_ > path_.length[segment_]) {
    start_ += path_.length[segment_++];
    enter();
  }
  while (position < start_ && segment_ > 0) {
    start_ -= path_.length[--segment_];
    enter();
  }
  at_ = position - start_;
}

ParameterDerivatives PathSampler::derivatives() const {
  switch (path_.kind[segment_]) {
    case SegmentKind::line: return line_;
    case SegmentKind::arc: {
      const Frame f = frame_at(path_, segment_, at_);
      return {f.first, f.second, f.third};
    }
    default: return derivatives_at_share(path_, segment_, share());
  }
}

void PathSampler::enter() {
  if (path_.kind[segment_] == SegmentKind::line) {
    const Frame f = frame_at(path_, segment_, 0.0);
    line_ = {f.first, f.second, f.third};
  } else if (path_.kind[segment_] >= SegmentKind::spline) {
    begin_slope_ = slope(path_, segment_, 0.0);
    end_slope_ = slope(path_, segment_, 1.0);
  }
}

/// Share of the own parameter, as a Hermite cubic in the share of the length.
double PathSampler::share() const {
  const double x = std::clamp(at_ / path_.length[segment_], 0.0, 1.0), y = 1 - x;
  return std::clamp(x * x * (3 - 2 * x) + x * y * (begin_slope_ * y - end_slope_ * x), 0.0, 1.0);
}

}  // namespace toolpace::detail::retime
