#include "toolpace/machine/setup_keys.h"

#include <algorithm>
#include <numeric>

namespace toolpace {
namespace {

SetupSection axis_section(AxisLimits& axis, std::size_t k) {
  const bool rotary = is_rotary(k);
  const std::string u = rotary ? "deg" : "mm";
  const double unit = rotary ? kRadiansPerDegree : 1.0;
  return {std::string("axes.") + kAxisNames[k],
          {{"max_speed_" + u + "_s", &axis.speed, unit, KeyRange::positive},
           {"max_acceleration_" + u + "_s2", &axis.acceleration, unit, KeyRange::positive},
           {"max_jerk_" + u + "_s3", &axis.jerk, unit, KeyRange::positive},
           {"steps_per_" + u, &axis.steps_per_unit, 1 / unit, KeyRange::positive}},
          {{"travel_" + u, &axis.travel_min, &axis.travel_max, unit}},
          {}};
}

SetupSection servo_section(ServoAxis& servo, std::size_t k) {
  const bool rotary = is_rotary(k);
  return {std::string("servo.") + kAxisNames[k],
          {{"kv_1_s", &servo.position_gain, 1.0, KeyRange::positive},
           {"velocity_feed_forward", &servo.velocity_feed_forward, 1.0, KeyRange::share},
           {"acceleration_feed_forward", &servo.acceleration_feed_forward, 1.0, KeyRange::share},
           {"bandwidth_hz", &servo.bandwidth, 1.0, KeyRange::positive},
           {"damping", &servo.damping, 1.0, KeyRange::positive},
           {rotary ? "backlash_deg" : "backlash_mm", &servo.backlash, rotary ? kRadiansPerDegree : 1.0,
            KeyRange::not_negative},
           {"resonance_hz", &servo.resonance, 1.0, KeyRange::not_negative},
           {"resonance_damping", &servo.resonance_damping, 1.0, KeyRange::positive}},
          {},
          {}};
}

}  // namespace

bool is_in_range(double value, KeyRange range) {
  switch (range) {
    case KeyRange::positive: return value > 0;
    case KeyRange::not_negative: return value >= 0;
    case KeyRange::share: break;
  }
  return value >= 0 && value <= 1;
}

const char* range_text(KeyRange range) {
  switch (range) {
    case KeyRange::positive: return "> 0";
    case KeyRange::not_negative: return "≥ 0";
    case KeyRange::share: break;
  }
  return "between 0 and 1";
}

const std::vector<Named<Ramps>>& ramps_names() {
  static const std::vector<Named<Ramps>> names = {{"block", Ramps::block}, {"span", Ramps::span}};
  return names;
}

const std::vector<Named<CornerRule>>& corner_names() {
  static const std::vector<Named<CornerRule>> names = {{"stop", CornerRule::stop},
                                                       {"servo", CornerRule::servo},
                                                       {"junction", CornerRule::junction},
                                                       {"blend", CornerRule::blend},
                                                       {"smooth", CornerRule::smooth}};
  return names;
}

std::vector<SetupSection> setup_sections(Setup& s) {
  constexpr double kMilli = 1e-3;
  PathLimits& p = s.machine.path;
  CornerOptions& corner = s.options.corner;
  std::vector<SetupSection> sections = {
      {"machine",
       {{"period_ms", &s.machine.period, kMilli, KeyRange::positive},
        {"tool_change_s", &s.machine.tool_change, 1.0, KeyRange::not_negative}},
       {},
       {"name"}},
      {"path",
       {{"max_speed_mm_s", &p.speed, 1.0, KeyRange::positive},
        {"max_acceleration_mm_s2", &p.acceleration, 1.0, KeyRange::positive},
        {"max_deceleration_mm_s2", &p.deceleration, 1.0, KeyRange::positive},
        {"max_jerk_mm_s3", &p.jerk, 1.0, KeyRange::positive},
        {"max_jerk_deceleration_mm_s3", &p.jerk_deceleration, 1.0, KeyRange::positive}},
       {},
       {}},
      {"law",
       {{"tacc_ms", &s.options.t_acc, kMilli, KeyRange::positive},
        {"tdec_ms", &s.options.t_dec, kMilli, KeyRange::positive}},
       {},
       {"kind"}},
      {"lookahead",
       {{"tolerance_mm", &corner.tolerance, 1.0, KeyRange::positive},
        {"junction_deviation_mm", &corner.junction_deviation, 1.0, KeyRange::positive}},
       {},
       {"blocks", "ramps", "corner"}}};
  for (std::size_t k = 0; k < kAxisCount; ++k) sections.push_back(axis_section(s.machine.axes[k], k));
  for (std::size_t k = 0; k < kAxisCount; ++k) sections.push_back(servo_section(s.machine.servo[k], k));
  return sections;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0u);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t above = row[j + 1];
      row[j + 1] = std::min({above + 1, row[j] + 1, diagonal + (a[i] == b[j] ? 0u : 1u)});
      diagonal = above;
    }
  }
  return row.back();
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
  return *std::min_element(candidates.begin(), candidates.end(), [&](const std::string& a, const std::string& b) {
    return edit_distance(word, a) < edit_distance(word, b);
  });
}

}  // namespace toolpace
