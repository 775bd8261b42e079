#pragma once
/// Orthographic view of the workpiece: how a point in mm lands on the screen, and back.

#include <Eigen/Core>
#include <QPointF>
#include <QSizeF>
#include <cstdint>

namespace toolpace::ui {

enum class View : std::uint8_t { xy, xz, yz, iso, zx };  ///< zx: as at a lathe, Z to the right, X upwards

/// Axis-aligned box [mm]. Empty until something is added.
struct Box {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300), high = Eigen::Vector3d::Constant(-1e300);

  bool is_empty() const { return low.x() > high.x(); }
  void add(const Eigen::Vector3d& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  Eigen::Vector3d centre() const { return (low + high) / 2; }
  double diagonal() const { return is_empty() ? 0.0 : (high - low).norm(); }
};

/// screen = origin + scale · axes · (point − pivot), with y pointing down the screen.
struct Projection {
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();  ///< unit, towards the right of the screen
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();     ///< unit, towards the top
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();   ///< [mm], lands on origin
  double scale = 1.0;                                ///< [px/mm], > 0
  QPointF origin;                                    ///< [px]

  QPointF map(const Eigen::Vector3d& point) const;
  /// Moves the picture by a number of pixels.
  void pan(const QPointF& delta) { origin += delta; }
  /// Scales about a fixed screen point; the scale stays within [least, most].
  void zoom(double factor, const QPointF& fixed, double least, double most);
  /// Turns the view about the pivot: `turn` about Z, `tilt` about the screen's horizontal [rad].
  void orbit(double turn, double tilt);
};

/// The directions of a named view. Looking along −Z, +Y, −X; isometric from the front right.
Projection named_view(View view);

/// The view to begin with: `wanted`, but for a flat path that it would see from its edge, as that of a lathe from above.
View suited_view(View wanted, const Box& box);

/// The same view direction, scaled and placed so that `box` fills `size` but for `margin` px on each side. A box
/// without extent is shown at a scale of its own: one point stands in the middle.
Projection fitted(Projection projection, const Box& box, const QSizeF& size, double margin);

}  // namespace toolpace::ui
