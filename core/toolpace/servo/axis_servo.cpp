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
  const auto is_mode = [](const AxisMode& m) {
    return is_within(m.frequency, kServoMode) && is_within(m.damping, kServoDamping) && is_within(m.share, kServoShare);
  };
  const bool fits = std::isfinite(period) && period > 0 && is_within(s.position_gain, kServoGain) &&
                    is_within(s.bandwidth, kServoBandwidth) && is_within(s.damping, kServoDamping) &&
                    is_within(s.resonance, kServoResonance) && is_within(s.resonance_damping, kServoDamping) &&
                    not_negative(s.velocity_feed_forward) && not_negative(s.acceleration_feed_forward) &&
                    not_negative(s.backlash) && std::all_of(s.modes.begin(), s.modes.end(), is_mode);
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

namespace {

using Matrix8 = Eigen::Matrix<double, 8, 8>;

/// State: y, v/ω, v̇/ω², z, ż/ω_r, then the command r and its slope and bend, which are constant in a period. Scaled so,
/// all entries are of one size and the exponential loses no digits.
Matrix8 coupled_step(const ServoAxis& s, const AxisMode* mode, double period) {
  const double w = 2 * std::numbers::pi * s.bandwidth;
  Matrix8 m = Matrix8::Zero();
  m(0, 1) = w;
  m(1, 2) = w;
  m.row(2) << -s.position_gain, -w, -2 * s.damping * w, 0, 0, s.position_gain, s.velocity_feed_forward,
      s.acceleration_feed_forward * 2 * s.damping / w;
  if (mode) {
    const double wr = 2 * std::numbers::pi * mode->frequency;
    m(3, 4) = wr;
    m.row(4) << wr, 2 * mode->damping * w, 0, -wr, -2 * mode->damping * wr, 0, 0, 0;
  }
  m(5, 6) = 1;
  return (m * period).exp();
}

/// State: z, ż/ω_r, what pushes it and its speed, which is constant in a period.
Eigen::Matrix4d pushed_step(const AxisMode& mode, double period) {
  const double wr = 2 * std::numbers::pi * mode.frequency;
  Eigen::Matrix4d ring = Eigen::Matrix4d::Zero();
  ring(0, 1) = wr;
  ring.row(1) << -wr, -2 * mode.damping * wr, wr, 2 * mode.damping;
  ring(2, 3) = 1;
  return (ring * period).exp();
}

}  // namespace

AxisServo AxisServo::of(const ServoAxis& s, double period) {
  AxisServo servo;
  servo.per_period_ = 1 / period;
  servo.half_play_ = s.backlash / 2;
  const std::vector<AxisMode> modes = modes_of(s);
  const bool is_coupled = !modes.empty() && s.backlash == 0;
  const Matrix8 exact = coupled_step(s, is_coupled ? &modes.front() : nullptr, period);
  servo.transition_ = exact.topLeftCorner<3, 3>();
  servo.by_slope_ = exact.block<3, 1>(0, 6);
  servo.by_bend_ = exact.block<3, 1>(0, 7);
  for (const AxisMode& mode : modes) {
    Ring ring;
    ring.share = mode.share;
    servo.stiff_share_ -= mode.share;
    if (is_coupled) {
      const Matrix8 of_mode = &mode == &modes.front() ? exact : coupled_step(s, &mode, period);
      ring.by_motor = of_mode.block<2, 3>(3, 0);
      ring.by_itself = of_mode.block<2, 2>(3, 3);
      ring.by_slope = of_mode.block<2, 1>(3, 6);
      ring.by_bend = of_mode.block<2, 1>(3, 7);
    } else {
      const Eigen::Matrix4d pushed = pushed_step(mode, period);
      ring.by_motor.setZero();
      ring.by_itself = pushed.topLeftCorner<2, 2>();
      ring.by_slope = pushed.block<2, 1>(0, 3);
      ring.by_bend.setZero();
    }
    servo.rings_.push_back(ring);
  }
  return servo;
}

void AxisServo::reset(double position) {
  motor_.setZero();
  origin_ = position;
  pushed_ = position;
  for (Ring& r : rings_) r.state << (half_play_ == 0 ? 0.0 : position), 0.0;
}

double AxisServo::slide(double motor) {
  if (half_play_ == 0) {
    if (rings_.empty()) return motor;
    double sum = stiff_share_ * motor_[0];
    for (const Ring& r : rings_) sum += r.share * r.state[0];
    return origin_ + sum;
  }
  const double before = pushed_;
  pushed_ = std::clamp(pushed_, motor - half_play_, motor + half_play_);
  double place = stiff_share_ * pushed_;
  // Relative to where the play ended up last, as the step knows what pushes from 0 on.
  for (Ring& r : rings_) {
    const Eigen::Vector2d relative(r.state[0] - before, r.state[1]);
    r.state = r.by_itself * relative + r.by_slope * ((pushed_ - before) * per_period_);
    r.state[0] += before;
    place += r.share * r.state[0];
  }
  return place;
}

}  // namespace toolpace
