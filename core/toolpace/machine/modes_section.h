#pragma once
/// [[servo.X.modes]] of machine files.

#include <string>
#include <vector>

#include "toolpace/machine/setup.h"
#include "toolpace/machine/toml_library.h"

namespace toolpace::detail {

/// Errors (usage), with file, line and column: "machine-key", "machine-value".
Result<std::vector<AxisMode>> read_modes(const toml::node& node, const std::string& file, UnknownKeys unknown);

/// Keys and values of a mode as a machine file has them; what goes without saying is left out.
struct ModeText {
  std::string key, value;
  bool operator==(const ModeText&) const = default;
};
std::vector<ModeText> mode_texts(const AxisMode& mode);

/// All of an axis in one line: [{frequency_hz = 40, damping = 0.03}, …]
std::string inline_modes(const std::vector<AxisMode>& modes);
/// All of an axis as sections: [[servo.X.modes]] …
std::string modes_sections(char axis, const std::vector<AxisMode>& modes, const std::string& newline);

}  // namespace toolpace::detail
