#include "toolpace/limits/limit_speed.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "toolpace/limits/ceilings.h"
#include "toolpace/limits/corner_between.h"
#include "toolpace/limits/curve_axes.h"
#include "toolpace/limits/curve_bounds.h"
#include "toolpace/limits/curve_budget.h"
#include "toolpace/limits/dynamics_table.h"
#include "toolpace/limits/tip_bounds.h"
#include "toolpace/path/axis_curve.h"

namespace toolpace {
namespace {

constexpr double kOpposite = 1e-9;     // difference of opposite directions, by rounding
constexpr double kSmoothJoint = 1e-5;  // difference of directions that rounding of micrometre-long lines may leave

using AxesLimits = std::array<AxisLimits, kAxisCount>;

bool is_bounded(const AxisLimits& a) {
  return a.speed < kUnlimited || a.acceleration < kUnlimited || a.jerk < kUnlimited;
}

/// The machine under one ceiling of the program, as blocks and nodes ask for it.
struct Ceiling {
  Ceiling(const Machine& own, const MotionCeiling& of_program, const LimitOptions& options)
      : limits(of_program),
        machine(under(own, of_program)),
        curve_axes(toolpace::curve_axes(machine, options.keeps_jerk)),
        rapid_axes(curve_axes) {
    const double rapid_override = of_program.holds_overrides ? 1.0 : options.rapid_override;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
      const double speed = own.axes[k].speed * rapid_override, most = of_program.speed[static_cast<Eigen::Index>(k)];
      rapid_axes[k].speed = std::min(speed, most);
      lowers_speed = lowers_speed || most < own.axes[k].speed;
      if (machine.axes[k].acceleration < own.axes[k].acceleration) along.of_axes = Cause::program_limit;
    }
    const PathLimits& p = machine.path;
    along.dynamics = {{p.acceleration, p.jerk, options.t_acc}, {p.deceleration, p.jerk_deceleration, options.t_dec}};
    if (p.acceleration < own.path.acceleration || p.deceleration < own.path.deceleration)
      along.own = Cause::program_limit;
    axes_are_bounded = std::any_of(machine.axes.begin(), machine.axes.end(), is_bounded);
  }

  MotionCeiling limits;
  Machine machine;
  AxesLimits curve_axes, rapid_axes;
  AlongPath along;
  bool axes_are_bounded = false;
  bool lowers_speed = false;  ///< of an axis
};

class Limiter {
 public:
  Limiter(const Path& path, const Commands& commands, const Machine& machine, const LimitOptions& options)
      : path_(path), curve_(path), commands_(commands), options_(options) {
    ceilings_.reserve(commands.ceilings.size());
    for (const MotionCeiling& c : commands.ceilings) {
      ceilings_.emplace_back(machine, c, options);
      limits_.along.push_back(ceilings_.back().along);
    }
    const std::size_t n = path.size();
    limits_.length = path.length;
    limits_.block_cap.reserve(n);
    limits_.block_cause.reserve(n);
    limits_.ramp.reserve(n);
    limits_.node_cap.reserve(n + 1);
    limits_.node_cause.reserve(n + 1);
    limits_.node_cap.push_back(0.0);
    limits_.node_cause.push_back(Cause::stop);
  }

  void add_block(std::size_t i) {
    const Command& command = commands_[i];
    double cap = command.speed;
    Cause cause = command.cause;
    const Ceiling& ceiling = ceilings_[command.ceiling];
    Dynamics dynamics = ceiling.along.dynamics;
    if (!curve_.is_straight(i) || ceiling.axes_are_bounded) {
      const CurveBudget budget = curve_budget(curve_bounds(path_, i), axes_of(i));
      const double top = budget.bends() ? budget.top_speed() : budget.speed;
      if (top < cap) cause = cause_of_axes(i, top < budget.speed, ceiling);
      cap = std::min(cap, top);
      dynamics = within(dynamics, budget.at(cap, usual_split(AtCap::changes), AtCap::changes));
      if (budget.bends()) {
        limits_.curved.push_back(static_cast<std::uint32_t>(i));
        limits_.budget.add(budget);
        limits_.ceiling.push_back(command.ceiling);
      }
    }
    limits_.block_cap.push_back(cap);
    limits_.block_cause.push_back(cause);
    limits_.ramp.push_back(dynamics_.add(dynamics, cause_of(dynamics, ceiling.along)));
  }

  /// Node between block i − 1 and block i.
  void add_node(std::size_t i) {
    const CornerOptions corner = corner_between(options_.corner, commands_[i - 1].control, commands_[i].control);
    if (is_reversal(i)) limits_.reversals.push_back(static_cast<std::uint32_t>(i));
    const bool is_inside = (corner.rule == CornerRule::blend && is_inside_spline(path_, i)) || curve_.is_cut(i);
    const double allowed = is_inside ? kUnlimited : node_speed(corner, i);
    const double lower = std::min(limits_.block_cap[i - 1], limits_.block_cap[i]);
    const bool feed_decides = lower <= allowed;
    if (allowed < kUnlimited && !limits_.curved.empty() && limits_.curved.back() + std::size_t{1} >= i)
      limits_.corners.push_back({static_cast<std::uint32_t>(i), allowed});
    limits_.node_cap.push_back(feed_decides ? lower : allowed);
    limits_.node_cause.push_back(feed_decides                      ? slower_block_cause(i)
                                 : corner.rule == CornerRule::stop ? Cause::stop
                                                                   : Cause::corner);
  }

  SpeedLimits finish() {
    limits_.node_cap.resize(path_.size() + 1, 0.0);
    limits_.node_cause.resize(path_.size() + 1, Cause::stop);
    limits_.node_cap.back() = 0.0;
    limits_.node_cause.back() = Cause::stop;
    for (const Path::Pause& pause : path_.pauses) {
      limits_.node_cap[pause.node] = 0.0;
      limits_.node_cause[pause.node] = Cause::stop;
    }
    std::erase_if(limits_.reversals, [&](std::uint32_t node) {
      return std::binary_search(path_.pauses.begin(), path_.pauses.end(), Path::Pause{node, 0, 0},
                                [](const Path::Pause& a, const Path::Pause& b) { return a.node < b.node; });
    });
    std::move(dynamics_).give_to(limits_);
    return std::move(limits_);
  }

 private:
  double node_speed(const CornerOptions& corner, std::size_t i) const {
    // Curves meet their neighbours with one direction and one curvature, whatever rounding leaves of short lines.
    const bool is_curve = path_.kind[i - 1] >= SegmentKind::spline || path_.kind[i] >= SegmentKind::spline;
    if (is_curve && corner.rule == CornerRule::blend && turn_of_path(i) < kSmoothJoint) return kUnlimited;
    const AxisVector arriving = curve_.end_direction(i - 1), leaving = curve_.start_direction(i);
    const double speed = speed_under(commands_[i - 1].ceiling, corner, arriving, leaving);
    if (commands_[i - 1].ceiling == commands_[i].ceiling) return speed;
    return std::min(speed, speed_under(commands_[i].ceiling, corner, arriving, leaving));
  }

  double turn_of_path(std::size_t i) const { return (start_direction(path_, i) - end_direction(path_, i - 1)).norm(); }

  double speed_under(std::uint16_t index, const CornerOptions& corner, const AxisVector& arriving,
                     const AxisVector& leaving) const {
    const Ceiling& c = ceilings_[index];
    return std::min(corner_speed(corner, arriving, leaving, c.machine),
                    corner_speed(c.limits, arriving, leaving, c.machine));
  }

  /// @param by_turning  whether what turning takes is the lower cap than the axes' top speeds
  Cause cause_of_axes(std::size_t i, bool by_turning, const Ceiling& c) const {
    const Command& command = commands_[i];
    if (!curve_.is_path(i) && is_near_pole(path_, i)) return Cause::singularity;
    if (by_turning && !command.is_rapid) return Cause::curvature;
    if (c.lowers_speed) return Cause::program_limit;
    return command.is_rapid ? command.cause : Cause::axis_speed;
  }

  /// Whether every axis goes back between two lines. What is left of its direction would be a step of acceleration.
  bool is_reversal(std::size_t i) const {
    if (path_.kind[i - 1] != SegmentKind::line || path_.kind[i] != SegmentKind::line) return false;
    if (!curve_.is_straight(i - 1) || !curve_.is_straight(i)) return false;
    if (!((path_.node[i] - path_.node[i - 1]).dot(path_.end_of(i) - path_.node[i]) < 0)) return false;
    return (curve_.end_direction(i - 1) + curve_.start_direction(i)).norm() <= kOpposite;
  }

  const AxesLimits& axes_of(std::size_t i) const {
    const Ceiling& c = ceilings_[commands_[i].ceiling];
    if (curve_.is_straight(i)) return c.machine.axes;
    return commands_[i].is_rapid ? c.rapid_axes : c.curve_axes;
  }

  Cause slower_block_cause(std::size_t i) const {
    return limits_.block_cap[i - 1] <= limits_.block_cap[i] ? limits_.block_cause[i - 1] : limits_.block_cause[i];
  }

  const Path& path_;
  AxisCurve curve_;
  const Commands& commands_;
  const LimitOptions& options_;
  std::vector<Ceiling> ceilings_;
  SpeedLimits limits_;
  DynamicsTable dynamics_;
};

/// A limit along the path that is none, in a block that has no other.
Error unbounded(const std::string& flag, const char* key, const char* what, std::uint32_t line, const char* code) {
  return {ErrorKind::usage,
          code,
          flag + " (" + key + " in [path]) is inf, and nothing else bounds the " + what + " in line " +
              std::to_string(line),
          "give " + flag + ", or a limit for each axis that moves",
          {},
          {}};
}

std::optional<Error> find_unbounded(const SpeedLimits& limits, const Commands& commands) {
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const std::uint32_t line = commands[i].line;
    const Dynamics& d = limits.dynamics_of(i);
    if (!(limits.block_cap[i] < kUnlimited)) {
      return unbounded("--vmax", "max_speed_mm_s", "speed", line, "no-speed-limit");
    }
    if (!(d.up.acceleration < kUnlimited)) {
      return unbounded("--am", "max_acceleration_mm_s2", "acceleration", line, "no-acceleration-limit");
    }
    if (!(d.down.acceleration < kUnlimited)) {
      return unbounded("--dm", "max_deceleration_mm_s2", "deceleration", line, "no-acceleration-limit");
    }
  }
  return std::nullopt;
}

}  // namespace

CommandOptions command_options(const Machine& machine) {
  CommandOptions options;
  options.path_speed = machine.path.speed;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    options.rapid_speed[static_cast<Eigen::Index>(k)] = machine.axes[k].speed;
  }
  return options;
}

CornerOptions corner_between(const CornerOptions& job, PathControl before, PathControl after) {
  CornerOptions corner = job;
  if (before == PathControl::blend && after == PathControl::blend) corner.rule = CornerRule::blend;
  if (before == PathControl::exact_path || after == PathControl::exact_path) {
    corner.rule = CornerRule::servo;
    corner.step.reset();
  }
  if (before == PathControl::exact_stop) {
    corner.rule = CornerRule::stop;
    corner.step.reset();
  }
  return corner;
}

Result<SpeedLimits> limit_speed(const Path& path, const Commands& commands, const Machine& machine,
                                const LimitOptions& options, const Monitor& monitor) {
  Limiter limiter(path, commands, machine, options);
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i % kReportEvery == 0) {
      if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
      monitor.report(static_cast<double>(i) / static_cast<double>(path.size()));
    }
    limiter.add_block(i);
    if (i > 0) limiter.add_node(i);
  }
  SpeedLimits limits = limiter.finish();
  if (auto error = find_unbounded(limits, commands)) return tl::unexpected(std::move(*error));
  return limits;
}

}  // namespace toolpace
