#pragma once
/// Choices of planning, as people call them.

#include <QString>
#include <vector>

#include "toolpace/limits/servo_axis.h"
#include "toolpace/plan/options.h"
#include "toolpace/tune/tuning_space.h"

namespace toolpace::ui {

QString corner_title(CornerRule rule);
QString ramps_title(Ramps ramps);
QString shaper_title(ShaperKind kind);
/// "31.5 Hz (ζ 0.02), 84 Hz (ζ 0.03, 40 %)", or a dash.
QString modes_text(const std::vector<AxisMode>& modes);
QString knob_title(Knob knob);

}  // namespace toolpace::ui
