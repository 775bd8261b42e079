#pragma once
/// Where work coordinates lie: G54 … G59.3, G10 L2 L20, G52, G92.x, rotation, and the stored points of G28 and G30.

#include <vector>

#include "toolpace/nc/context.h"
#include "toolpace/nc/read_options.h"

namespace toolpace::nc {

/// Offsets as they would be with system 1 … 9 active.
Offsets system_offsets(const Context& context, int system);

/// Makes a system the active one. The machine does not move.
void activate_system(Context& context, int system);

bool set_system(Context& context, const Block& block);

/// G10 and the G92 family, G52, G28, G30 and their .1 forms.
bool run_once_code(Context& context, const Block& block);

/// G68 X Y R, G69 (Fanuc)
bool set_turned_plane(Context& context, const Block& block);

/// Writes the origins of systems that the reader was given.
void set_work_offsets(Context& context, const std::vector<WorkOffset>& offsets);

/// Takes the offsets of a parameter file into use.
void adopt_parameters(Context& context);

}  // namespace toolpace::nc
