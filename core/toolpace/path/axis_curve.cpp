#include "toolpace/path/axis_curve.h"

namespace toolpace {
namespace {

/// At an end of a segment, whose direction splines and blends know by their own parameter.
Frame end_frame(const Path& path, std::size_t segment, bool is_start) {
  if (path.kind[segment] < SegmentKind::spline) {
    return frame_at(path, segment, is_start ? 0.0 : path.length[segment]);
  }
  const ParameterDerivatives d = derivatives_at_share(path, segment, is_start ? 0.0 : 1.0);
  return {is_start ? path.node[segment] : path.end_of(segment), d.first, d.second, d.third};
}

}  // namespace

Frame through(const Chain& chain, const Frame& tip) {
  const auto xyz = [](const AxisVector& v) -> Eigen::Vector3d { return v.head<3>(); };
  const auto axes = axes_along(chain, {xyz(tip.point), xyz(tip.first), xyz(tip.second), xyz(tip.third)},
                               {tip.point, tip.first, tip.second, tip.third});
  return {axes[0], axes[1], axes[2], axes[3]};
}

bool AxisCurve::is_straight(std::size_t segment) const {
  if (!is_even_line(*path_, segment)) return false;
  return is_path(segment) || path_->node[segment].tail<3>() == path_->end_of(segment).tail<3>();
}

bool AxisCurve::is_cut(std::size_t node) const {
  const auto& p = *path_;
  return p.move[node - 1] == p.move[node] && p.kind[node - 1] == p.kind[node] && p.kind[node] <= SegmentKind::arc &&
         !is_path(node) && !is_path(node - 1);
}

AxisVector AxisCurve::axes_of(std::size_t segment, const AxisVector& place) const {
  const Chain* const chain = path_->chain_of(segment);
  return chain == nullptr ? place : axes_at(*chain, place.head<3>(), place);
}

AxisVector AxisCurve::point_at(std::size_t segment, double s) const {
  return axes_of(segment, toolpace::point_at(*path_, segment, s));
}

Frame AxisCurve::frame_at(std::size_t segment, double s) const {
  const Frame frame = toolpace::frame_at(*path_, segment, s);
  const Chain* const chain = path_->chain_of(segment);
  return chain == nullptr ? frame : through(*chain, frame);
}

AxisVector AxisCurve::begin_of(std::size_t segment) const { return axes_of(segment, path_->node[segment]); }

AxisVector AxisCurve::end_of(std::size_t segment) const { return axes_of(segment, path_->end_of(segment)); }

AxisVector AxisCurve::start_direction(std::size_t segment) const {
  const Chain* const chain = path_->chain_of(segment);
  if (chain == nullptr) return toolpace::start_direction(*path_, segment);
  return through(*chain, end_frame(*path_, segment, true)).first;
}

AxisVector AxisCurve::end_direction(std::size_t segment) const {
  const Chain* const chain = path_->chain_of(segment);
  if (chain == nullptr) return toolpace::end_direction(*path_, segment);
  return through(*chain, end_frame(*path_, segment, false)).first;
}

}  // namespace toolpace
