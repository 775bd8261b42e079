#pragma once
/// One axis: position loop, drive, backlash, resonance; exact from period to period.

#include <Eigen/Core>
#include <vector>

#include "toolpace/base/result.h"
#include "toolpace/limits/servo_axis.h"

namespace toolpace {

/// The command r(t) goes straight from setpoint to setpoint. The position loop asks the drive for the speed
///   w = Kv·(r − y) + kᵥ·ṙ + kₐ·(2ζ/ω)·r̈,
/// y the motor's position, r̈ the second difference of the setpoints; the drive follows as v̈ = ω²(w − v) − 2ζω·v̇, ẏ = v.
/// The slide hangs on the motor through its play and, if it has modes, through each of them: z = p + Σ share·(z_r − p) with
/// z̈_r = ω_r²(p − z_r) + 2ζ_r·ω_r(ṗ − ż_r).
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
    const double moved = from - origin_;  // positions are relative to it, so that large coordinates cost no digits
    origin_ = from;
    motor_[0] -= moved;
    if (half_play_ == 0) {
      for (Ring& r : rings_) {
        r.state[0] -= moved;
        const Eigen::Vector2d next =
            r.by_motor * motor_ + r.by_itself * r.state + r.by_slope * slope + r.by_bend * bend;
        r.state = next;
      }
    }
    const Eigen::Vector3d next = transition_ * motor_ + by_slope_ * slope + by_bend_ * bend;
    motor_ = next;
    return slide(origin_ + motor_[0]);
  }

 private:
  /// A mode of the slide. Without play it is coupled to the motor and told from origin_ on; behind play it is driven by what is left of
  /// the motor's motion.
  struct Ring {
    double share;
    Eigen::Matrix<double, 2, 3> by_motor;
    Eigen::Matrix2d by_itself;
    Eigen::Vector2d by_slope, by_bend;                ///< of the command, or of what pushes it
    Eigen::Vector2d state = Eigen::Vector2d::Zero();  ///< position, speed/ω_r
  };

  AxisServo() = default;
  double slide(double motor);

  double per_period_ = 0.0;
  Eigen::Matrix3d transition_;
  Eigen::Vector3d by_slope_, by_bend_;
  Eigen::Vector3d motor_ = Eigen::Vector3d::Zero();  ///< position, speed/ω, acceleration/ω²
  double origin_ = 0.0;
  double half_play_ = 0.0;
  double pushed_ = 0.0;  ///< position behind the play
  std::vector<Ring> rings_;
  double stiff_share_ = 1.0;  ///< of the slide that does not ring: 1 − Σ share
};

}  // namespace toolpace
