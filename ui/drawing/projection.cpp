#include "drawing/projection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace toolpace::ui {

QPointF Projection::map(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d d = point - pivot;
  return {origin.x() + scale * right.dot(d), origin.y() - scale * up.dot(d)};
}

void Projection::zoom(double factor, const QPointF& fixed, double least, double most) {
  const double next = std::clamp(scale * factor, least, most);
  const double ratio = next / scale;
  origin = fixed + (origin - fixed) * ratio;
  scale = next;
}

void Projection::orbit(double turn, double tilt) {
  const Eigen::AngleAxisd about_z(turn, Eigen::Vector3d::UnitZ());
  right = about_z * right;
  up = about_z * up;
  const Eigen::AngleAxisd about_right(tilt, right);
  const Eigen::Vector3d tilted = about_right * up;
  // Beyond the poles Z would point down the screen and dragging would feel turned round.
  if (tilted.z() >= 0.0) up = tilted;
  right.normalize();
  up = (up - up.dot(right) * right).normalized();
}

Projection named_view(View view) {
  Projection p;
  switch (view) {
    case View::xy: break;
    case View::xz: p.up = Eigen::Vector3d::UnitZ(); break;
    case View::yz:
      p.right = Eigen::Vector3d::UnitY();
      p.up = Eigen::Vector3d::UnitZ();
      break;
    case View::zx:
      p.right = Eigen::Vector3d::UnitZ();
      p.up = Eigen::Vector3d::UnitX();
      break;
    case View::iso:
      p.right = Eigen::Vector3d(1, 1, 0).normalized();
      p.up = Eigen::Vector3d(-1, 1, 2).normalized();
      break;
  }
  return p;
}

View suited_view(View wanted, const Box& box) {
  if (box.is_empty()) return wanted;
  const Eigen::Vector3d extent = box.high - box.low;
  const double whole = std::max(extent.maxCoeff(), 1e-300);
  constexpr double kNothing = 1e-6;  // of the whole
  // What a view shows: the area first, and of a line its length.
  const auto shown = [&](View view) {
    const Projection p = named_view(view);
    const double across = p.right.cwiseAbs().dot(extent) / whole, upwards = p.up.cwiseAbs().dot(extent) / whole;
    const bool flat = std::min(across, upwards) < kNothing;
    return flat ? kNothing * std::max(across, upwards) : across * upwards;
  };
  View best = wanted;
  for (const View view : {View::xy, View::xz, View::yz}) {
    if (shown(view) > shown(best)) best = view;
  }
  return shown(wanted) < 2 * kNothing && shown(best) > 100 * shown(wanted) ? best : wanted;
}

Projection fitted(Projection projection, const Box& box, const QSizeF& size, double margin) {
  projection.origin = {size.width() / 2, size.height() / 2};
  if (box.is_empty()) {
    projection.pivot.setZero();
    projection.scale = 1.0;
    return projection;
  }
  projection.pivot = box.centre();
  const Eigen::Vector3d extent = box.high - box.low;
  const double wide = extent.dot(projection.right.cwiseAbs());
  const double tall = extent.dot(projection.up.cwiseAbs());
  const double room_x = std::max(size.width() - 2 * margin, 1.0), room_y = std::max(size.height() - 2 * margin, 1.0);
  double scale = 0;
  if (wide > 0) scale = room_x / wide;
  if (tall > 0) scale = scale > 0 ? std::min(scale, room_y / tall) : room_y / tall;
  // Seen end on, or a single point: as large as the whole box would be, or 10 px a millimetre.
  if (!(scale > 0) || !std::isfinite(scale)) {
    const double diagonal = extent.norm();
    scale = diagonal > 0 ? std::min(room_x, room_y) / diagonal : 10.0;
  }
  projection.scale = std::clamp(scale, 1e-9, 1e12);
  return projection;
}

}  // namespace toolpace::ui
