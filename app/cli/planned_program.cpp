#include "planned_program.h"

#include "interrupt.h"
#include "report.h"

namespace toolpace::cli {

tl::expected<Outcome, Failure> plan_program(const ReadingFlags& flags, const Setup& setup) {
  auto reading = flags.read_accepted();
  if (!reading) return tl::unexpected(std::move(reading.error()));
  auto job = std::make_shared<Job>();
  job->program_name = flags.program;
  job->program = std::make_shared<const Reading>(std::move(*reading));
  job->machine = setup.machine;
  job->options = setup.options;
  auto outcome = run(job, terminal_monitor("planning"));
  end_progress();
  if (!outcome) return tl::unexpected<Failure>(std::move(outcome.error()));
  outcome->warnings.insert(outcome->warnings.begin(), setup.warnings.begin(), setup.warnings.end());
  report(outcome->warnings);
  return std::move(*outcome);
}

}  // namespace toolpace::cli
