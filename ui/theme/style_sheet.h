#pragma once
/// The style sheet of the workbench.

#include <QString>

#include "theme/theme.h"

namespace toolpace::ui {

/// Style sheet made from the tokens. `touch`: every control at least 48 px high.
QString style_sheet(const Theme& tokens, bool touch);

}  // namespace toolpace::ui
