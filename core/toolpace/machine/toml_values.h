#pragma once
/// Values of TOML documents, and how messages show them.

#include <optional>
#include <string>

#include "toolpace/base/result.h"
#include "toolpace/machine/toml_library.h"

namespace toolpace::detail {

Location place_in(const std::string& file, const toml::source_region& source);

/// Whole numbers, too. The parser's own conversions take true for 1.
std::optional<double> number_of(const toml::node* node);

/// A value as the message about it shows it: "12.5", "[1, 2]", "a text", "a section", …
std::string shown(const toml::node& node);

}  // namespace toolpace::detail
