#include "toolpace/verify/report.h"

#include "toolpace/base/axis_unit.h"

namespace toolpace {

const char* key_of(CheckKind kind) {
  switch (kind) {
    case CheckKind::axis_speed: return "axis-speed";
    case CheckKind::axis_acceleration: return "axis-acceleration";
    case CheckKind::axis_jerk: return "axis-jerk";
    case CheckKind::travel_min: return "travel-min";
    case CheckKind::travel_max: return "travel-max";
    case CheckKind::path_speed: return "path-speed";
    case CheckKind::path_acceleration: return "path-acceleration";
    case CheckKind::path_deceleration: return "path-deceleration";
    case CheckKind::path_jerk: return "path-jerk";
    case CheckKind::time_step: return "time-step";
    case CheckKind::speed_column: return "speed-column";
    case CheckKind::acceleration_column: return "acceleration-column";
    case CheckKind::jerk_column: return "jerk-column";
    case CheckKind::line_column: return "line-column";
    case CheckKind::follows_path: return "follows-path";
    case CheckKind::deviation: return "deviation";
    case CheckKind::tool_angle: return "tool-angle";
    case CheckKind::end_point: return "end-point";
  }
  return "";
}

std::string check_title(const Check& check) {
  const std::string axis = check.axis ? std::string(1, kAxisNames[*check.axis]) + " " : "";
  switch (check.kind) {
    case CheckKind::axis_speed: return axis + "speed";
    case CheckKind::axis_acceleration: return axis + "acceleration";
    case CheckKind::axis_jerk: return axis + "jerk";
    case CheckKind::travel_min: return axis + "travel, lowest";
    case CheckKind::travel_max: return axis + "travel, highest";
    case CheckKind::path_speed: return "path speed";
    case CheckKind::path_acceleration: return "path acceleration";
    case CheckKind::path_deceleration: return "path deceleration";
    case CheckKind::path_jerk: return "path jerk";
    case CheckKind::time_step: return "clock error";
    case CheckKind::speed_column: return axis + "v column against positions";
    case CheckKind::acceleration_column: return axis + "a column against " + (check.axis ? "positions" : "v");
    case CheckKind::jerk_column: return axis + "j column against " + (check.axis ? "positions" : "a");
    case CheckKind::line_column: return "lines not under the tool";
    case CheckKind::follows_path: return "follows the path within";
    case CheckKind::deviation: return "deviation from the path";
    case CheckKind::tool_angle: return "tool off its direction";
    case CheckKind::end_point: return "distance from the end";
  }
  return "";
}

CheckUnit check_unit(const Check& check) {
  const AxisUnit& unit = check.axis ? axis_unit(*check.axis) : kMillimetres;
  const auto of = [&](std::size_t order) { return CheckUnit{unit.size, unit.symbol[order], unit.key[order]}; };
  switch (check.kind) {
    case CheckKind::axis_speed:
    case CheckKind::path_speed:
    case CheckKind::speed_column: return of(1);
    case CheckKind::axis_acceleration:
    case CheckKind::path_acceleration:
    case CheckKind::path_deceleration:
    case CheckKind::acceleration_column: return of(2);
    case CheckKind::axis_jerk:
    case CheckKind::path_jerk:
    case CheckKind::jerk_column: return of(3);
    case CheckKind::time_step: return {1, "s", "s"};
    case CheckKind::tool_angle: return {kDegrees.size, kDegrees.symbol[0], kDegrees.key[0]};
    case CheckKind::line_column: return {1, "rows", "rows"};
    default: return of(0);
  }
}

}  // namespace toolpace
