#include "toolpace/pipeline/follow.h"

#include "toolpace/pipeline/sampled.h"

namespace toolpace {
namespace {

constexpr std::size_t kRowsAtATime = 4096;  // that stay in the cache from one stage to the next

template <class T>
void drop(std::vector<T>& column, std::size_t rows) {
  if (!column.empty()) column.erase(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(rows));
}

template <class T>
void append(std::vector<T>& column, const std::vector<T>& more) {
  column.insert(column.end(), more.begin(), more.end());
}

/// Rows that wait for their contour error, which is known some rows later.
struct Waiting {
  Setpoints commanded;
  ServoTrace trace;

  void add(const Setpoints& chunk) {
    commanded.period = chunk.period;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) append(commanded.position[axis], chunk.position[axis]);
    append(commanded.speed, chunk.speed);
    append(commanded.acceleration, chunk.acceleration);
    append(commanded.jerk, chunk.jerk);
    append(commanded.line, chunk.line);
  }

  Result<void> hand_out(const FollowedRows& take) {
    const std::size_t rows = trace.contour_error.size();
    if (take && rows > 0) {
      if (auto taken = take(commanded, trace, rows); !taken) return taken;
    }
    commanded.first_row += rows;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      drop(commanded.position[axis], rows);
      drop(trace.actual[axis], rows);
    }
    for (auto* column :
         {&commanded.speed, &commanded.acceleration, &commanded.jerk, &trace.lag, &trace.contour_error}) {
      drop(*column, rows);
    }
    drop(commanded.line, rows);
    return {};
  }
};

}  // namespace

Result<ServoSummary> follow(const Outcome& outcome, const FollowedRows& take, const Monitor& monitor) {
  const Job& job = *outcome.job;
  auto simulation = ServoSimulation::create(job.machine.servo, job.machine.period);
  if (!simulation) return tl::unexpected(simulation.error());
  Sampler sampler = sampler_of(outcome);
  Waiting waiting;
  for (Setpoints chunk; sampler.next(chunk, kRowsAtATime);) {
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    waiting.add(chunk);
    simulation->take(chunk, waiting.trace);
    if (auto done = waiting.hand_out(take); !done) return tl::unexpected(done.error());
    monitor.report(static_cast<double>(chunk.first_row + chunk.size()) / static_cast<double>(sampler.rows()));
  }
  const ServoSummary summary = simulation->finish(waiting.trace);
  if (auto done = waiting.hand_out(take); !done) return tl::unexpected(done.error());
  return summary;
}

}  // namespace toolpace
