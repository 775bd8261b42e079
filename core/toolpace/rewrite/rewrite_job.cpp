#include "toolpace/rewrite/rewrite_job.h"

#include <algorithm>
#include <utility>

#include "toolpace/machine/controller_machine.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/rewrite/controller_timer.h"

namespace toolpace {
namespace {

constexpr double kBitsOfBlock = 300;  // 30 bytes, as blocks with three coordinates or a centre have
constexpr double kRewriting = 0.8;    // of the progress

/// By a plan.
Result<ProgramTime> planned_time(const RewriteTarget& target, const std::string& name,
                                 std::shared_ptr<const Reading> reading, const Monitor& monitor) {
  auto job = std::make_shared<Job>();
  job->program_name = name;
  job->program = std::move(reading);
  job->machine = target.setup.machine;
  job->options = target.setup.options;
  const auto outcome = run(job, {monitor.stop, {}});
  if (!outcome) return tl::unexpected(outcome.error());
  ProgramTime time{outcome->summary.cycle_time, std::vector<double>(job->program->moves.size())};
  const auto& at = outcome->node_time;
  for (std::size_t i = 0; i < outcome->path->size() && i + 1 < at.size(); ++i)
    time.row[outcome->path->move[i]] += at[i + 1] - at[i];
  return time;
}

/// Klipper without [gcode_arcs] has none.
bool knows_arcs(const std::optional<ControllerSettings>& settings) {
  const auto* const klipper = settings ? std::get_if<KlipperSettings>(&settings->values) : nullptr;
  return !klipper || klipper->has_arcs;
}

/// Of the machine; or, where a controller is named, what of its own limits it does not hold by itself: all models hold speeds of axes,
/// LinuxCNC's accelerations on arcs, too.
FeedLimits feed_limits(const RewriteTarget& target) {
  FeedLimits limits{target.setup.machine, 0.0};
  if (target.settings) {
    limits.machine = controller_setup(*target.settings).machine;
    limits.machine.path.speed = kUnlimited;
    for (AxisLimits& axis : limits.machine.axes) axis.speed = kUnlimited;
    if (target.settings->controller == Controller::linuxcnc) {
      limits.machine.path.acceleration = kUnlimited;
      for (AxisLimits& axis : limits.machine.axes) axis.acceleration = kUnlimited;
    }
  }
  limits.block_time = target.predict.block_time.value_or(0.0);
  if (target.predict.baud) limits.block_time += kBitsOfBlock / *target.predict.baud;
  return limits;
}

}  // namespace

Result<RewrittenFor> rewrite_for(const RewriteTarget& target, std::string_view text, const std::string& name,
                                 const std::shared_ptr<const Reading>& reading, const ReadOptions& read_options,
                                 const Monitor& monitor) {
  if (!(target.setup.options.corner.tolerance > 0)) {
    return tl::unexpected(Error{ErrorKind::usage,
                                "bad-limit",
                                "the tolerance is 0: nothing can be written otherwise within it",
                                "",
                                {},
                                {}});
  }
  RewriteOptions options{
      target.setup.options.corner.tolerance, target.wants_arcs && knows_arcs(target.settings), {}, {}};
  if (target.plans_feeds) options.feeds = feed_limits(target);
  const Monitor quiet{monitor.stop, {}};
  if (target.settings) options.timer = controller_timer(*target.settings, target.predict, quiet);
  Monitor part = quiet;
  if (monitor.progress) part.progress = [&](double fraction) { monitor.report(kRewriting * fraction); };
  auto rewritten = rewrite(text, name, *reading, read_options, options, part);
  if (!rewritten) return tl::unexpected(rewritten.error());
  const auto time_of = [&](std::shared_ptr<const Reading> of, std::string_view its_text) {
    return target.settings ? options.timer(*of, its_text) : planned_time(target, name, std::move(of), quiet);
  };
  auto before = time_of(reading, text);
  if (!before) return tl::unexpected(before.error());
  monitor.report((1 + kRewriting) / 2);
  auto after = time_of(std::make_shared<const Reading>(rewritten->reading), rewritten->text);
  if (!after) return tl::unexpected(after.error());
  rewritten->time_before = before->total;
  rewritten->time_after = after->total;
  monitor.report(1);
  return RewrittenFor{std::move(*rewritten), std::move(*before), std::move(*after)};
}

std::size_t motion_rows(const Moves& moves) {
  return static_cast<std::size_t>(std::count_if(moves.kind.begin(), moves.kind.end(), is_motion));
}

}  // namespace toolpace
