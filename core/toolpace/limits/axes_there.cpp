#include "toolpace/limits/axes_there.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "toolpace/path/axis_curve.h"

namespace toolpace {
namespace {

constexpr double kNoMotion = 1e-9;  // [mm] rounding of curves

bool is_described(const AxisLimits& axis) {
  return axis.speed < kUnlimited || axis.acceleration < kUnlimited || axis.jerk < kUnlimited ||
         axis.travel_min > -kUnlimited || axis.travel_max < kUnlimited || axis.steps_per_unit > 0;
}

/// A curve that comes back to its start moves both axes of its plane all the same.
bool moves_axis(const Path& path, std::size_t segment, Eigen::Index axis) {
  const AxisCurve curve(path);
  if (!curve.is_path(segment) && axis < 3) {
    const double from = curve.begin_of(segment)[axis];
    return std::abs(curve.end_of(segment)[axis] - from) > kNoMotion ||
           std::abs(curve.point_at(segment, path.length[segment] / 3)[axis] - from) > kNoMotion;
  }
  const double from = path.node[segment][axis];
  if (path.end_of(segment)[axis] != from) return true;
  if (path.kind[segment] == SegmentKind::line || axis >= 3) return false;
  return std::abs(point_at(path, segment, path.length[segment] / 3)[axis] - from) > kNoMotion;
}

}  // namespace

Diagnostics check_axes(const Path& path, const Moves& moves, const Machine& machine) {
  Diagnostics warnings;
  if (std::none_of(machine.axes.begin(), machine.axes.end(), is_described)) return warnings;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    if (is_described(machine.axes[k])) continue;
    const auto i = static_cast<Eigen::Index>(k);
    for (std::size_t segment = 0; segment < path.size(); ++segment) {
      // An arc that comes back to its start moves both axes of its plane all the same.
      if (!moves_axis(path, segment, i)) continue;
      Diagnostic& warning = warnings.emplace_back();
      warning.severity = Severity::warning;
      warning.code = "axis-not-there";
      warning.message = fmt::format("the program moves {0}, but the machine has no axis {0}", kAxisNames[k]);
      warning.remedy =
          fmt::format("choose the machine that it is for, or describe the axis in [axes.{}]", kAxisNames[k]);
      const std::uint32_t row = path.move[segment];
      warning.where.line = moves.line[row];
      if (!moves.files.empty()) warning.where.file = moves.files[moves.file[row]];
      break;
    }
  }
  return warnings;
}

}  // namespace toolpace
