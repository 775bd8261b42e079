#pragma once
/// Back from a pixel to the path, and what else asks where the path runs on the screen.

#include <QPointF>
#include <QRectF>
#include <optional>
#include <vector>

#include "drawing/contour_scene.h"

namespace toolpace::ui {

/// A place on the screen and the way the tool goes there.
struct DirectionMark {
  QPointF at;
  QPointF way;  ///< unit
};

/// Places along the feeds in sight, at least `apart` px from each other along the path and at most `most`; none where
/// the path is too dense for them to say anything.
std::vector<DirectionMark> direction_marks(const ContourScene& scene, const Projection& projection, const QSizeF& size,
                                           double apart, std::size_t most);

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
std::optional<Pick> pick(const ContourScene& scene, const Projection& projection, const QPointF& at, double radius,
                         bool rapids = true);

}  // namespace toolpace::ui
