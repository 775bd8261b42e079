#pragma once
/// The machine's reference points: ways there and back, G27 to G30.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

/// G28 and G30: through the given point, then the named axes (all, if none is named) to the point that parameters from
/// `stored` on keep.
bool go_home(Context& context, const Block& block, int stored);

/// G28.1 and G30.1: keeps the point where the machine stands.
void store_home(Context& context, int stored);

/// G100 T of Brother: to X Y at once, the tool is changed on the way, then to Z. Without T it is the machine's own.
bool change_tool_on_the_way(Context& context, const Block& block);

/// G27: to the given point, where the controller would check that it is the reference point.
bool go_to_reference(Context& context, const Block& block);

/// G29: through the point that the way home led through, to the given one.
bool leave_reference(Context& context, const Block& block);

}  // namespace toolpace::nc
