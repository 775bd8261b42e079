#pragma once
/// Does a program leave the machine's travel?

#include <vector>

#include "toolpace/base/result.h"
#include "toolpace/kinematics/inverse.h"
#include "toolpace/limits/machine.h"
#include "toolpace/nc/moves.h"
#include "toolpace/path/path.h"

namespace toolpace {

/// How far the machine's rotary axes turn.
RotaryTravel rotary_travel(const Machine& machine);

/// An axis beyond one end of its travel.
struct TravelExcess {
  std::size_t axis = 0;
  bool is_upper = false;
  double excess = 0.0;          ///< beyond the end, at worst [mm, rad]
  std::uint32_t row = 0;        ///< of Moves: the first that does it
  std::uint32_t worst_row = 0;  ///< the one that goes farthest
};

/// Each axis and end that is left. Lines and arcs exactly, splines by their control polygon's piece ends and middle;
/// what is about the tool's tip by its axes at four places of each piece that cut_for_axes() leaves.
std::vector<TravelExcess> find_travel_excess(const Path& path, const Machine& machine);

/// One warning "travel" for each of these, at the first line, with the worst excess.
Diagnostics check_travel(const Path& path, const Moves& moves, const Machine& machine);

}  // namespace toolpace
