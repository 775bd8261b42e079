#include "toolpace/path/node_positions.h"

namespace toolpace {

std::vector<double> node_positions(const std::vector<double>& lengths) {
  std::vector<double> position(lengths.size() + 1, 0.0);
  double sum = 0.0, carry = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double next = sum + lengths[i];
    carry += sum >= lengths[i] ? (sum - next) + lengths[i] : (lengths[i] - next) + sum;
    sum = next;
    position[i + 1] = sum + carry;
  }
  return position;
}

}  // namespace toolpace
