#pragma once
/// One axis: position loop, drive, backlash, resonance; exact from period to period.

#include <Eigen/Core>

#include "toolpace/base/result.h"
#include "toolpace/limits/servo_axis.h"

namespace toolpace {

/// The command r(t) goes straight from setpoint to setpoint. The position loop asks the drive for the speed
///   w = Kv·(r − y) + kᵥ·ṙ + kₐ·(2ζ/ω)·r̈,
/// y the motor's position, r̈ the second difference of the setpoints; the drive follows as v̈ = ω²(w − v) − 2ζω·v̇, ẏ = v.
/// The slide hangs on the motor through its play and, if it has a resonance, through z̈ = ω_r²(p − z) + 2ζ_r·ω_r(ṗ − ż).
///
/// Without play the whole is linear and each step is exact (matrix exponential), so any period is stable if the loop is.
/// With play, the motor's step is exact and the play acts on its position at the periods' ends.
///
/// @source Pritschow, "A comparison of linear and conventional electromechanical drives", CIRP Annals 47/2, 1998, for the
/// model of loop and drive; Van Loan, "Computing integrals involving the matrix exponential", 1978, for the step.
class AxisServo {
 public:
  /// @param period  [s] > 0
  /// Errors (usage): servo-value for values that make no sense; servo-unstable for Kv ≥ 2ζω (Hurwitz).
  static Result<AxisServo> create(const ServoAxis& axis, double period);

  /// The same without looking at the values, for fits that try some beside those that make sense: a feed-forward below 0.
  /// @pre Kv < 2ζω; gain, bandwidth and damping > 0
  static AxisServo of(const ServoAxis& axis, double period);

  /// At rest at a position.
  void reset(double position);

  /// One period on: the command goes from `from` to `to`. @param before  setpoint before `from`
  /// @return the slide's position at the period's end
  double step(double before, double from, double to) {
    const double slope = (to - from) * per_period_;
    const double bend = ((to - from) - (from - before)) * per_period_ * per_period_;
    const double origin = from;  // positions are relative to it, so that large coordinates cost no digits
    motor_[0] -= origin - origin_;
    if (size_ > 3) motor_[3] -= origin - origin_;
    origin_ = origin;
    if (size_ > 3) {
      motor_ = transition_ * motor_ + by_slope_ * slope + by_bend_ * bend;
    } else {
      motor_.head<3>() = transition_.topLeftCorner<3, 3>() * motor_.head<3>() + by_slope_.head<3>() * slope +
                         by_bend_.head<3>() * bend;
    }
    return slide(origin_ + motor_[0]);
  }

 private:
  AxisServo() = default;
  using State = Eigen::Matrix<double, 5, 1>;  ///< motor position, speed/ω, acceleration/ω²; slide position, speed/ω_r
  double slide(double motor);

  int size_ = 3;
  double per_period_ = 0.0;
  Eigen::Matrix<double, 5, 5> transition_;
  State by_slope_, by_bend_;
  State motor_ = State::Zero();
  double origin_ = 0.0;

  // With play: play, then the resonance driven by what is left of the motor's motion.
  double half_play_ = 0.0;
  double pushed_ = 0.0;  ///< position behind the play
  bool rings_ = false;
  Eigen::Matrix2d ring_;
  Eigen::Vector2d ring_by_slope_;
  Eigen::Vector2d slide_ = Eigen::Vector2d::Zero();  ///< position, speed/ω_r
};

}  // namespace toolpace
