#include "toolpace/trace/identify.h"

#include <algorithm>
#include <cmath>

#include "toolpace/base/axis_unit.h"
#include "toolpace/trace/compare.h"

namespace toolpace {
namespace {

constexpr double kBefore = 2.0;       // [s] of motion that a drive has forgotten
constexpr double kAfter = 1.0;        // [s] behind the end, in which it settles
constexpr double kClockKnown = 1e-8;  // [s] a smaller error of the clock is none

IdentificationData data_of(const CommandedRows& commanded, const Trace& trace, const Alignment& alignment,
                           std::size_t axis) {
  IdentificationData data;
  data.period = commanded.period;
  data.unit = axis_unit(axis).size;
  const auto& time = trace.rows.time;
  const auto rows = commanded.position[axis].size();
  const double begins = std::max(0.0, alignment.at(time.front()) - kBefore);
  const auto first = std::min(rows - 1, static_cast<std::size_t>(begins / commanded.period));
  const std::size_t last = std::min(rows, first + kMostIdentifiedRows);
  const auto begin = commanded.position[axis].begin();
  data.commanded.assign(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last));
  const double zero = static_cast<double>(first) * commanded.period;
  const double end = static_cast<double>(last - 1) * commanded.period + (last == rows ? kAfter : 0.0);
  // A trace that is much denser than the setpoints tells no more.
  const auto stride = std::max<std::size_t>(1, static_cast<std::size_t>(commanded.period / trace.step / 4));
  for (std::size_t i = 0; i < time.size(); i += stride) {
    const double t = alignment.at(time[i]);
    if (t < 0 || t > end) continue;
    data.time.push_back(t - zero);
    data.actual.push_back(trace.rows.actual[axis][i]);
  }
  if (!alignment.by_commanded) {
    data.clock_error.reset();
    if (alignment.drift == 0) data.same_clock = alignment.clock_offset();
  } else {
    data.clock_error = alignment.offset_error > kClockKnown ? alignment.offset_error : 0.0;
  }
  return data;
}

struct Axes {
  const CommandedRows& commanded;
  const Trace& trace;
  const ServoMachine& known;
  const Monitor& monitor;

  /// Errors: cancelled; others are kept with the result.
  Result<void> identify(std::size_t axis, const IdentificationData& data, Identification& result) const {
    Result<AxisIdentification> found = tl::unexpected(Error{ErrorKind::input,
                                                            "trace-short",
                                                            "too few rows of the trace fall into the program",
                                                            "record while the program runs",
                                                            {},
                                                            {}});
    if (data.time.size() >= kFewestTraceRows) found = identify_axis(data, known[axis], {monitor.stop, {}});
    if (!found && found.error().kind == ErrorKind::cancelled) return tl::unexpected(found.error());
    result.axis[axis].reset();
    result.refused[axis].reset();
    if (found) {
      result.is_same_clock |= data.same_clock && found->clock == *data.same_clock;
      result.axis[axis] = std::move(*found);
      return {};
    }
    Error error = found.error();
    error.where = {trace.name, 0, 0};
    error.message = std::string("axis ") + kAxisNames[axis] + ": " + error.message;
    result.refused[axis] = std::move(error);
    return {};
  }

  /// All axes have one clock: where it was not known, the one that tells it best tells it to the others.
  Result<void> share_clock(Identification& result) const {
    if (result.alignment.by_commanded || result.is_same_clock) return {};
    std::optional<std::size_t> best;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      const auto& found = result.axis[axis];
      if (found && found->clock_error > 0 && (!best || found->clock_error < result.axis[*best]->clock_error))
        best = axis;
    }
    if (!best) return {};
    const double clock = result.axis[*best]->clock, error = result.axis[*best]->clock_error;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (!result.alignment.axis[axis] || axis == *best) continue;
      IdentificationData data = data_of(commanded, trace, result.alignment, axis);
      for (double& t : data.time) t += clock;
      data.clock_error = error;
      data.same_clock.reset();
      if (auto done = identify(axis, data, result); !done) return done;
    }
    return {};
  }
};

}  // namespace

Result<Identification> identify(const CommandedRows& commanded, const Trace& trace, const ServoMachine& known,
                                const Monitor& monitor) {
  const auto alignment = align(commanded, trace, monitor);
  if (!alignment) return tl::unexpected(alignment.error());
  if (auto fine = check_saturation(commanded, trace, *alignment); !fine) return tl::unexpected(fine.error());
  Identification result;
  result.alignment = *alignment;
  const Axes axes{commanded, trace, known, monitor};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!alignment->axis[axis]) continue;
    IdentificationData data = data_of(commanded, trace, *alignment, axis);
    if (auto done = axes.identify(axis, data, result); !done) return tl::unexpected(done.error());
    monitor.report(static_cast<double>(axis + 1) / kAxisCount);
  }
  if (auto done = axes.share_clock(result); !done) return tl::unexpected(done.error());
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (result.axis[axis]) return result;
  }
  for (const auto& refused : result.refused) {
    if (refused) return tl::unexpected(*refused);
  }
  return result;
}

}  // namespace toolpace
