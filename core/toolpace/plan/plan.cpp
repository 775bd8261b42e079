#include "toolpace/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "toolpace/law/law_table.h"
#include "toolpace/plan/block/block_plan.h"
#include "toolpace/plan/span/dispatch.h"

namespace toolpace {
namespace {

void require(bool condition, const char* what) {
  if (!condition) throw std::invalid_argument(std::string("plan_motion: ") + what);
}

void check_shape(const SpeedLimits& limits) {
  const std::size_t n = limits.size();
  require(limits.block_cap.size() == n && limits.ramp.size() == n, "one cap and one ramp index a block");
  require(n == 0 || limits.node_cap.size() == n + 1, "one cap a node");
  for (std::size_t i = 0; i < n; ++i) {
    require(limits.length[i] > 0 && std::isfinite(limits.length[i]), "lengths are positive and finite");
    require(limits.ramp[i] < limits.dynamics.size(), "ramp indices are in range");
    require(limits.block_cap[i] >= 0 && limits.node_cap[i] >= 0, "caps are not negative");
  }
}

Error unbounded(std::string what, const char* remedy) {
  return {ErrorKind::usage, "limits-unbounded", std::move(what), remedy, {}, {}};
}

/// What bounds a ramp along the path, as people know it.
struct RampSettings {
  const char *acceleration, *jerk;
};
constexpr RampSettings kUpSettings{"--am (max_acceleration_mm_s2 in [path])", "--jm (max_jerk_mm_s3 in [path])"};
constexpr RampSettings kDownSettings{"--dm (max_deceleration_mm_s2 in [path])",
                                     "--jd (max_jerk_deceleration_mm_s3 in [path])"};

std::optional<Error> check_ramp(const RampLimits& r, const LawRow& law, const RampSettings& settings) {
  require(r.acceleration > 0 && r.jerk > 0 && r.time >= 0, "ramp limits are positive");
  if (law.needs_acceleration && std::isinf(r.acceleration)) {
    return unbounded(std::string(settings.acceleration) + " is inf, and nothing else bounds the acceleration",
                     "give --am, or an acceleration for each axis that moves");
  }
  if (law.needs_jerk && std::isinf(r.jerk)) {
    return unbounded(std::string(settings.jerk) + " is inf, and nothing else bounds the jerk, which " +
                         std::string(law.id) + " needs",
                     "give --jm, or a jerk for each axis that moves, or choose another law");
  }
  return std::nullopt;
}

std::optional<Error> check_limits(const SpeedLimits& limits, const LawRow& law) {
  check_shape(limits);
  for (const Dynamics& d : limits.dynamics) {
    if (auto error = check_ramp(d.up, law, kUpSettings)) return error;
    if (auto error = check_ramp(d.down, law, kDownSettings)) return error;
  }
  for (const double cap : limits.block_cap) {
    if (cap == 0) {
      return Error{ErrorKind::infeasible,
                   "feed-zero",
                   "a block's top speed is zero: the motion would never end",
                   "raise the feedrate or the override above 0",
                   {},
                   {}};
    }
    if (std::isinf(cap)) {
      return unbounded("--vmax (max_speed_mm_s in [path]) is inf, and nothing else bounds the speed",
                       "give --vmax, a feedrate, or a speed for each axis that moves");
    }
  }
  return std::nullopt;
}

}  // namespace

Result<MotionPlan> plan_motion(const SpeedLimits& limits, const PlanOptions& options, const Monitor& monitor) {
  if (auto error = check_limits(limits, law_row(options.law))) return tl::make_unexpected(*error);
  if (options.lookahead && *options.lookahead == 0) {
    return tl::make_unexpected(Error{ErrorKind::usage,
                                     "lookahead-zero",
                                     "a look-ahead of 0 blocks cannot move",
                                     "give at least 1 block, or all",
                                     {},
                                     {}});
  }
  if (limits.size() == 0) return MotionPlan{};
  const std::size_t blocks = std::min(limits.size(), options.lookahead.value_or(limits.size()));
  const bool spans = options.ramps == Ramps::span;
  MotionPlan plan = spans ? detail::plan_across_blocks(limits, options.law, blocks, monitor)
                          : detail::plan_block_ramps(limits, options.law, blocks, monitor);
  if (monitor.is_cancelled()) return tl::make_unexpected(cancelled_error());
  return plan;
}

}  // namespace toolpace
