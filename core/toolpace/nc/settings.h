#pragma once
/// What a block sets for the blocks that follow: feed, speed, plane, units, path control.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

/// G93 G94 G95
bool set_feed_mode(Context& context, const Block& block);
/// G96 G97
bool set_spindle_mode(Context& context, const Block& block);
/// $: exchanges the first spindle with the one that the block names; once more puts them back.
bool exchange_spindle(Context& context, const Block& block);
/// F
bool set_feed(Context& context, const Block& block);
/// S
bool set_speed(Context& context, const Block& block);
/// The other modal groups, in the order of execution.
bool run_settings(Context& context, const Block& block);

/// M72 and the end of a call with M73: all but motion and cutter compensation as it was saved.
void restore_modal(Context& context, const Modal& saved);

}  // namespace toolpace::nc
