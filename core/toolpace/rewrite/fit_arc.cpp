#include "toolpace/rewrite/fit_arc.h"

#include <algorithm>
#include <cmath>

namespace toolpace::detail::rewrite {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr std::size_t kSamples = 16;  // points that a centre is guessed from
constexpr int kTries = 3;             // centres looked at
constexpr double kClosed = 0.25;  // of the extent: a shorter way from start to end does not tell where the centre lies
constexpr double kLeastRadius = 2.0;  // [tolerances]
constexpr double kNearTurn = 0.05;    // [rad] about a whole turn where start and end are too close for comfort

}  // namespace

void flatten(const Curve& curve, const PlaneOfArcs& plane, std::size_t first, std::size_t last, FlatPoints& chain) {
  const std::size_t begin = curve.vertex[first], end = curve.vertex[last];
  const Eigen::Vector3d& start = curve.point[begin];
  chain.resize(end - begin + 1);
  for (std::size_t k = begin; k <= end; ++k) chain[k - begin] = plane.flat(curve.point[k] - start);
}

Flat rounded(const Flat& centre, double step) {
  return {std::round(centre.u / step) * step, std::round(centre.v / step) * step, 0.0};
}

ArcFitter::ArcFitter(const Curve& curve, const ArcRules& rules, double tolerance)
    : curve_(curve), rules_(rules), tolerance_(tolerance) {}

/// By least squares of power distances, through the start, and through the end where that is far enough.
std::optional<Flat> ArcFitter::guess_centre() const {
  const std::size_t count = chain_.size() - 1, samples = std::min(kSamples, count);
  double suu = 0, suv = 0, svv = 0, su = 0, sv = 0;
  for (std::size_t k = 1; k < samples; ++k) {
    const Flat& p = chain_[k * count / samples];
    const double power = dot(p, p) / 2;
    suu += p.u * p.u, suv += p.u * p.v, svv += p.v * p.v, su += p.u * power, sv += p.v * power;
  }
  if (is_closed_) {
    const double det = suu * svv - suv * suv;
    if (!(det > 1e-12 * suu * svv)) return std::nullopt;
    return Flat{(su * svv - sv * suv) / det, (sv * suu - su * suv) / det, 0.0};
  }
  // The centre is M + h·n, M the middle of the chord, n at right angles to it: p·(M + h·n) = |p|²/2 for all points.
  const double mu = end_.u / 2, mv = end_.v / 2, nu = -end_.v, nv = end_.u;
  const double below = nu * nu * suu + 2 * nu * nv * suv + nv * nv * svv;
  const double above = nu * su + nv * sv - (mu * nu * suu + (mu * nv + mv * nu) * suv + mv * nv * svv);
  if (!(below > 0)) return std::nullopt;
  const double h = above / below;
  return Flat{mu + h * nu, mv + h * nv, 0.0};
}

ArcWalk ArcFitter::walk(const Flat& centre) {
  const double radius = std::sqrt(dot(centre, centre));
  if (!(radius >= kLeastRadius * tolerance_ && radius <= rules_.most_radius)) return {};
  return walk_arc(chain_, {{}, end_, centre}, tolerance_, angles_);
}

/// A centre about which the farthest places outwards and inwards are as far: that of the walk shifted along the line of the
/// centres that are as far from both ends.
std::optional<Flat> ArcFitter::evened(const Flat& centre, const ArcWalk& walk) const {
  if (is_closed_) return std::nullopt;
  const double length = std::sqrt(dot(end_, end_)), radius = std::sqrt(dot(centre, centre));
  const Flat normal{-end_.v / length, end_.u / length, 0.0};
  // How the distance of a place to the arc changes with the shift.
  const auto slope = [&](const Flat& p) {
    const Flat d = p - centre;
    return -dot(normal, d) / std::sqrt(dot(d, d)) - dot(normal, centre) / radius;
  };
  const double both = slope(walk.out_at) + slope(walk.in_at);
  const double shift = both != 0.0 ? -(walk.out + walk.in) / both : 0.0;
  if (shift == 0.0 || !std::isfinite(shift)) return std::nullopt;
  return Flat{centre.u + shift * normal.u, centre.v + shift * normal.v, 0.0};
}

std::optional<FittedArc> ArcFitter::finished(const Flat& centre, const ArcWalk& walk) const {
  FittedArc arc{plane_, centre.u, centre.v, walk.clockwise, 1, walk.sweep};
  const bool ends_at_start = end_.u == 0.0 && end_.v == 0.0;
  const double turns = walk.sweep / kTwoPi, whole = std::round(turns);
  if (whole >= 1.0 && std::fabs(turns - whole) * kTwoPi < kNearTurn) {
    if (!ends_at_start) return std::nullopt;
    arc.turns = static_cast<int>(whole);
  } else {
    if (ends_at_start || walk.sweep < 1e-6) return std::nullopt;
    arc.turns = static_cast<int>(std::floor(turns)) + 1;
  }
  if (arc.turns > 1 && !rules_.may_turn_on) return std::nullopt;
  return arc;
}

std::optional<FittedArc> ArcFitter::fit(int plane, std::size_t first, std::size_t last) {
  plane_ = plane;
  flatten(curve_, PlaneOfArcs(plane), first, last, chain_);
  end_ = chain_.back();
  double extent = 0.0;
  const std::size_t count = chain_.size() - 1, samples = std::min(kSamples, count);
  for (std::size_t k = 1; k <= samples; ++k) {
    const Flat& p = chain_[k * count / samples];
    extent = std::max(extent, dot(p, p));
  }
  is_closed_ = dot(end_, end_) < kClosed * kClosed * extent;
  auto centre = guess_centre();
  for (int tries = 0; centre && tries < kTries; ++tries) {
    const Flat c = rounded(*centre, rules_.centre_step);
    const ArcWalk found = walk(c);
    if (found.fits) return finished(c, found);
    if (!found.goes_round || (found.out - found.in) / 2 > tolerance_) return std::nullopt;
    centre = evened(c, found);
  }
  return std::nullopt;
}

}  // namespace toolpace::detail::rewrite
