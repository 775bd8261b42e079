/// Plans one program under every law and prints what each of them costs and asks of the drives.
///
///   04_compare_laws [PROGRAM]

#include <cstdio>
#include <memory>
#include <utility>

#include "toolpace/law/law_table.h"
#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/job.h"

int main(int argc, char** argv) {
  const std::string program = argc > 1 ? argv[1] : TOOLPACE_EXAMPLES_DIR "/nc/butterfly.ngc";
  auto reading = toolpace::read_file(program);
  if (!reading || reading->refused) {
    std::fprintf(stderr, "%s cannot be read\n", program.c_str());
    return 1;
  }
  const auto shared = std::make_shared<const toolpace::Reading>(std::move(*reading));
  const auto setup = toolpace::default_setup();

  std::printf("%-18s %12s %14s %14s\n", "law", "time s", "accel mm/s2", "jerk mm/s3");
  for (const auto& law : toolpace::law_table()) {
    auto job = std::make_shared<toolpace::Job>();
    job->program_name = program;
    job->program = shared;
    job->machine = setup.machine;
    job->options = setup.options;
    job->options.law = law.kind;
    const auto outcome = toolpace::run(job);
    if (!outcome) {
      std::fprintf(stderr, "%s\n", outcome.error().message.c_str());
      return 1;
    }
    const auto& summary = outcome->summary;
    std::printf("%-18.*s %12.3f %14.1f %14.4g\n", static_cast<int>(law.id.size()), law.id.data(), summary.cycle_time,
                summary.peaks.acceleration, summary.peaks.jerk);
  }
}
