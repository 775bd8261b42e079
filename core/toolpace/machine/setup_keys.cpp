#include "toolpace/machine/setup_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "toolpace/base/axis_unit.h"
#include "toolpace/base/numbers.h"
#include "toolpace/limits/corner_names.h"
#include "toolpace/sample/shaper.h"
#include "toolpace/servo/servo_range.h"

namespace toolpace {
namespace {

constexpr double kMilli = 1e-3;
constexpr double kPercent = 1e-2;
constexpr double kRounding = 1e-9;  // relative: of ms to s, degrees to radians, and back

// Limits reach from a micrometre in a second to what no machine comes near.
constexpr double kLeast = 1e-6, kFastest = 1e9, kStrongest = 1e12, kHardest = 1e15;

constexpr NumberRange limit(double most, const char* unit) { return {kLeast, most, unit, false, true}; }

constexpr NumberRange kPeriod = {1e-3, 1e4, "ms"};  // no drive is faster, and no disk holds more
constexpr NumberRange kToolChange = {0, 86400, "s"};
constexpr NumberRange kRampTime = {1e-3, 1e7, "ms"};
constexpr NumberRange kCornerSize = {1e-6, 1e6, "mm"};
constexpr NumberRange kShare = {0, 1};
constexpr double kFarthestTravel = 1e9;  // [mm, deg], as programs

SetupSection axis_section(AxisLimits& axis, std::size_t k) {
  const auto& [unit, symbol, key] = axis_unit(k);
  return {std::string("axes.") + kAxisNames[k],
          {{std::string("max_speed_") + key[1], &axis.speed, unit, limit(kFastest, symbol[1])},
           {std::string("max_acceleration_") + key[2], &axis.acceleration, unit, limit(kStrongest, symbol[2])},
           {std::string("max_jerk_") + key[3], &axis.jerk, unit, limit(kHardest, symbol[3])},
           {std::string("steps_per_") + key[0],
            &axis.steps_per_unit,
            1 / unit,
            {1e-6, 1e9, is_rotary(k) ? "steps/deg" : "steps/mm", true}}},
          {{std::string("travel_") + key[0],
            &axis.travel_min,
            &axis.travel_max,
            unit,
            {-kFarthestTravel, kFarthestTravel, symbol[0], false, true}}},
          {}};
}

NumberRange servo_range(const ServoRange& range, const char* unit) {
  return {range.least, range.most, unit, range.may_be_zero};
}

SetupSection servo_section(ServoAxis& servo, std::size_t k) {
  const AxisUnit& unit = axis_unit(k);
  return {std::string("servo.") + kAxisNames[k],
          {{"kv_1_s", &servo.position_gain, 1.0, servo_range(kServoGain, "1/s")},
           {"velocity_feed_forward", &servo.velocity_feed_forward, 1.0, kShare},
           {"acceleration_feed_forward", &servo.acceleration_feed_forward, 1.0, kShare},
           {"bandwidth_hz", &servo.bandwidth, 1.0, servo_range(kServoBandwidth, "Hz")},
           {"damping", &servo.damping, 1.0, servo_range(kServoDamping, "")},
           {std::string("backlash_") + unit.key[0],
            &servo.backlash,
            unit.size,
            {0, is_rotary(k) ? 360.0 : 1000.0, unit.symbol[0]}},
           {"resonance_hz", &servo.resonance, 1.0, servo_range(kServoResonance, "Hz")},
           {"resonance_damping", &servo.resonance_damping, 1.0, servo_range(kServoDamping, "")}},
          {},
          {kModesKey}};
}

/// 1e-06 -> 1e-6, 1e+09 -> 1e9
std::string bound_text(double value) {
  std::string text = to_text(value);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  std::size_t digits = e + 1;
  if (text[digits] == '+') text.erase(digits, 1);
  if (text[digits] == '-') ++digits;
  while (digits + 1 < text.size() && text[digits] == '0') text.erase(digits, 1);
  return text;
}

std::string with_unit(std::string text, const char* unit) { return *unit ? text + ' ' + unit : text; }

}  // namespace

bool is_in_range(double value, const NumberRange& range) {
  if (value == 0 && range.may_be_zero) return true;
  if (std::isinf(value)) return value > 0 && range.may_be_infinite;
  const double slack = kRounding * std::abs(value);
  return value >= range.least - slack && value <= range.most + slack;
}

std::string range_text(const NumberRange& range) {
  std::string text = fmt::format("{} to {}", bound_text(range.least), bound_text(range.most));
  text = with_unit(std::move(text), range.unit);
  if (range.may_be_zero) text += ", or 0 for none";
  if (range.may_be_infinite) text += ", or inf for no limit";
  return text;
}

bool is_ordered(const RangeKey& key) {
  const double low = *key.low / key.unit, high = *key.high / key.unit;
  const auto fits = [&](double end) { return std::isinf(end) || is_in_range(end, key.range); };
  return low < high && fits(low) && fits(high);
}

std::string range_text(const RangeKey& key) {
  return "[min, max] with min < max, " +
         with_unit(fmt::format("each {} to {}", bound_text(key.range.least), bound_text(key.range.most)),
                   key.range.unit) +
         ", or -inf and inf for open ends";
}

const std::vector<Named<Ramps>>& ramps_names() {
  static const std::vector<Named<Ramps>> names = {{"block", Ramps::block}, {"span", Ramps::span}};
  return names;
}

const std::vector<Named<CornerRule>>& corner_names() {
  static const std::vector<Named<CornerRule>> names = [] {
    std::vector<Named<CornerRule>> all;
    for (const CornerRule rule : kCornerRules) all.push_back({corner_rule_name(rule), rule});
    return all;
  }();
  return names;
}

const std::vector<Named<ShaperKind>>& shaper_names() {
  static const std::vector<Named<ShaperKind>> names = [] {
    std::vector<Named<ShaperKind>> all;
    for (const ShaperKind kind : kShaperKinds) all.push_back({shaper_name(kind), kind});
    return all;
  }();
  return names;
}

std::vector<SetupSection> setup_sections(Setup& s) {
  PathLimits& p = s.machine.path;
  CornerOptions& corner = s.options.corner;
  std::vector<SetupSection> sections = {
      {"machine",
       {{"period_ms", &s.machine.period, kMilli, kPeriod}, {"tool_change_s", &s.machine.tool_change, 1.0, kToolChange}},
       {},
       {"name"}},
      {"path",
       {{"max_speed_mm_s", &p.speed, 1.0, limit(kFastest, "mm/s")},
        {"max_acceleration_mm_s2", &p.acceleration, 1.0, limit(kStrongest, "mm/s²")},
        {"max_deceleration_mm_s2", &p.deceleration, 1.0, limit(kStrongest, "mm/s²")},
        {"max_jerk_mm_s3", &p.jerk, 1.0, limit(kHardest, "mm/s³")},
        {"max_jerk_deceleration_mm_s3", &p.jerk_deceleration, 1.0, limit(kHardest, "mm/s³")},
        {"fine_acceleration_mm_s2", &p.fine_acceleration, 1.0, limit(kStrongest, "mm/s²")}},
       {},
       {}},
      {"law",
       {{"tacc_ms", &s.options.t_acc, kMilli, kRampTime}, {"tdec_ms", &s.options.t_dec, kMilli, kRampTime}},
       {},
       {"kind"}},
      {"lookahead",
       {{"tolerance_mm", &corner.tolerance, 1.0, kCornerSize},
        {"junction_deviation_mm", &corner.junction_deviation, 1.0, kCornerSize}},
       {},
       {"blocks", "ramps", "corner", "shaper"}}};
  for (std::size_t k = 0; k < kAxisCount; ++k) sections.push_back(axis_section(s.machine.axes[k], k));
  for (std::size_t k = 0; k < kAxisCount; ++k) sections.push_back(servo_section(s.machine.servo[k], k));
  return sections;
}

std::size_t axis_of_section(std::string_view section) {
  return static_cast<std::size_t>(std::find(kAxisNames.begin(), kAxisNames.end(), section.back()) - kAxisNames.begin());
}

std::vector<NumberKey> mode_keys(AxisMode& mode) {
  return {{"frequency_hz", &mode.frequency, 1.0, servo_range(kServoMode, "Hz")},
          {"damping", &mode.damping, 1.0, servo_range(kServoDamping, "")},
          {"share", &mode.share, 1.0, servo_range(kServoShare, "")}};
}

SetupSection job_section(PlanOptions& options) {
  SetupSection section = {"",
                          {{"override_percent", &options.feed_override, kPercent, {0.01, 200, "%"}},
                           {"rapid_percent", &options.rapid_override, kPercent, {0.01, 100, "%"}}},
                          {},
                          {}};
  if (options.corner.step) {
    section.numbers.push_back({"corner_step_mm_s", &*options.corner.step, 1.0, limit(kStrongest, "mm/s")});
  }
  if (options.hold_at) section.numbers.push_back({"hold_at_s", &*options.hold_at, 1.0, {0, 1e9, "s"}});
  return section;
}

NumberKey find_number(Setup& setup, std::string_view section, std::string_view key) {
  auto sections = setup_sections(setup);
  sections.push_back(job_section(setup.options));
  for (const SetupSection& candidate : sections) {
    if (candidate.name != section) continue;
    for (const NumberKey& number : candidate.numbers) {
      if (number.name == key) return number;
    }
  }
  throw std::logic_error(fmt::format("there is no number [{}] {}", section, key));
}

}  // namespace toolpace
