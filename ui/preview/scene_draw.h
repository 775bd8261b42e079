#pragma once
/// A ContourScene into the pixels of an image, and back from a pixel to the path.

#include <QImage>
#include <QRectF>
#include <optional>

class QPainter;

#include "preview/colour_map.h"
#include "preview/contour_scene.h"

namespace toolpace::ui {

struct SceneStyle {
  ColourBy by = ColourBy::speed;
  const ColourTable* colours = nullptr;  ///< by level; by cause index for ColourBy::limit; null = `plain` everywhere
  QRgb plain = 0xff000000, rapid = 0xff808080;
  double width = 1.5;  ///< of the lines [px of the image]
  double dash = 5.0;   ///< of rapids, and of everything if `all_dashed` [px of the image]
  bool all_dashed = false;
  bool smooth = true;
  double detail = 0.75;  ///< largest distance between drawn and true line [px of the image]
  double cut = 4;  ///< long pieces are cut this short, so that their colour can change along them [px of the image]
  std::size_t most_cuts = 40'000;  ///< in one picture; more make longer ones. 0 = none
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

/// A place on the screen and the way the tool goes there.
struct DirectionMark {
  QPointF at;
  QPointF way;  ///< unit
};

/// Places along the feeds in sight, at least `apart` px from each other along the path and at most `most`; none where
/// the path is too dense for them to say anything.
std::vector<DirectionMark> direction_marks(const ContourScene& scene, const Projection& projection, const QSizeF& size,
                                           double apart, std::size_t most);

/// How many pieces a picture of the scene takes.
std::size_t visible_pieces(const ContourScene& scene, const Projection& projection, const QSizeF& size);

/// Runs of vertices of the full line whose chunk may touch a rectangle of the screen: [first, last].
std::vector<std::pair<std::size_t, std::size_t>> runs_near(const ContourScene& scene, const Projection& projection,
                                                           const QRectF& rectangle);

struct Pick {
  std::size_t piece;  ///< of the full line
  double fraction;    ///< from its first vertex to its second
  double time;        ///< [s]
  double distance;    ///< on the screen [px]
};

/// The piece nearest to a screen point, within `radius` px; of several as near, the one drawn last.
std::optional<Pick> pick(const ContourScene& scene, const Projection& projection, const QPointF& at, double radius);

}  // namespace toolpace::ui
