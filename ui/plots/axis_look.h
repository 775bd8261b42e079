#pragma once
/// How the axes of the small plots look.

#include <qcustomplot.h>

#include "theme/theme.h"

namespace toolpace::ui {

/// Colours, fonts and numbers of an axis, with `digits` at most.
void dressAxis(QCPAxis& axis, const Theme& theme, const QFont& font, int digits);

}  // namespace toolpace::ui
