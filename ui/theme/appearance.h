#pragma once
/// How the application is dressed in a theme.

#include <QColor>
#include <QFont>

#include "theme/theme.h"

class QApplication;

namespace toolpace::ui {

/// Colour `share` of the way from `a` to `b`, 0 … 1.
QColor mixed(const QColor& a, const QColor& b, double share);

/// Monospace font of NC text, `points` high.
QFont monospace_font(qreal points);

/// Sets palette and style sheet of the application; before there are widgets this costs least. `touch`: every control at least 48 px high.
void apply_theme(QApplication& application, const Theme& tokens, bool touch);

}  // namespace toolpace::ui
