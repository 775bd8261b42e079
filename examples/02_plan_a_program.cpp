/// Reads an NC program, plans it under a machine's limits and prints what came out.
///
///   02_plan_a_program [PROGRAM [MACHINE.toml]]

#include <cstdio>
#include <memory>
#include <utility>

#include "toolpace/machine/read_machine.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/job.h"

namespace {

int fail(const toolpace::Error& error) {
  std::fprintf(stderr, "%s\n%s\n", error.message.c_str(), error.remedy.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string program = argc > 1 ? argv[1] : TOOLPACE_EXAMPLES_DIR "/nc/pocket.ngc";
  const auto setup = argc > 2 ? toolpace::read_machine(argv[2]) : toolpace::default_setup();
  if (!setup) return fail(setup.error());

  auto reading = toolpace::read_file(program);
  if (!reading) return fail(reading.error());
  for (const auto& d : reading->diagnostics) {
    std::fprintf(stderr, "line %zu, column %zu: %s\n", d.where.line, d.where.column, d.message.c_str());
  }
  if (reading->refused) return 1;

  auto job = std::make_shared<toolpace::Job>();
  job->program_name = program;
  job->program = std::make_shared<toolpace::Reading>(std::move(*reading));
  job->machine = setup->machine;
  job->options = setup->options;
  const auto outcome = toolpace::run(job);
  if (!outcome) return fail(outcome.error());

  const auto& summary = outcome->summary;
  std::printf("%zu blocks, %.3f mm, %.3f s (%.3f s of it rapids)\n", summary.blocks, summary.path_length,
              summary.cycle_time, summary.rapid_time);
  std::printf("at most %.2f mm/s, %.1f mm/s2, %.4g mm/s3\n", summary.peaks.speed, summary.peaks.acceleration,
              summary.peaks.jerk);
}
