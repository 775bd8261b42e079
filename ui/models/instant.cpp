#include "models/instant.h"

#include <algorithm>
#include <cmath>

#include "toolpace/plan/plan.h"
#include "toolpace/plan/restraint.h"
#include "toolpace/sample/motion.h"

namespace toolpace::ui {

bool has_motion(const Outcome& o) {
  return o.path && o.path->size() > 0 && !o.plan.phases.empty() && o.node_time.size() == o.path->node.size();
}

std::optional<std::uint32_t> resting_move(const Outcome& o, std::size_t node, double time) {
  if (time < o.node_time[node]) return std::nullopt;
  const auto& pauses = o.path->pauses;
  auto pause = std::lower_bound(pauses.begin(), pauses.end(), node,
                                [](const Path::Pause& p, std::size_t n) { return p.node < n; });
  double end = o.node_time[node];
  for (; pause != pauses.end() && pause->node == node; ++pause) {
    end += pause->duration;
    if (time < end) return pause->move;
  }
  return std::nullopt;
}

std::optional<Instant> instant_at(const Outcome& o, double time) {
  if (!has_motion(o)) return std::nullopt;
  Motion motion(*o.path, o.plan);
  Instant instant;
  instant.time = std::clamp(std::isfinite(time) ? time : 0.0, 0.0, motion.duration());
  instant.block = segment_at(o.node_time, instant.time);
  motion.at(instant.time, instant.block);
  instant.state = motion.along();
  instant.position = motion.position();
  if (o.job && o.job->program) {
    const Moves& moves = o.job->program->moves;
    const std::size_t end = instant.block + 1;
    auto resting = resting_move(o, instant.block, instant.time);
    if (!resting && end == o.path->size()) resting = resting_move(o, end, instant.time);
    const std::uint32_t row = resting ? *resting : motion.move();
    if (row < moves.line.size() && (row >= moves.file.size() || moves.file[row] == 0)) instant.line = moves.line[row];
  }
  if (const Restraint* restraint = restraint_at(o.restraints, instant.time)) instant.cause = restraint->cause;
  return instant;
}

}  // namespace toolpace::ui
