#include "toolpace/sample/program_pulses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "toolpace/base/axis_unit.h"
#include "toolpace/base/numbers.h"
#include "toolpace/sample/motion.h"

namespace toolpace {
namespace {

constexpr double kWindow = 1e-3;                   // [s] in which a curve turns at most once
constexpr double kMostTicks = 9007199254740992.0;  // 2^53: up to here doubles count exactly
constexpr double kHysteresis = 1e-7;               // [steps] so that rounding at a middle makes no pulses
constexpr double kTickFraction = 1e-3;             // of a tick, to which the time of a pulse is solved
constexpr int kMostIterations = 100;
constexpr double kSlopePart = 1.0 / 64;  // of a window, over which its end slopes are measured
constexpr std::size_t kPulsesAtATime = 65536;

Error pulse_error(const char* code, std::string what, std::string remedy) {
  return {ErrorKind::usage, code, std::move(what), std::move(remedy), {}, {}};
}

class PulseMaker {
 public:
  PulseMaker(const TimedMotion& motion, const Machine& machine, double timer_hz)
      : motion_(motion.path, motion.plan), timer_hz_(timer_hz) {
    const AxisVector start = motion_.at(0).position();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      steps_[axis] = machine.axes[axis].steps_per_unit;
      count_[axis] = start_[axis] = std::llround(start[static_cast<Eigen::Index>(axis)] * steps_[axis]);
    }
  }

  /// Adds the pulses of a window without node or phase change inside, in the order of time.
  Result<void> add_window(double t0, double t1) {
    const std::size_t first = pulses_.size();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (steps_[axis] <= 0) continue;
      add_axis(axis, t0, t1);
      if (too_slow_) {
        const AxisUnit& unit = axis_unit(axis);
        return tl::unexpected(pulse_error(
            "timer-too-slow",
            fmt::format(
                "--timer-hz is {} Hz and steps_per_{} in [axes.{}] is {:.9g}: two pulses of {} fall on one tick",
                to_text(timer_hz_), unit.key[0], kAxisNames[axis], steps_[axis] * unit.size, kAxisNames[axis]),
            "give a faster timer or fewer steps per mm"));
      }
    }
    std::stable_sort(pulses_.begin() + static_cast<std::ptrdiff_t>(first), pulses_.end(),
                     [](const Pulse& a, const Pulse& b) { return a.ticks < b.ticks; });
    return {};
  }

  std::vector<Pulse>& pulses() { return pulses_; }
  std::array<std::int64_t, kAxisCount> net() const {
    std::array<std::int64_t, kAxisCount> net = {};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) net[axis] = count_[axis] - start_[axis];
    return net;
  }

 private:
  /// Position of an axis in steps.
  double in_steps(std::size_t axis, double time) {
    return motion_.at(time).position()[static_cast<Eigen::Index>(axis)] * steps_[axis];
  }

  void add_axis(std::size_t axis, double t0, double t1) {
    const double p0 = in_steps(axis, t0), p1 = in_steps(axis, t1);
    const double part = kSlopePart * (t1 - t0);
    const double begins = in_steps(axis, t0 + part) - p0, ends = p1 - in_steps(axis, t1 - part);
    if (begins * ends < 0 && (t1 - t0) * timer_hz_ > 0.5) {  // it turns in between
      const double middle = t0 + (t1 - t0) / 2;
      add_axis(axis, t0, middle);
      add_axis(axis, middle, t1);
      return;
    }
    add_monotone(axis, {t0, p0}, {t1, p1});
  }

  struct Moment {
    double time, steps;
  };

  void add_monotone(std::size_t axis, Moment from, Moment to) {
    const int direction = to.steps > from.steps ? 1 : -1;
    for (;;) {
      const double level = static_cast<double>(count_[axis]) + direction * (0.5 + kHysteresis);
      if (direction * (to.steps - level) < 0) return;
      from = solve(axis, level, from, to);
      count_[axis] += direction;
      const auto ticks = static_cast<std::uint64_t>(std::llround(from.time * timer_hz_));
      too_slow_ |= last_[axis] && *last_[axis] == ticks;
      last_[axis] = ticks;
      pulses_.push_back({ticks, static_cast<std::uint8_t>(axis), static_cast<std::int8_t>(direction)});
    }
  }

  /// Where the position crosses a level, to a small part of a tick. Illinois variant of false position, bracketed.
  Moment solve(std::size_t axis, double level, Moment a, Moment b) {
    double fa = a.steps - level, fb = b.steps - level;
    int side = 0;
    for (int i = 0; i < kMostIterations && (b.time - a.time) * timer_hz_ > kTickFraction && fa != fb; ++i) {
      // Every third step halves, so that flat ends cannot stall it.
      const double t = i % 3 == 2 ? a.time + (b.time - a.time) / 2 : a.time + (b.time - a.time) * (fa / (fa - fb));
      const double time = std::clamp(t, a.time, b.time);
      const double f = in_steps(axis, time) - level;
      if (f == 0) return {time, level};
      if ((f < 0) == (fb < 0)) {
        b = {time, f + level};
        fb = f;
        if (side == -1) fa /= 2;
        side = -1;
      } else {
        a = {time, f + level};
        fa = f;
        if (side == 1) fb /= 2;
        side = 1;
      }
      const double least = kTickFraction / timer_hz_;
      if (std::abs(f) < 1e-12) return {time, level};
      if (b.time - a.time < least) break;
    }
    return {a.time + (b.time - a.time) / 2, level};
  }

  Motion motion_;
  double timer_hz_;
  std::array<double, kAxisCount> steps_ = {};
  std::array<std::int64_t, kAxisCount> count_ = {}, start_ = {};
  std::array<std::optional<std::uint64_t>, kAxisCount> last_ = {};
  bool too_slow_ = false;
  std::vector<Pulse> pulses_;
};

Result<void> check_plan(const TimedMotion& motion, const Machine& machine, double timer_hz) {
  if (auto fine = check_timer(timer_hz); !fine) return fine;
  const bool has_steppers =
      std::any_of(machine.axes.begin(), machine.axes.end(), [](const AxisLimits& a) { return a.steps_per_unit > 0; });
  if (!has_steppers) {
    return tl::unexpected(pulse_error("no-steppers", "no axis of the machine has steps",
                                      "put steps_per_mm into [axes.X] of the machine file"));
  }
  if (motion.plan.cycle_time() * timer_hz >= kMostTicks) {
    return tl::unexpected(pulse_error(
        "timer-too-fast",
        fmt::format("--timer-hz is {} Hz: the program of {} s takes more ticks than 2^53, which is what the "
                    "counter holds",
                    to_text(timer_hz), to_text(motion.plan.cycle_time())),
        "give a slower timer"));
  }
  return {};
}

/// Times at which something changes: nodes, phases, and in between at most a window apart.
class Breaks {
 public:
  explicit Breaks(const TimedMotion& motion) : motion_(motion), end_(motion.plan.cycle_time()) {}

  double after(double time) {
    const auto& nodes = motion_.node_time;
    const auto& phases = motion_.plan.phases;
    while (node_ < nodes.size() && nodes[node_] <= time) ++node_;
    while (phase_ < phases.size() && phases[phase_].begin <= time) ++phase_;
    double next = std::min(time + kWindow, end_);
    if (node_ < nodes.size()) next = std::min(next, nodes[node_]);
    if (phase_ < phases.size()) next = std::min(next, phases[phase_].begin);
    return next > time ? next : end_;
  }
  double end() const { return end_; }

 private:
  const TimedMotion& motion_;
  double end_;
  std::size_t node_ = 0, phase_ = 0;
};

}  // namespace

Result<void> check_timer(double timer_hz) {
  if (timer_hz >= kSlowestTimer && timer_hz <= kFastestTimer) return {};
  return tl::unexpected(pulse_error("timer-value",
                                    "the timer's clock is " + to_text(timer_hz) + " Hz, not between 1 Hz and 1e12 Hz",
                                    "give --timer-hz, such as 1000000"));
}

Result<PulseCounts> program_pulses(const TimedMotion& motion, const Machine& machine, double timer_hz,
                                   const std::function<Result<void>(const std::vector<Pulse>&)>& take,
                                   const Monitor& monitor) {
  if (auto fits = check_plan(motion, machine, timer_hz); !fits) return tl::unexpected(fits.error());
  PulseCounts counts;
  if (motion.path.node.empty()) return counts;
  PulseMaker maker(motion, machine, timer_hz);
  Breaks breaks(motion);
  const auto hand_out = [&]() -> Result<void> {
    counts.pulses += maker.pulses().size();
    auto taken = take(maker.pulses());
    maker.pulses().clear();
    return taken;
  };
  for (double time = 0; time < breaks.end();) {
    const double next = breaks.after(time);
    if (auto added = maker.add_window(time, next); !added) return tl::unexpected(added.error());
    time = next;
    if (maker.pulses().size() < kPulsesAtATime) continue;
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    if (auto taken = hand_out(); !taken) return tl::unexpected(taken.error());
    monitor.report(time / breaks.end());
  }
  if (auto taken = hand_out(); !taken) return tl::unexpected(taken.error());
  counts.net = maker.net();
  return counts;
}

}  // namespace toolpace
