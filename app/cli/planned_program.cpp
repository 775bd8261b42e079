#include "planned_program.h"

#include "console.h"
#include "interrupt.h"
#include "report.h"
#include "toolpace/pipeline/replan.h"

namespace toolpace::cli {

tl::expected<Outcome, Failure> plan_program(const ReadingFlags& flags, const Setup& setup) {
  const Outcome* const before = console() ? console()->before() : nullptr;
  auto job = std::make_shared<Job>();
  if (before) {
    job->program = before->job->program;
  } else {
    auto reading = flags.on(setup).read_accepted();
    if (!reading) return tl::unexpected(std::move(reading.error()));
    job->program = std::make_shared<const Reading>(std::move(*reading));
  }
  job->program_name = flags.program;
  job->machine = setup.machine;
  job->options = setup.options;
  auto outcome = before ? replan(job, *before, terminal_monitor("planning")) : run(job, terminal_monitor("planning"));
  end_progress();
  if (!outcome) return tl::unexpected<Failure>(std::move(outcome.error()));
  outcome->warnings.insert(outcome->warnings.begin(), setup.warnings.begin(), setup.warnings.end());
  report(outcome->warnings);
  return std::move(*outcome);
}

}  // namespace toolpace::cli
