#include "toolpace/limits/travel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "toolpace/base/axis_unit.h"
#include "toolpace/path/axis_curve.h"

namespace toolpace {
namespace {

// Rounding of offsets and units must not read as leaving the travel.
constexpr double kTravelRounding = 1e-9;
constexpr int kPlaces = 4;  // looked at on what is about the tool's tip

/// About the tool's tip, no axis goes farther from where it is at a segment's end.
struct Reach {
  double linear, rotary;  ///< [mm], [rad]
};

/// The tip moves by no more than the length, and what turns takes it along on arms no longer than from the farthest joint.
Reach reach_of(const Path& path, std::size_t i) {
  double turn = (path.end_of(i) - path.node[i]).tail<3>().cwiseAbs().sum();
  if (path.kind[i] >= SegmentKind::spline) {
    if (path.kind[i] == SegmentKind::spline || path.detail[i] >= Path::kCurveBlend) return {kUnlimited, kUnlimited};
    const CornerBlend& blend = path.corner_blends[path.detail[i]];
    turn = (blend.before.tail<3>().cwiseAbs() + blend.after.tail<3>().cwiseAbs()).sum();
  }
  const Chain& chain = *path.chain_of(i);
  double arm = path.end_of(i).head<3>().norm() + path.length[i] + chain.tool_length;
  for (const RotaryJoint& joint : chain.joints) arm += 2 * joint.point.norm();
  return {path.length[i] + turn * arm, turn};
}

bool is_inside(const AxisVector& p, const Reach& reach, const Machine& machine) {
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const double value = p[static_cast<Eigen::Index>(k)], margin = is_rotary(k) ? reach.rotary : reach.linear;
    const AxisLimits& axis = machine.axes[k];
    if (!(value - margin >= axis.travel_min && value + margin <= axis.travel_max)) return false;
  }
  return true;
}

/// Calls f with points that include every extreme of every axis on the segment, or with fewer where no axis comes near its ends.
template <class F>
void for_extremes(const Path& path, std::size_t i, const Machine& machine, F f) {
  const AxisCurve curve(path);
  if (!curve.is_path(i)) {
    const AxisVector end = curve.end_of(i);
    if (!curve.is_straight(i) && !is_inside(end, reach_of(path, i), machine)) {
      for (int k = 1; k < kPlaces; ++k) f(curve.point_at(i, path.length[i] * k / kPlaces));
    }
    f(end);
    return;
  }
  f(path.end_of(i));
  if (path.kind[i] == SegmentKind::line) return;
  if (path.kind[i] != SegmentKind::arc) {
    f(point_at(path, i, path.length[i] / 2));
    return;
  }
  const ArcCurve& arc = path.arcs[path.detail[i]];
  for (int axis = 0; axis < 3; ++axis) {
    // d/dφ (cos φ·radial + sin φ·lateral) = 0; exact for circles, within the growth of the radius for spirals.
    const double extreme = std::atan2(arc.lateral[axis], arc.radial[axis]);
    for (double phi = extreme - 2 * std::numbers::pi; phi < arc.sweep; phi += std::numbers::pi) {
      if (phi > 0) f(arc_point(arc, phi));
      if (phi > 4 * std::numbers::pi && arc.rise == 0 && arc.start_radius == arc.end_radius) break;
    }
  }
}

}  // namespace

RotaryTravel rotary_travel(const Machine& machine) {
  RotaryTravel travel = RotaryTravel::unbounded();
  for (std::size_t k = 3; k < kAxisCount; ++k) {
    travel.low[k] = machine.axes[k].travel_min;
    travel.high[k] = machine.axes[k].travel_max;
  }
  return travel;
}

std::vector<TravelExcess> find_travel_excess(const Path& path, const Machine& machine) {
  std::array<std::array<TravelExcess, 2>, kAxisCount> excess;
  const bool any_limit = std::any_of(machine.axes.begin(), machine.axes.end(), [](const AxisLimits& axis) {
    return axis.travel_min > -kUnlimited || axis.travel_max < kUnlimited;
  });
  for (std::size_t i = 0; any_limit && i < path.size(); ++i) {
    for_extremes(path, i, machine, [&](const AxisVector& p) {
      for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double value = p[static_cast<Eigen::Index>(k)];
        const std::array<double, 2> beyond = {machine.axes[k].travel_min - value, value - machine.axes[k].travel_max};
        for (std::size_t side = 0; side < 2; ++side) {
          TravelExcess& e = excess[k][side];
          if (beyond[side] <= kTravelRounding || beyond[side] <= e.excess) continue;
          if (e.excess == 0) e.row = path.move[i];
          e = {k, side == 1, beyond[side], e.row, path.move[i]};
        }
      }
    });
  }
  std::vector<TravelExcess> found;
  for (const auto& axis : excess) {
    std::copy_if(axis.begin(), axis.end(), std::back_inserter(found), [](const auto& e) { return e.excess > 0; });
  }
  return found;
}

Diagnostics check_travel(const Path& path, const Moves& moves, const Machine& machine) {
  Diagnostics warnings;
  for (const TravelExcess& e : find_travel_excess(path, machine)) {
    Diagnostic& warning = warnings.emplace_back();
    warning.severity = Severity::warning;
    warning.code = "travel";
    warning.message =
        fmt::format("{} leaves its travel beyond the {} end, by up to {:.6g} {}", kAxisNames[e.axis],
                    e.is_upper ? "upper" : "lower", e.excess / axis_unit(e.axis).size, axis_unit(e.axis).symbol[0]);
    warning.remedy = "move the part, or tell with --work-offset where it lies";
    warning.where.line = moves.line[e.row];
    if (!moves.files.empty()) warning.where.file = moves.files[moves.file[e.row]];
  }
  return warnings;
}

}  // namespace toolpace
