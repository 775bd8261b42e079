#pragma once
/// The stop of a feed hold.

#include <optional>
#include <vector>

#include "toolpace/law/phase.h"

namespace toolpace::detail {

/// Smallest limits while braking.
struct Brakes {
  double deceleration, jerk;
  double release;  ///< jerk that takes a positive acceleration away
};

/// Brakes from a state with `speed` and `acceleration` to rest: at most four phases, from distance 0 and time 0.
///
/// The acceleration falls to −peak, is held there, and rises to 0 as the speed does: v + a²/2J (what is left once the
/// acceleration is 0) is shared out over two equal jerk phases and the hold between them.
/// @return nothing where the present deceleration would stop the motion before the jerk can take it away
std::optional<std::vector<Phase>> brake(double speed, double acceleration, const Brakes& brakes);

}  // namespace toolpace::detail
