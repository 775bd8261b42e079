#pragma once
/// The words of canned cycles: which stick from hole to hole, and what they must say.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

/// Lathes drill along Z by G83 to G85 and along X by G87 to G89, whatever the plane.
PlaneAxes cycle_plane(const Context& context, Code code);

/// What the code does: G87 to G89 of lathes are G83 to G85 from the side.
Code cycle_of(const Context& context, Code code);

/// Whether a cycle may run here.
bool check_cycle(Context& context, const Block& block);

/// Takes the words that stick, of a cycle that begins or goes on.
bool remember_cycle_words(Context& context, const Block& block, Code code, bool same_series);

bool find_repeats(Context& context, const Block& block, int& repeats);

}  // namespace toolpace::nc
