/// toolpace rewrite: the program again, in fewer and longer blocks, proven.

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include "json.h"

#include "commands.h"
#include "controller_flags.h"
#include "interrupt.h"
#include "job_flags.h"
#include "outcome_json.h"
#include "reading_flags.h"
#include "report.h"
#include "toolpace/base/descriptor.h"
#include "toolpace/base/input_file.h"
#include "toolpace/io/output_file.h"
#include "toolpace/machine/controller_machine.h"
#include "toolpace/rewrite/controller_timer.h"
#include "toolpace/rewrite/rewrite.h"

namespace toolpace::cli {
namespace {

constexpr double kBitsOfBlock = 300;  // 30 bytes, as blocks with three coordinates or a centre have

struct RewriteFlags {
  ReadingFlags reading;
  JobFlags job;
  ControllerFlags controller;
  std::string output, fit = "arcs", feeds = "keep";
  bool json = false;
};

/// What is known before the program is read.
struct Order {
  Setup setup;
  std::optional<ControllerSettings> settings;
  PredictOptions predict;
};

Result<Order> order_of(const RewriteFlags& flags) {
  if (flags.fit != "arcs" && flags.fit != "lines") {
    return tl::unexpected(
        usage_error("bad-flag", "--fit does not know '" + flags.fit + "'", "give one of arcs, lines"));
  }
  if (flags.output.empty())
    return tl::unexpected(usage_error("flag-missing", "there is no file to write", "name it with -o"));
  if (flags.feeds != "keep" && flags.feeds != "planned") {
    return tl::unexpected(
        usage_error("bad-flag", "--feeds does not know '" + flags.feeds + "'", "give one of keep, planned"));
  }
  auto setup = flags.job.setup();
  if (!setup) return tl::unexpected(setup.error());
  auto predict = flags.controller.options();
  if (!predict) return tl::unexpected(predict.error());
  Order order{std::move(*setup), std::nullopt, *predict};
  if (!(order.setup.options.corner.tolerance > 0)) {
    return tl::unexpected(usage_error("bad-flag", "--tolerance-mm is 0: nothing can be written otherwise within it",
                                      "give a tolerance above 0"));
  }
  if (flags.controller.is_given()) {
    auto settings = flags.controller.read_settings();
    if (!settings) return tl::unexpected(settings.error());
    order.settings = std::move(*settings);
  } else if (!flags.controller.controller.empty() || flags.controller.baud || flags.controller.block_time_ms) {
    return tl::unexpected(
        usage_error("settings-missing", "a controller is named without its settings", "give them with --settings"));
  }
  return order;
}

std::size_t motion_blocks(const Moves& moves) {
  std::size_t motion = 0;
  for (const MoveKind kind : moves.kind) motion += is_motion(kind) ? 1 : 0;
  return motion;
}

/// [s] of a plan.
Result<double> planned_time(const RewriteFlags& flags, const Setup& setup, Reading reading) {
  auto job = std::make_shared<Job>();
  job->program_name = flags.reading.program;
  job->program = std::make_shared<const Reading>(std::move(reading));
  job->machine = setup.machine;
  job->options = setup.options;
  const auto outcome = toolpace::run(job, terminal_monitor("planning"));
  end_progress();
  if (!outcome) return tl::unexpected(outcome.error());
  return outcome->summary.cycle_time;
}

/// Klipper without [gcode_arcs] has none.
bool has_arcs(const std::optional<ControllerSettings>& settings) {
  const auto* const klipper = settings ? std::get_if<KlipperSettings>(&settings->values) : nullptr;
  return !klipper || klipper->has_arcs;
}

/// Of the machine; or, where a controller is named, what of its own limits it does not hold by itself: all models hold speeds of axes,
/// LinuxCNC's accelerations on arcs, too.
FeedLimits feed_limits(const Order& order) {
  FeedLimits limits{order.setup.machine, 0.0};
  if (order.settings) {
    limits.machine = controller_setup(*order.settings).machine;
    limits.machine.path.speed = kUnlimited;
    for (AxisLimits& axis : limits.machine.axes) axis.speed = kUnlimited;
    if (order.settings->controller == Controller::linuxcnc) {
      limits.machine.path.acceleration = kUnlimited;
      for (AxisLimits& axis : limits.machine.axes) axis.acceleration = kUnlimited;
    }
  }
  limits.block_time = order.predict.block_time.value_or(0.0);
  if (order.predict.baud) limits.block_time += kBitsOfBlock / *order.predict.baud;
  return limits;
}

Result<Rewritten> rewrite_with_times(const RewriteFlags& flags, const Order& order, std::string_view text,
                                     const Reading& reading) {
  RewriteOptions options{order.setup.options.corner.tolerance, flags.fit == "arcs" && has_arcs(order.settings), {}, {}};
  if (flags.feeds == "planned") options.feeds = feed_limits(order);
  const Monitor monitor = terminal_monitor("rewriting");
  if (order.settings) options.timer = controller_timer(*order.settings, order.predict, {monitor.stop, {}});
  auto rewritten = rewrite(text, flags.reading.program, reading, flags.reading.options(), options, monitor);
  end_progress();
  if (!rewritten || order.settings) return rewritten;
  const auto before = planned_time(flags, order.setup, reading);
  if (!before) return tl::unexpected(before.error());
  const auto after = planned_time(flags, order.setup, rewritten->reading);
  if (!after) return tl::unexpected(after.error());
  rewritten->time_before = *before;
  rewritten->time_after = *after;
  return rewritten;
}

struct Told {
  const RewriteFlags& flags;
  const Order& order;
  const Reading& reading;
  std::size_t bytes;
  const Rewritten& rewritten;
};

Json rewrite_json(const Told& t) {
  Json controller;
  if (t.order.settings) controller = std::string(controller_name(t.order.settings->controller));
  return {{"program", t.flags.reading.program},
          {"output", t.flags.output},
          {"dialect", std::string(dialect_name(t.reading.dialect))},
          {"controller", std::move(controller)},
          {"fit", t.flags.fit},
          {"feeds", t.flags.feeds},
          {"tolerance_mm", t.order.setup.options.corner.tolerance},
          {"blocks_in", motion_blocks(t.reading.moves)},
          {"blocks_out", motion_blocks(t.rewritten.reading.moves)},
          {"bytes_in", t.bytes},
          {"bytes_out", t.rewritten.text.size()},
          {"max_deviation_mm", t.rewritten.max_deviation},
          {"cycle_time_in_s", Json(t.rewritten.time_before)},
          {"cycle_time_out_s", Json(t.rewritten.time_after)},
          {"replaced_blocks", t.rewritten.replaced},
          {"left_unproven", t.rewritten.unproven},
          {"left_for_time", t.rewritten.slower}};
}

void print_summary(const Told& t) {
  const Rewritten& r = t.rewritten;
  fmt::print("{} -> {}\n", t.flags.reading.program, t.flags.output);
  fmt::print("  blocks       {} -> {}\n", motion_blocks(t.reading.moves), motion_blocks(r.reading.moves));
  fmt::print("  bytes        {} -> {}\n", t.bytes, r.text.size());
  fmt::print("  deviation    {:.6f} mm, of {} mm\n", r.max_deviation, t.order.setup.options.corner.tolerance);
  fmt::print("  cycle time   {:.4f} s -> {:.4f} s by {}\n", *r.time_before, *r.time_after,
             t.order.settings ? controller_title(t.order.settings->controller) : std::string_view("the plan"));
  if (r.slower > 0) fmt::print("  left alone   {} blocks, which would take longer otherwise\n", r.slower);
  if (r.unproven > 0) fmt::print("  left alone   {} stretches, whose replacement did not pass the proof\n", r.unproven);
}

Done run_rewrite(RewriteFlags flags) {
  const auto order = order_of(flags);
  if (!order) return tl::unexpected(order.error());
  if (order->settings && flags.reading.dialect == "auto")
    flags.reading.dialect = std::string(dialect_name(dialect_of(order->settings->controller)));
  // What cannot be written is known at once.
  auto file = OutputFile::create(flags.output, OutputFile::Access::forward, terminal_monitor("writing"));
  if (!file) return tl::unexpected(file.error());
  const auto content = read_whole_file(flags.reading.program, terminal_monitor("reading"));
  if (!content) return tl::unexpected(content.error());
  const auto reading = flags.reading.read_accepted(content->bytes());
  if (!reading) return tl::unexpected(reading.error());
  const auto rewritten = rewrite_with_times(flags, *order, content->bytes(), *reading);
  if (!rewritten) return tl::unexpected(rewritten.error());
  if (auto written = file->write(rewritten->text); !written) return tl::unexpected(written.error());
  if (auto done = file->commit(); !done) return tl::unexpected(done.error());
  const Told told{flags, *order, *reading, content->bytes().size(), *rewritten};
  if (flags.json) {
    print_json(rewrite_json(told));
  } else if (!is_standard_output(flags.output)) {
    print_summary(told);
  }
  return kFine;
}

}  // namespace

void add_rewrite_command(CommandLine& line) {
  auto flags = std::make_shared<RewriteFlags>();
  Command command =
      line.add("rewrite", "Write the program again in fewer and longer blocks, and prove that it does the same",
               [flags] { return run_rewrite(*flags); });
  command.output("-o,--output FILE", flags->output, "The new program; - = standard output");
  command.word("--fit HOW", flags->fit, "arcs (default): lines, arcs and helices; lines: lines alone");
  command.word("--feeds HOW", flags->feeds,
               "keep (default); planned: lower F where axes could not follow, or blocks would come too late");
  flags->controller.add_to(command, Need::optional);
  command.json(flags->json, "Print one JSON object");
  flags->job.add_to(command);
  flags->reading.add_to(command);
  command.footer(
      "Runs of plain G1, G2 and G3 lines become longer ones within --tolerance-mm; everything else stays byte for "
      "byte.\n"
      "With --settings the times are those of the controller, and what it would take longer for is left alone.\n\n"
      "Examples:\n"
      "  toolpace rewrite part.ngc -o shorter.ngc\n"
      "  toolpace rewrite part.nc -o part-grbl.nc --tolerance-mm 0.005 --settings mill-settings.txt\n"
      "  toolpace rewrite part.ngc -o - --fit lines");
}

}  // namespace toolpace::cli
