/// Uses the installed library for all it does: reads a program, plans it, writes and reads setpoints. Fails unless headers,
/// library and CMake package fit together.

// The whole public face (cmake/public_headers.cmake).
#include <toolpace/bound/lower_bound.h>
#include <toolpace/io/setpoint_writer.h>
#include <toolpace/law/single_move.h>
#include <toolpace/machine/read_machine.h>
#include <toolpace/nc/reader.h>
#include <toolpace/pipeline/job.h>
#include <toolpace/pipeline/prove.h>
#include <toolpace/pipeline/replan.h>
#include <toolpace/report/report_page.h>
#include <toolpace/sample/motion.h>
#include <toolpace/sample/program_pulses.h>
#include <toolpace/sample/sampler.h>
#include <toolpace/tune/sweep.h>
#include <toolpace/verify/verify.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

int main() {
  auto reading = toolpace::read_text("G21 G90 G94\nG1 X10 F3000\nM2\n", "line.ngc");
  if (!reading || reading->refused) return 1;
  const auto setup = toolpace::default_setup();
  auto job = std::make_shared<toolpace::Job>();
  job->program = std::make_shared<const toolpace::Reading>(std::move(*reading));
  job->machine = setup.machine;
  job->options = setup.options;
  const auto outcome = toolpace::run(job);
  if (!outcome) return 2;

  auto writer = toolpace::open_setpoint_writer("setpoints.npz");
  if (!writer) return 3;
  toolpace::Sampler sampler(*outcome->path, outcome->plan, job->program->moves, job->machine.period);
  for (toolpace::Setpoints chunk; sampler.next(chunk);) {
    if (!(*writer)->write(chunk)) return 4;
  }
  if (!(*writer)->finish()) return 5;

  // Two quintic ramps between 0 and 50 mm/s at 3000 mm/s², 15·50/(8·3000) s and 0.78125 mm each, and a cruise.
  const double expected = 2 * 0.03125 + (10 - 2 * 0.78125) / 50;
  std::printf("%.6f s, %zu setpoints\n", outcome->summary.cycle_time, sampler.rows());
  return std::abs(outcome->summary.cycle_time - expected) < 1e-9 ? 0 : 6;
}
