#pragma once
/// Machine files: a machine and the defaults of its jobs, as TOML.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/kinematics/chain.h"
#include "toolpace/limits/machine.h"
#include "toolpace/plan/options.h"

namespace toolpace {

struct Setup {
  Machine machine;
  PlanOptions options;
  Kinematics kinematics = {};
  Diagnostics warnings = {};  ///< what settings of another controller left open
};

/// What holds without a machine file: path limits 100 mm/s, 3000 mm/s², 1e6 mm/s³, axes unlimited, 1 ms.
Setup default_setup();

/// What to make of keys and sections that are not known: those of a later version may be worth keeping.
enum class UnknownKeys : std::uint8_t { refuse, pass_over };

/// Reads a machine file. A missing key means no limit. Errors (usage), with file, line and column, for bad syntax ("machine-syntax"), an unknown key or section, naming the nearest known one
/// ("machine-key"), or a value that makes no sense, naming what would ("machine-value").
Result<Setup> parse_setup(std::string_view text, const std::string& name, UnknownKeys unknown = UnknownKeys::refuse);
/// Reads at most 1 MiB: a file of settings has thousands of bytes. Errors: io, cancelled, "machine-syntax".
Result<std::string> read_settings_text(const std::filesystem::path& file, const Monitor& monitor = {});

/// The setup as a new machine file. What it holds reads back to the same values, or it is refused: with the error of
/// check_setup(), or "machine-unwritable" for what no text can hold.
Result<std::string> format_setup(const Setup& setup);

/// The machine file `text` with the values of `setup`: only values that differ are written, in their place. Comments,
/// order, layout and keys that are not known stay as they are; missing keys are added at the end of their section,
/// missing sections at the end of the file, and limits that are none any more leave it. Nothing differs: the same bytes.
/// Errors: of parse_setup() for `text`, of format_setup() for `setup`.
Result<std::string> edit_setup(std::string_view text, const std::string& name, const Setup& setup);

/// Whether a machine file holds the same for both: what only a job says (overrides, feed hold) is left aside.
bool is_same_file(const Setup& a, const Setup& b);

/// Limits and options that no plan can be made with: each number in the range of its key (setup_keys.h), travel in order,
/// depth 1 or more. Every door (flags, file, import, panel) goes through here. Errors (usage): "bad-limit".
Result<void> check_setup(const Machine& machine, const PlanOptions& options);

}  // namespace toolpace
