#include <fmt/format.h>

#include <cmath>

#include "toolpace/base/numbers.h"
#include "toolpace/machine/setup.h"
#include "toolpace/machine/setup_keys.h"

namespace toolpace {
namespace {

constexpr double kShortestPeriod = 1e-6 * (1 - 1e-9);  // [s] no drive is that fast, and no disk that large

Error bad_limit(std::string what, std::string remedy) {
  return {ErrorKind::usage, "bad-limit", std::move(what), std::move(remedy), {}, {}};
}

}  // namespace

Result<void> check_setup(const Machine& machine, const PlanOptions& options) {
  Setup copy{machine, options};
  for (const SetupSection& section : setup_sections(copy)) {
    for (const NumberKey& key : section.numbers) {
      const bool unset_steps = key.value != nullptr && *key.value == 0 && key.name.rfind("steps_per", 0) == 0;
      if (!is_in_range(*key.value, key.range) && !unset_steps) {
        return tl::unexpected(bad_limit(
            fmt::format("[{}] {} is {}, which makes no sense", section.name, key.name, to_text(*key.value / key.unit)),
            fmt::format("give a value {}", range_text(key.range))));
      }
    }
  }
  if (!(std::isfinite(machine.period) && machine.period >= kShortestPeriod)) {
    return tl::unexpected(bad_limit(fmt::format("a period of {:.6g} ms makes no sense", machine.period * 1e3),
                                    "give 0.001 ms or more, such as 1 ms"));
  }
  if (options.lookahead && *options.lookahead < 1) {
    return tl::unexpected(bad_limit("the look-ahead is 0 blocks", "give 1 (a stop at every node) or more, or all"));
  }
  if (!(options.feed_override > 0 && options.feed_override <= 2)) {
    return tl::unexpected(bad_limit("the feed override is outside 0 … 200 %, or 0, at which the program never ends",
                                    "give more than 0 and at most 200 %"));
  }
  if (!(options.rapid_override > 0 && options.rapid_override <= 1)) {
    return tl::unexpected(
        bad_limit("the rapid override is outside 0 … 100 %, or 0", "give more than 0 and at most 100 %"));
  }
  if (options.corner.step && !(*options.corner.step > 0)) {
    return tl::unexpected(bad_limit("the corner's speed step is not above 0", "give a speed in mm/s"));
  }
  if (options.hold_at && !(*options.hold_at >= 0)) {
    return tl::unexpected(bad_limit("the time of the feed hold is no number of 0 s or more", "give 0 s or later"));
  }
  return {};
}

}  // namespace toolpace
