#include "toolpace/kinematics/inverse.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "toolpace/kinematics/links.h"

namespace toolpace {
namespace {

using detail::Link;
using detail::links_of;
using Eigen::Vector3d;

constexpr double kSame = 1e-9;  // [rad] as good as the same direction: a tool of 100 mm is 0.1 nm off at its end

double angle_between(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

double angle_about(const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
  return std::atan2(axis.dot(from.cross(to)), from.dot(to) - axis.dot(from) * axis.dot(to));
}

bool is_along(const Vector3d& v, const Vector3d& axis) { return v.cross(axis).norm() < kSame; }

Error unreachable(double missing) {
  Error error{
      ErrorKind::infeasible, "tool-direction-unreachable",
      fmt::format("the rotary axes cannot point the tool so: {:.3g} deg are missing", missing / kRadiansPerDegree),
      "tilt the tool less, or check the directions of the rotary axes in [kinematics]"};
  error.attainable = missing;
  return error;
}

class Solver {
 public:
  Solver(std::vector<Link> links, const Vector3d& tool, const AxisVector& near, const RotaryTravel& travel)
      : links_(std::move(links)), tool_(tool), near_(near), travel_(travel) {}

  Result<std::vector<AxisVector>> solve() {
    const double missing = missing_angle();
    if (missing > kSame) return tl::unexpected(unreachable(missing));
    for (const Vector3d& between : vectors_between()) add(between);
    if (!found_.empty()) {
      std::stable_sort(found_.begin(), found_.end(),
                       [&](const AxisVector& a, const AxisVector& b) { return turn(a) < turn(b); });
      prefer_larger_angle();
      return std::move(found_);
    }
    return tl::unexpected(Error{ErrorKind::infeasible, "rotary-travel",
                                fmt::format("{} would have to turn beyond its travel to point the tool so", beyond_),
                                "give the axis more travel, or tilt the tool otherwise"});
  }

 private:
  void prefer_larger_angle() {
    if (found_.size() < 2 || turn(found_[1]) - turn(found_[0]) > kSame) return;
    const auto next_to_tool = static_cast<Eigen::Index>(links_.front().axis);
    if (found_[1][next_to_tool] > found_[0][next_to_tool] + kSame) std::swap(found_[0], found_[1]);
  }

  // The joint next to the tool may turn the tool about itself, or both may turn about the same line: one joint is left.
  bool has_two() const {
    return links_.size() == 2 && !is_along(kTool, links_[0].direction) &&
           !is_along(links_[0].direction, links_[1].direction);
  }

  // The tool as the joints that do not count leave it.
  Vector3d held_tool() const {
    if (links_.size() < 2) return kTool;
    return Eigen::AngleAxisd(present(links_[0]), links_[0].direction) * kTool;
  }

  double present(const Link& link) const { return link.sign * near_[static_cast<Eigen::Index>(link.axis)]; }

  double missing_angle() const {
    if (links_.empty()) return angle_between(kTool, tool_);
    const Vector3d& outer = links_.back().direction;
    const double wanted = angle_between(tool_, outer);
    if (!has_two()) return std::fabs(wanted - angle_between(held_tool(), outer));
    const double apart = angle_between(links_[0].direction, outer), cone = angle_between(kTool, links_[0].direction);
    const double widest = std::min(apart + cone, 2 * std::numbers::pi - apart - cone);
    return std::max({std::fabs(apart - cone) - wanted, wanted - widest, 0.0});
  }

  // What the joint next to the tool may make of it, so that the other one can do the rest.
  std::vector<Vector3d> vectors_between() const {
    if (!has_two()) return {held_tool()};
    const Vector3d &u = links_[1].direction, &w = links_[0].direction;
    const double k = u.dot(w), p = tool_.dot(u), q = kTool.dot(w), rest = 1 - k * k;
    const double a = (p - k * q) / rest, b = (q - k * p) / rest;
    // Of the determinant of u, w and the vector, whose square is that of their cosines; in half angles, as cosines of small
    // angles have lost theirs.
    const double of_u = angle_between(tool_, u), of_w = angle_between(kTool, w), apart = angle_between(u, w);
    const double half = (of_u + of_w + apart) / 2;
    const double square = std::sin(half) * std::sin(half - of_u) * std::sin(half - of_w) * std::sin(half - apart);
    const double height = 2 * std::sqrt(std::max(0.0, square)) / rest;
    const Vector3d foot = a * u + b * w, normal = u.cross(w);
    if (height < kSame) return {foot.normalized()};
    return {foot + height * normal, foot - height * normal};
  }

  void add(const Vector3d& between) {
    AxisVector axes = near_;
    if (has_two() && !place(links_[0], angle_about(links_[0].direction, kTool, between), axes)) return;
    if (!links_.empty() && !is_along(between, links_.back().direction) &&
        !place(links_.back(), angle_about(links_.back().direction, between, tool_), axes)) {
      return;
    }
    found_.push_back(axes);
  }

  // The turns of an angle that lie nearest to where the axis is, inside its travel.
  bool place(const Link& link, double turned, AxisVector& axes) {
    const double angle = link.sign * turned, near = near_[static_cast<Eigen::Index>(link.axis)];
    const double least = std::ceil((travel_.low[link.axis] - angle - kSame) / kTwoPi);
    const double most = std::floor((travel_.high[link.axis] - angle + kSame) / kTwoPi);
    if (least > most) {
      beyond_ = kAxisNames[link.axis];
      return false;
    }
    axes[static_cast<Eigen::Index>(link.axis)] =
        angle + kTwoPi * std::clamp(std::round((near - angle) / kTwoPi), least, most);
    return true;
  }

  double turn(const AxisVector& axes) const { return (axes - near_).cwiseAbs().maxCoeff(); }

  inline static const Vector3d kTool = Vector3d::UnitZ();

  std::vector<Link> links_;
  Vector3d tool_;
  const AxisVector& near_;
  const RotaryTravel& travel_;
  std::vector<AxisVector> found_;
  char beyond_ = ' ';
};

}  // namespace

RotaryTravel RotaryTravel::unbounded() {
  RotaryTravel travel;
  travel.low.fill(-std::numeric_limits<double>::infinity());
  travel.high.fill(std::numeric_limits<double>::infinity());
  return travel;
}

Result<std::vector<AxisVector>> rotary_solutions(const Chain& chain, const Vector3d& tool, const AxisVector& near,
                                                 const RotaryTravel& travel) {
  return Solver(links_of(chain), tool.normalized(), near, travel).solve();
}

Result<AxisVector> inverse(const Chain& chain, const ToolPose& pose, const AxisVector& near,
                           const RotaryTravel& travel) {
  return rotary_solutions(chain, pose.tool, near, travel).map([&](const std::vector<AxisVector>& ways) {
    return axes_at(chain, pose.tip, ways.front());
  });
}

}  // namespace toolpace
