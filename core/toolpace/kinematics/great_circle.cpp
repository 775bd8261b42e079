#include "toolpace/kinematics/great_circle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "toolpace/kinematics/inverse.h"
#include "toolpace/kinematics/links.h"

namespace toolpace {
namespace {

using detail::Link;
using Eigen::Vector3d;

constexpr double kPlaceTurn = 0.15;   // [rad] of the rotary axes together, from place to place
constexpr double kLeastShare = 1e-7;  // a step that is to be shorter leads into a pole
constexpr double kSameAngle = 1e-6;   // [rad] of angles at which one arrives
constexpr double kNoWay = 1e-9;       // [rad] between directions that are the same
constexpr double kNoPlane = 1e-6;     // [rad] from opposite directions
constexpr double kSingular = 1e-12;   // of the sine between both joints' effects
constexpr double kLooks[] = {0.13, 0.29, 0.5, 0.71, 0.87};

/// Even turning in a plane.
class Circle {
 public:
  Circle(const Vector3d& from, const Vector3d& to)
      : from_(from), angle_(std::atan2(from.cross(to).norm(), from.dot(to))) {
    const Vector3d side = to - from * from.dot(to);
    side_ = angle_ > kNoWay ? side.normalized() : Vector3d::Zero();
  }

  double angle() const { return angle_; }
  Vector3d at(double share) const { return std::cos(share * angle_) * from_ + std::sin(share * angle_) * side_; }
  Vector3d first(double share) const {
    return angle_ * (std::cos(share * angle_) * side_ - std::sin(share * angle_) * from_);
  }
  Vector3d second(double share) const { return -angle_ * angle_ * at(share); }

 private:
  Vector3d from_, side_;
  double angle_;
};

class PlaneTurner {
 public:
  PlaneTurner(const Chain& chain, const AxisVector& from, const AxisVector& to)
      : chain_(chain),
        links_(detail::links_of(chain)),
        from_(from),
        to_(to),
        circle_(forward(chain, from).tool, forward(chain, to).tool) {}

  /// Opposite directions have many.
  bool has_plane() const { return circle_.angle() < std::numbers::pi - kNoPlane; }

  bool is_even() const {
    return std::all_of(std::begin(kLooks), std::end(kLooks), [&](double share) {
      return off(from_.tail<3>() + share * (to_ - from_).tail<3>(), share) <= kInPlane;
    });
  }

  std::optional<std::vector<SharePlace>> run() const {
    if (links_.size() < 2 || circle_.angle() <= kNoWay) return {};
    std::vector<SharePlace> places{{0.0, place_at(0.0, from_)}};
    const double most = kPlaceTurn / circle_.angle();
    for (double step = std::min(1.0, most); places.back().share < 1;) {
      const double share = places.back().share + step >= 1 - kLeastShare ? 1.0 : places.back().share + step;
      const auto next = step_to(places.back(), share);
      if (!next) {
        step /= 2;
        if (step < kLeastShare) return {};
        continue;
      }
      if (share == 1 && (next->angle - to_.tail<3>()).cwiseAbs().maxCoeff() > kSameAngle) return {};
      places.push_back({share, *next});
      step = std::min(2 * step, most);
    }
    places.back().place.angle = to_.tail<3>();
    return places;
  }

 private:
  double off(const Vector3d& angles, double share) const {
    AxisVector axes = from_;
    axes.tail<3>() = angles;
    const Vector3d tool = forward(chain_, axes).tool, there = circle_.at(share);
    return std::atan2(tool.cross(there).norm(), tool.dot(there));
  }

  /// None where the polynomial that leads there leaves the plane.
  std::optional<RotaryPlace> step_to(const SharePlace& from, double share) const {
    const double h = share - from.share;
    AxisVector near = from_ + share * (to_ - from_);
    for (const Link& link : links_) {
      const auto k = static_cast<Eigen::Index>(link.axis);
      near[k] = from.place.angle[k - 3] + h * (from.place.first[k - 3] + h / 2 * from.place.second[k - 3]);
    }
    const auto ways = rotary_solutions(chain_, circle_.at(share), near);
    if (!ways) return {};
    const RotaryPlace to = place_at(share, ways->front());
    if ((to.angle - from.place.angle).cwiseAbs().sum() > kPlaceTurn) return {};
    const RotaryTurn turn = turn_between(from.place, to, h);
    const bool stays = std::all_of(std::begin(kLooks), std::end(kLooks), [&](double part) {
      return off(turn.at(part * h)[0], from.share + part * h) <= kInPlane;
    });
    return stays ? std::optional(to) : std::nullopt;
  }

  RotaryPlace place_at(double share, const AxisVector& axes) const {
    RotaryPlace place{axes.tail<3>(), (to_ - from_).tail<3>(), Vector3d::Zero()};
    const Link &farther = links_[1], &nearer = links_[0];
    const auto far_axis = static_cast<Eigen::Index>(farther.axis), near_axis = static_cast<Eigen::Index>(nearer.axis);
    const Vector3d d = circle_.at(share), d1 = circle_.first(share), &u = farther.direction;
    const Vector3d w = Eigen::AngleAxisd(farther.sign * axes[far_axis], u) * nearer.direction;
    // d' = α'·u×d + β'·w×d, and once more.
    const auto [a1, b1] = rates(u.cross(d), w.cross(d), d, d1);
    const Vector3d rest = circle_.second(share) - a1 * u.cross(d1) - b1 * (a1 * u.cross(w).cross(d) + w.cross(d1));
    const auto [a2, b2] = rates(u.cross(d), w.cross(d), d, rest);
    place.first[far_axis - 3] = farther.sign * a1;
    place.first[near_axis - 3] = nearer.sign * b1;
    place.second[far_axis - 3] = farther.sign * a2;
    place.second[near_axis - 3] = nearer.sign * b2;
    return place;
  }

  /// x, y with x·a + y·b = r across d; in the pole, where a vanishes, the farther joint rests.
  static std::pair<double, double> rates(const Vector3d& a, const Vector3d& b, const Vector3d& d, const Vector3d& r) {
    const double sine = d.dot(a.cross(b));
    if (std::fabs(sine) > kSingular) return {d.dot(r.cross(b)) / sine, d.dot(a.cross(r)) / sine};
    return {0.0, b.squaredNorm() > 0 ? b.dot(r) / b.squaredNorm() : 0.0};
  }

  const Chain& chain_;
  std::vector<Link> links_;
  const AxisVector &from_, &to_;
  Circle circle_;
};

}  // namespace

std::optional<std::vector<SharePlace>> turn_in_plane(const Chain& chain, const AxisVector& from, const AxisVector& to) {
  if (from.tail<3>() == to.tail<3>()) return std::vector<SharePlace>{};
  const PlaneTurner turner(chain, from, to);
  if (!turner.has_plane()) return std::nullopt;
  if (turner.is_even()) return std::vector<SharePlace>{};
  return turner.run();
}

}  // namespace toolpace
