#include "toolpace/tune/tune_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "toolpace/base/numbers.h"
#include "toolpace/machine/controller_machine.h"
#include "toolpace/tune/what_if.h"

namespace toolpace {
namespace {

constexpr double kHelps = 1e-4;      // of the cycle time, that a change saves at least
constexpr double kOverLimit = 1e-9;  // relative
constexpr int kHalvings = 50;
constexpr double kFarthest = 1e4;  // times a value: what may be that much larger is not limited at all

/// The limits that a controller's settings show, as numbers in one order; what is larger is more. No axis does more than the path.
std::vector<double> limits_in(const Setup& setup) {
  const PathLimits& path = setup.machine.path;
  std::vector<double> limits = {path.speed, path.acceleration};
  for (const AxisLimits& axis : setup.machine.axes) {
    limits.push_back(std::min(axis.speed, path.speed));
    limits.push_back(std::min(axis.acceleration, path.acceleration));
  }
  limits.push_back(setup.options.corner.rule == CornerRule::junction ? setup.options.corner.junction_deviation : 0.0);
  return limits;
}

/// What no limit along the path needs to be beyond where it has none: all linear axes at once.
PathLimits path_of(const Machine& machine) {
  PathLimits path = machine.path;
  Eigen::Vector3d speed, acceleration;
  for (Eigen::Index k = 0; k < 3; ++k) {
    speed[k] = machine.axes[static_cast<std::size_t>(k)].speed;
    acceleration[k] = machine.axes[static_cast<std::size_t>(k)].acceleration;
  }
  path.speed = std::min(path.speed, speed.norm());
  path.acceleration = std::min(path.acceleration, acceleration.norm());
  return path;
}

/// The same of a controller; then what its axes could do on another path, how fast it speeds up where it does not work, and the tolerance
/// within which it rounds corners.
std::vector<double> limits_of(const ControllerSettings& settings) {
  Setup setup = controller_setup(settings);
  const auto* linuxcnc = std::get_if<LinuxcncSettings>(&settings.values);
  const auto* marlin = std::get_if<MarlinSettings>(&settings.values);
  const double along = setup.machine.path.acceleration, travel = marlin ? marlin->travel_acceleration : along;
  setup.machine.path.acceleration = std::max(along, travel);
  std::vector<double> limits = limits_in(setup);
  for (const AxisLimits& axis : setup.machine.axes) limits.insert(limits.end(), {axis.speed, axis.acceleration});
  limits.insert(limits.end(), {along, travel, linuxcnc ? linuxcnc->blend_tolerance : 0.0});
  return limits;
}

/// The same of the machine on which it is allowed.
std::vector<double> limits_of(Setup allowed) {
  const PathLimits path = allowed.machine.path = path_of(allowed.machine);
  std::vector<double> limits = limits_in(allowed);
  limits.back() = allowed.options.corner.junction_deviation;
  for (const AxisLimits& axis : allowed.machine.axes)  // none needs more than the path
    limits.insert(limits.end(), {std::min(axis.speed, path.speed), std::min(axis.acceleration, path.acceleration)});
  limits.insert(limits.end(), {path.acceleration, path.acceleration, allowed.options.corner.tolerance});
  return limits;
}

/// Whether the limits show this setting: if not, nothing says how far it may be raised.
bool is_limit(const ControllerSettings& settings, std::size_t i) {
  ControllerSettings other = settings;
  const auto table = parameters(other);
  *table[i].value *= 2;
  return limits_of(other) != limits_of(settings);
}

class SettingsTuner {
 public:
  SettingsTuner(const Reading& reading, const ProgramText& text, const ControllerSettings& settings,
                const SettingsSearch& search, const Monitor& monitor)
      : reading_(reading), text_(text), search_(search), monitor_(monitor), original_(settings), settings_(settings) {
    search_.predict.keeps_blocks = search_.predict.keeps_motion = false;
    most_ = limits_of(settings);
    if (search.allowed) {
      const std::vector<double> allowed = limits_of(*search.allowed);
      for (std::size_t i = 0; i < most_.size(); ++i) most_[i] = std::max(most_[i], allowed[i]);
    }
  }

  Result<TunedSettings> run() {
    auto before = time_of(settings_);
    if (!before) return tl::unexpected(before.error());
    best_ = *before;
    if (auto done = raise_all(); !done) return tl::unexpected(done.error());
    for (bool helps = true; helps && has_room();) {
      helps = false;
      for (std::size_t i = 0; i < count() && has_room(); ++i) {
        auto better = turn(i);
        if (!better) return tl::unexpected(better.error());
        helps |= *better;
      }
    }
    for (std::size_t i = 0; i < count(); ++i) {
      if (auto done = take_back(i); !done) return tl::unexpected(done.error());
    }
    return result(*before);
  }

 private:
  std::size_t count() { return parameters(settings_).size(); }
  bool has_room() const { return made_ < search_.predictions; }

  /// Infinite where the controller refuses.
  Result<double> time_of(const ControllerSettings& settings) {
    ++made_;
    monitor_.report(std::min(1.0, static_cast<double>(made_) / static_cast<double>(search_.predictions)));
    const auto prediction = predict(reading_, text_, settings, search_.predict, {monitor_.stop, {}});
    if (prediction) return prediction->cycle_time;
    if (made_ == 1 || prediction.error().kind == ErrorKind::cancelled) return tl::unexpected(prediction.error());
    return kUnlimited;
  }

  bool is_allowed(const ControllerSettings& settings) const {
    const std::vector<double> limits = limits_of(settings);
    for (std::size_t i = 0; i < limits.size(); ++i) {
      if (limits[i] > most_[i] * (1 + kOverLimit)) return false;
    }
    return true;
  }

  static void set(ControllerSettings& settings, std::size_t i, double value) {
    const auto table = parameters(settings);
    *table[i].value = value * table[i].size;
  }

  /// The largest value that is allowed, of a setting that is a limit. Nothing where nothing bounds it.
  std::optional<double> largest(std::size_t i) const {
    ControllerSettings tried = settings_;
    const auto table = parameters(tried);
    const ControllerParameter& p = table[i];
    const double now = *p.value / p.size;
    if (!is_turned(p) || !(now > 0) || !is_limit(settings_, i)) return std::nullopt;
    const auto fits = [&](double value) {
      *p.value = value * p.size;
      return is_allowed(tried);
    };
    double low = now, high = now;
    while (high < p.most && high < now * kFarthest && fits(high)) low = high, high *= 2;
    high = std::min(high, p.most);
    if (fits(high)) return std::nullopt;
    for (int k = 0; k < kHalvings && high - low > 1e-12 * high; ++k) {
      const double middle = (low + high) / 2;
      (fits(middle) ? low : high) = middle;
    }
    const double tidy = rounded_down(low);
    return tidy > now ? std::optional(tidy) : std::nullopt;
  }

  /// To four digits, as people write it.
  static double rounded_down(double value) {
    for (double below = value; below > 0.99 * value; below *= 1 - 1e-4) {
      const double tidy = parse_number(fmt::format("{:.4g}", below)).value_or(below);
      if (tidy <= value * (1 + kOverLimit)) return tidy;
    }
    return value;
  }

  bool is_turned(const ControllerParameter& p) const {
    const auto& chosen = search_.turned;
    return !is_built_in_setting(p) &&
           (chosen.empty() || std::find(chosen.begin(), chosen.end(), p.key) != chosen.end());
  }

  /// All limits at once: one alone often does nothing, as the others then hold.
  Result<void> raise_all() {
    ControllerSettings raised = settings_;
    for (std::size_t i = 0; i < count(); ++i) {
      if (const auto value = largest(i)) set(raised, i, *value);
    }
    if (!is_allowed(raised)) return {};
    const auto time = time_of(raised);
    if (!time) return tl::unexpected(time.error());
    if (*time < best_) settings_ = raised, best_ = *time;
    return {};
  }

  /// @return whether one of its values helps
  Result<bool> turn(std::size_t i) {
    ControllerSettings tried = settings_;
    const auto table = parameters(tried);
    const ControllerParameter& p = table[i];
    if (!is_turned(p)) return false;
    const double now = *p.value / p.size;
    std::vector<double> values = p.others;
    if (const auto most = largest(i)) values.push_back(*most);
    double chosen = now;
    for (const double value : values) {
      if (value == now || !has_room()) continue;
      *p.value = value * p.size;
      if (!is_allowed(tried)) continue;
      const auto time = time_of(tried);
      if (!time) return tl::unexpected(time.error());
      if (*time < best_ * (1 - kHelps)) best_ = *time, chosen = value;
    }
    if (chosen == now) return false;
    set(settings_, i, chosen);
    return true;
  }

  /// To what it was, where that costs nothing.
  Result<void> take_back(std::size_t i) {
    ControllerSettings tried = settings_, was = original_;
    const auto table = parameters(tried), old = parameters(was);
    if (*table[i].value == *old[i].value) return {};
    *table[i].value = *old[i].value;
    const auto time = time_of(tried);
    if (!time) return tl::unexpected(time.error());
    if (*time <= best_ * (1 + kHelps) && is_allowed(tried)) settings_ = tried, best_ = std::min(best_, *time);
    return {};
  }

  TunedSettings result(double before) {
    TunedSettings tuned{settings_, {}, before, before, made_ + 1};
    ControllerSettings was = original_;
    const auto now = parameters(tuned.settings), old = parameters(was);
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (*now[i].value == *old[i].value) continue;
      tuned.changes.push_back(
          {now[i].key, now[i].title, now[i].unit, *old[i].value / old[i].size, *now[i].value / now[i].size});
    }
    if (!tuned.changes.empty()) tuned.after = time_of(settings_).value_or(best_);
    return tuned;
  }

  const Reading& reading_;
  const ProgramText& text_;
  SettingsSearch search_;
  const Monitor& monitor_;
  const ControllerSettings original_;
  ControllerSettings settings_;
  std::vector<double> most_;
  double best_ = 0;
  std::size_t made_ = 0;
};

}  // namespace

std::vector<std::string> tunable_settings(const ControllerSettings& settings) {
  ControllerSettings copy = settings;
  const auto table = parameters(copy);
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const bool is_there = std::isfinite(*table[i].value);
    const bool has_others = !table[i].others.empty() || (*table[i].value > 0 && is_limit(settings, i));
    if (is_there && has_others && !is_built_in_setting(table[i])) keys.push_back(table[i].key);
  }
  return keys;
}

Result<TunedSettings> tune_settings(const Reading& reading, const ProgramText& text, const ControllerSettings& settings,
                                    const SettingsSearch& search, const Monitor& monitor) {
  return SettingsTuner(reading, text, settings, search, monitor).run();
}

}  // namespace toolpace
