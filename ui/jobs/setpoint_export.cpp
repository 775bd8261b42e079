#include "jobs/setpoint_export.h"

#include "toolpace/io/setpoint_writer.h"
#include "toolpace/sample/sampler.h"

namespace toolpace::ui {

Result<std::size_t> write_setpoints(const Outcome& outcome, const QString& file, const Monitor& monitor) {
  SetpointFileOptions options;
  options.program_name = outcome.job->program_name;
  auto writer = open_setpoint_writer(file.toStdString(), options);
  if (!writer) return tl::unexpected(writer.error());
  Sampler sampler(*outcome.path, outcome.plan, outcome.job->program->moves, outcome.job->machine.period);
  Setpoints chunk;
  std::size_t rows = 0;
  while (sampler.next(chunk)) {
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    if (auto written = (*writer)->write(chunk); !written) return tl::unexpected(written.error());
    rows += chunk.size();
    monitor.report(static_cast<double>(rows) / static_cast<double>(sampler.rows()));
  }
  if (auto finished = (*writer)->finish(); !finished) return tl::unexpected(finished.error());
  return rows;
}

}  // namespace toolpace::ui
