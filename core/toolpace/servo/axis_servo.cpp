#include "toolpace/servo/axis_servo.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>

#include "toolpace/servo/servo_range.h"

namespace toolpace {
namespace {

Error servo_error(const char* code, std::string what, std::string remedy) {
  return {ErrorKind::usage, code, std::move(what), std::move(remedy), {}, {}};
}

bool is_within(double value, const ServoRange& range) {
  return (value >= range.least && value <= range.most) || (range.may_be_zero && value == 0);
}

Result<void> check(const ServoAxis& s, double period) {
  const auto not_negative = [](double v) { return std::isfinite(v) && v >= 0; };
  const bool fits = std::isfinite(period) && period > 0 && is_within(s.position_gain, kServoGain) &&
                    is_within(s.bandwidth, kServoBandwidth) && is_within(s.damping, kServoDamping) &&
                    is_within(s.resonance, kServoResonance) && is_within(s.resonance_damping, kServoDamping) &&
                    not_negative(s.velocity_feed_forward) && not_negative(s.acceleration_feed_forward) &&
                    not_negative(s.backlash);
  if (!fits) {
    return tl::unexpected(
        servo_error("servo-value", "a value of the servo drive is out of range or no number",
                    "the gain must be 1e-3 to 1e5 1/s, bandwidth and resonance 0.01 to 1e5 Hz, damping 1e-3 to 100"));
  }
  // s³ + 2ζω·s² + ω²·s + Kv·ω² is stable exactly for 2ζω > Kv.
  const double most = 2 * s.damping * 2 * std::numbers::pi * s.bandwidth;
  if (s.position_gain < most) return {};
  Error error = servo_error("servo-unstable", "the position gain is too high for the drive: the loop would swing up",
                            fmt::format("give a gain below {:.6g} 1/s, which is 4π·damping·bandwidth", most));
  error.attainable = most;
  return tl::unexpected(error);
}

}  // namespace

Result<AxisServo> AxisServo::create(const ServoAxis& s, double period) {
  if (auto fits = check(s, period); !fits) return tl::unexpected(fits.error());
  return of(s, period);
}

AxisServo AxisServo::of(const ServoAxis& s, double period) {
  const double w = 2 * std::numbers::pi * s.bandwidth;
  const double wr = 2 * std::numbers::pi * s.resonance;
  const bool rings = s.resonance > 0;
  // State: y, v/ω, v̇/ω², z, ż/ω_r, then the command r and its slope and bend, which are constant in a period. Scaled so,
  // all entries are of one size and the exponential loses no digits.
  Eigen::Matrix<double, 8, 8> m = Eigen::Matrix<double, 8, 8>::Zero();
  m(0, 1) = w;
  m(1, 2) = w;
  m.row(2) << -s.position_gain, -w, -2 * s.damping * w, 0, 0, s.position_gain, s.velocity_feed_forward,
      s.acceleration_feed_forward * 2 * s.damping / w;
  if (rings) {
    m(3, 4) = wr;
    m.row(4) << wr, 2 * s.resonance_damping * w, 0, -wr, -2 * s.resonance_damping * wr, 0, 0, 0;
  }
  m(5, 6) = 1;
  const Eigen::Matrix<double, 8, 8> exact = (m * period).exp();

  AxisServo servo;
  servo.per_period_ = 1 / period;
  const bool coupled = rings && s.backlash == 0;
  servo.size_ = coupled ? 5 : 3;
  servo.transition_ = exact.topLeftCorner<5, 5>();
  servo.by_slope_ = exact.block<5, 1>(0, 6);
  servo.by_bend_ = exact.block<5, 1>(0, 7);
  servo.half_play_ = s.backlash / 2;
  servo.rings_ = rings && !coupled;
  if (servo.rings_) {
    Eigen::Matrix4d ring = Eigen::Matrix4d::Zero();  // z, ż/ω_r, p, ṗ
    ring(0, 1) = wr;
    ring.row(1) << -wr, -2 * s.resonance_damping * wr, wr, 2 * s.resonance_damping;
    ring(2, 3) = 1;
    const Eigen::Matrix4d ring_exact = (ring * period).exp();
    servo.ring_ = ring_exact.topLeftCorner<2, 2>();
    servo.ring_by_slope_ = ring_exact.block<2, 1>(0, 3);
  }
  return servo;
}

void AxisServo::reset(double position) {
  motor_.setZero();
  origin_ = position;
  pushed_ = position;
  slide_ << position, 0.0;
}

double AxisServo::slide(double motor) {
  if (size_ > 3) return origin_ + motor_[3];
  if (half_play_ == 0) return motor;
  const double before = pushed_;
  pushed_ = std::clamp(pushed_, motor - half_play_, motor + half_play_);
  if (!rings_) return pushed_;
  // Relative to where the play ended up last, as the step knows the command p from 0 on.
  const Eigen::Vector2d relative(slide_[0] - before, slide_[1]);
  slide_ = ring_ * relative + ring_by_slope_ * ((pushed_ - before) * per_period_);
  slide_[0] += before;
  return slide_[0];
}

}  // namespace toolpace
