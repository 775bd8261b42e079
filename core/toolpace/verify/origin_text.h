#pragma once
/// What the "meta" of a .npz says of the plan. For use inside verify/ alone.

#include <string>

#include "toolpace/verify/setpoint_file.h"

namespace toolpace::detail {

/// Reads law, shaper, corner, corner_step_mm_s, junction_deviation_mm, tolerance_mm and path_control of an object in JSON; what is
/// missing or of another kind stays unknown, as in files of others.
SetpointOrigin origin_of_text(const std::string& json);

}  // namespace toolpace::detail
