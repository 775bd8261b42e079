#include "toolpace/limits/travel.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "toolpace/base/axis_unit.h"

namespace toolpace {
namespace {

// Rounding of offsets and units must not read as leaving the travel.
constexpr double kTravelRounding = 1e-9;

struct Excess {
  double worst = 0.0;
  std::uint32_t row = 0;  // first row that does it
};

/// Calls f with points that include every extreme of every axis on the segment.
template <class F>
void for_extremes(const Path& path, std::size_t i, F f) {
  f(path.node[i + 1]);
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

Diagnostics check_travel(const Path& path, const Moves& moves, const Machine& machine) {
  std::array<std::array<Excess, 2>, kAxisCount> excess;
  bool any_limit = false;
  for (const AxisLimits& axis : machine.axes)
    any_limit |= axis.travel_min > -kUnlimited || axis.travel_max < kUnlimited;
  if (!any_limit) return {};
  for (std::size_t i = 0; i < path.size(); ++i) {
    for_extremes(path, i, [&](const AxisVector& p) {
      for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double value = p[static_cast<Eigen::Index>(k)];
        const std::array<double, 2> beyond = {machine.axes[k].travel_min - value, value - machine.axes[k].travel_max};
        for (std::size_t side = 0; side < 2; ++side) {
          Excess& e = excess[k][side];
          if (beyond[side] > kTravelRounding && e.worst == 0) e.row = path.move[i];
          if (beyond[side] > kTravelRounding && beyond[side] > e.worst) e.worst = beyond[side];
        }
      }
    });
  }
  Diagnostics warnings;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    for (std::size_t side = 0; side < 2; ++side) {
      const Excess& e = excess[k][side];
      if (e.worst == 0) continue;
      Diagnostic& warning = warnings.emplace_back();
      warning.severity = Severity::warning;
      warning.code = "travel";
      warning.message = fmt::format("{} leaves its travel beyond the {} end, by up to {:.6g} {}", kAxisNames[k],
                                    side == 0 ? "lower" : "upper", e.worst / axis_unit(k).size, axis_unit(k).symbol[0]);
      warning.remedy = "move the work offset or the part";
      warning.where.line = moves.line[e.row];
      if (!moves.files.empty()) warning.where.file = moves.files[moves.file[e.row]];
    }
  }
  return warnings;
}

}  // namespace toolpace
