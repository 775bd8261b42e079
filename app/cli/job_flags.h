#pragma once
/// The flags of every command that plans: machine, law, limits, look-ahead, corners.

#include <optional>
#include <string>
#include <vector>

#include "command_line.h"
#include "toolpace/machine/setup_keys.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::cli {

struct JobFlags {
  std::string machine, law, lookahead, ramps, corner;
  std::optional<double> tacc_ms, tdec_ms, am, dm, jm, jd, vmax, corner_step, tolerance, junction_deviation;
  std::optional<double> override_percent, rapid_percent, period_ms, hold_at;

  void add_to(Command& command);

  /// The machine file (or the defaults) with the flags on top. Usage and io errors.
  Result<Setup> setup() const;

  /// Those flags that were given, and change nothing in an outcome: "--law", …
  std::vector<std::string> ignored_in(const Outcome& outcome) const;
};

/// Stores what --law and --corner name, where they are given. Usage errors (bad-flag).
Result<void> pick_law(const std::string& word, LawKind& law);
Result<void> pick_corner(const std::string& word, CornerRule& rule);

/// Stores the value of a flag, where it is given, as the machine file would store this number (see find_number()).
/// Usage error that names the flag and what it may be where the value makes no sense.
Result<void> set_flag(Setup& setup, const char* flag, const std::optional<double>& value, const std::string& section,
                      const char* key);

}  // namespace toolpace::cli
