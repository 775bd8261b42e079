#pragma once
/// Numbers as text, always in the C locale.

#include <optional>
#include <string>
#include <string_view>

namespace toolpace {

/// Shortest decimal text that reads back to the same double ("0.1", "1e-09", "inf", "nan").
std::string to_text(double value);

/// Appends the same to `out` without allocating a temporary.
void append_text(std::string& out, double value);

/// The number that the whole of `text` is, denormal ones, "inf" and "nan" included. Nothing where it is none, or one that
/// no double holds.
std::optional<double> parse_number(std::string_view text);

}  // namespace toolpace
