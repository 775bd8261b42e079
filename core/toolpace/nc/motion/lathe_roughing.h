#pragma once
/// The passes of G71 and G72: level by level from the start down to the contour, then along it from pocket to pocket.

#include <vector>

#include "toolpace/nc/motion/lathe_profile.h"
#include "toolpace/nc/moves.h"

namespace toolpace::nc {

/// What of the material a cycle takes.
enum class RoughingPart : std::uint8_t {
  all,            ///< G71, G72
  first_pocket,   ///< G71.1, G72.1: what lies open from the start, then over the contour's rising parts
  later_pockets,  ///< G71.2, G72.2: what the former left
};

struct Roughing {
  RoughingPart part = RoughingPart::all;
  double step = 1.0;                ///< [mm] I, between levels, > 0
  bool first_pass_is_deep = false;  ///< not at the start's own level, but a step below
  double retract = 0.5;             ///< [mm] R, away from the work after each pass, ≥ 0
};

/// A move of a cycle, in the profile's frame.
struct LatheMove {
  MoveKind kind = MoveKind::feed;  ///< rapid, feed or arc
  Point end, centre;
  int turn = 0;  ///< of an arc
};

inline constexpr std::size_t kMostLatheMoves = 1'000'000;

/// Appends the passes over a closed profile. @return false after recording a fault
bool rough(const LatheProfile& profile, const Roughing& roughing, std::vector<LatheMove>& moves, WorkBudget& budget,
           FaultSink& faults);

}  // namespace toolpace::nc
