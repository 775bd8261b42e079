#pragma once
/// G65 H… of Fanuc's older macros (type A): one operation or jump a block.

#include "toolpace/nc/context.h"
#include "toolpace/nc/flow/flow.h"

namespace toolpace::nc {

/// Whether a G65 block is of this kind: H stands first, and no other words than P Q R behind it.
bool is_macro_arithmetic(const Block& block);

/// #P = Q op R (H01 to H05, H11 to H13, H21 to H28, H31 to H34), a jump to N<P> (H80 to H86), an alarm (H99). Angles in degrees.
/// @return false after recording a fault
bool run_macro_arithmetic(Context& context, Flow& flow, const Block& block);

}  // namespace toolpace::nc
