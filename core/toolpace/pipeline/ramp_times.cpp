#include "toolpace/pipeline/ramp_times.h"

#include <fmt/format.h>

#include "toolpace/law/law_table.h"
#include "toolpace/plan/plan.h"

namespace toolpace {
namespace {

constexpr double kDearly = 1.5;  // of the time without least durations

}  // namespace

Result<std::optional<Diagnostic>> check_ramp_times(const Outcome& o, const Monitor& monitor) {
  if (!law_row(o.ran.law).uses_time) return std::nullopt;
  SpeedLimits limits = o.limits;
  for (Dynamics& d : limits.dynamics) d.up.time = d.down.time = 0;
  const auto free = plan_motion(limits, o.ran, {monitor.stop, {}});
  if (!free) return tl::unexpected(free.error());
  const double moving = o.summary.cycle_time - o.summary.dwell_time;
  if (!(moving > kDearly * free->cycle_time())) return std::nullopt;
  const PlanOptions& options = o.job->options;
  return Diagnostic{
      Severity::warning,
      "ramp-times",
      fmt::format("Tacc does not fit the blocks: ramps of no less than {:.4g} and {:.4g} ms take {:.4g} s where "
                  "the limits allow {:.4g} s",
                  options.t_acc * 1e3, options.t_dec * 1e3, moving, free->cycle_time()),
      "give a shorter --tacc-ms and --tdec-ms",
      {},
      {}};
}

}  // namespace toolpace
