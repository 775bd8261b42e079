#pragma once
/// Tolerances that a program names itself, by G64 P.

#include <cstddef>

#include "toolpace/nc/moves.h"

namespace toolpace::ui {

struct ProgramTolerance {
  std::size_t blocks = 0, all = 0;  ///< that move with a tolerance of the program, and that move at all
  double least = 0, most = 0;       ///< [mm] 0 where `blocks` is 0
};

ProgramTolerance tolerances_of(const Moves& moves);

}  // namespace toolpace::ui
