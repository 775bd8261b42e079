#include "drawing/motion_figures.h"

#include <algorithm>

#include "toolpace/base/metric.h"
#include "toolpace/pipeline/sampled.h"
#include "toolpace/sample/motion.h"

namespace toolpace::ui {
namespace {

/// Of a motion that is polynomials of time.
double chord_error_in_time(const Outcome& outcome, const Monitor& monitor) {
  constexpr Metric kApart = Metric::apart();
  Motion motion(*outcome.path, outcome.plan);
  const double period = outcome.job->machine.period;
  const std::size_t rows = row_count(motion.duration(), period);
  double largest = 0;
  AxisVector from = motion.at(0).position();
  for (std::size_t row = 1; row < rows && !monitor.is_cancelled(); ++row) {
    const double end = static_cast<double>(row) * period;
    const AxisVector middle = motion.at(end - period / 2).position(), to = motion.at(end).position();
    const AxisVector chord = to - from, off = middle - from;
    const double square = kApart.squared_norm(chord);
    const double share = square > 0 ? std::clamp(kApart.dot(chord, off) / square, 0.0, 1.0) : 0.0;
    largest = std::max(largest, kApart.norm(off - share * chord));
    from = to;
  }
  return largest;
}

}  // namespace

ContourErrors contour_errors(const Outcome& outcome, const ErrorTrace& trace) {
  ContourErrors worst;
  const auto& kinds = outcome.job->program->moves.kind;
  const auto& pauses = outcome.path->pauses;
  auto pause = std::find_if(pauses.begin(), pauses.end(), [](const Path::Pause& p) { return p.node > 0; });
  // When it goes on from a node: while it rests there it comes to rest from the move before.
  const auto departure = [&](std::size_t node) {
    double time = outcome.node_time[node];
    for (auto p = pause; p != pauses.end() && p->node == node; ++p) time += p->duration;
    return time;
  };
  std::size_t block = 0;
  for (std::size_t i = 0; i < trace.time.size(); ++i) {
    while (block + 1 < outcome.path->size() && departure(block + 1) <= trace.time[i]) {
      ++block;
      while (pause != pauses.end() && pause->node <= block) ++pause;
    }
    const bool cuts = outcome.path->size() == 0 || kinds[outcome.path->move[block]] != MoveKind::rapid;
    double& largest = cuts ? worst.cutting : worst.rapid;
    largest = std::max(largest, static_cast<double>(trace.error[i]));
  }
  return worst;
}

double chord_error(const Outcome& outcome, const Monitor& monitor) {
  if (!outcome.plan.splines.empty()) return chord_error_in_time(outcome, monitor);
  Sampler sampler = sampler_of(outcome);
  sampler.measure_chords();
  for (Setpoints chunk; !monitor.is_cancelled() && sampler.next(chunk);) {
  }
  return sampler.largest_chord_error();
}

}  // namespace toolpace::ui
