#pragma once
/// The cycles of Fanuc's lathes that take many passes: G70 to G73 along a contour, G74 and G75 in steps, G76 for threads.

#include <vector>

#include "toolpace/nc/context.h"
#include "toolpace/nc/motion/lathe_profile.h"

namespace toolpace::nc {

/// The first block of a cycle's two: depths and ways back, for the second one.
bool set_up_turning(Context& context, const Block& block, Code code);

/// G70 G71 G72 G73 along `contour`, whose first element leads from where the tool stands to it. It comes back there.
bool run_turning_cycle(Context& context, const Block& block, Code code, std::vector<ContourElement> contour,
                       WorkBudget& budget);

/// G74 (holes and grooves in the face), G75 (grooves across).
bool run_grooving(Context& context, const Block& block, Code code);

/// G76
bool run_threads(Context& context, const Block& block);

}  // namespace toolpace::nc
