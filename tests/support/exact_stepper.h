#pragma once
/// Pulse times of a stepper move in 50 digits.

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cstdint>

#include "toolpace/sample/pulse_table.h"

namespace toolpace::test {

using Exact = boost::multiprecision::cpp_dec_float_50;

/// The exact time of each pulse by bisection on the definition, with 50 digits.
class ExactStepper {
 public:
  explicit ExactStepper(const StepperMove& m) : steps_(m.steps), t_acc_(m.t_acc), t_dec_(m.t_dec), peak_(m.speed) {
    const Exact highest = 2 * steps_ / (t_acc_ + t_dec_);
    if (highest < peak_) peak_ = highest;
    cruise_ = (steps_ - peak_ * (t_acc_ + t_dec_) / 2) / peak_;
  }
  Exact total() const { return t_acc_ + cruise_ + t_dec_; }

  Exact time(std::uint64_t pulse) const {
    const Exact k = pulse;
    const Exact up = peak_ * t_acc_ / 2, down = peak_ * t_dec_ / 2;
    if (k < up) return on_ramp(k, t_acc_);
    if (steps_ - k < down) return total() - on_ramp(steps_ - k, t_dec_);
    return t_acc_ + (k - up) / peak_;
  }

 private:
  /// v = 2·peak·τ², then mirrored: s = T·peak·(2τ³/3), s(1) − s = T·peak·((1−τ) − 2(1−τ)³/3)
  Exact on_ramp(const Exact& distance, const Exact& time) const {
    const Exact wanted = distance / (time * peak_);
    Exact low = 0, high = 1;
    for (int i = 0; i < 150; ++i) {
      const Exact middle = (low + high) / 2, rest = 1 - middle;
      const Exact covered = middle < Exact(1) / 2 ? Exact(2 * middle * middle * middle / 3)
                                                  : Exact(Exact(1) / 2 - (rest - 2 * rest * rest * rest / 3));
      (covered < wanted ? low : high) = middle;
    }
    return low * time;
  }

  Exact steps_, t_acc_, t_dec_, peak_, cruise_;
};

}  // namespace toolpace::test
