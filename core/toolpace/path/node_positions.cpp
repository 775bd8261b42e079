#include "toolpace/path/node_positions.h"

namespace toolpace {
namespace {

/// Neumaier's sum of values that are not negative.
class Sum {
 public:
  void add(double value) {
    const double next = sum_ + value;
    carry_ += sum_ >= value ? (sum_ - next) + value : (value - next) + sum_;
    sum_ = next;
  }
  double value() const { return sum_ + carry_; }
  /// What rounding takes from the value.
  double rest() const { return (sum_ - value()) + carry_; }

 private:
  double sum_ = 0.0, carry_ = 0.0;
};

}  // namespace

NodePositions::NodePositions(const std::vector<double>& lengths)
    : sum_(lengths.size() + 1, 0.0), rest_(lengths.size() + 1, 0.0f) {
  Sum sum;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    sum.add(lengths[i]);
    sum_[i + 1] = sum.value();
    rest_[i + 1] = static_cast<float>(sum.rest());
  }
}

}  // namespace toolpace
