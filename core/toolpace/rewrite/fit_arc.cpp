#include "toolpace/rewrite/fit_arc.h"

#include <algorithm>
#include <cmath>

#include "toolpace/base/axes.h"

namespace toolpace::detail::rewrite {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr std::size_t kSamples = 16;  // points that a centre is guessed from
constexpr int kTries = 3;             // centres looked at
constexpr double kClosed = 0.25;   // of the extent: a shorter way from start to end does not tell where the centre lies
constexpr double kMostSine = 0.5;  // of what a chord goes round: 30 degrees; farther, it is a side of a polygon
constexpr double kLeastRadius = 2.0;   // [tolerances]
constexpr double kNearTurn = 0.05;     // [rad] about a whole turn where start and end are too close for comfort
constexpr double kHopeless = 3.0;      // [tolerances] off: no shift of the centre will help
constexpr double kBendOfAngle = 0.02;  // by how much the angle along a chord of 1 rad is off even, at most

/// asin for magnitudes up to kMostSine, to 3e-6.
double small_asin(double s) {
  const double q = s * s;
  return s * (1 + q * (1.0 / 6 + q * (3.0 / 40 + q * (15.0 / 336 + q * (105.0 / 3456 + q * (945.0 / 42240))))));
}

}  // namespace

ArcFitter::ArcFitter(const Curve& curve, const ArcRules& rules, double tolerance)
    : curve_(curve), rules_(rules), tolerance_(tolerance) {}

ArcFitter::Flat ArcFitter::flat(std::size_t point) const {
  const Eigen::Vector3d d = curve_.point[point] - start_;
  return {d[u_], d[v_], d[w_]};
}

/// By least squares of power distances, through the start, and through the end where that is far enough.
std::optional<ArcFitter::Centre> ArcFitter::guess_centre(std::size_t begin, std::size_t end) const {
  const std::size_t count = end - begin, samples = std::min(kSamples, count);
  double suu = 0, suv = 0, svv = 0, su = 0, sv = 0;
  for (std::size_t k = 1; k < samples; ++k) {
    const Flat p = flat(begin + k * count / samples);
    const double power = (p.u * p.u + p.v * p.v) / 2;
    suu += p.u * p.u, suv += p.u * p.v, svv += p.v * p.v, su += p.u * power, sv += p.v * power;
  }
  if (is_closed_) {
    const double det = suu * svv - suv * suv;
    if (!(det > 1e-12 * suu * svv)) return std::nullopt;
    return Centre{(su * svv - sv * suv) / det, (sv * suu - su * suv) / det};
  }
  // The centre is M + h·n, M the middle of the chord, n at right angles to it: p·(M + h·n) = |p|²/2 for all points.
  const double mu = end_.u / 2, mv = end_.v / 2, nu = -end_.v, nv = end_.u;
  const double below = nu * nu * suu + 2 * nu * nv * suv + nv * nv * svv;
  const double above = nu * su + nv * sv - (mu * nu * suu + (mu * nv + mv * nu) * suv + mv * nv * svv);
  if (!(below > 0)) return std::nullopt;
  const double h = above / below;
  return Centre{mu + h * nu, mv + h * nv};
}

ArcFitter::Centre ArcFitter::rounded(const Centre& c) const {
  const double step = rules_.centre_step;
  return {std::round(c.u / step) * step, std::round(c.v / step) * step};
}

/// Which way round the first chords go.
double ArcFitter::sense(const Centre& c, std::size_t begin, std::size_t end) const {
  double sum = 0.0;
  Flat last = flat(begin);
  for (std::size_t k = begin + 1; k <= std::min(end, begin + kSamples); ++k) {
    const Flat p = flat(k);
    sum += (last.u - c.u) * (p.v - c.v) - (last.v - c.v) * (p.u - c.u);
    last = p;
  }
  return sum < 0.0 ? -1.0 : 1.0;
}

ArcFitter::Walk ArcFitter::walk(const Centre& c, std::size_t begin, std::size_t end) {
  Walk result;
  const double radius = std::hypot(c.u, c.v), end_radius = std::hypot(end_.u - c.u, end_.v - c.v);
  if (!(radius >= kLeastRadius * tolerance_ && radius <= rules_.most_radius)) return result;
  const double slack = tolerance_ - std::fabs(end_radius - radius), most = kHopeless * tolerance_;
  turn_ = sense(c, begin, end);
  angle_.assign(end - begin + 1, 0.0);
  double u = -c.u, v = -c.v, rho = radius, angle = 0.0, farthest = 0.0, lag = 0.0, height = 0.0;
  for (std::size_t k = begin + 1; k <= end; ++k) {
    const Flat p = flat(k);
    const double nu = p.u - c.u, nv = p.v - c.v, next = std::sqrt(nu * nu + nv * nv);
    const double cross = turn_ * (u * nv - v * nu), dot = u * nu + v * nv;
    if (!(dot > 0.0) || std::fabs(cross) > kMostSine * rho * next) return result;
    angle += small_asin(cross / (rho * next));
    angle_[k - begin] = angle;
    farthest = std::max(farthest, angle);
    lag = std::max(lag, (farthest - angle) * next);
    // A chord lies inside of its ends by c²/(8ρ) at most.
    const double cu = nu - u, cv = nv - v, least = std::min(rho, next);
    const double inner = least - (cu * cu + cv * cv) / (8 * least) * 1.05 - radius, outer = next - radius;
    if (outer > result.out) result.out = outer, result.out_at = p;
    if (inner < result.in) result.in = inner, result.in_at = p;
    if (outer > most || inner < -most) return result;
    height = std::max(height, std::fabs(p.w));
    u = nu, v = nv, rho = next;
  }
  if (!(angle > 0.0) || lag > tolerance_) return result;
  result.goes_round = true;
  result.sweep = angle;
  const double off = std::max(result.out, -result.in);
  result.fits = std::hypot(off, lag) <= slack;
  if (result.fits && height > 0.0) result.fits = heights_fit(c, begin, end, slack, angle);
  return result;
}

/// The same with the distance along the normal, which the arc goes evenly with its angle.
bool ArcFitter::heights_fit(const Centre& c, std::size_t begin, std::size_t end, double slack, double sweep) {
  const double radius = std::hypot(c.u, c.v), rise = end_.w / sweep;
  double farthest = 0.0, last_off = 0.0, last_angle = 0.0, last_rho = radius;
  Flat last{0, 0, 0};
  for (std::size_t k = begin + 1; k <= end; ++k) {
    const Flat p = flat(k);
    farthest = std::min(sweep, std::max(farthest, angle_[k - begin]));
    const double rho = std::hypot(p.u - c.u, p.v - c.v), step = std::fabs(angle_[k - begin] - last_angle);
    const double height = std::fabs(p.w - rise * farthest);
    const double cu = p.u - last.u, cv = p.v - last.v, least = std::min(rho, last_rho);
    const double inner = radius - least + (cu * cu + cv * cv) / (8 * least) * 1.05;
    const double across = std::max({std::fabs(rho - radius), std::fabs(last_rho - radius), inner});
    const double uneven = kBendOfAngle * step * step * step * std::fabs(rise) +
                          step * std::fabs(rise) * std::fabs(rho - last_rho) / (2 * least);
    const double along = std::max(height, last_off) + uneven;
    const double lag = (farthest - angle_[k - begin]) * rho;
    if (across * across + along * along + lag * lag > slack * slack) return false;
    last = p, last_rho = rho, last_off = height, last_angle = angle_[k - begin];
  }
  return true;
}

/// A centre about which the farthest places outwards and inwards are as far: that of the walk shifted along the line of the
/// centres that are as far from both ends.
std::optional<ArcFitter::Centre> ArcFitter::evened(const Centre& c, const Walk& walk) const {
  if (is_closed_) return std::nullopt;
  const double length = std::hypot(end_.u, end_.v), nu = -end_.v / length, nv = end_.u / length;
  // How the distance of a place to the arc changes with the shift.
  const auto slope = [&](const Flat& p) {
    const double du = p.u - c.u, dv = p.v - c.v, rho = std::hypot(du, dv), radius = std::hypot(c.u, c.v);
    return -(nu * du + nv * dv) / rho - (nu * c.u + nv * c.v) / radius;
  };
  const double both = slope(walk.out_at) + slope(walk.in_at);
  if (both == 0.0) return std::nullopt;
  const double shift = -(walk.out + walk.in) / both;
  if (!std::isfinite(shift)) return std::nullopt;
  return Centre{c.u + shift * nu, c.v + shift * nv};
}

std::optional<FittedArc> ArcFitter::finished(const Centre& c, const Walk& walk, std::size_t end) const {
  FittedArc arc{plane_, c.u, c.v, turn_ < 0.0, 1, walk.sweep};
  const Eigen::Vector3d back = curve_.point[end] - start_;
  const bool ends_at_start = back[u_] == 0.0 && back[v_] == 0.0;
  const double turns = walk.sweep / kTwoPi;
  const double whole = std::round(turns);
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
  u_ = plane == 17 ? 0 : plane == 18 ? 2 : 1;
  v_ = (u_ + 1) % 3;
  w_ = (u_ + 2) % 3;
  const std::size_t begin = curve_.vertex[first], end = curve_.vertex[last];
  start_ = curve_.point[begin];
  end_ = flat(end);
  double extent = 0.0;
  const std::size_t count = end - begin, samples = std::min(kSamples, count);
  for (std::size_t k = 1; k <= samples; ++k) {
    const Flat p = flat(begin + k * count / samples);
    extent = std::max(extent, p.u * p.u + p.v * p.v);
  }
  is_closed_ = end_.u * end_.u + end_.v * end_.v < kClosed * kClosed * extent;
  auto centre = guess_centre(begin, end);
  for (int tries = 0; centre && tries < kTries; ++tries) {
    const Centre c = rounded(*centre);
    const Walk found = walk(c, begin, end);
    if (found.fits) return finished(c, found, end);
    if (!found.goes_round || (found.out - found.in) / 2 > tolerance_) return std::nullopt;
    centre = evened(c, found);
  }
  return std::nullopt;
}

}  // namespace toolpace::detail::rewrite
