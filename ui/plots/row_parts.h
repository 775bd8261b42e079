#pragma once
/// What the stacked plots have in common: frames, titles, curves.

#include <qcustomplot.h>

#include "drawing/profile_curves.h"
#include "theme/theme.h"

namespace toolpace::ui {

inline constexpr double kRowMargin = 0.09, kRowFloor = 0.03;  // of the height, above and below what is drawn

void fill_graph(QCPGraph* graph, const Curve& curve, double factor);
/// As large as the plot is high, so that it does not reach into the next one.
void set_row_label(QCPAxis& axis, const QString& label);
/// The plot's, at a row of its layout.
QCPAxisRect* new_row_rect(QCustomPlot* plot, int row);
void dress_row(QCPAxisRect* rect, const Theme& theme, const QFont& font);

}  // namespace toolpace::ui
