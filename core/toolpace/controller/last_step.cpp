#include "toolpace/controller/last_step.h"

namespace toolpace::detail::controller {
namespace {

constexpr double kSegment = 0.01;         // [s]
constexpr double kLeastSteps = 1.25;      // of a segment, which else lasts longer
constexpr double kRounding = 1e-9;        // [steps]
constexpr double kRest = 1e-6;            // [s] less is no segment of its own
constexpr int kMostSegments = 1'000'000;  // hours of one block

/// What is left of the last block after a time [mm].
double left_at(const LastBlock& last, double time) {
  const Block& block = last.block;
  const Trapezoid& t = last.times;
  const double entry = std::sqrt(last.entry2), rest = t.total() - time, a = block.acceleration;
  if (rest <= 0) return 0;
  if (time < t.up) return block.length - time * (entry + 0.5 * a * time);
  const double end = t.peak - a * t.down;  // 0 but for rounding
  if (rest <= t.down) return rest * (end + 0.5 * a * rest);
  return t.down * 0.5 * (t.peak + end) + (rest - t.down) * t.peak;
}

}  // namespace

double time_of_last_step(const LastBlock& last, double steps) {
  const double total = last.times.total(), steps_a_mm = steps / last.block.length;
  double begin = 0, left = steps, carried = 0;  // [s], [steps], [s] of a step that was begun
  for (int i = 0; i < kMostSegments; ++i) {
    double end = begin + kSegment;
    while (end < total - kRest && left_at(last, end) * steps_a_mm > left - kLeastSteps) end += kSegment;
    if (end > total - kRest) end = total;
    const double then = end >= total ? 0.0 : left_at(last, end) * steps_a_mm;
    const double whole_before = std::ceil(left - kRounding), whole_then = std::ceil(then - kRounding);
    const double step_time = (end - begin + carried) / std::max(whole_before - then, kRounding);
    if (end >= total) return std::min(step_time, total);
    carried = (whole_then - then) * step_time;
    begin = end;
    left = then;
  }
  return 0;
}

}  // namespace toolpace::detail::controller
