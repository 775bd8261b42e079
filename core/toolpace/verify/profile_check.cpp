#include "toolpace/verify/profile_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "toolpace/verify/chord.h"

namespace toolpace {
namespace {

constexpr double kTimeUlps = 4;     // t = k·Ts, from a period and a product that are rounded once each
constexpr double kStraight = 1e-6;  // [rad] below it three chords lie on one line
constexpr double kKernel = 0.0321;  // ∫|½u(u−1) + 1/12| du over [0, 1]

/// How the direction changes around an interval, and the acceleration vector there.
struct Turning {
  double angle;         ///< [rad], at most π
  double acceleration;  ///< [mm/s²]
};

Turning turning_at(const RowStream& stream, std::size_t i, double period) {
  const Chord before = chord_to(stream, i - 1), here = chord_to(stream, i), after = chord_to(stream, i + 1);
  const auto change = [](const Chord& a, const Chord& b) {
    return a.metric == b.metric ? a.metric.norm(b.way - a.way) : std::hypot(a.length(), b.length());
  };
  const double angle = turn(before, here) + turn(here, after);
  return {std::min(std::numbers::pi, angle), std::max(change(before, here), change(here, after)) / (period * period)};
}

/// Towards 0 by `amount`, not beyond.
double shrink(double value, double amount) {
  return value > 0 ? std::max(0.0, value - amount) : std::min(0.0, value + amount);
}

}  // namespace

ProfileCheck::ProfileCheck(const Machine& machine, double period)
    : limits_(machine.path), period_(period), time_(0.0) {}

void ProfileCheck::take(const RowStream& stream, PathWorst& worst) {
  has_time_ = !stream.rows().time.empty();
  has_profile_ = !stream.rows().speed.empty();
  for (std::size_t i = stream.begin(); i < stream.end(); ++i) {
    if (!stream.is_real(i)) continue;
    if (has_time_) {
      const double t = stream.rows().time[i];
      if (stream.row(i) == 0) first_time_ = t;
      last_time_ = t;
      const double due = first_time_ + static_cast<double>(stream.row(i)) * period_;
      const double error = std::abs(t - due);
      if (time_.would_take(error, 0.0))
        time_.take(error, kTimeUlps * kEpsilon * std::max(std::abs(due), period_), stream, i);
    }
    if (!has_profile_) continue;
    take_limits(stream, i, worst);
    if (stream.row(i) > 0) take_interval(stream, i);
  }
}

void ProfileCheck::take_limits(const RowStream& stream, std::size_t i, PathWorst& worst) {
  const double a = stream.rows().acceleration[i], j = stream.rows().jerk[i];
  largest_ = std::max(largest_, std::abs(a));
  largest_jerk_ = std::max(largest_jerk_, std::abs(j));
  if (worst.acceleration.would_take(a, 0.0)) worst.acceleration.take(a, 0.0, stream, i);
  if (worst.deceleration.would_take(-a, 0.0)) worst.deceleration.take(-a, 0.0, stream, i);
  // With two limits the smaller one holds for certain where the speed rises or falls clearly.
  const double clear = 1e-6 * largest_;
  const double limit = a > clear ? limits_.jerk : a < -clear ? limits_.jerk_deceleration : worst.jerk.check().limit;
  double jerk = std::abs(j);
  if (limit < worst.jerk.check().limit) jerk *= worst.jerk.check().limit / limit;
  if (std::isfinite(jerk) && worst.jerk.would_take(jerk, 0.0)) worst.jerk.take(jerk, 0.0, stream, i);
}

void ProfileCheck::take_interval(const RowStream& stream, std::size_t i) {
  const auto& rows = stream.rows();
  const double v0 = rows.speed[i - 1], v1 = rows.speed[i];
  const double a0 = rows.acceleration[i - 1], a1 = rows.acceleration[i];
  const double j0 = rows.jerk[i - 1], j1 = rows.jerk[i];
  largest_speed_ = std::max({largest_speed_, std::abs(v0), std::abs(v1)});
  const double way = period_ / 2 * (v0 + v1) + period_ * period_ / 12 * (a0 - a1);
  way_ += std::abs(way);
  const Chord here = chord_to(stream, i);
  const double length = here.length();
  double chord_off = length - way;
  double speed_off = std::abs(v1 - v0 - period_ / 2 * (a0 + a1));
  double acceleration_off = std::abs(a1 - a0 - period_ / 2 * (j0 + j1));
  if (chord_off < 0 || speed_.would_take(speed_off, 0.0) || acceleration_.would_take(acceleration_off, 0.0)) {
    const Turning turning = turning_at(stream, i, period_);
    const double slow = std::max(std::min(std::abs(v0), std::abs(v1)), std::numeric_limits<double>::min());
    if (chord_off < 0 && turning.angle > kStraight) chord_off = 0;
    chord_off = shrink(chord_off, period_ * period_ * turning.acceleration * turning.angle / 2);
    speed_off = shrink(speed_off, period_ * turning.acceleration * turning.angle);
    acceleration_off = shrink(
        acceleration_off,
        turning.acceleration * (turning.angle + std::min(1.0, turning.angle) * period_ * turning.acceleration / slow));
  }
  const double disagreement = std::abs(chord_off);
  if (chord_.would_take(disagreement, 0.0)) chord_.take(disagreement, 0.0, stream, i);
  if (speed_.would_take(speed_off, 0.0)) speed_.take(speed_off, 0.0, stream, i);
  if (acceleration_.would_take(acceleration_off, 0.0)) acceleration_.take(acceleration_off, 0.0, stream, i);
}

void ProfileCheck::report(VerifyReport& report) const {
  if (has_time_) {
    report.checks.push_back(time_.named(CheckKind::time_step));
    report.duration = last_time_ - first_time_;
  } else {
    report.duration = static_cast<double>(report.rows - 1) * period_;
  }
  if (!has_profile_) return;
  // The bounds come from the machine, not from the columns: an altered number must not widen its own bound.
  const double limit = std::max(limits_.jerk, limits_.jerk_deceleration);
  const double jerk = std::isfinite(limit) ? limit : largest_jerk_;
  const double jump = std::isfinite(limits_.acceleration + limits_.deceleration)
                          ? limits_.acceleration + limits_.deceleration
                          : 2 * largest_;
  const bool smooth = std::isfinite(limit);
  const double step = smooth ? std::min(jump, limit * period_) : jump;  // of acceleration in a period
  const double noise = 16 * kEpsilon * (way_ + largest_speed_ * period_);
  const double bounds[3] = {
      period_ * period_ / (smooth ? 12 : 4) * step + kKernel * jerk * period_ * period_ * period_ + noise,
      period_ * step / (smooth ? 2 : 1) + noise / period_,
      period_ * jerk + step + noise / (period_ * period_),
  };
  const Worst* const worst[3] = {&chord_, &speed_, &acceleration_};
  const CheckKind kinds[3] = {CheckKind::speed_column, CheckKind::acceleration_column, CheckKind::jerk_column};
  const double scale[3] = {1 / period_, 1 / period_, 1 / period_};
  for (std::size_t k = 0; k < 3; ++k) {
    Check check = worst[k]->named(kinds[k]);
    check.value *= scale[k];
    check.bound = bounds[k] * scale[k];
    check.limit = 0.0;
    check.broken = check.value > check.bound;
    report.checks.push_back(check);
  }
}

}  // namespace toolpace
