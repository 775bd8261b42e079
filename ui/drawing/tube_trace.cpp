#include "drawing/tube_trace.h"

#include <algorithm>

#include "toolpace/path/blend_path.h"
#include "toolpace/path/build_path.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/pipeline/sampled.h"
#include "toolpace/verify/path_follower.h"

namespace toolpace::ui {
namespace {

constexpr double kReach = 1.5;           // of the tolerance: where setpoints are looked for
constexpr double kSagitta = 1.0 / 1024;  // of it: how far a chord of the programmed path may be from its curve

bool rounds(const CornerOptions& corner) {
  return !corner.step && (corner.rule == CornerRule::blend || corner.rule == CornerRule::smooth);
}

bool turns(const Path& path) {
  return std::any_of(path.node.begin(), path.node.end(),
                     [&](const AxisVector& p) { return p.tail<3>() != path.node.front().tail<3>(); });
}

/// Setpoint after setpoint against the programmed path.
class TubeFollower {
 public:
  TubeFollower(const Path& path, const Outcome& outcome, double reach)
      : path_(path),
        outcome_(outcome),
        reach_(reach),
        vertices_(path, reach * kSagitta),
        follower_(vertices_, reach, turns(path)) {}

  /// @return false once the path is lost
  bool take(const Setpoints& chunk, std::size_t k, TubeTrace& trace) {
    AxisVector at = path_.node.front();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (!chunk.position[axis].empty()) at[static_cast<Eigen::Index>(axis)] = chunk.position[axis][k];
    }
    const AxisVector point = weighted(at);
    const bool follows = trace.size() == 0 ? follower_.start(point) : follower_.advance(last_, point, {reach_, reach_});
    last_ = point;
    if (!follows) return false;
    const PathMatch& match = follower_.match();
    const PathVertex* const end = vertices_.at(match.cell + 1);
    const AxisVector foot = end ? vertices_.point(match.cell, match.t) : vertices_.at(match.cell)->point;
    const std::uint32_t row = path_.move[end ? end->segment : path_.size() - 1];
    trace.time.push_back(chunk.time(k));
    trace.programmed.push_back(foot.head<3>().cast<float>());
    trace.offset.push_back((point - foot).head<3>().cast<float>());
    trace.tolerance.push_back(
        static_cast<float>(corner_tolerance(outcome_.job->program->moves, row, outcome_.job->options.corner)));
    return true;
  }

 private:
  const Path& path_;
  const Outcome& outcome_;
  double reach_;
  PathVertices vertices_;
  PathFollower follower_;
  AxisVector last_ = AxisVector::Zero();
};

void find_worst(TubeTrace& trace) {
  for (std::size_t i = 0; i < trace.size(); ++i) {
    trace.largest_offset = std::max<double>(trace.largest_offset, trace.offset[i].norm());
    if (trace.share(i) <= trace.largest_share) continue;
    trace.largest_share = trace.share(i);
    trace.worst = i;
  }
}

}  // namespace

double TubeTrace::share(std::size_t row) const {
  return tolerance[row] > 0 ? static_cast<double>(offset[row].norm() / tolerance[row]) : 0.0;
}

std::optional<std::size_t> TubeTrace::row_at(double t) const {
  if (time.empty() || t < time.front()) return std::nullopt;
  const auto after = std::upper_bound(time.begin(), time.end(), t);
  const std::size_t row = static_cast<std::size_t>(after - time.begin()) - 1;
  const double period = time.size() > 1 ? time[1] - time[0] : 0.0;
  if (row + 1 == time.size() && t > time.back() + period) return std::nullopt;
  return row;
}

bool leaves_programmed_path(const Outcome& outcome) {
  return rounds(outcome.job->options.corner) || asks_for_blends(outcome.job->program->moves);
}

std::shared_ptr<const TubeTrace> make_tube_trace(const Outcome& outcome, const Monitor& monitor) {
  const Job& job = *outcome.job;
  if (!leaves_programmed_path(outcome) || outcome.path->size() == 0) return nullptr;
  if (job.program->moves.has_tip()) return nullptr;  // setpoints are of the axes, and the path is the tip's
  const auto programmed = build_path(job.program->moves, job.machine.tool_change, {monitor.stop, {}});
  if (!programmed || programmed->size() == 0) return nullptr;
  const double reach = kReach * std::max(judged_tolerance(job.program->moves, job.options.corner), 1e-6);
  TubeFollower follower(*programmed, outcome, reach);
  auto trace = std::make_shared<TubeTrace>();
  Sampler sampler = sampler_of(outcome);
  bool follows = true;
  for (Setpoints chunk; follows && sampler.next(chunk);) {
    if (monitor.is_cancelled()) return nullptr;
    for (std::size_t k = 0; follows && k < chunk.size(); ++k) follows = follower.take(chunk, k, *trace);
  }
  find_worst(*trace);
  return trace;
}

}  // namespace toolpace::ui
