#include "toolpace/machine/import_machine.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>
#include <vector>

namespace toolpace {
namespace {

constexpr double kMmPerInch = 25.4;
constexpr double kSecondsPerMinute = 60.0;

std::string_view trimmed(std::string_view text) {
  const auto is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::optional<double> leading_number(std::string_view text) {
  text = trimmed(text);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end == text.data()) return std::nullopt;
  return value;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return lines;
}

using Values = std::map<std::string, std::string>;  // "SECTION.KEY" -> value; the first one counts

Values read_ini(std::string_view text) {
  Values values;
  std::string section;
  for (std::string_view line : lines_of(text)) {
    if (line.empty() || line.front() == '#' || line.front() == ';') continue;
    if (line.front() == '[') {
      section = upper(trimmed(line.substr(1, line.find(']') - 1)));
      continue;
    }
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) continue;
    values.emplace(section + "." + upper(trimmed(line.substr(0, equals))), trimmed(line.substr(equals + 1)));
  }
  return values;
}

class Taker {
 public:
  explicit Taker(const Values& values) : values_(values) {}

  /// Stores a number that stands under one of `keys`, times `unit`.
  void take(double& target, std::initializer_list<std::string> keys, double unit) {
    for (const auto& key : keys) {
      const auto found = values_.find(key);
      if (found == values_.end()) continue;
      const auto number = leading_number(found->second);
      if (!number) continue;
      target = *number * unit;
      ++taken_;
      return;
    }
  }
  bool nothing() const { return taken_ == 0; }

 private:
  const Values& values_;
  int taken_ = 0;
};

Error empty_error(const std::string& name, const char* what) {
  return {ErrorKind::input,      "import-empty", std::string("no limits found: this does not look like ") + what,
          "choose another file", {name, 0, 0},   {}};
}

Result<Setup> checked(Setup setup) {
  if (auto fine = check_setup(setup.machine, setup.options); !fine) return tl::unexpected(fine.error());
  return setup;
}

}  // namespace

Result<Setup> import_linuxcnc_ini(std::string_view text, const std::string& name, const Setup& base) {
  const Values values = read_ini(text);
  Setup setup = base;
  Machine& machine = setup.machine;
  const auto units = values.find("TRAJ.LINEAR_UNITS");
  const bool inch = units != values.end() && upper(units->second).starts_with("IN");
  const double length = inch ? kMmPerInch : 1.0;
  Taker taker(values);
  taker.take(machine.path.speed, {"TRAJ.MAX_LINEAR_VELOCITY", "TRAJ.MAX_VELOCITY", "DISPLAY.MAX_LINEAR_VELOCITY"},
             length);
  taker.take(machine.path.acceleration, {"TRAJ.MAX_LINEAR_ACCELERATION", "TRAJ.MAX_ACCELERATION"}, length);
  machine.path.deceleration = machine.path.acceleration;
  taker.take(machine.path.jerk, {"TRAJ.MAX_LINEAR_JERK"}, length);
  taker.take(machine.period, {"EMCMOT.SERVO_PERIOD"}, 1e-9);
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const double unit = is_rotary(i) ? kRadiansPerDegree : length;
    const std::string section = std::string("AXIS_") + kAxisNames[i];
    const std::string joint = "JOINT_" + std::to_string(i);
    auto& axis = machine.axes[i];
    taker.take(axis.speed, {section + ".MAX_VELOCITY", joint + ".MAX_VELOCITY"}, unit);
    taker.take(axis.acceleration, {section + ".MAX_ACCELERATION", joint + ".MAX_ACCELERATION"}, unit);
    taker.take(axis.jerk, {section + ".MAX_JERK", joint + ".MAX_JERK"}, unit);
    taker.take(axis.travel_min, {section + ".MIN_LIMIT", joint + ".MIN_LIMIT"}, unit);
    taker.take(axis.travel_max, {section + ".MAX_LIMIT", joint + ".MAX_LIMIT"}, unit);
  }
  if (taker.nothing()) return tl::unexpected(empty_error(name, "a LinuxCNC configuration"));
  const auto title = values.find("EMC.MACHINE");
  if (title != values.end()) machine.name = title->second;
  return checked(std::move(setup));
}

Result<Setup> import_grbl_dump(std::string_view text, const std::string& name, const Setup& base) {
  Values values;
  for (std::string_view line : lines_of(text)) {
    const std::size_t equals = line.find('=');
    if (!line.starts_with('$') || equals == std::string_view::npos) continue;
    values.emplace(std::string(trimmed(line.substr(0, equals))), trimmed(line.substr(equals + 1)));
  }
  Setup setup = base;
  Taker taker(values);
  taker.take(setup.options.corner.junction_deviation, {"$11"}, 1.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string digit = std::to_string(i);
    auto& axis = setup.machine.axes[i];
    taker.take(axis.steps_per_unit, {"$10" + digit}, 1.0);
    taker.take(axis.speed, {"$11" + digit}, 1.0 / kSecondsPerMinute);
    taker.take(axis.acceleration, {"$12" + digit}, 1.0);
    double travel = 0;
    taker.take(travel, {"$13" + digit}, 1.0);
    if (travel > 0) {
      axis.travel_min = -travel;
      axis.travel_max = 0;
    }
  }
  if (taker.nothing()) return tl::unexpected(empty_error(name, "grbl's answer to $$"));
  if (values.contains("$11")) setup.options.corner.rule = CornerRule::junction;
  return checked(std::move(setup));
}

}  // namespace toolpace
