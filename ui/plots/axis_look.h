#pragma once
/// How the axes of the small plots look.

#include <QFont>

#include "theme/theme.h"

class QCPAxis;

namespace toolpace::ui {

/// Gives an axis its colours, fonts and form of numbers.
void dressAxis(QCPAxis& axis, const Theme& theme, const QFont& font);

}  // namespace toolpace::ui
