#pragma once
/// Choices of planning, as people call them.

#include <QString>

#include "toolpace/plan/options.h"
#include "toolpace/tune/tuning_space.h"

namespace toolpace::ui {

QString corner_title(CornerRule rule);
QString ramps_title(Ramps ramps);
QString knob_title(Knob knob);

}  // namespace toolpace::ui
