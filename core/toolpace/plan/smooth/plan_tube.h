#pragma once
/// The fastest motion through the tolerance tube of a path, as a cubic B-spline in time.

#include <optional>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/plan/for_each.h"
#include "toolpace/plan/smooth/tube_path.h"

namespace toolpace {

/// A feed hold: when the motion begins to brake, and how long it rests.
struct TubeHold {
  double time;   ///< [s] ≥ 0 from the motion's start; the brakes are put on at the next knot
  double pause;  ///< [s] ≥ 0, rounded to steps
};

/// How much computing a motion is worth. The guarantees are the same.
enum class TubeEffort {
  thorough,  ///< within a few percent of a local optimum
  quick,     ///< some percent from there, for a third of the time: longer steps, few rounds
};

struct TubeMotion {
  double step = 0.001;          ///< h [s]
  std::vector<double> control;  ///< control points, axes values each [mm, deg]; the first and last three are equal
  std::vector<double> pass;     ///< when each vertex of the path is passed [s], from 0 on; never falling
  double deviation = 0;         ///< largest distance from the polyline at stations and vertices [mm, deg]
  std::size_t windows = 0;      ///< optimised
  std::size_t fallbacks = 0;    ///< of these, planned with stops because no faster plan passed every check
  double duration = 0;          ///< [s], a whole number of steps
  bool held = false;            ///< the hold is in it; otherwise it comes after the motion's end
};

/// Plans a path from rest to rest.
///
/// Guarantees: differences of the control points prove every speed, acceleration and jerk limit for all t; every point at
/// a multiple of the period and every vertex of the path is within the tolerance of the other curve, in order (a Fréchet
/// matching up to the sag of one period, √3·A·Ts²/8). Not guaranteed: the global optimum. Windows of bounded size are
/// planned independently of each other, then the stops between them are removed; where nothing but the commanded speed binds
/// for long, nothing is optimised. So time is linear, memory in proportion to path and motion, and the result the same
/// whatever runs the tasks.
///
/// With a hold the motion stops inside the tube, as soon after the hold's time as the limits allow, rests, and goes on to
/// join the motion without it some way behind: the same guarantees.
///
/// @param period  interpolation period [s] > 0
/// @return Error "cancelled"; usage "tube-unbounded" where neither acceleration nor jerk of a moving axis is bounded
Result<TubeMotion> plan_tube(const TubePath& path, const TubeLimits& limits, double period,
                             const ForEach& for_each = for_each_in_turn, const Monitor& monitor = {},
                             const std::optional<TubeHold>& hold = {}, TubeEffort effort = TubeEffort::thorough);

}  // namespace toolpace
