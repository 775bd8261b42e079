#pragma once
/// Planning: from speed limits to the motion that is as fast as the law and the look-ahead allow.

#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/path/node_positions.h"
#include "toolpace/plan/motion_plan.h"
#include "toolpace/plan/options.h"

namespace toolpace {

/// Plans the whole chain of blocks from rest to rest.
///
/// Reads `law`, `lookahead` and `ramps` of the options; everything else is in the limits already. The plan never passes
/// a cap, keeps the ramp limits of every block it runs through, is continuous, and ends exactly at the sum of the
/// lengths. It depends on nothing but its arguments.
///
/// With Ramps::block a ramp ends inside its block, and a node is crossed with zero acceleration; a window of
/// `lookahead` blocks that ends at rest slides over the chain (1 = a stop at every node). With Ramps::span ramps run
/// across blocks, and look-ahead means that at every node the machine can still stop inside its window; a deeper one
/// never takes longer. Where the path goes back (SpeedLimits::reversals) seven-phase and time-optimal ramps across blocks are at
/// rest for an instant only, with the acceleration that both sides have.
///
/// @return usage error "limits-unbounded" where speed and acceleration (or jerk, where the law needs it) have no limit
///         at all; infeasible "feed-zero" where a block may not move; cancelled
/// @throws std::invalid_argument where the arrays do not fit together (a fault of the caller)
/// @source Ning et al. 2014, section 2 (block); the sources of plan/span are named there
Result<MotionPlan> plan_motion(const SpeedLimits& limits, const PlanOptions& options, const Monitor& monitor = {});

/// Time after a phase's start at which it has covered `way` [s]: 0 where that is not above 0, its duration where it does not
/// come that far.
double time_to_cover(const Phase& phase, double way);

/// Time at which the plan arrives at each node [s], size() + 1 values, not falling. Where it rests at a node this is
/// the beginning of the rest.
std::vector<double> node_times(const SpeedLimits& limits, const MotionPlan& plan);

/// Segment under the tool at a time, by the arrivals at the nodes: from an arrival on it is the next one.
/// @pre node_time.size() ≥ 2
std::size_t segment_at(const std::vector<double>& node_time, double time);

/// Of each node of a chain of its own [mm].
inline NodePositions node_positions(const SpeedLimits& limits) { return NodePositions(limits.length); }

}  // namespace toolpace
