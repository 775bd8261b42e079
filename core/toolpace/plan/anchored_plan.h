#pragma once
/// Plans of any law whose ramps run across blocks: block ramps between anchors.

#include <cstdint>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/law/law.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace::detail {

/// Where anchors may stand.
enum class AnchorSites : std::uint8_t {
  touched,  ///< nodes that the acceleration-limited optimum touches, where caps are lower than feeds or feeds change
  touched_changed  ///< … and those where the ramp limits change
};

struct AnchoredLaw {
  LawKind law;
  AnchorSites sites = AnchorSites::touched;
  bool may_remove = true;  ///< whether anchors are removed where that saves time
};

/// Anchors are nodes that the acceleration-limited optimum touches, and those where the feed changes there; the law
/// keeps its accelerations, so it cannot pass a cap that the optimum does not touch. Between anchors a span is planned
/// as one block, under the lowest feed that is touched in it and the smallest limits. Anchors are crossed with zero
/// acceleration; then any of them whose removal saves time and keeps the caps is removed.
/// @param cap  of the nodes, no higher than either neighbour's feed [mm/s]
/// @return no phases when cancelled
MotionPlan plan_anchored_ramps(const SpeedLimits& limits, const std::vector<double>& cap, const AnchoredLaw& anchored,
                               const Monitor& monitor);

/// Caps under which the nodes where the ramp limits change can all be crossed at their cap with zero acceleration: the
/// speeds that seven-phase ramps between anchors give them. The other caps stay.
std::vector<double> settle_where_limits_change(const SpeedLimits& limits, const std::vector<double>& cap);

}  // namespace toolpace::detail
