#pragma once
/// The second pass: accelerations at the touched nodes that suit the bridges on both sides.

#include <cstdint>
#include <vector>

#include "toolpace/plan/motion_plan.h"
#include "toolpace/plan/span/hull.h"
#include "toolpace/plan/span/kernel.h"

namespace toolpace::detail {

/// Tilts each touched node towards the middle of the accelerations with which it is met and left: a kernel that is met
/// with little deceleration and left with much acceleration is crossed while speeding up.
///
/// A tilt is at most √(J·cap/2), so that the bottom keeps three quarters of the cap, and within the accelerations; a tilt
/// that would put the bottom past a neighbour's is halved, then dropped.
void tilt_kernels(const std::vector<HullEntry>& hull, const SpanLimits& limits, std::vector<Kernel>& kernels);

/// Lets the stretch begin and end at v = 0 with these accelerations, ≥ 0: as tilts of its first and last kernel, which stay.
/// Plateaus beside them begin where the motion has come up from the turn.
void tilt_ends(double begin, double end, const SpanLimits& limits, std::vector<Kernel>& kernels);

/// The tilt that suits a node which is met and left with these accelerations, without regard to its neighbours.
double suitable_tilt(const Kernel& k, double meet, double leave, const SpanLimits& limits);

/// Takes all tilts away but those of the ends.
void drop_all_tilts(const SpanLimits& limits, std::vector<Kernel>& kernels);

/// Kernels whose caps are passed.
struct Broken {
  std::vector<std::uint32_t> kernels;  ///< ascending
  std::size_t radius;                  ///< entries on either side that may be to blame
};

/// Takes the tilts away from the kernels of hull entries around each of the broken ones.
/// @return the kernels that were changed, ascending
std::vector<std::uint32_t> drop_tilts(const std::vector<HullEntry>& hull, const SpanLimits& limits,
                                      const Broken& broken, std::vector<Kernel>& kernels);

/// Phases from the first kernel of a chain to the last one, exact polynomials, and the places of the nodes that they count from.
struct PlacedPhases {
  const std::vector<Phase>& phases;
  const std::vector<ExactPlace>& position;
};

/// Kernels whose cap the phases pass, ascending. With tilts the order of bottoms is not quite that of the caps, so a
/// hull may pass a cap that it does not touch. (A touched node is crossed at its cap by construction.)
std::vector<std::uint32_t> find_broken(const std::vector<Kernel>& kernels, const SpanLimits& limits,
                                       const std::vector<HullEntry>& hull, const PlacedPhases& placed);

}  // namespace toolpace::detail
