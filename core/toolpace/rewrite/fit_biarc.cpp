#include "toolpace/rewrite/fit_biarc.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toolpace::detail::rewrite {
namespace {

constexpr double kLeastArc = 2.0;     // [tolerances] radius
constexpr double kMostBetween = 1.5;  // [rad] that the directions may be apart
constexpr double kMostSweep = 3.0;    // [rad] of each half

Flat unit(const Flat& p) {
  const double length = std::sqrt(dot(p, p));
  return length > 0.0 ? Flat{p.u / length, p.v / length, 0.0} : Flat{};
}

/// Where the two arcs meet; both ends are as far from it along their directions.
std::optional<Flat> joint_of(const Flat& end, const Flat& leaving, const Flat& arriving) {
  const double between = dot(leaving, arriving),
               along = end.u * (leaving.u + arriving.u) + end.v * (leaving.v + arriving.v);
  if (between < std::cos(kMostBetween)) return std::nullopt;
  if (!(along > 0.0)) return std::nullopt;
  const double square = dot(end, end);
  const double reach = square / (along + std::sqrt(along * along + 2 * (1 - between) * square));
  if (!(reach > 0.0) || !std::isfinite(reach)) return std::nullopt;
  return Flat{(end.u + reach * (leaving.u - arriving.u)) / 2, (end.v + reach * (leaving.v - arriving.v)) / 2, 0.0};
}

}  // namespace

BiarcFitter::BiarcFitter(const Curve& curve, const ArcRules& rules, const PlaceGrid& grid, double tolerance)
    : curve_(curve), rules_(rules), grid_(grid), tolerance_(tolerance) {}

/// Cuts the chain where it is nearest to the joint.
bool BiarcFitter::split_at(const Flat& joint) {
  double least = std::numeric_limits<double>::infinity(), share = 0.0;
  std::size_t cell = 0;
  for (std::size_t k = 1; k < chain_.size(); ++k) {
    const Flat way = chain_[k] - chain_[k - 1], off = joint - chain_[k - 1];
    const double square = dot(way, way), t = square > 0.0 ? std::clamp(dot(off, way) / square, 0.0, 1.0) : 0.0;
    const double du = off.u - t * way.u, dv = off.v - t * way.v, distance = du * du + dv * dv;
    if (distance < least) least = distance, share = t, cell = k;
  }
  if (!(least <= tolerance_ * tolerance_)) return false;
  const Flat &a = chain_[cell - 1], &b = chain_[cell];
  met_ = {a.u + share * (b.u - a.u), a.v + share * (b.v - a.v), a.w + share * (b.w - a.w)};
  before_.assign(chain_.begin(), chain_.begin() + static_cast<std::ptrdiff_t>(cell));
  before_.push_back(met_);
  behind_.assign(1, met_);
  behind_.insert(behind_.end(), chain_.begin() + static_cast<std::ptrdiff_t>(cell), chain_.end());
  return true;
}

Flat BiarcFitter::on_grid(const Flat& joint) const {
  const auto place = [&](double value, Eigen::Index axis) {
    const double offset = grid_.offset[axis], start = start_[axis];
    return offset + std::round((start + value - offset) / grid_.step) * grid_.step - start;
  };
  const double level = joint.w == 0.0 ? 0.0 : place(joint.w, axes_.normal);  // where nothing moves along the normal
  return {place(joint.u, axes_.first), place(joint.v, axes_.second), level};
}

/// The arc from start to end with a direction at one of them; a line where it would be too wide for an arc.
/// @param at, along  the place, start or end, and the direction there
std::optional<FittedArc> BiarcFitter::half(const FlatPoints& chain, const Flat& start, const Flat& end, const Flat& at,
                                           const Flat& along) {
  const Flat chord = (&at == &start) ? end - start : start - end;
  const Flat normal{-along.v, along.u, 0.0};
  const double aside = 2 * dot(normal, chord), radius = aside != 0.0 ? dot(chord, chord) / aside : 0.0;
  if (aside == 0.0 || std::fabs(radius) > rules_.most_radius) {
    if (!walk_line(chain, start, end, tolerance_)) return std::nullopt;
    return FittedArc{plane_, 0.0, 0.0, false, 0, 0.0};
  }
  if (std::fabs(radius) < kLeastArc * tolerance_) return std::nullopt;
  const Flat centre{at.u + radius * normal.u, at.v + radius * normal.v, 0.0};
  const Flat offset = rounded(centre - start, rules_.centre_step);
  const Flat written{start.u + offset.u, start.v + offset.v, 0.0};
  const ArcWalk found = walk_arc(chain, {start, end, written}, tolerance_, angles_);
  if (!found.fits || found.sweep > kMostSweep) return std::nullopt;
  return FittedArc{plane_, offset.u, offset.v, found.clockwise, 1, found.sweep};
}

std::optional<FittedBiarc> BiarcFitter::fit(int plane, std::size_t first, std::size_t last,
                                            const Eigen::Vector3d& leaving, const Eigen::Vector3d& arriving) {
  plane_ = plane;
  axes_ = PlaneOfArcs(plane);
  start_ = curve_.at(first);
  flatten(curve_, axes_, first, last, chain_);
  const Flat end = chain_.back(), out = unit(axes_.flat(leaving)), in = unit(axes_.flat(arriving));
  auto joint = joint_of(end, out, in);
  if (!joint || !split_at(*joint)) return std::nullopt;
  joint->w = met_.w;
  const Flat start{}, meeting = on_grid(*joint);
  const auto one = half(before_, start, meeting, start, out);
  if (!one) return std::nullopt;
  const auto two = half(behind_, meeting, end, end, in);
  if (!two) return std::nullopt;
  FittedBiarc biarc{*one, *two, start_};
  biarc.joint[axes_.first] += meeting.u;
  biarc.joint[axes_.second] += meeting.v;
  biarc.joint[axes_.normal] += meeting.w;
  return biarc;
}

}  // namespace toolpace::detail::rewrite
