#pragma once
/// Pulse tables: how long a timer waits before each step pulse of a stepper move.

#include <cstdint>
#include <limits>
#include <span>

#include "toolpace/base/result.h"
#include "toolpace/law/phase_list.h"

namespace toolpace {

/// A move from rest to rest by the five-phase law with constant ramp times.
struct StepperMove {
  std::uint64_t steps = 0;  ///< ≥ 1
  double speed = 0.0;       ///< top speed [step/s], > 0
  double t_acc = 0.0;       ///< [s], > 0
  double t_dec = 0.0;       ///< [s], > 0
  double timer_hz = 0.0;    ///< timer clock [Hz], above the peak speed, so that intervals are never 0
};

/// The times of all pulses, exact on the polynomial profile, without storing them.
///
/// Pulse k (1 … steps) falls where s(t) = k. The time is rounded to ticks and the rounded times are differenced, so
/// every pulse lies within half a tick of its exact time, the count is exact and the intervals add up to the rounded
/// time of the move. Times are exact to 1e-14 of the move, ramps to standstill are measured from the standstill.
///
/// ERRATUM: the text steps by t_{k+1} = t_k + 1/v(t_k); its error accumulates, and its first interval is 1/0.
/// @source the stepper text (docs/SOURCES.md); Zheng et al. 2014, eqs. (7)–(13), (27)
class PulseTable {
 public:
  static constexpr std::uint64_t kLongestInterval = std::numeric_limits<std::uint32_t>::max();

  /// Errors (usage): numbers that make no sense; a timer slower than the pulses (timer-too-slow), an interval over 32
  /// bits or a move over 2^45 ticks (timer-too-fast).
  static Result<PulseTable> create(const StepperMove& move);

  const StepperMove& move() const { return move_; }
  double peak_speed() const { return peak_; }  ///< [step/s]
  bool reaches_speed() const { return peak_ >= move_.speed; }
  double total_time() const { return total_; }  ///< [s]
  std::uint64_t total_ticks() const { return ticks_at(move_.steps); }

  /// Exact time of a pulse [s]; 0 for pulse 0, total_time() for the last. pulse ≤ steps.
  double time(std::uint64_t pulse) const;

  /// Ticks from the start of the move to a pulse.
  std::uint64_t ticks_at(std::uint64_t pulse) const { return to_ticks(time(pulse)); }

  /// The intervals before the pulses first + 1, first + 2, … in ticks, as many as `ticks` holds.
  /// Precondition: first + ticks.size() ≤ steps. Any stretch may be asked for; long ones are fastest.
  void read(std::uint64_t first, std::span<std::uint32_t> ticks) const;

 private:
  /// A ramp from rest: time at which it has covered a distance.
  struct Ramp {
    PhaseList phases;
    double length = 0.0;
    double time = 0.0;
  };
  /// Where a sequence of pulses has got to on a ramp.
  struct RampCursor;

  PulseTable() = default;
  std::uint64_t to_ticks(double time) const {
    // Never negative and below 2^45, so the sum is exact to 1/100 tick; llround() would cost a third of the speed.
    return static_cast<std::uint64_t>(time * move_.timer_hz + 0.5);  // NOLINT(bugprone-incorrect-roundings)
  }
  Result<void> check_timer() const;

  StepperMove move_;
  Ramp up_;    ///< from the start
  Ramp down_;  ///< from the end, backwards
  double peak_ = 0.0;
  double total_ = 0.0;
};

}  // namespace toolpace
