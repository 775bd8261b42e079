#pragma once
/// How the C library keeps memory.

namespace toolpace::studio {

/// Plans come and go by the tens of megabytes while a slider is dragged. Without this the C library gives each back to
/// the system and has it zeroed anew for the next, which takes as long as planning does. Call it first in main().
void keep_memory_between_plans();

}  // namespace toolpace::studio
