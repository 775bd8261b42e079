#pragma once
/// The turning cycles of lathes: G70 (finish), G71 (rough along Z), G72 (rough along X), with a contour from a sub-program.

#include <vector>

#include "toolpace/nc/context.h"
#include "toolpace/nc/motion/lathe_profile.h"
#include "toolpace/nc/motion/lathe_roughing.h"

namespace toolpace::nc {

constexpr bool is_lathe_cycle(Code code) { return code >= 700 && code <= 722; }

/// A cycle's words. Lengths in mm.
struct LatheCycle {
  Code code = kNoCode;
  int contour = 0;              ///< Q: number of the sub-program
  Position start{};             ///< X Z: where the cycle begins
  double allowance = 0.0;       ///< D: distance from the contour; of G70 that of the first pass
  double last_allowance = 0.0;  ///< E of G70: distance of the last pass
  int passes = 1;               ///< P of G70
  Point shift;                  ///< W U of G71 and G72, in the profile's frame
  Roughing roughing;            ///< I, R and the code's form
};

/// Checks where the cycle may run, reads its words, and goes to its start.
bool begin_lathe_cycle(Context& context, const Block& block, Code code, LatheCycle& cycle);

/// Cuts the contour, whose first element leads from the cycle's start to it. `budget` bounds the calculation.
bool run_lathe_cycle(Context& context, const Block& block, const LatheCycle& cycle, std::vector<ContourElement> contour,
                     WorkBudget& budget);

}  // namespace toolpace::nc
