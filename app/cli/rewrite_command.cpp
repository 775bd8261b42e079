/// toolpace rewrite: the program again, in fewer and longer blocks, proven.

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include "json.h"

#include "commands.h"
#include "interrupt.h"
#include "job_flags.h"
#include "outcome_json.h"
#include "reading_flags.h"
#include "report.h"
#include "toolpace/base/descriptor.h"
#include "toolpace/base/input_file.h"
#include "toolpace/io/output_file.h"
#include "toolpace/rewrite/rewrite.h"

namespace toolpace::cli {
namespace {

struct RewriteFlags {
  ReadingFlags reading;
  JobFlags job;
  std::string output, fit = "arcs";
  bool json = false;
};

std::size_t motion_blocks(const Moves& moves) {
  std::size_t motion = 0;
  for (const MoveKind kind : moves.kind) motion += is_motion(kind) ? 1 : 0;
  return motion;
}

/// A program and what is told of it.
struct Side {
  std::size_t blocks, bytes;
  std::optional<double> cycle_time;  ///< [s]
};

Result<Side> side_of(const RewriteFlags& flags, const Setup& setup, const Reading& reading, std::size_t bytes) {
  auto job = std::make_shared<Job>();
  job->program_name = flags.reading.program;
  job->program = std::make_shared<const Reading>(reading);
  job->machine = setup.machine;
  job->options = setup.options;
  const auto outcome = toolpace::run(job, terminal_monitor("planning"));
  end_progress();
  if (!outcome) return tl::unexpected(outcome.error());
  return Side{motion_blocks(reading.moves), bytes, outcome->summary.cycle_time};
}

Done run_rewrite(const RewriteFlags& flags) {
  if (flags.fit != "arcs" && flags.fit != "lines") {
    return tl::unexpected<Failure>(
        usage_error("bad-flag", "--fit does not know '" + flags.fit + "'", "give one of arcs, lines"));
  }
  const auto setup = flags.job.setup();
  if (!setup) return tl::unexpected(setup.error());
  // What cannot be written is known at once.
  auto file = OutputFile::create(flags.output, OutputFile::Access::forward, terminal_monitor("writing"));
  if (!file) return tl::unexpected(file.error());
  const auto content = read_whole_file(flags.reading.program, terminal_monitor("reading"));
  if (!content) return tl::unexpected(content.error());
  const auto reading = flags.reading.read_accepted(content->bytes());
  if (!reading) return tl::unexpected(reading.error());
  const RewriteOptions options{setup->options.corner.tolerance, flags.fit == "arcs"};
  const auto rewritten = rewrite(content->bytes(), flags.reading.program, *reading, flags.reading.options(), options,
                                 terminal_monitor("rewriting"));
  end_progress();
  if (!rewritten) return tl::unexpected(rewritten.error());
  const auto in = side_of(flags, *setup, *reading, content->bytes().size());
  if (!in) return tl::unexpected(in.error());
  const auto out = side_of(flags, *setup, rewritten->reading, rewritten->text.size());
  if (!out) return tl::unexpected(out.error());
  if (auto written = file->write(rewritten->text); !written) return tl::unexpected(written.error());
  if (auto done = file->commit(); !done) return tl::unexpected(done.error());
  if (flags.json) {
    print_json({{"program", flags.reading.program},
                {"output", flags.output},
                {"dialect", std::string(dialect_name(reading->dialect))},
                {"fit", flags.fit},
                {"tolerance_mm", options.tolerance},
                {"blocks_in", in->blocks},
                {"blocks_out", out->blocks},
                {"bytes_in", in->bytes},
                {"bytes_out", out->bytes},
                {"max_deviation_mm", rewritten->max_deviation},
                {"cycle_time_in_s", Json(in->cycle_time)},
                {"cycle_time_out_s", Json(out->cycle_time)},
                {"runs", rewritten->runs},
                {"runs_replaced", rewritten->replaced},
                {"runs_unproven", rewritten->unproven}});
  } else if (!is_standard_output(flags.output)) {
    fmt::print("{} -> {}\n", flags.reading.program, flags.output);
    fmt::print("  blocks       {} -> {}\n", in->blocks, out->blocks);
    fmt::print("  bytes        {} -> {}\n", in->bytes, out->bytes);
    fmt::print("  deviation    {:.6f} mm\n", rewritten->max_deviation);
    fmt::print("  cycle time   {:.4f} s -> {:.4f} s\n", *in->cycle_time, *out->cycle_time);
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
  command.json(flags->json, "Print one JSON object");
  flags->job.add_to(command);
  flags->reading.add_to(command);
  command.footer(
      "Examples:\n"
      "  toolpace rewrite part.ngc -o shorter.ngc");
}

}  // namespace toolpace::cli
