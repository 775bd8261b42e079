#include "toolpace/rewrite/tangents.h"

#include <algorithm>
#include <array>
#include <utility>

namespace toolpace::detail::rewrite {
namespace {

constexpr std::size_t kLeastPoints = 2, kMostPoints = 24;  // on a side
constexpr std::size_t kCertainPoints = 4;
constexpr double kStraight = 0.985;  // chord by way: behind that a curve has turned too far (0.6 rad) to be a parabola

/// Sums for a parabola P = a + b·s + c·s².
struct Parabola {
  std::array<double, 5> moment{1, 0, 0, 0, 0};  // of s; the vertex itself stands at 0
  Eigen::Vector3d plain = Eigen::Vector3d::Zero(), linear = plain, square = plain;

  void add(double s, const Eigen::Vector3d& p) {
    double power = 1.0;
    for (double& m : moment) m += power, power *= s;
    plain += p, linear += s * p, square += s * s * p;
  }

  /// Direction of b; by Cramer's rule, the determinant left out.
  Eigen::Vector3d slope() const {
    const auto& m = moment;
    return (m[0] * m[4] - m[2] * m[2]) * linear - (m[1] * m[4] - m[2] * m[3]) * plain -
           (m[0] * m[3] - m[1] * m[2]) * square;
  }
};

}  // namespace

Tangents::Tangents(const Curve& curve, std::vector<double> reach)
    : curve_(curve), reach_(std::move(reach)), first_(curve.vertex.size(), 0), last_(first_) {
  for (std::size_t k = 1; k < first_.size(); ++k)
    first_[k] = curve.barrier[k - 1] != 0 ? curve.vertex[k - 1] : first_[k - 1];
  last_.back() = curve.vertex.back();
  for (std::size_t k = last_.size() - 1; k-- > 0;)
    last_[k] = curve.barrier[k + 1] != 0 ? curve.vertex[k + 1] : last_[k + 1];
}

Eigen::Vector3d Tangents::arriving(std::size_t vertex) const {
  const double reach = reach_[vertex - 1];
  const bool is_end = curve_.barrier[vertex] != 0;
  return direction(vertex, is_end ? 2 * reach : std::min(reach, reach_[vertex]),
                   is_end ? 0.0 : std::min(reach, reach_[vertex]));
}

Eigen::Vector3d Tangents::leaving(std::size_t vertex) const {
  if (curve_.barrier[vertex] == 0) return arriving(vertex);
  return direction(vertex, 0.0, 2 * reach_[vertex]);
}

/// @param back, on  how far points are looked at before and behind [mm]; 0 = none
Eigen::Vector3d Tangents::direction(std::size_t vertex, double back, double on) const {
  const std::size_t here = curve_.vertex[vertex];
  const Eigen::Vector3d& origin = curve_.point[here];
  Parabola parabola;
  std::size_t seen = 0;
  const double scale = 1.0 / std::max({back, on, 1e-9});
  const auto look = [&](double reach, std::size_t end, bool is_back) {
    double way = 0.0;
    std::size_t k = here;
    for (std::size_t n = 0; k != end && n < kMostPoints && (way < reach || n < kLeastPoints); ++n, ++seen) {
      const std::size_t next = is_back ? k - 1 : k + 1;
      way += (curve_.point[next] - curve_.point[k]).norm();
      const Eigen::Vector3d off = curve_.point[next] - origin;
      if (n >= kCertainPoints && off.norm() < kStraight * way) return;
      parabola.add(is_back ? -way * scale : way * scale, off);
      k = next;
    }
  };
  if (back > 0.0) look(back, first_[vertex], true);
  if (on > 0.0) look(on, last_[vertex], false);
  Eigen::Vector3d slope = parabola.slope();
  if (seen < 2) slope = back > 0.0 ? origin - curve_.point[here - 1] : curve_.point[here + 1] - origin;
  const double length = slope.norm();
  return length > 0.0 ? Eigen::Vector3d(slope / length) : Eigen::Vector3d::Zero();
}

}  // namespace toolpace::detail::rewrite
