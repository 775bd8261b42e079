#include "verification.h"

#include <fmt/format.h>

#include <cmath>

#include "toolpace/base/axes.h"

namespace toolpace::cli {
namespace {

std::string limit_text(const Check& check, double factor) {
  return std::isfinite(check.limit) ? fmt::format("{:.6g}", check.limit * factor) : "-";
}

}  // namespace

CheckUnit check_unit(const Check& check) {
  const bool rotary = check.axis && is_rotary(*check.axis);
  const double degrees = rotary ? 1 / kRadiansPerDegree : 1.0;
  switch (check.kind) {
    case CheckKind::axis_speed:
    case CheckKind::path_speed:
    case CheckKind::speed_column: return rotary ? CheckUnit{"deg/s", "deg_s", degrees} : CheckUnit{"mm/s", "mm_s", 1};
    case CheckKind::axis_acceleration:
    case CheckKind::path_acceleration:
    case CheckKind::path_deceleration:
    case CheckKind::acceleration_column:
      return rotary ? CheckUnit{"deg/s²", "deg_s2", degrees} : CheckUnit{"mm/s²", "mm_s2", 1};
    case CheckKind::axis_jerk:
    case CheckKind::path_jerk:
    case CheckKind::jerk_column:
      return rotary ? CheckUnit{"deg/s³", "deg_s3", degrees} : CheckUnit{"mm/s³", "mm_s3", 1};
    case CheckKind::time_step: return {"s", "s", 1};
    case CheckKind::line_column: return {"rows", "rows", 1};
    default: break;
  }
  return rotary ? CheckUnit{"deg", "deg", degrees} : CheckUnit{"mm", "mm", 1};
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
    case CheckKind::end_point: return "distance from the end";
  }
  return "";
}

Json verification_json(const VerifyReport& report) {
  Json checks = Json::array();
  int violations = 0;
  for (const Check& check : report.checks) {
    const CheckUnit unit = check_unit(check);
    violations += check.broken;
    checks.push_back({{"check", key_of(check.kind)},
                      {"axis", check.axis ? Json(std::string(1, kAxisNames[*check.axis])) : Json(nullptr)},
                      {std::string("value_") + unit.suffix, check.value * unit.factor},
                      {std::string("limit_") + unit.suffix, check.limit * unit.factor},
                      {std::string("bound_") + unit.suffix, check.bound * unit.factor},
                      {"t_s", check.time},
                      {"row", check.row},
                      {"line", check.line == 0 ? Json(nullptr) : Json(check.line)},
                      {"broken", check.broken}});
  }
  return {{"passes", report.passes()},
          {"violations", violations},
          {"rows", report.rows},
          {"period_ms", report.period * 1e3},
          {"duration_s", report.duration},
          {"exempt_corners", report.exempt_corners},
          {"largest_corner_step_mm_s", report.largest_corner_step},
          {"chord_error_mm", report.chord_error},
          {"position_resolution_mm", report.position_resolution},
          {"checks", std::move(checks)},
          {"notes", report.notes}};
}

void print_verification(const VerifyReport& report) {
  fmt::print("{} rows every {:.6g} ms, {:.6g} s\n", report.rows, report.period * 1e3, report.duration);
  fmt::print("  {:<28} {:>12} {:>12} {:>10}  {:<7} {:>10} {:>8}\n", "", "worst", "limit", "bound", "", "at s", "line");
  for (const Check& check : report.checks) {
    const CheckUnit unit = check_unit(check);
    fmt::print("{} {:<28} {:>12.6g} {:>12} {:>10.2g}  {:<7} {:>10.4f} {:>8}\n", check.broken ? "!" : " ",
               check_title(check), check.value * unit.factor, limit_text(check, unit.factor), check.bound * unit.factor,
               unit.symbol, check.time, check.line == 0 ? "-" : std::to_string(check.line));
  }
  if (report.chord_error)
    fmt::print("  {:<28} {:>12.6g} {:>12} {:>10}  mm\n", "chord error", *report.chord_error, "-", "");
  if (report.exempt_corners > 0) {
    fmt::print(
        "  {} corners are passed with a speed step, the largest {:.6g} mm/s; they are exempt by what it explains\n",
        report.exempt_corners, report.largest_corner_step);
  }
  for (const auto& note : report.notes) fmt::print("  note: {}\n", note);
  fmt::print("{}\n", report.passes() ? "every limit holds" : "LIMITS ARE BROKEN");
}

}  // namespace toolpace::cli
