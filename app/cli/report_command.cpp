/// toolpace report: a page about a plan, for people.

#include <fmt/format.h>

#include "commands.h"
#include "interrupt.h"
#include "job_flags.h"
#include "planned_program.h"
#include "report.h"
#include "toolpace/io/output_file.h"
#include "toolpace/pipeline/report_page.h"

namespace toolpace::cli {
namespace {

struct ReportFlags {
  ReadingFlags reading;
  JobFlags job;
  std::string output = "report.html";
};

int run_report(const ReportFlags& flags) {
  const auto setup = flags.job.setup();
  if (!setup) return report(setup.error());
  const auto outcome = plan_program(flags.reading, *setup);
  if (!outcome) return report(outcome.error());
  const auto page = report_page(*outcome, terminal_monitor("reporting"));
  end_progress();
  if (!page) return report(page.error());
  if (auto written = write_whole_file(flags.output, *page); !written) return report(written.error());
  if (flags.output != "-")
    fmt::print("{}: {:.4f} s -> {}\n", flags.reading.program, outcome->summary.cycle_time, flags.output);
  return kFine;
}

}  // namespace

void add_report_command(CLI::App& app, Action& action) {
  auto flags = std::make_shared<ReportFlags>();
  CLI::App* const command =
      app.add_subcommand("report", "Write a page (HTML) about a program: times, plots, contour, limits, proof");
  flags->reading.add_to(*command);
  flags->job.add_to(*command);
  command->add_option("-o,--output", flags->output, "The page; - = standard output")->capture_default_str();
  command->callback([flags, &action] { action = [flags] { return run_report(*flags); }; });
}

}  // namespace toolpace::cli
