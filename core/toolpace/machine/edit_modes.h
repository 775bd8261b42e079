#pragma once
/// [[servo.X.modes]] in the text of a machine file.

#include "toolpace/limits/servo_axis.h"
#include "toolpace/machine/toml_editor.h"

namespace toolpace::detail {

/// Brings the modes of an axis from those that the text holds to others: value by value where they are told in sections, as a whole
/// where they stand in one list.
void edit_modes(TomlEditor& editor, std::size_t axis, const std::vector<AxisMode>& had,
                const std::vector<AxisMode>& wanted);

}  // namespace toolpace::detail
