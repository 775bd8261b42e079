#pragma once
/// Machine files: a machine and the defaults of its jobs, as TOML.

#include <filesystem>
#include <string>
#include <string_view>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/limits/machine.h"
#include "toolpace/plan/options.h"

namespace toolpace {

struct Setup {
  Machine machine;
  PlanOptions options;
};

/// What holds without a machine file: path limits 100 mm/s, 3000 mm/s², 1e6 mm/s³, axes unlimited, 1 ms.
Setup default_setup();

/// Reads a machine file. A missing key means no limit. Errors: io for a file that cannot be read; cancelled; usage, with file,
/// line and column, for bad syntax ("machine-syntax"), an unknown key or section, naming the nearest known one
/// ("machine-key"), or a value that makes no sense ("machine-value").
Result<Setup> read_setup(const std::filesystem::path& file, const Monitor& monitor = {});
Result<Setup> parse_setup(std::string_view text, const std::string& name);

/// The setup as a machine file that reads back to the same values.
std::string format_setup(const Setup& setup);

/// Limits and options that no plan can be made with: negative or zero limits, period 0, depth 0, override outside 0 …
/// 200 %. Every door (flags, file, panel) goes through here.
Result<void> check_setup(const Machine& machine, const PlanOptions& options);

}  // namespace toolpace
