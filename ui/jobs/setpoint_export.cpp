#include "jobs/setpoint_export.h"

#include "toolpace/io/program_pulse_writer.h"
#include "toolpace/io/setpoint_writer.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/pipeline/sampled.h"

namespace toolpace::ui {
namespace {

Result<std::size_t> write_pulses(const Outcome& outcome, const std::string& file, double timer_hz,
                                 const Monitor& monitor) {
  auto writer = ProgramPulseWriter::create(file);
  if (!writer) return tl::unexpected(writer.error());
  const TimedMotion motion{*outcome.path, outcome.plan, outcome.node_time};
  const auto take = [&](const std::vector<Pulse>& pulses) { return writer->write(pulses); };
  const auto counts = program_pulses(motion, outcome.job->machine, timer_hz, take, monitor);
  if (!counts) return tl::unexpected(counts.error());
  if (auto finished = writer->finish(); !finished) return tl::unexpected(finished.error());
  return static_cast<std::size_t>(counts->pulses);
}

}  // namespace

Result<std::size_t> write_setpoints(const Outcome& outcome, const QString& file, const ExportOptions& options,
                                    const Monitor& monitor) {
  const std::string name = file.toStdString();
  if (is_pulse_file(name)) return write_pulses(outcome, name, options.timer_hz, monitor);
  SetpointFileOptions format;
  format.axis_derivatives = options.axis_derivatives;
  format.decimal_comma = options.decimal_comma;
  format.program_name = outcome.job->program_name;
  auto writer = open_setpoint_writer(name, format);
  if (!writer) return tl::unexpected(writer.error());
  Sampler sampler = sampler_of(outcome);
  Setpoints chunk;
  std::size_t rows = 0;
  while (sampler.next(chunk)) {
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    if (auto written = (*writer)->write(chunk); !written) return tl::unexpected(written.error());
    rows += chunk.size();
    monitor.report(static_cast<double>(rows) / static_cast<double>(sampler.rows()));
  }
  (*writer)->tell_origin(origin_of(outcome));
  if (auto finished = (*writer)->finish(); !finished) return tl::unexpected(finished.error());
  return rows;
}

}  // namespace toolpace::ui
