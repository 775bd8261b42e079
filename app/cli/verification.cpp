#include "verification.h"

#include <fmt/format.h>

#include <cmath>

#include "toolpace/base/axes.h"

namespace toolpace::cli {
namespace {

std::string limit_text(const Check& check, double size) {
  return std::isfinite(check.limit) ? fmt::format("{:.6g}", check.limit / size) : "-";
}

}  // namespace

Json verification_json(const VerifyReport& report) {
  Json checks = Json::array();
  int violations = 0;
  for (const Check& check : report.checks) {
    const CheckUnit unit = check_unit(check);
    violations += check.broken;
    checks.push_back({{"check", key_of(check.kind)},
                      {"axis", check.axis ? Json(std::string(1, kAxisNames[*check.axis])) : Json(nullptr)},
                      {std::string("value_") + unit.key, check.value / unit.size},
                      {std::string("limit_") + unit.key, check.limit / unit.size},
                      {std::string("bound_") + unit.key, check.bound / unit.size},
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
               check_title(check), check.value / unit.size, limit_text(check, unit.size), check.bound / unit.size,
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
