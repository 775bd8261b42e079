/// Plans a polyline that the program makes itself and writes its setpoints, chunk by chunk, in bounded memory.
///
///   03_write_setpoints [OUT.csv]

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "toolpace/base/numbers.h"
#include "toolpace/io/setpoint_writer.h"
#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/sample/sampler.h"

namespace {

/// Archimedes' spiral in chords of about half a millimetre, as a CSV polyline.
std::string spiral() {
  std::string text = "x_mm,y_mm,feed_mm_min\n";
  for (double angle = 0.0; angle < 40.0; angle += 0.5 / (1.0 + angle)) {
    text += toolpace::to_text(angle * std::cos(angle)) + "," + toolpace::to_text(angle * std::sin(angle)) + ",3000\n";
  }
  return text;
}

int fail(const toolpace::Error& error) {
  std::fprintf(stderr, "%s\n%s\n", error.message.c_str(), error.remedy.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path file =
      argc > 1 ? argv[1] : std::filesystem::temp_directory_path() / "toolpace-spiral.csv";
  auto reading = toolpace::read_text(spiral(), "spiral.csv");
  if (!reading) return fail(reading.error());

  const auto setup = toolpace::default_setup();
  auto job = std::make_shared<toolpace::Job>();
  job->program_name = "spiral.csv";
  job->program = std::make_shared<toolpace::Reading>(std::move(*reading));
  job->machine = setup.machine;
  job->options = setup.options;
  const auto outcome = toolpace::run(job);
  if (!outcome) return fail(outcome.error());

  auto writer = toolpace::open_setpoint_writer(file);
  if (!writer) return fail(writer.error());
  toolpace::Sampler sampler(*outcome->path, outcome->plan, job->program->moves, job->machine.period);
  for (toolpace::Setpoints chunk; sampler.next(chunk);) {
    if (auto written = (*writer)->write(chunk); !written) return fail(written.error());
  }
  if (auto finished = (*writer)->finish(); !finished) return fail(finished.error());
  std::printf("%zu setpoints in %s\n", sampler.rows(), file.c_str());
}
