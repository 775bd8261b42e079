#pragma once
/// From the scene to pixels, fast.

#include <QPointF>
#include <QRectF>
#include <utility>

#include "drawing/lod.h"
#include "drawing/projection.h"

namespace toolpace::ui {

/// A projection with everything multiplied out, for vertices relative to the scene's centre.
struct Screen {
  Eigen::Vector3d x, y;  // px a mm
  double x0, y0;         // px

  Screen(const Projection& p, const Eigen::Vector3d& centre)
      : x(p.scale * p.right),
        y(-p.scale * p.up),
        x0(p.origin.x() + x.dot(centre - p.pivot)),
        y0(p.origin.y() + y.dot(centre - p.pivot)) {}

  QPointF map(const Eigen::Vector3f& v) const {
    const Eigen::Vector3d d = v.cast<double>();
    return {x0 + x.dot(d), y0 + y.dot(d)};
  }
  bool meets(const ChunkBox& box, const QRectF& rectangle) const {
    const Eigen::Vector3d middle = (box.low + box.high).cast<double>() / 2;
    const Eigen::Vector3d half = (box.high - box.low).cast<double>() / 2;
    const double half_x = x.cwiseAbs().dot(half), half_y = y.cwiseAbs().dot(half);
    const double cx = x0 + x.dot(middle), cy = y0 + y.dot(middle);
    return cx + half_x >= rectangle.left() && cx - half_x <= rectangle.right() && cy + half_y >= rectangle.top() &&
           cy - half_y <= rectangle.bottom();
  }
};

/// The share of a line that lies in a rectangle; begin > end if none does.
std::pair<double, double> inside(const QPointF& from, const QPointF& to, const QRectF& window);

}  // namespace toolpace::ui
