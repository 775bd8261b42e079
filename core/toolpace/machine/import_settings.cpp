#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "toolpace/base/numbers.h"
#include "toolpace/machine/read_machine.h"
#include "toolpace/machine/setup_keys.h"

namespace toolpace {
namespace {

constexpr double kMmPerInch = 25.4;
constexpr double kNoLimit = 1e9;  // LinuxCNC's own default is 1e99

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

struct Value {
  std::string text;
  std::size_t line;
};
using Values = std::map<std::string, Value>;  // "SECTION.KEY" or "$110"; the first one counts

/// Calls take(line, number) for each line, trimmed.
template <class Take>
void for_each_line(std::string_view text, const Take& take) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    take(trimmed(text.substr(0, end)), number);
    if (end == std::string_view::npos) return;
    text.remove_prefix(end + 1);
  }
}

Values read_ini(std::string_view text) {
  Values values;
  std::string section;
  for_each_line(text, [&](std::string_view line, std::size_t number) {
    if (line.empty() || line.front() == '#' || line.front() == ';') return;
    if (line.front() == '[') {
      section = upper(trimmed(line.substr(1, line.find(']') - 1)));
      return;
    }
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) return;
    values.try_emplace(section + "." + upper(trimmed(line.substr(0, equals))),
                       Value{std::string(trimmed(line.substr(equals + 1))), number});
  });
  return values;
}

Values read_dump(std::string_view text) {
  Values values;
  for_each_line(text, [&](std::string_view line, std::size_t number) {
    const std::size_t equals = line.find('=');
    if (!line.starts_with('$') || equals == std::string_view::npos) return;
    values.try_emplace(std::string(trimmed(line.substr(0, equals))),
                       Value{std::string(trimmed(line.substr(equals + 1))), number});
  });
  return values;
}

/// Carries values of a controller to the keys of a machine file. The first thing that is wrong stops it.
class Importer {
 public:
  Importer(Values values, std::string name) : values_(std::move(values)), name_(std::move(name)) {}

  Setup& setup() { return setup_; }

  const Value* find(std::initializer_list<std::string> keys, std::string* found = nullptr) const {
    for (const std::string& key : keys) {
      const auto at = values_.find(key);
      if (at == values_.end()) continue;
      if (found) *found = key;
      return &at->second;
    }
    return nullptr;
  }

  /// The number under the first of `keys` that is there, times `unit`.
  std::optional<double> take(std::initializer_list<std::string> keys, double unit) {
    std::string key;
    const Value* value = find(keys, &key);
    if (!value || error_) return std::nullopt;
    // A comment may stand behind the number.
    const std::string_view word = std::string_view(value->text).substr(0, value->text.find_first_of(" \t;#("));
    const auto number = parse_number(word);
    ++taken_;
    last_key_ = key;
    last_line_ = value->line;
    if (number) return *number * unit;
    fail(fmt::format("{} is '{}', which is no number", key, value->text.substr(0, kShown)));
    return std::nullopt;
  }

  /// Stores it as a number of a machine file. @param none  a value that stands for no limit
  void take(const std::string& section, const std::string& key, std::initializer_list<std::string> keys, double unit,
            std::optional<double> none = {}) {
    const auto value = take(keys, unit);
    if (!value || value == none) return;
    const NumberKey number = find_number(setup_, section, key);
    if (!is_in_range(*value, number.range) || std::isinf(*value)) {
      NumberRange finite = number.range;
      finite.may_be_infinite = false;
      return fail(
          fmt::format("{} makes {} {}, but it must be {}", last_key_, key, to_text(*value), range_text(finite)));
    }
    *number.value = *value * number.unit;
  }

  /// @param low, high  in mm or degrees
  void set_travel(std::size_t axis, double low, double high) {
    if (error_) return;
    const std::string section = std::string("axes.") + kAxisNames[axis];
    for (const SetupSection& known : setup_sections(setup_)) {
      if (known.name != section) continue;
      const RangeKey& travel = known.ranges.front();
      *travel.low = low * travel.unit;
      *travel.high = high * travel.unit;
      if (is_ordered(travel)) continue;
      fail(fmt::format("{} makes {} [{}, {}], but it must be {}", last_key_, travel.name, to_text(low), to_text(high),
                       range_text(travel)));
    }
  }

  Result<Setup> finish(const char* what) {
    if (error_) return tl::unexpected(*error_);
    if (taken_ == 0) {
      return tl::unexpected(Error{ErrorKind::input,
                                  "import-empty",
                                  std::string("no limits found: this does not look like ") + what,
                                  "choose another file",
                                  {name_, 0, 0},
                                  {}});
    }
    PathLimits& path = setup_.machine.path;
    path.deceleration = path.acceleration;
    path.jerk_deceleration = path.jerk;
    const auto& axes = setup_.machine.axes;
    const bool has_jerk = std::isfinite(path.jerk) || std::any_of(axes.begin(), axes.end(), [](const AxisLimits& axis) {
                            return std::isfinite(axis.jerk);
                          });
    if (!has_jerk) setup_.options.law = LawKind::trapezoid;
    if (auto fine = check_setup(setup_.machine, setup_.options); !fine) return tl::unexpected(fine.error());
    return setup_;
  }

 private:
  static constexpr std::size_t kShown = 40;  // letters of a value in a message

  void fail(std::string message) {
    if (error_) return;
    error_ = Error{ErrorKind::usage,       "import-value",
                   std::move(message),     "correct the controller's settings",
                   {name_, last_line_, 0}, {}};
  }

  Values values_;
  std::string name_;
  Setup setup_;
  std::optional<Error> error_;
  std::string last_key_;
  std::size_t last_line_ = 0;
  int taken_ = 0;
};

/// The text where it is UTF-8, as TOML wants it; else with ? for every letter outside of ASCII.
std::string as_name(std::string text) {
  Setup setup;
  setup.machine.name = text;
  if (format_setup(setup)) return text;
  for (char& c : text) {
    if (static_cast<unsigned char>(c) >= 0x80 || static_cast<unsigned char>(c) < 0x20) c = '?';
  }
  return text;
}

void import_axis(Importer& importer, std::size_t k, double unit) {
  const std::string letter(1, kAxisNames[k]), axis = "AXIS_" + letter, joint = "JOINT_" + std::to_string(k);
  const std::string section = "axes." + letter, u = is_rotary(k) ? "deg" : "mm";
  const auto take = [&](const std::string& key, const std::string& from, std::optional<double> none = {}) {
    importer.take(section, key, {axis + from, joint + from}, unit, none);
  };
  take("max_speed_" + u + "_s", ".MAX_VELOCITY");
  take("max_acceleration_" + u + "_s2", ".MAX_ACCELERATION");
  take("max_jerk_" + u + "_s3", ".MAX_JERK", 0.0);
  double low = -kUnlimited, high = kUnlimited;
  const auto least = importer.take({axis + ".MIN_LIMIT", joint + ".MIN_LIMIT"}, unit);
  if (least && *least > -kNoLimit) low = *least;
  const auto most = importer.take({axis + ".MAX_LIMIT", joint + ".MAX_LIMIT"}, unit);
  if (most && *most < kNoLimit) high = *most;
  if (least || most) importer.set_travel(k, low, high);
}

}  // namespace

Result<Setup> import_linuxcnc_ini(std::string_view text, const std::string& name) {
  Importer importer(read_ini(text), name);
  const Value* units = importer.find({"TRAJ.LINEAR_UNITS"});
  const double length = units && upper(units->text).starts_with("IN") ? kMmPerInch : 1.0;
  importer.take("path", "max_speed_mm_s",
                {"TRAJ.MAX_LINEAR_VELOCITY", "TRAJ.MAX_VELOCITY", "DISPLAY.MAX_LINEAR_VELOCITY"}, length);
  importer.take("path", "max_acceleration_mm_s2", {"TRAJ.MAX_LINEAR_ACCELERATION", "TRAJ.MAX_ACCELERATION"}, length);
  importer.take("path", "max_jerk_mm_s3", {"TRAJ.MAX_LINEAR_JERK"}, length, 0.0);
  importer.take("machine", "period_ms", {"EMCMOT.SERVO_PERIOD"}, 1e-6);
  for (std::size_t k = 0; k < kAxisCount; ++k) import_axis(importer, k, is_rotary(k) ? 1.0 : length);
  if (const Value* title = importer.find({"EMC.MACHINE"})) importer.setup().machine.name = as_name(title->text);
  return importer.finish("a LinuxCNC configuration");
}

Result<Setup> import_grbl_dump(std::string_view text, const std::string& name) {
  Importer importer(read_dump(text), name);
  importer.take("lookahead", "junction_deviation_mm", {"$11"}, 1.0);
  if (importer.find({"$11"})) importer.setup().options.corner.rule = CornerRule::junction;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string digit = std::to_string(k), section = std::string("axes.") + kAxisNames[k];
    importer.take(section, "steps_per_mm", {"$10" + digit}, 1.0);
    importer.take(section, "max_speed_mm_s", {"$11" + digit}, kPerMinute);
    importer.take(section, "max_acceleration_mm_s2", {"$12" + digit}, 1.0);
    const auto travel = importer.take({"$13" + digit}, 1.0);
    if (travel && *travel != 0) importer.set_travel(k, -*travel, 0.0);
  }
  return importer.finish("grbl's answer to $$");
}

}  // namespace toolpace
