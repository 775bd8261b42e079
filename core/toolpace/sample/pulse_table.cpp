#include "toolpace/sample/pulse_table.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "toolpace/base/numbers.h"
#include "toolpace/law/single_move.h"

namespace toolpace {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMostMoveTicks = 35184372088832.0;  // 2^45: a time in ticks is then exact to 1/100 tick

Error bad_number(std::string what, double value, std::string remedy) {
  return {
      ErrorKind::usage, "number-out-of-range", std::move(what) + " is " + to_text(value), std::move(remedy), {}, {}};
}

std::optional<Error> check_numbers(const StepperMove& move) {
  const auto is_fine = [](double value) { return value >= 1e-30 && value <= 1e30; };
  const char* kBounds = "it must be between 1e-30 and 1e30";
  if (move.steps < 1) return bad_number("the number of steps", 0.0, "it must be at least 1");
  if (!is_fine(move.speed)) return bad_number("the top speed in step/s", move.speed, kBounds);
  if (!is_fine(move.t_acc)) return bad_number("the acceleration time in s", move.t_acc, kBounds);
  if (!is_fine(move.t_dec)) return bad_number("the deceleration time in s", move.t_dec, kBounds);
  if (!is_fine(move.timer_hz)) return bad_number("the timer clock in Hz", move.timer_hz, kBounds);
  return std::nullopt;
}

PhaseList ramp_from_rest(double peak, double time) {
  PhaseList phases;
  FivePhaseTime::append_ramp(0.0, peak, {kInfinity, kInfinity, time}, phases);
  return phases;
}

/// Distance and speed of a ramp's phase, both from the phase's start.
struct Progress {
  double distance, speed;
};

Progress advance(const Phase& p, double time) {
  return {time * (p.speed + time * (p.acceleration / 2 + time * (p.rate / 6))),
          p.speed + time * (p.acceleration + time * (p.rate / 2))};
}

/// Newton's method for the time at which the phase has covered `distance`. The speed never falls on a ramp from rest,
/// so the distance is convex: from above the steps descend to the root, from below the first one goes above it.
double solve_time(const Phase& p, double distance, double guess) {
  constexpr int kMaxSteps = 100;  // from the far end of a phase of 1e18 steps it takes 105 thirds; guesses take 1 or 2
  // [step] A step from here leaves an error of its square; the second term is the rounding of the distance itself.
  const double small = 1e-8 + 1e-15 * distance;
  double time = guess;
  for (int i = 0; i < kMaxSteps; ++i) {
    const Progress at = advance(p, time);
    const double excess = at.distance - distance;
    time -= excess / at.speed;
    if (std::abs(excess) <= small) break;
  }
  return time;
}

const Phase& phase_at(const PhaseList& phases, double distance) {
  std::size_t i = phases.size() - 1;
  while (i > 0 && phases[i].distance > distance) --i;
  return phases[i];
}

double time_on_ramp(const PhaseList& phases, double distance) {
  if (!(distance > 0)) return 0.0;
  const Phase& p = phase_at(phases, distance);
  return p.begin + solve_time(p, distance - p.distance, p.duration);
}

}  // namespace

/// Takes a ramp's pulses in order, forwards or backwards, each guess from the pulse before.
struct PulseTable::RampCursor {
  const PhaseList& phases;
  const Phase* phase = nullptr;
  double local = 0.0;  ///< time in the phase

  RampCursor(const PhaseList& list, double distance) : phases(list) { restart(distance); }

  void restart(double distance) {
    phase = &phase_at(phases, distance);
    local = distance > 0 ? solve_time(*phase, distance - phase->distance, phase->duration) : 0.0;
  }

  /// Time at which the ramp has covered `distance`, one step from the last.
  double move_to(double distance, double direction) {
    const bool leaves =
        distance < phase->distance || (phase != phases.end() - 1 && distance >= (phase + 1)->distance) || !(local > 0);
    if (leaves) {
      restart(distance);
    } else {
      // The motion at constant acceleration covers the step in dt: v·dt ± a·dt²/2 = 1.
      const double speed = phase->speed + local * (phase->acceleration + local * (phase->rate / 2));
      const double acceleration = phase->acceleration + local * phase->rate;
      const double root = std::sqrt(std::max(speed * speed + direction * 2 * acceleration, 0.0));
      local = solve_time(*phase, distance - phase->distance, local + direction * (2 / (speed + root)));
    }
    return phase->begin + local;
  }
};

Result<PulseTable> PulseTable::create(const StepperMove& move) {
  if (auto error = check_numbers(move)) return tl::make_unexpected(std::move(*error));
  const double length = static_cast<double>(move.steps);
  const Dynamics dynamics{{kInfinity, kInfinity, move.t_acc}, {kInfinity, kInfinity, move.t_dec}};
  const auto motion = single_move<FivePhaseTime>({length, move.speed, 0.0, 0.0}, dynamics);
  if (!motion) return tl::make_unexpected(motion.error());
  PulseTable table;
  table.move_ = move;
  table.peak_ = motion->peak;
  table.total_ = motion->total_time();
  table.up_ = {ramp_from_rest(motion->peak, move.t_acc), motion->up.length, motion->up.time};
  table.down_ = {ramp_from_rest(motion->peak, move.t_dec), motion->down.length, motion->down.time};
  if (auto fine = table.check_timer(); !fine) return tl::make_unexpected(fine.error());
  return table;
}

Result<void> PulseTable::check_timer() const {
  const auto refuse = [](std::string code, std::string message, std::string remedy) -> Result<void> {
    return tl::make_unexpected(Error{ErrorKind::usage, std::move(code), std::move(message), std::move(remedy), {}, {}});
  };
  const std::string clock = "the timer clock is " + to_text(move_.timer_hz) + " Hz";
  // At exactly one tick a pulse, rounding would put two pulses on the same tick here and there.
  if (peak_ > move_.timer_hz * (1 - 1e-9)) {
    return refuse("timer-too-slow",
                  clock + ", so pulses at " + to_text(peak_) + " step/s are no more than one tick apart",
                  "take a faster timer clock or a lower top speed");
  }
  if (total_ * move_.timer_hz > kMostMoveTicks) {
    return refuse("timer-too-fast",
                  clock + ", so the move of " + to_text(total_) + " s takes " + to_text(total_ * move_.timer_hz) +
                      " ticks, more than 2^45",
                  "take a slower timer clock or a shorter move");
  }
  // The speed rises and then falls, so the first interval or the last one is the longest.
  const std::uint64_t longest = std::max(ticks_at(1), ticks_at(move_.steps) - ticks_at(move_.steps - 1));
  if (longest > kLongestInterval) {
    return refuse("timer-too-fast",
                  clock + ", so an interval takes " + std::to_string(longest) + " ticks, more than 32 bits hold",
                  "take a slower timer clock or shorter ramps");
  }
  return {};
}

double PulseTable::time(std::uint64_t pulse) const {
  const double distance = static_cast<double>(pulse);
  const double left = static_cast<double>(move_.steps - pulse);
  if (distance < up_.length) return time_on_ramp(up_.phases, distance);
  if (left < down_.length) return total_ - time_on_ramp(down_.phases, left);
  return up_.time + (distance - up_.length) / peak_;
}

void PulseTable::read(std::uint64_t first, std::span<std::uint32_t> ticks) const {
  std::uint64_t before = ticks_at(first);
  std::size_t i = 0;
  const auto pulse = [&] { return first + i + 1; };
  const auto put = [&](double time) {
    const std::uint64_t now = to_ticks(time);
    ticks[i++] = static_cast<std::uint32_t>(now - before);
    before = now;
  };
  if (i < ticks.size() && static_cast<double>(pulse()) < up_.length) {
    RampCursor cursor(up_.phases, static_cast<double>(first));
    while (i < ticks.size() && static_cast<double>(pulse()) < up_.length) {
      put(cursor.move_to(static_cast<double>(pulse()), 1.0));
    }
  }
  const auto left = [&] { return static_cast<double>(move_.steps - pulse()); };
  while (i < ticks.size() && !(left() < down_.length)) {
    put(up_.time + (static_cast<double>(pulse()) - up_.length) / peak_);
  }
  if (i >= ticks.size()) return;
  RampCursor cursor(down_.phases, left());
  put(total_ - (left() > 0 ? cursor.phase->begin + cursor.local : 0.0));
  while (i < ticks.size()) put(left() > 0 ? total_ - cursor.move_to(left(), -1.0) : total_);
}

}  // namespace toolpace
