#pragma once
/// Is there a walk along two polylines, never backwards, on which they stay within a distance of each other?

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace toolpace::test {

using Points = std::vector<Eigen::VectorXd>;

/// Part of the segment a b within `most` of p, as parameters 0 … 1.
inline std::optional<std::pair<double, double>> near_part(const Eigen::VectorXd& p, const Eigen::VectorXd& a,
                                                          const Eigen::VectorXd& b, double most) {
  const Eigen::VectorXd d = b - a, e = a - p;
  const double qa = d.squaredNorm(), qc = e.squaredNorm() - most * most;
  if (qa == 0) return qc <= 0 ? std::optional(std::pair(0.0, 1.0)) : std::nullopt;
  const double qb = d.dot(e), disc = qb * qb - qa * qc;
  if (disc < 0) return std::nullopt;
  const double root = std::sqrt(disc), low = std::max(0.0, (-qb - root) / qa), high = std::min(1.0, (-qb + root) / qa);
  return low <= high ? std::optional(std::pair(low, high)) : std::nullopt;
}

/// @source Alt and Godau 1995, "Computing the Fréchet distance between two polygonal curves", the decision problem
inline bool frechet_within(const Points& p, const Points& q, double most) {
  using Part = std::pair<double, double>;
  if ((p.front() - q.front()).norm() > most || (p.back() - q.back()).norm() > most) return false;
  std::map<std::size_t, Part> left;  // segment of q -> reachable part of it at the present vertex of p
  for (std::size_t j = 0; j + 1 < q.size(); ++j) {
    const auto part = near_part(p.front(), q[j], q[j + 1], most);
    if (!part || part->first > 0) break;
    left[j] = *part;
    if (part->second < 1) break;
  }
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    std::map<std::size_t, Part> next;
    bool entered = false;  // from the cell before, through its upper edge
    Part bottom{0, 1};
    std::size_t j = left.empty() ? q.size() : left.begin()->first;
    while (j + 1 < q.size()) {
      const auto here = left.find(j);
      if (here == left.end() && !entered) {
        const auto later = left.upper_bound(j);
        if (later == left.end()) break;
        j = later->first;
        continue;
      }
      if (const auto right = near_part(p[i + 1], q[j], q[j + 1], most)) {
        if (entered) {
          next[j] = *right;
        } else if (right->second >= here->second.first) {
          next[j] = {std::max(right->first, here->second.first), right->second};
        }
      }
      auto top = near_part(q[j + 1], p[i], p[i + 1], most);
      if (top && here == left.end()) {
        if (top->second < bottom.first)
          top.reset();
        else
          top->first = std::max(top->first, bottom.first);
      }
      entered = top.has_value();
      if (top) bottom = *top;
      ++j;
    }
    left.swap(next);
    if (left.empty()) return false;
  }
  const auto end = left.find(q.size() - 2);
  return end != left.end() && end->second.second >= 1 - 1e-12;
}

}  // namespace toolpace::test
