#pragma once
/// Path positions of the places where segments meet.

#include <vector>

namespace toolpace {

/// Sums of the lengths, one more than there are lengths, the first one 0; compensated (Neumaier), so that the error of 10⁶
/// additions stays that of one.
std::vector<double> node_positions(const std::vector<double>& lengths);

}  // namespace toolpace
