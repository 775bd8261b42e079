#pragma once
/// The timer that makes grbl's steps: it counts whole cycles of its clock, and one more each time.

#include <algorithm>
#include <cmath>

#include "toolpace/controller/trapezoid.h"

namespace toolpace::detail::controller {

/// @source grbl 1.1, stepper.c: st_prep_buffer() rounds cycles up, smooths slow steps by interrupts 2, 4 or 8 times as often,
///         and sets the compare register of a timer whose period is one cycle longer than that
class StepTimer {
 public:
  /// @param clock  [Hz]; 0 = one that does not round
  explicit StepTimer(double clock) : clock_(clock) {}

  /// Makes the times of a block what the timer makes of them. @param steps_a_mm  of the axis with the most steps
  void stretch(Trapezoid& t, double entry, double exit, double steps_a_mm) const {
    if (clock_ == 0) return;
    t.up *= 1.0 + mean_delay(entry * steps_a_mm, t.peak * steps_a_mm);
    t.down *= 1.0 + mean_delay(exit * steps_a_mm, t.peak * steps_a_mm);
    if (t.cruise > 0) t.cruise *= 1.0 + steady_delay(t.peak * steps_a_mm);
  }

 private:
  static constexpr double kFastest = 2000;  // [cycles] a step below which each interrupt makes one

  static double interrupts_a_step(double cycles) {
    return cycles < kFastest ? 1.0 : cycles < 2 * kFastest ? 2.0 : cycles < 4 * kFastest ? 4.0 : 8.0;
  }

  /// How much longer a step takes than it should, relative, at a steady rate [steps/s].
  double steady_delay(double rate) const {
    const double wanted = clock_ / rate, cycles = std::ceil(wanted * (1.0 - 1e-9)), share = interrupts_a_step(cycles);
    return share * (std::floor(cycles / share) + 1.0) / wanted - 1.0;
  }

  /// The mean of it over rates near by: half of what is rounded, and what is added.
  double delay_near(double rate) const {
    if (!(rate > 0)) return 0;
    const double wanted = clock_ / rate;
    return (0.5 * interrupts_a_step(wanted) + 1.0) / wanted;
  }

  /// The mean over a ramp, whose speed changes evenly.
  double mean_delay(double from, double to) const {
    constexpr double kSmallChange = 200;  // [steps/s]
    const double change = to - from;
    if (change < kSmallChange) return delay_near(0.5 * (from + to));
    return 0.25 * (delay_near(from + 0.125 * change) + delay_near(from + 0.375 * change) +
                   delay_near(from + 0.625 * change) + delay_near(from + 0.875 * change));
  }

  double clock_;
};

}  // namespace toolpace::detail::controller
