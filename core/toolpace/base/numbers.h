#pragma once
/// Numbers as text, always in the C locale.

#include <string>

namespace toolpace {

/// Shortest decimal text that reads back to the same double ("0.1", "1e-09", "inf", "nan").
std::string to_text(double value);

/// Appends the same to `out` without allocating a temporary.
void append_text(std::string& out, double value);

}  // namespace toolpace
