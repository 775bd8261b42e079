#pragma once
/// What a block's words are for: which motion takes its axis words, and whether each word has a code that uses it.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

constexpr bool is_cycle(Code code) {
  return (code >= 730 && code <= 760) || (code >= 810 && code <= 890) || code == kFineBoring || code == kBackBoring;
}

/// The motion code that the block runs; kNoCode for none.
bool find_motion(Context& context, const Block& block, Code& motion);

/// Words that nothing in the block uses are faults.
bool check_words(Context& context, const Block& block, Code motion);

}  // namespace toolpace::nc
