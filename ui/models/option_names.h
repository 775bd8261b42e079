#pragma once
/// Choices of planning, as people call them.

#include <QString>

#include "toolpace/plan/options.h"

namespace toolpace::ui {

QString corner_title(CornerRule rule);
QString ramps_title(Ramps ramps);

}  // namespace toolpace::ui
