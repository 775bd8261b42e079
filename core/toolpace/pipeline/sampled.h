#pragma once
/// The setpoints of an outcome.

#include "toolpace/pipeline/job.h"
#include "toolpace/sample/sampler.h"

namespace toolpace {

/// By which the outcome's setpoints are shaped; {0, 1} alone where they are not.
inline Impulses impulses_of(const Outcome& outcome) {
  return shaping(outcome.job->options.shaper, outcome.job->machine.servo);
}

/// How long its setpoints last [s]: shaped, longer than its plan.
inline double setpoints_duration(const Outcome& outcome) {
  return outcome.summary.cycle_time + duration_of(impulses_of(outcome));
}

/// Every period of the machine's. Keeps references to the outcome.
inline Sampler sampler_of(const Outcome& outcome) {
  const Job& job = *outcome.job;
  return {*outcome.path, outcome.plan, job.program->moves, job.machine.period, impulses_of(outcome)};
}

}  // namespace toolpace
