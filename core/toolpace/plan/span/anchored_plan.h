#pragma once
/// Plans of any law whose ramps run across blocks: block ramps between anchors.

#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/law/law.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace::detail {

struct AnchoredLaw {
  LawKind law;
  double seam_ratio = 1e300;  ///< nodes where ramp limits differ by more than this may be anchors, too
  bool may_remove = true;     ///< whether anchors are removed where that saves time
};

/// Anchors are nodes that the acceleration-limited optimum touches, and those where the feed changes there; the law
/// keeps its accelerations, so it cannot pass a cap that the optimum does not touch. Between anchors a span is planned
/// as one block, under the lowest feed that is touched in it and the smallest limits. Anchors are crossed with zero
/// acceleration; then any of them whose removal saves time and keeps the caps is removed.
/// @param cap  of the nodes, no higher than either neighbour's feed [mm/s]
/// @return no phases when cancelled
MotionPlan plan_anchored_ramps(const SpeedLimits& limits, const std::vector<double>& cap, const AnchoredLaw& anchored,
                               const Monitor& monitor);

/// Caps under which the nodes where ramp limits differ by more than `seam_ratio` can all be crossed with zero acceleration:
/// the speeds that seven-phase ramps between anchors give them. The other caps stay.
std::vector<double> settle_seams(const SpeedLimits& limits, const std::vector<double>& cap, double seam_ratio);

}  // namespace toolpace::detail
