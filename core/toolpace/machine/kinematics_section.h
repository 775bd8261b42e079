#pragma once
/// [kinematics] of machine files.

#include <string>

#include "toolpace/kinematics/chain.h"
#include "toolpace/machine/setup.h"
#include "toolpace/machine/toml_library.h"

namespace toolpace::detail {

/// Errors (usage), with file, line and column: "machine-key", "machine-value".
Result<Kinematics> read_kinematics(const toml::node& node, const std::string& file, UnknownKeys unknown);

/// The section as a machine file has it; empty for a machine without a chain.
std::string kinematics_text(const Kinematics& kinematics);

}  // namespace toolpace::detail
