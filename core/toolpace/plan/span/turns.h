#pragma once
/// Where ramps across blocks turn back without coming to rest in their acceleration.

#include <cstdint>
#include <vector>

#include "toolpace/law/law.h"
#include "toolpace/limits/speed_limits.h"

namespace toolpace::detail {

/// At a reversal an axis goes from +v to −v in one change of speed. Along the path that is a stretch that ends at v = 0 with the
/// acceleration −a, and one that begins with +a: nothing steps, and the node is not passed.
struct Turn {
  std::uint32_t node;
  double acceleration;  ///< a [mm/s²] ≥ 0; 0 = a rest
};

/// Whether a law's ramps turn: those that are shaped by jerk and acceleration alone. The others come to rest by definition.
inline bool turns_back(LawKind law) { return law == LawKind::seven_phase || law == LawKind::time_optimal; }

/// Turns that a chain may make, rising: with as much acceleration as both stretches may use all over, and can come to and away
/// from within the block beside the node and its top speed. The shortest cycle from (v = 0, +a) to (0, −a) takes (2/3)·a³/J² of
/// length, and a²/2J of speed. A node that gains nothing on being crossed at its cap is not there, but where one of its
/// sides is all that holds it back: then it parts the two with a rest. Stretches with curves, whose plans are timed anew from
/// rest to rest, have none.
/// @param cap    of the nodes, no higher than either neighbour's [mm/s]
/// @param nodes  reversals to choose from, rising
std::vector<Turn> possible_turns(const SpeedLimits& limits, const std::vector<double>& cap,
                                 std::vector<std::uint32_t> nodes);

/// Whether turning with this acceleration is faster than crossing at a speed, as a rule.
bool is_worth_turning(double acceleration, double jerk, double speed);

}  // namespace toolpace::detail
