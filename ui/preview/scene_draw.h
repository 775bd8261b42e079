#pragma once
/// A ContourScene into the pixels of an image.

#include <QImage>
#include <QSizeF>

class QPainter;

#include "drawing/colour_map.h"
#include "drawing/contour_scene.h"
#include "preview/strokes.h"

namespace toolpace::ui {

struct SceneStyle {
  ColourBy by = ColourBy::speed;
  const ColourTable* colours = nullptr;  ///< by level; by cause index for ColourBy::limit; null = `plain` everywhere
  QRgb plain = 0xff000000, rapid = 0xff808080;
  double width = 1.5;  ///< of the lines [px of the image]
  double dash = 5.0;   ///< of rapids, and of everything if `all_dashed` [px of the image]
  bool all_dashed = false;
  bool rapids = true;  ///< whether they are drawn
  bool smooth = true;
  double detail = 0.75;  ///< largest distance between drawn and true line [px of the image]
  double cut = 4;  ///< long pieces are cut this short, so that their colour can change along them [px of the image]
  std::size_t most_cuts = 40'000;  ///< in one picture; more make longer ones. 0 = none
  double most_pixels = 60e6;       ///< of strokes; beyond, a part of the pieces stands for all [px]
};

/// Draws what of the scene can be seen, at the level of detail that `projection` (in pixels of the image) asks for.
/// @return number of pieces drawn
std::size_t draw_scene(QImage& image, const ContourScene& scene, const Projection& projection, const SceneStyle& style);

/// The same as vectors.
void paint_scene(QPainter& painter, const ContourScene& scene, const Projection& projection, const QSizeF& size,
                 const SceneStyle& style);

/// Draws where the tool really went, its distance across the commanded path enlarged; being late along it is left out.
/// @return number of pieces drawn
std::size_t draw_trace(QImage& image, const ErrorTrace& trace, const Projection& projection, double enlargement,
                       QRgb colour, double width);

/// The same as vectors.
std::size_t paint_trace(QPainter& painter, const ErrorTrace& trace, const Projection& projection, double enlargement,
                        QRgb colour, double width);

/// What a picture of the scene would take.
DrawingLoad drawing_load(const ContourScene& scene, const Projection& projection, const QSizeF& size);

}  // namespace toolpace::ui
