#pragma once
/// Pictures of widgets, written to build/screenshots for people to look at.

#include <QWidget>

#include "theme/theme.h"

namespace toolpace::ui {

/// Draws the widget as it stands and saves it as <name>.png; returns the picture.
QImage screenshot(QWidget& widget, const QString& name);

/// Gives the application the look of a theme, as the window has it.
void wear(const Theme& theme);

/// Number of different colours, a cheap proof that something is drawn.
int colours_in(const QImage& image);

}  // namespace toolpace::ui
