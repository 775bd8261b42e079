#include "toolpace/plan/retime/path_sampler.h"

#include <algorithm>

#include "toolpace/path/axis_curve.h"

namespace toolpace::detail::retime {
namespace {

// Pieces of splines are short; through a sharp corner the parameter runs very unevenly.
constexpr std::size_t kSplineKnots = 5, kBlendKnots = 9;
constexpr double kMostSlope = 3.0;  // of a Hermite cubic that does not run back

}  // namespace

PathSampler::PathSampler(const Path& path, std::size_t begin) : path_(path), segment_(begin) { enter(); }

void PathSampler::go(double position) {
  while (segment_ + 1 < path_.size() && position - start_ > path_.length[segment_]) enter_next();
  while (position < start_ && segment_ > 0) {
    start_ -= path_.length[--segment_];
    enter();
  }
  at_ = position - start_;
}

void PathSampler::enter_next() {
  start_ += path_.length[segment_++];
  at_ = 0;
  enter();
}

void PathSampler::go_inside(double position) { at_ = std::clamp(position - start_, 0.0, path_.length[segment_]); }

template <int rows>
CurveDerivatives<rows> PathSampler::derivatives() const {
  const auto first_rows = [](const auto& d) -> CurveDerivatives<rows> {
    return {d.first.template head<rows>(), d.second.template head<rows>(), d.third.template head<rows>()};
  };
  if (chain_ != nullptr) return first_rows(about_tip());
  switch (path_.kind[segment_]) {
    case SegmentKind::line: return first_rows(line_);
    case SegmentKind::arc: return first_rows(frame_at(path_, segment_, at_));
    default: return curve_->at_share<rows>(share());
  }
}

template CurveDerivatives<3> PathSampler::derivatives<3>() const;
template CurveDerivatives<static_cast<int>(kAxisCount)> PathSampler::derivatives<static_cast<int>(kAxisCount)>() const;

ParameterDerivatives PathSampler::about_tip() const {
  Frame tip;
  if (path_.kind[segment_] < SegmentKind::spline) {
    tip = frame_at(path_, segment_, at_);
  } else {
    const double at = share();
    const ParameterDerivatives d = curve_->at_share(at);
    tip = {point_at_share(path_, segment_, at), d.first, d.second, d.third};
  }
  const Frame axes = through(*chain_, tip);
  return {axes.first, axes.second, axes.third};
}

void PathSampler::enter() {
  chain_ = path_.chain_of(segment_);
  if (path_.kind[segment_] == SegmentKind::line) {
    const Frame f = frame_at(path_, segment_, 0.0);
    line_ = {f.first, f.second, f.third};
  } else if (path_.kind[segment_] >= SegmentKind::spline) {
    curve_.emplace(path_, segment_);
    tabulate(path_.kind[segment_] == SegmentKind::spline ? kSplineKnots : kBlendKnots);
  }
}

/// Lengths by Simpson's rule, scaled to the segment's own.
void PathSampler::tabulate(std::size_t knots) {
  knots_ = knots;
  const double h = 1.0 / static_cast<double>(knots - 1);
  length_[0] = 0;
  speed_[0] = curve_->speed(0.0);
  for (std::size_t k = 1; k < knots; ++k) {
    const double share = static_cast<double>(k) * h;
    speed_[k] = curve_->speed(share);
    length_[k] = length_[k - 1];
    length_[k] +=
        knots == 2 ? path_.length[segment_] : h / 6 * (speed_[k - 1] + 4 * curve_->speed(share - h / 2) + speed_[k]);
  }
  const double scale = path_.length[segment_] / length_[knots - 1];
  for (std::size_t k = 0; k < knots; ++k) length_[k] *= scale;
}

/// Share of the own parameter, as Hermite cubics in the length.
double PathSampler::share() const {
  std::size_t k = 1;
  while (k + 1 < knots_ && at_ > length_[k]) ++k;
  const double h = 1.0 / static_cast<double>(knots_ - 1), width = length_[k] - length_[k - 1];
  const double x = std::clamp((at_ - length_[k - 1]) / width, 0.0, 1.0), y = 1 - x;
  const auto slope = [&](double speed) { return speed * h * kMostSlope > width ? width / (speed * h) : kMostSlope; };
  const double part = x * x * (3 - 2 * x) + x * y * (slope(speed_[k - 1]) * y - slope(speed_[k]) * x);
  return std::clamp((static_cast<double>(k - 1) + part) * h, 0.0, 1.0);
}

}  // namespace toolpace::detail::retime
