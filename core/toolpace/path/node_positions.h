#pragma once
/// Path positions of the places where segments meet.

#include <cstddef>
#include <vector>

namespace toolpace {

/// What lies before each node of a chain: sums of the lengths, one more than there are lengths, the first one 0. Compensated
/// (Neumaier), so that the error of 10⁶ additions stays that of one; and what even that rounding leaves is kept, so that a way
/// between two nodes is as exact as its own length lets it be, however long the path before it is.
class NodePositions {
 public:
  NodePositions() = default;
  /// @param lengths  [mm] ≥ 0
  explicit NodePositions(const std::vector<double>& lengths);

  std::size_t size() const { return sum_.size(); }
  bool empty() const { return sum_.empty(); }
  double operator[](std::size_t node) const { return sum_[node]; }
  double front() const { return sum_.front(); }
  double back() const { return sum_.back(); }
  auto begin() const { return sum_.begin(); }
  auto end() const { return sum_.end(); }

  /// Path length from one node to another [mm], negative backwards.
  double between(std::size_t from, std::size_t to) const {
    return (sum_[to] - sum_[from]) + (static_cast<double>(rest_[to]) - static_cast<double>(rest_[from]));
  }

 private:
  std::vector<double> sum_;
  std::vector<float> rest_;  ///< the sum proper less the rounded one
};

}  // namespace toolpace
