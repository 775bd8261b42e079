#include "models/program_tolerance.h"

#include <algorithm>

namespace toolpace::ui {

ProgramTolerance tolerances_of(const Moves& moves) {
  ProgramTolerance found;
  for (std::size_t i = 0; i < moves.kind.size(); ++i) {
    if (!is_motion(moves.kind[i])) continue;
    ++found.all;
    const MoveMode& mode = moves.modes[moves.mode[i]];
    if (mode.control != PathControl::blend || !(mode.tolerance > 0)) continue;
    found.least = found.blocks == 0 ? mode.tolerance : std::min(found.least, mode.tolerance);
    found.most = std::max(found.most, mode.tolerance);
    ++found.blocks;
  }
  return found;
}

}  // namespace toolpace::ui
