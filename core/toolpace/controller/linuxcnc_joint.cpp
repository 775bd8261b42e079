/// Corners of LinuxCNC: tangent, rounded by an arc, parabolic.

#include <algorithm>
#include <numbers>

#include <Eigen/Geometry>

#include "toolpace/controller/linuxcnc_segment.h"

namespace toolpace::detail::controller {
namespace {

constexpr double kReversal = 2.0 * std::numbers::pi / 180.0;  // [rad]
constexpr double kLeastAngle = 1e-3;                          // [rad]
constexpr double kLeastBlend = 1e-6;                          // [mm]
constexpr double kLeastRadius = 1e-12;                        // [mm]
constexpr double kToleranceShare = 0.25;                      // of a length, where no tolerance is given
constexpr double kTakenShare = 0.5;                           // of a segment that a blend may take
constexpr double kLeastCycles = 1.02;                         // of a segment

/// A corner as if both sides were lines.
struct Corner {
  double theta = 0;  ///< half the angle between the two, π/2 where they are straight
  double phi = 0;    ///< the angle by which the path turns
  double tolerance = 0;
  double first = 0, second = 0;  ///< [mm] that may be taken of each
  double acceleration = 0, wanted = 0, most = 0;
  double speed = 0, radius = 0, distance = 0;  ///< found
};

double half_angle(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  return 0.5 * std::acos(std::clamp(-u.dot(v), -1.0, 1.0));
}

double blend_tolerance(const Segment& a, const Segment& b) {
  const double first = a.programmed * kToleranceShare, second = b.programmed * kToleranceShare;
  return std::min({a.tolerance > 0 ? a.tolerance : first, b.tolerance > 0 ? b.tolerance : second, first, second});
}

/// The lowest bound in the plane with this normal.
double in_plane(const Eigen::Vector3d& normal, const Eigen::Vector3d& bounds) {
  double least = 1e99;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double part = std::sqrt(std::max(0.0, 1.0 - normal[k] * normal[k]));
    if (part > 1e-9) least = std::min(least, bounds[k] / part);
  }
  return least;
}

void set_ending(Segment& before, Segment& next, Ending ending) {
  next.blends_before = ending == Ending::parabolic;
  before.ending = ending;
}

void remove_kink(Segment& before, Segment& next) {
  before.kink_speed = -1;
  before.kink_loss = 0;
  next.kink_loss_before = 0;
}

enum class Kink : std::uint8_t { none, settled, open };

/// Whether the two may follow each other as if they were tangent.
Kink check_kink(Segment& before, Segment& next, const JointLimits& limits) {
  if (before.has_rotary || next.has_rotary || before.ending == Ending::stop) return Kink::none;
  if (before.end_tangent.dot(next.start_tangent) < 0 &&
      (before.end_tangent + next.start_tangent).squaredNorm() < kReversal * kReversal) {
    set_ending(before, next, Ending::stop);
    return Kink::none;
  }
  const double speed = std::min(before.target(limits.feed_scale), next.target(limits.feed_scale));
  const double jump = speed / limits.cycle + next.acceleration;
  const Eigen::Vector3d change = (next.start_tangent - before.end_tangent) * jump;
  double share = change.cwiseAbs().cwiseQuotient(limits.axis_acceleration).maxCoeff();
  if (before.shape == Shape::arc || next.shape == Shape::arc) share /= kTangentialShare;
  const bool is_tangent = share < limits.kink_ratio;
  before.kink_speed = is_tangent ? speed : speed * limits.kink_ratio / share;
  const double loss = is_tangent ? share : limits.kink_ratio;
  before.kink_loss = std::max(before.kink_loss, loss);
  next.kink_loss_before = std::max(next.kink_loss_before, loss);
  if (is_tangent) set_ending(before, next, Ending::tangent);
  return is_tangent ? Kink::settled : Kink::open;
}

/// Bends away from the other side of the corner, so that a chord stands for it.
bool is_convex(const Segment& arc, const Eigen::Vector3d& corner, const Eigen::Vector3d& other, bool is_second) {
  const bool inwards = (corner - arc.centre).dot(other) < 0;
  return is_second ? !inwards : inwards;
}

/// What an arc beside a corner allows. @param most  [rad] that may be taken of it
double arc_share(const Segment& arc, const Eigen::Vector3d& corner, const Eigen::Vector3d& other, bool is_second,
                 double theta, double& most, double& effective) {
  const bool convex = is_convex(arc, corner, other, is_second);
  most = std::min(arc.sweep * (is_second ? 1.0 : 2.0) / 3.0, convex ? theta : 0.5 * std::numbers::pi);
  if (!convex) return most * arc.radius;
  effective = std::min(effective, theta - most / 4.0);
  return std::sin(most / 4.0) * arc.radius;
}

bool find_corner(const Segment& a, const Segment& b, const JointLimits& limits, Corner& c, double& first_angle,
                 double& second_angle) {
  const Eigen::Vector3d binormal = a.end_tangent.cross(b.start_tangent).normalized();
  for (const Segment* arc : {&a, &b}) {
    if (arc->shape == Shape::arc && std::abs(std::abs(binormal.dot(arc->normal)) - 1.0) > 1e-6) return false;
  }
  const double theta = half_angle(a.end_tangent, b.start_tangent);
  c.theta = theta;
  c.first = std::min(a.length, a.programmed * kTakenShare);
  c.second = (a.shape == Shape::arc ? b.programmed : b.length) * kTakenShare;
  if (a.shape == Shape::arc) c.first = arc_share(a, a.to, b.start_tangent, false, theta, first_angle, c.theta);
  if (b.shape == Shape::arc) c.second = arc_share(b, b.from, a.end_tangent, true, theta, second_angle, c.theta);
  if (a.shape == Shape::arc && b.shape == Shape::arc && c.theta < std::numbers::pi / 12.0) return false;
  c.phi = std::numbers::pi - 2.0 * c.theta;
  c.tolerance = blend_tolerance(a, b);
  c.acceleration = in_plane(binormal, limits.axis_acceleration);
  c.wanted = std::max(a.wanted, b.wanted);
  const double planar = in_plane(binormal, limits.axis_velocity);
  double altitude = 0;
  if (a.shape == Shape::line && b.shape == Shape::line) {
    const double cosine = std::cos(std::min(c.phi, 0.49 * std::numbers::pi));
    const double v1 = std::min(a.top, b.top / cosine), v2 = std::min(b.top, a.top / cosine);
    const double base = (b.start_tangent * v2 - a.end_tangent * v1).norm();
    altitude = base > 0 ? v1 * v2 * std::sin(c.phi) / base : 0;
  }
  c.most = std::min(c.wanted * limits.feed_scale, std::max(altitude, planar));
  return c.theta >= kLeastAngle && c.phi >= kLeastAngle;
}

/// Radius and speed of the arc that rounds a corner.
bool size_blend(Corner& c) {
  const double normal = c.acceleration * kNormalShare;
  const double by_tolerance = std::cos(c.theta) * c.tolerance / (1.0 - std::sin(c.theta));
  const double distance = std::min({c.first, c.second, by_tolerance});
  const double largest = std::tan(c.theta) * distance;
  c.speed = std::min(std::sqrt(normal * largest), c.most);
  const double a = 0.5 * c.acceleration;
  const double time = std::min(std::sqrt(2.0 * a * distance), c.speed) / a;
  c.radius = std::max(c.speed * c.speed / normal, std::min(time * c.speed / c.phi, largest));
  c.distance = c.radius / std::tan(c.theta);
  return c.radius >= kLeastRadius && c.radius * c.phi >= kLeastBlend;
}

void cut_end(Segment& s, double by) {
  s.length -= by;
  if (s.shape == Shape::line) {
    s.to -= s.end_tangent * by;
  } else {
    s.sweep -= by / s.radius;
  }
}

void cut_start(Segment& s, double by) {
  s.length -= by;
  if (s.shape == Shape::line) {
    s.from += s.start_tangent * by;
  } else {
    s.sweep -= by / s.radius;
  }
}

bool make_blend(const Segment& a, const Segment& b, const JointLimits& limits, Segment& blend, Corner& c) {
  if (!limits.arc_blends || a.ending != Ending::parabolic || a.has_rotary || b.has_rotary) return false;
  if (a.shape == Shape::blend || b.shape == Shape::blend) return false;
  double first_angle = 1e9, second_angle = 1e9;
  if (!find_corner(a, b, limits, c, first_angle, second_angle) || !size_blend(c)) return false;
  if (a.shape == Shape::arc && c.distance / a.radius > first_angle) return false;
  if (b.shape == Shape::arc && c.distance / b.radius > second_angle) return false;
  blend = Segment{};
  blend.shape = Shape::blend;
  blend.is_rapid = a.is_rapid;
  blend.row = a.row;
  blend.wanted = c.wanted;
  blend.top = c.speed;
  blend.acceleration = c.acceleration;
  blend.tangential = kTangentialShare;
  blend.length = blend.programmed = c.radius * c.phi;
  blend.start_tangent = blend.start_pull = a.end_tangent;
  blend.end_tangent = blend.end_pull = b.start_tangent;
  blend.cruise = TimeLimit::corner;
  blend.is_final = true;
  return true;
}

}  // namespace

ParabolicSpeeds parabolic_speeds(const Segment& a, const Segment& b, double scale) {
  const auto reach = [scale](const Segment& s) {
    return std::min(std::sqrt(s.path_acceleration() * s.length * (s.is_final ? 1.0 : 0.5)), s.target(scale));
  };
  const double a1 = a.path_acceleration(), a2 = b.path_acceleration(), v1 = reach(a), v2 = reach(b);
  const double time = std::min(std::min(a.length / v1, b.length / v2), std::max(v1 / a1, v2 / a2));
  ParabolicSpeeds speeds{std::min(v1, time * a1), std::min(v2, time * a2), 0};
  const double theta = half_angle(a.end_pull, b.start_pull);
  if (a.tolerance > 0 && std::cos(theta) > std::cos(0.5 * std::numbers::pi - kLeastAngle)) {
    const double most = 2.0 * std::sqrt(a1 * a.tolerance / std::cos(theta));
    speeds.first = std::min(speeds.first, most);
    speeds.second = std::min(speeds.second, most);
  }
  speeds.net = std::sin(theta) * 0.5 * (speeds.first + speeds.second);
  return speeds;
}

void finalize(Segment& s, double cycle) {
  if (s.is_final) return;
  if (s.shape == Shape::arc) {
    const double a = s.overall_acceleration(), wanted = s.top * s.top / s.bend;
    s.tangential = kTangentialShare;
    if (wanted > kNormalShare * a) {
      s.top = std::sqrt(kNormalShare * a * s.bend);
    } else {
      s.tangential = std::sqrt(1.0 - (wanted / a) * (wanted / a));
    }
  }
  s.top = std::min(s.top, s.length / (cycle * kLeastCycles));
  s.is_final = true;
}

bool join(Segment& before, Segment& next, const JointLimits& limits, Segment& blend, bool& consumed) {
  consumed = false;
  if (before.is_rapid != next.is_rapid) set_ending(before, next, Ending::stop);
  if (check_kink(before, next, limits) != Kink::open || before.ending != Ending::parabolic) return false;
  Corner corner;
  const bool has_arc = make_blend(before, next, limits, blend, corner);
  const double by_arc = has_arc ? blend.top : 0.0, as_tangent = before.kink_speed;
  const double parabolic = 0.5 * parabolic_speeds(before, next, limits.feed_scale).net;
  if (parabolic >= as_tangent && parabolic >= by_arc) {
    remove_kink(before, next);
    set_ending(before, next, Ending::parabolic);
    return false;
  }
  set_ending(before, next, Ending::tangent);
  if (as_tangent >= by_arc) return false;
  remove_kink(before, next);
  const double rest = before.length - corner.distance;
  consumed = before.shape == Shape::line && rest / corner.speed < limits.gap_cycles * limits.cycle;
  if (consumed) {
    blend.length += rest;
  } else {
    cut_end(before, corner.distance);
  }
  cut_start(next, corner.distance);
  blend.ending = Ending::tangent;
  return true;
}

}  // namespace toolpace::detail::controller
