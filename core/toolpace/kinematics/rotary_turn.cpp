#include "toolpace/kinematics/rotary_turn.h"

namespace toolpace {

Derivatives<Eigen::Vector3d> RotaryTurn::at(double s) const {
  const double u = (begin + s) / scale;
  const auto& c = coefficients;
  Derivatives<Eigen::Vector3d> d;
  d[0] = c[0] + u * (c[1] + u * (c[2] + u * (c[3] + u * (c[4] + u * c[5]))));
  d[1] = (c[1] + u * (2 * c[2] + u * (3 * c[3] + u * (4 * c[4] + u * (5 * c[5]))))) / scale;
  d[2] = (2 * c[2] + u * (6 * c[3] + u * (12 * c[4] + u * (20 * c[5])))) / (scale * scale);
  d[3] = (6 * c[3] + u * (24 * c[4] + u * (60 * c[5]))) / (scale * scale * scale);
  return d;
}

RotaryTurn turn_between(const RotaryPlace& from, const RotaryPlace& to, double length) {
  const Eigen::Vector3d v0 = length * from.first, v1 = length * to.first;
  const Eigen::Vector3d a0 = length * length * from.second, a1 = length * length * to.second;
  // What the second-order beginning leaves of value, first and second derivative at the end.
  const Eigen::Vector3d d = to.angle - from.angle - v0 - a0 / 2, e = v1 - v0 - a0, f = a1 - a0;
  return {{from.angle, v0, a0 / 2, 10 * d - 4 * e + f / 2, -15 * d + 7 * e - f, 6 * d - 3 * e + f / 2}, 0.0, length};
}

}  // namespace toolpace
