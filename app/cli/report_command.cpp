/// toolpace report: a page about a plan, for people.

#include <fmt/format.h>

#include "commands.h"
#include "interrupt.h"
#include "job_flags.h"
#include "planned_program.h"
#include "shaper_flag.h"
#include "toolpace/base/descriptor.h"
#include "toolpace/io/output_file.h"
#include "toolpace/report/report_page.h"

namespace toolpace::cli {
namespace {

struct ReportFlags {
  ReadingFlags reading;
  JobFlags job;
  std::string output = "report.html";
};

Done run_report(const ReportFlags& flags) {
  auto setup = flags.job.setup();
  if (!setup) return tl::unexpected(setup.error());
  if (auto shaped = ShaperFlag{}.apply_to(*setup); !shaped) return tl::unexpected(shaped.error());
  // What cannot be written is known at once.
  auto file = OutputFile::create(flags.output, OutputFile::Access::forward, terminal_monitor("writing"));
  if (!file) return tl::unexpected(file.error());
  const auto outcome = plan_program(flags.reading, *setup);
  if (!outcome) return tl::unexpected(outcome.error());
  const auto page = report_page(*outcome, terminal_monitor("reporting"));
  end_progress();
  if (!page) return tl::unexpected(page.error());
  if (auto written = file->write(*page); !written) return tl::unexpected(written.error());
  if (auto done = file->commit(); !done) return tl::unexpected(done.error());
  if (!is_standard_output(flags.output)) {
    fmt::print("{}: {:.4f} s -> {}\n", flags.reading.program, outcome->summary.cycle_time, flags.output);
  }
  return kFine;
}

}  // namespace

void add_report_command(CommandLine& line) {
  auto flags = std::make_shared<ReportFlags>();
  Command command = line.add("report", "Write a page (HTML) about a program: times, plots, limits, proof",
                             [flags] { return run_report(*flags); });
  command.output("-o,--output FILE", flags->output, "The page; default report.html, - = standard output");
  flags->job.add_to(command);
  flags->reading.add_to(command);
  command.footer(
      "The page stands alone: no other file, no script, no network.\n\n"
      "Examples:\n"
      "  toolpace report part.ngc --machine mill.toml -o part.html");
}

}  // namespace toolpace::cli
