#include "toolpace/trace/trace.h"

#include <fmt/format.h>

#include <algorithm>

namespace toolpace {
namespace {

constexpr std::size_t kTraceRowsAtATime = 65536;
constexpr std::size_t kStepsLookedAt = 4096;
constexpr double kLongestStep = 10;  // in usual ones

/// The median of steps all over the trace.
double usual_step(const std::vector<double>& time) {
  std::vector<double> steps;
  const std::size_t stride = std::max<std::size_t>(1, time.size() / kStepsLookedAt);
  for (std::size_t i = 1; i < time.size(); i += stride) steps.push_back(time[i] - time[i - 1]);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

Result<void> check_times(Trace& trace) {
  const auto& time = trace.rows.time;
  const auto fail = [&](const char* code, std::string message, const char* remedy, std::size_t row) {
    return tl::unexpected(
        Error{ErrorKind::input, code, std::move(message), remedy, {trace.name, trace.first_line + row, 1}, {}});
  };
  if (time.size() < kFewestTraceRows) {
    return fail("trace-short", fmt::format("the trace has {} rows, too few to be judged", time.size()),
                "record at least the motion of a few blocks", time.size());
  }
  for (std::size_t i = 1; i < time.size(); ++i) {
    if (time[i] > time[i - 1]) continue;
    return fail("trace-time", fmt::format("the time goes from {:.9g} s to {:.9g} s", time[i - 1], time[i]),
                "record the time with more digits, or one recording at a time", i);
  }
  trace.step = usual_step(time);
  for (std::size_t i = 1; i < time.size(); ++i) {
    const double step = time[i] - time[i - 1];
    if (step <= kLongestStep * trace.step) continue;
    return fail("trace-gap",
                fmt::format("a gap of {:.6g} s, where rows follow each other every {:.6g} s", step, trace.step),
                "cut the trace there, or record again without lost samples", i);
  }
  return {};
}

}  // namespace

bool Trace::has_commanded() const {
  return std::any_of(rows.commanded.begin(), rows.commanded.end(), [](const auto& column) { return !column.empty(); });
}

Result<Trace> read_trace(const std::filesystem::path& file, const TraceOptions& options, const Monitor& monitor) {
  auto open = TraceFile::open(file, options, monitor);
  if (!open) return tl::unexpected(open.error());
  Trace trace;
  trace.columns = open->columns();
  trace.first_line = open->line_of(0);
  trace.name = file.string();
  for (;;) {
    const auto taken = open->read(trace.rows, kTraceRowsAtATime);
    if (!taken) return tl::unexpected(taken.error());
    if (*taken == 0) break;
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    monitor.report(open->progress());
  }
  if (auto fine = check_times(trace); !fine) return tl::unexpected(fine.error());
  return trace;
}

}  // namespace toolpace
