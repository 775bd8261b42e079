#include "toolpace/verify/tangent_check.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "toolpace/verify/chord.h"
#include "toolpace/verify/position_corners.h"

namespace toolpace {
namespace {

constexpr double kDetour = 16;          // see TangentCheck
constexpr double kSharpTurn = 0.5;      // [rad] beyond it the chords do not tell the way
constexpr double kStraightTurn = 1e-6;  // [rad] below it two chords lie on one line
constexpr double kLengthUlps = 4;       // rounding of a chord, in those of a position
constexpr double kOffTangent = 0.75;    // √3 − 1: on curves the axes have their limits each
constexpr double kTightTurn = 2.2;  // √3·4/π: a speed of √3·A·Ts·4/π turns by a right angle in two periods
constexpr double kNever = std::numeric_limits<double>::infinity();

/// Goes through a window, three row intervals at a time: local, local + 1, local + 2.
class Judge {
 public:
  Judge(const RowStream& stream, double period, double noise, CornerExemption& corners, PathWorst& worst)
      : stream_(stream), period_(period), noise_(noise), corners_(corners), worst_(worst) {}

  void take_all() {
    for (std::size_t k = 0; k < 3; ++k) enter(k, stream_.begin() + k);
    for (local_ = stream_.begin(); local_ < stream_.end(); ++local_) {
      take_acceleration();
      take_jerk();
      for (std::size_t k = 0; k < 2; ++k) chord_[k] = chord_[k + 1], length_[k] = length_[k + 1];
      enter(2, local_ + 3);
    }
  }

 private:
  void enter(std::size_t k, std::size_t interval) {
    chord_[k] = chord_to(stream_, interval);
    length_[k] = chord_[k].length();
  }

  bool is_of_one_metric(std::size_t k) const {
    return length_[k] == 0 || length_[k + 1] == 0 || chord_[k].metric == chord_[k + 1].metric;
  }
  bool turns_back(std::size_t k) const { return chord_[k].way.dot(chord_[k + 1].way) < 0; }

  /// Rounding of a chord's length [mm; deg].
  double rounding() const {
    const bool rotary = chord_[1].metric == Metric::along(true);
    return kLengthUlps * noise_ / (rotary ? kRadiansPerDegree : 1.0);
  }

  /// From interval i − 1 to interval i; none where one of them is at rest.
  std::optional<double> turn_to(std::size_t i) const {
    const Chord a = chord_to(stream_, i - 1), b = chord_to(stream_, i);
    return a.length() == 0 || b.length() == 0 ? std::nullopt : std::optional(turn(a, b));
  }

  /// How much longer than chord k the way may be.
  double detour(std::size_t k) const {
    const std::size_t i = local_ + k;
    if (chord_to(stream_, i - 1).way.dot(chord_to(stream_, i + 1).way) < 0) return detour_of_return(i);
    if (length_[k] == 0) return 0.0;
    const double programmed = corners_.detour(stream_, i);  // there may be several corners in a period
    const double round_corner = detour_between_straights(stream_, i, noise_);
    if (round_corner > 0) return std::max(round_corner, programmed);
    return std::max({detour_of_curve(i, length_[k]), detour_beside_curve(stream_, i, noise_), programmed});
  }

  /// By how the chords around it turn.
  double detour_of_curve(std::size_t interval, double length) const {
    const auto before = turn_to(interval), after = turn_to(interval + 1);
    const double one = before.value_or(after.value_or(0)), other = after.value_or(one);
    if (std::min(one, other) <= kStraightTurn + rounding() / length) return 0.0;
    const double angle = one + other;
    return angle > kSharpTurn ? kNever : kDetour * length * angle * angle / 8;
  }

  /// Where the way turns back: as far as the step that a corner explains carries in a period, or a curve that is turned within
  /// it under the axes' limits.
  double detour_of_return(std::size_t interval) const {
    const AxisVector step = corners_.explain(stream_, interval, 1, noise_).place_step;
    const double limit = std::max(worst_.acceleration.check().limit, worst_.deceleration.check().limit);
    return chord_to(stream_, interval).metric.norm(step) * period_ + kTightTurn * limit * period_ * period_;
  }

  /// Takes a value, or of one beyond the limit what `explained()` leaves of it.
  template <class Explained>
  void take(Worst& worst, double value, double bound, std::size_t row, Explained&& explained) {
    if (!worst.would_take(value, bound)) return;
    if (value > threshold(worst.check().limit, bound)) value = std::max(0.0, value - explained());
    if (worst.would_take(value, bound)) worst.take(value, bound, stream_, row);
  }

  void take_acceleration() {
    if (!is_of_one_metric(0)) return;
    if (turns_back(0)) return take_return();
    const double per2 = 1 / (period_ * period_), change = length_[1] - length_[0];
    take(change > 0 ? worst_.acceleration : worst_.deceleration, std::abs(change) * per2, 2 * rounding() * per2, local_,
         [&] { return detour(change > 0 ? 0 : 1) * per2; });
  }

  /// The whole change of velocity, less the step that a corner explains.
  void take_return() {
    const double per2 = 1 / (period_ * period_);
    Worst& worst = worst_.acceleration.check().limit > worst_.deceleration.check().limit ? worst_.acceleration
                                                                                         : worst_.deceleration;
    const double change = chord_[0].metric.norm(chord_[1].way - chord_[0].way) * per2;
    take(worst, change, 2 * rounding() * per2, local_, [&] {
      const bool in_line = turn(chord_[0], chord_[1]) >= std::numbers::pi - kStraightTurn;
      const AxisVector step = corners_.explain(stream_, local_, 2, noise_).place_step;
      return chord_[0].metric.norm(step) / period_ + (in_line ? 0.0 : kOffTangent * worst.check().limit);
    });
  }

  void take_jerk() {
    if (!is_of_one_metric(0) || !is_of_one_metric(1)) return;
    if (turns_back(0) || turns_back(1) || chord_[0].way.dot(chord_[2].way) < 0) return take_jerk_of_return();
    const double per3 = 1 / (period_ * period_ * period_);
    const double third = (length_[2] - length_[1]) - (length_[1] - length_[0]);
    take(worst_.jerk, std::abs(third) * per3, 4 * rounding() * per3, local_ + 1,
         [&] { return (third > 0 ? 2 * detour(1) : detour(0) + detour(2)) * per3; });
  }

  /// Back and forth on one line, where the way has a sign.
  void take_jerk_of_return() {
    if (!is_one_line()) return;
    const double per = 1 / period_, per3 = per * per * per;
    const AxisVector third = (chord_[2].way - chord_[1].way) - (chord_[1].way - chord_[0].way);
    take(worst_.jerk, chord_[1].metric.norm(third) * per3, 4 * rounding() * per3, local_ + 1, [&] {
      const Allowance steps = corners_.explain(stream_, local_, 3, noise_);
      return chord_[1].metric.norm(steps.place_step) * per * per + chord_[1].metric.norm(steps.acceleration_step) * per;
    });
  }

  bool is_one_line() const {
    const auto in_line = [this](std::size_t k) {
      const double angle = turn(chord_[k], chord_[k + 1]);
      return length_[k] == 0 || length_[k + 1] == 0 || std::min(angle, std::numbers::pi - angle) <= kStraightTurn;
    };
    return in_line(0) && in_line(1);
  }

  const RowStream& stream_;
  double period_, noise_;
  CornerExemption& corners_;
  PathWorst& worst_;
  std::size_t local_ = 0;
  std::array<Chord, 3> chord_ = {
      Chord{{}, Metric::along(false)}, {{}, Metric::along(false)}, {{}, Metric::along(false)}};
  std::array<double, 3> length_ = {};
};

}  // namespace

void TangentCheck::take(const RowStream& stream, double noise, CornerExemption& corners, PathWorst& worst) const {
  Judge(stream, period_, noise, corners, worst).take_all();
}

}  // namespace toolpace
