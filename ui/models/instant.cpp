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
    const std::uint32_t row = motion.move();
    if (row < moves.line.size() && (row >= moves.file.size() || moves.file[row] == 0)) instant.line = moves.line[row];
  }
  if (const Restraint* restraint = restraint_at(o.restraints, instant.time)) instant.cause = restraint->cause;
  return instant;
}

}  // namespace toolpace::ui
