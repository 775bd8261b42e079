#include "planned_program.h"

#include "interrupt.h"
#include "report.h"

namespace toolpace::cli {

Result<Outcome> plan_program(const ReadingFlags& reading_flags, const Setup& setup) {
  auto reading = reading_flags.read();
  if (!reading) return tl::unexpected(reading.error());
  if (reading->refused) {
    return tl::unexpected(Error{ErrorKind::input,
                                "program-refused",
                                "the program has errors and is not planned",
                                "correct it first",
                                {reading_flags.program, 0, 0},
                                {}});
  }
  auto job = std::make_shared<Job>();
  job->program_name = reading_flags.program;
  job->program = std::make_shared<const Reading>(std::move(*reading));
  job->machine = setup.machine;
  job->options = setup.options;
  auto outcome = run(job, terminal_monitor("planning"));
  end_progress();
  if (outcome) report(outcome->warnings);
  return outcome;
}

}  // namespace toolpace::cli
