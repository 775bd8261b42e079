#include "setpoint_pass.h"

#include <algorithm>

#include "toolpace/pipeline/prove.h"
#include "toolpace/pipeline/sampled.h"
#include "toolpace/sample/uniform_rows.h"

namespace toolpace::cli {
namespace {

constexpr std::size_t kRowsAtATime = 65536;

/// Measures a plan without writing it: rows between which nothing changes are passed over.
Result<void> measure(Sampler& sampler, const std::vector<UniformRows>& uniform, SetpointPass& pass,
                     const Monitor& monitor) {
  std::size_t row = 0;
  Setpoints chunk;
  const auto take = [&](std::size_t limit) {
    if (!sampler.next(chunk, limit)) return false;
    row = chunk.first_row + chunk.size();
    return true;
  };
  for (const UniformRows& rows : uniform) {
    while (row < rows.first && take(std::min<std::size_t>(kRowsAtATime, rows.first - row))) pass.peaks.add(chunk);
    sampler.seek(rows.end);
    if (take(1)) pass.peaks.resume(chunk);
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
  }
  while (take(kRowsAtATime)) {
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    pass.peaks.add(chunk);
    monitor.report(static_cast<double>(row) / static_cast<double>(pass.rows));
  }
  return {};
}

Result<void> write(Sampler& sampler, SetpointWriter& writer, const Outcome& outcome, SetpointPass& pass,
                   const Monitor& monitor) {
  for (Setpoints chunk; sampler.next(chunk, kRowsAtATime);) {
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    pass.peaks.add(chunk);
    if (auto written = writer.write(chunk); !written) return written;
    monitor.report(static_cast<double>(chunk.first_row + chunk.size()) / static_cast<double>(pass.rows));
  }
  writer.tell_origin(origin_of(outcome));
  return writer.finish();
}

/// Rows that tell nothing new.
std::vector<UniformRows> uniform_rows_of(const Sampler& sampler, const Outcome& outcome) {
  if (sampler.is_shaped()) return {};
  return uniform_rows(*outcome.path, outcome.plan, outcome.job->machine.period);
}

}  // namespace

Result<SetpointPass> pass_over_setpoints(const Outcome& outcome, SetpointWriter* writer, bool measures,
                                         const Monitor& monitor) {
  SetpointPass pass;
  Sampler sampler = sampler_of(outcome);
  pass.rows = sampler.rows();
  if (!writer && !measures) return pass;
  if (!sampler.is_shaped()) sampler.measure_chords();
  const auto done = writer ? write(sampler, *writer, outcome, pass, monitor)
                           : measure(sampler, uniform_rows_of(sampler, outcome), pass, monitor);
  if (!done) return tl::unexpected(done.error());
  pass.chord_error = sampler.largest_chord_error();
  pass.shaping = sampler.largest_offset();
  return pass;
}

}  // namespace toolpace::cli
