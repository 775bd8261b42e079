#pragma once
/// Where work coordinates lie: G54 … G59.3, G10 L2 L20, G52, G92.x and rotation.

#include <vector>

#include "toolpace/nc/context.h"
#include "toolpace/nc/read_options.h"

namespace toolpace::nc {

/// Changes the offsets and keeps the machine where it is.
void change_offsets(State& state, const Offsets& offsets);

/// Offsets as they would be with system 1 … 9 active.
Offsets system_offsets(const Context& context, int system);

/// Makes a system the active one. The machine does not move.
void activate_system(Context& context, int system);

bool set_system(Context& context, const Block& block);

bool run_g10(Context& context, const Block& block);

/// G52, G92 and its .1 to .3.
bool run_g92(Context& context, const Block& block, Code code);

/// G68 X Y R, G69 (Fanuc)
bool set_turned_plane(Context& context, const Block& block);

/// Writes the origins of systems that the reader was given.
void set_work_offsets(Context& context, const std::vector<WorkOffset>& offsets);

/// Takes the offsets of a parameter file into use.
void adopt_parameters(Context& context);

}  // namespace toolpace::nc
