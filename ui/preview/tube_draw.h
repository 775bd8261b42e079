#pragma once
/// Draws the tolerance band: programmed path, band, and the smoothed path inside it, enlarged about the programmed one.

#include <QImage>
#include <QString>

#include "drawing/projection.h"
#include "drawing/tube_trace.h"
#include "models/units.h"
#include "theme/theme.h"

class QPainter;

namespace toolpace::ui {

struct TubeStyle {
  Theme theme;
  double enlargement = 1.0;  ///< of band and offset
  double width = 1.6;        ///< of the smoothed path [px of the image]
};

/// From this share of the tolerance on it counts as used up and is drawn in the colour of a warning.
inline constexpr double kUsedUp = 0.9;

/// The band and, dashed, the programmed path: to be drawn beneath the plan.
/// @return false where the band is too narrow to be seen, or too long to be drawn in time
bool draw_band(QImage& image, const TubeTrace& trace, const Projection& projection, const TubeStyle& style);

/// The planned path, its distance from the programmed one enlarged like the band; where the tolerance is used up, in the
/// colour of a warning. With a ring at the place that uses most of it. To be drawn over the plan.
void draw_inside_band(QImage& image, const TubeTrace& trace, const Projection& projection, const TubeStyle& style);

/// The same two as vectors; what lies outside `window` is left out.
bool paint_band(QPainter& painter, const QRectF& window, const TubeTrace& trace, const Projection& projection,
                const TubeStyle& style);
void paint_inside_band(QPainter& painter, const TubeTrace& trace, const Projection& projection, const TubeStyle& style);

/// "band ±10 µm · at most 9.8 µm used (98 %)"
QString tube_caption(const TubeTrace& trace, Units unit);

/// "4.2 of 10 µm tolerance (42 %)" at a row; empty where there is no tolerance.
QString tube_text(const TubeTrace& trace, std::size_t row, Units unit);

}  // namespace toolpace::ui
