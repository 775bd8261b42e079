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
#include "toolpace/rewrite/rewrite_job.h"

namespace toolpace::cli {
namespace {

struct RewriteFlags {
  ReadingFlags reading;
  JobFlags job;
  ControllerFlags controller;
  std::string output, fit = "arcs", feeds = "keep";
  bool json = false;
};

/// What is known before the program is read.
Result<RewriteTarget> target_of(const RewriteFlags& flags) {
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
  RewriteTarget target{std::move(*setup), std::nullopt, *predict, flags.fit == "arcs", flags.feeds == "planned"};
  if (!(target.setup.options.corner.tolerance > 0)) {
    return tl::unexpected(usage_error("bad-flag", "--tolerance-mm is 0: nothing can be written otherwise within it",
                                      "give a tolerance above 0"));
  }
  if (flags.controller.is_given()) {
    auto settings = flags.controller.read_settings();
    if (!settings) return tl::unexpected(settings.error());
    target.settings = std::move(*settings);
  } else if (!flags.controller.controller.empty() || flags.controller.baud || flags.controller.block_time_ms) {
    return tl::unexpected(
        usage_error("settings-missing", "a controller is named without its settings", "give them with --settings"));
  }
  return target;
}

struct RewriteTold {
  const RewriteFlags& flags;
  const RewriteTarget& target;
  const Reading& reading;
  std::size_t bytes;
  const Rewritten& rewritten;
};

Json rewrite_json(const RewriteTold& t) {
  Json controller;
  if (t.target.settings) controller = std::string(controller_name(t.target.settings->controller));
  return {{"program", t.flags.reading.program},
          {"output", t.flags.output},
          {"dialect", std::string(dialect_name(t.reading.dialect))},
          {"controller", std::move(controller)},
          {"fit", t.flags.fit},
          {"feeds", t.flags.feeds},
          {"tolerance_mm", t.target.setup.options.corner.tolerance},
          {"blocks_in", motion_rows(t.reading.moves)},
          {"blocks_out", motion_rows(t.rewritten.reading.moves)},
          {"bytes_in", t.bytes},
          {"bytes_out", t.rewritten.text.size()},
          {"max_deviation_mm", t.rewritten.max_deviation},
          {"cycle_time_in_s", Json(t.rewritten.time_before)},
          {"cycle_time_out_s", Json(t.rewritten.time_after)},
          {"replaced_blocks", t.rewritten.replaced},
          {"left_unproven", t.rewritten.unproven},
          {"left_for_time", t.rewritten.slower}};
}

void print_summary(const RewriteTold& t) {
  const Rewritten& r = t.rewritten;
  fmt::print("{} -> {}\n", t.flags.reading.program, t.flags.output);
  fmt::print("  blocks       {} -> {}\n", motion_rows(t.reading.moves), motion_rows(r.reading.moves));
  fmt::print("  bytes        {} -> {}\n", t.bytes, r.text.size());
  fmt::print("  deviation    {:.6f} mm, of {} mm\n", r.max_deviation, t.target.setup.options.corner.tolerance);
  fmt::print("  cycle time   {:.4f} s -> {:.4f} s by {}\n", *r.time_before, *r.time_after,
             t.target.settings ? controller_title(t.target.settings->controller) : std::string_view("the plan"));
  if (r.slower > 0) fmt::print("  left alone   {} blocks, which would take longer otherwise\n", r.slower);
  if (r.unproven > 0) fmt::print("  left alone   {} stretches, whose replacement did not pass the proof\n", r.unproven);
}

Done run_rewrite(RewriteFlags flags) {
  const auto target = target_of(flags);
  if (!target) return tl::unexpected(target.error());
  if (target->settings && flags.reading.dialect == "auto")
    flags.reading.dialect = std::string(dialect_name(dialect_of(target->settings->controller)));
  // What cannot be written is known at once.
  auto file = OutputFile::create(flags.output, OutputFile::Access::forward, terminal_monitor("writing"));
  if (!file) return tl::unexpected(file.error());
  const auto content = read_whole_file(flags.reading.program, terminal_monitor("reading"));
  if (!content) return tl::unexpected(content.error());
  auto read = flags.reading.on(target->setup).read_accepted(content->bytes());
  if (!read) return tl::unexpected(read.error());
  if (read->moves.has_tip()) {
    return tl::unexpected(Error{ErrorKind::input,
                                "rewrite-tip",
                                "programs about the tool's tip are not rewritten",
                                "rewrite the program before it is posted for five axes",
                                {flags.reading.program, 0, 0},
                                {}});
  }
  const auto reading = std::make_shared<const Reading>(std::move(*read));
  const auto found = rewrite_for(*target, content->bytes(), flags.reading.program, reading, flags.reading.options(),
                                 terminal_monitor("rewriting"));
  end_progress();
  if (!found) return tl::unexpected(found.error());
  const Rewritten& rewritten = found->rewritten;
  if (auto written = file->write(rewritten.text); !written) return tl::unexpected(written.error());
  if (auto done = file->commit(); !done) return tl::unexpected(done.error());
  const RewriteTold told{flags, *target, *reading, content->bytes().size(), rewritten};
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
