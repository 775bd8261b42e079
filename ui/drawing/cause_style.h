#pragma once
/// How the causes that hold the speed down are named and coloured, the same in preview, ribbon and tables.

#include <QColor>
#include <QString>
#include <array>

#include "drawing/colour_map.h"
#include "toolpace/limits/speed_limits.h"

namespace toolpace::ui {

using toolpace::kCauseCount;

/// One colour a cause. Told apart under the common colour-vision deficiencies; contrast ≥ 1.9 against the ground.
/// Running at the programmed feed is quiet grey: nothing holds the tool back.
QColor cause_colour(Cause cause, Ground ground);

/// Short translated name, such as "axis acceleration".
QString cause_title(Cause cause);

inline constexpr std::size_t index_of(Cause cause) { return static_cast<std::size_t>(cause); }

}  // namespace toolpace::ui
