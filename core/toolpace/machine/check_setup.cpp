#include <fmt/format.h>

#include "toolpace/base/numbers.h"
#include "toolpace/machine/setup.h"
#include "toolpace/machine/setup_keys.h"

namespace toolpace {
namespace {

Error bad_limit(const std::string& section, const std::string& key, const std::string& value,
                const std::string& allowed) {
  const std::string place = section.empty() ? "" : "[" + section + "] ";
  return {
      ErrorKind::usage, "bad-limit", fmt::format("{}{} is {}, but must be {}", place, key, value, allowed), "", {}, {}};
}

Result<void> check_section(const SetupSection& section) {
  for (const NumberKey& key : section.numbers) {
    const double value = *key.value / key.unit;
    if (!is_in_range(value, key.range))
      return tl::unexpected(bad_limit(section.name, key.name, to_text(value), range_text(key.range)));
  }
  for (const RangeKey& key : section.ranges) {
    if (is_ordered(key)) continue;
    const std::string ends = fmt::format("[{}, {}]", to_text(*key.low / key.unit), to_text(*key.high / key.unit));
    return tl::unexpected(bad_limit(section.name, key.name, ends, range_text(key)));
  }
  return {};
}

}  // namespace

Result<void> check_setup(const Machine& machine, const PlanOptions& options) {
  Setup copy{machine, options};
  auto sections = setup_sections(copy);
  sections.push_back(job_section(copy.options));
  for (const SetupSection& section : sections) {
    if (auto fine = check_section(section); !fine) return fine;
  }
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    for (AxisMode& mode : copy.machine.servo[axis].modes) {
      const SetupSection section = {std::string("servo.") + kAxisNames[axis] + ".modes", mode_keys(mode), {}, {}};
      if (auto fine = check_section(section); !fine) return fine;
    }
  }
  if (options.lookahead && (*options.lookahead < 1 || *options.lookahead > kDeepestLookahead)) {
    return tl::unexpected(bad_limit("lookahead", "blocks", std::to_string(*options.lookahead),
                                    fmt::format("1 (a stop at every node) to {}, or all", kDeepestLookahead)));
  }
  return {};
}

}  // namespace toolpace
