#include "toolpace/servo/vibration.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "toolpace/base/axis_unit.h"
#include "toolpace/sample/motion.h"
#include "toolpace/servo/axis_modes.h"

namespace toolpace {
namespace {

constexpr double kTurn = 0.25;       // [rad] of a curve in one piece
constexpr double kMostPieces = 1e5;  // of one phase on one segment
constexpr double kStands = 1e-6;     // [mm/s]
constexpr double kShortest = 1e-12;  // [s] between breaks that are one

/// Begins of phases and arrivals at nodes, in order: in between each axis moves smoothly.
std::vector<double> breaks_of(const MotionPlan& plan, const std::vector<double>& node_time) {
  std::vector<double> begins;
  begins.reserve(plan.phases.size() + 1);
  for (const Phase& phase : plan.phases) begins.push_back(phase.begin);
  begins.push_back(plan.cycle_time());
  std::vector<double> all;
  all.reserve(begins.size() + node_time.size());
  std::merge(begins.begin(), begins.end(), node_time.begin(), node_time.end(), std::back_inserter(all));
  return all;
}

/// Of one axis in a piece of motion.
struct AxisPiece {
  double speed_before, speed_behind;  // of the drive, at its ends
  AccelerationPolynomial acceleration;
};

/// A piece of the planned motion in which every axis moves smoothly.
struct Piece {
  double begin, end;  // [s] of the plan
  std::uint32_t move;
  bool rests, stands_behind;    // in all of it; at its end
  std::vector<AxisPiece> axes;  // of those that were asked for
};

/// The pieces of a motion, in order.
class Pieces {
 public:
  Pieces(const Path& path, const MotionPlan& plan, const std::vector<double>& breaks,
         const std::vector<Eigen::Index>& axes)
      : path_(path), plan_(plan), breaks_(breaks), axes_(axes), motion_(path, plan) {}

  /// @return false behind the last one
  bool next(Piece& piece) {
    if (part_ == parts_) {
      while (at_ < breaks_.size() && !(breaks_[at_] - end_ > kShortest)) ++at_;
      if (at_ == breaks_.size()) return false;
      enter(end_, breaks_[at_]);
    }
    const double width = end_ - begin_;
    piece.begin = begin_ + width * part_ / parts_;
    ++part_;
    piece.end = part_ == parts_ ? end_ : begin_ + width * part_ / parts_;
    piece.move = move_;
    fill(piece);
    return true;
  }

  /// Of the breaks, that lie behind.
  double done() const { return static_cast<double>(at_) / static_cast<double>(breaks_.size()); }

 private:
  /// From one break to the next.
  void enter(double begin, double end) {
    begin_ = begin, end_ = end;
    const double middle = (begin + end) / 2;
    segment_ = motion_.at(middle).segment();
    move_ = motion_.move();
    rests_ = !(motion_.along().speed > 0);
    const bool is_straight = motion_.leaves_path() || AxisCurve(path_).is_straight(segment_);
    is_polynomial_ =
        motion_.leaves_path() || (is_straight && plan_.phases[motion_.phase()].shape == PhaseShape::constant_jerk);
    part_ = 0;
    parts_ = is_straight ? 1 : parts_on(begin, end, middle);
  }

  /// By how far the path turns in between.
  double parts_on(double begin, double end, double middle) {
    const double way = motion_.at(end, segment_).on_segment() - motion_.at(begin, segment_).on_segment();
    double curvature = 0;
    for (const double t : {begin, middle, end}) {
      const Frame frame = AxisCurve(path_).frame_at(segment_, motion_.at(t, segment_).on_segment());
      curvature = std::max(curvature, frame.second.head<3>().norm());
    }
    return std::clamp(std::ceil(std::abs(way) * curvature / kTurn), 1.0, kMostPieces);
  }

  void fill(Piece& piece) {
    const double duration = piece.end - piece.begin;
    piece.axes.resize(axes_.size());
    const AxisMotion first = motion_.at(piece.begin, segment_).axes();
    for (std::size_t i = 0; i < axes_.size(); ++i) piece.axes[i].speed_before = first.speed[axes_[i]];
    if (is_polynomial_) {
      const AxisMotion here = motion_.at((piece.begin + piece.end) / 2, segment_).axes();
      for (std::size_t i = 0; i < axes_.size(); ++i) {
        const double jerk = here.jerk[axes_[i]];
        piece.axes[i].acceleration = {here.acceleration[axes_[i]] - jerk * duration / 2, jerk};
      }
    } else {
      std::array<AxisVector, kAccelerationTerms> there;
      for (std::size_t k = 0; k < there.size(); ++k)
        there[k] = motion_.at(piece.begin + duration * acceleration_places()[k], segment_).axes().acceleration;
      for (std::size_t i = 0; i < axes_.size(); ++i) {
        std::array<double, kAccelerationTerms> values;
        for (std::size_t k = 0; k < values.size(); ++k) values[k] = there[k][axes_[i]];
        piece.axes[i].acceleration = acceleration_through(values, duration);
      }
    }
    const AxisMotion last = motion_.at(piece.end, segment_).axes();
    for (std::size_t i = 0; i < axes_.size(); ++i) piece.axes[i].speed_behind = last.speed[axes_[i]];
    piece.stands_behind = part_ == parts_ && std::abs(motion_.along().speed) < kStands;
    piece.rests = rests_ && piece.stands_behind;
  }

  const Path& path_;
  const MotionPlan& plan_;
  const std::vector<double>& breaks_;
  const std::vector<Eigen::Index>& axes_;
  Motion motion_;
  std::size_t at_ = 0, segment_ = 0;
  double begin_ = 0, end_ = 0, part_ = 0, parts_ = 0;
  std::uint32_t move_ = 0;
  bool is_polynomial_ = false, rests_ = false;
};

/// The modes of an axis, and what was found of them.
struct Shaken {
  AxisModes modes;
  AxisVibration found;

  explicit Shaken(const ServoAxis& axis) : modes(axis) {
    for (const AxisMode& m : modes.modes()) found.modes.push_back({m});
  }
  void run(const AccelerationPolynomial& acceleration, double duration, std::uint32_t move) {
    modes.run(acceleration, duration);
    if (modes.peak() <= found.peak) return;
    found.peak = modes.peak();
    found.peak_time = modes.peak_time();
    found.peak_move = move;
  }
  void stop(double time, std::uint32_t move) {
    for (std::size_t i = 0; i < found.modes.size(); ++i)
      found.modes[i].residual = std::max(found.modes[i].residual, modes.amplitude(i));
    const double amplitude = modes.amplitude();
    if (amplitude <= found.residual) return;
    found.residual = amplitude;
    found.residual_time = time;
    found.residual_move = move;
  }
};

/// The polynomial by a later begin.
AccelerationPolynomial shifted(AccelerationPolynomial c, double by) {
  if (by == 0) return c;
  for (std::size_t k = 0; k + 1 < c.size(); ++k) {
    for (std::size_t i = c.size() - 1; i-- > k;) c[i] += by * c[i + 1];
  }
  return c;
}

/// The motion at one impulse: the plan's, later.
struct Echo {
  Impulse impulse;
  Pieces pieces;
  Piece piece = {};
  enum class State : std::uint8_t { waits, runs, is_over } state = State::waits;

  /// When something changes.
  double next() const { return impulse.time + (state == State::runs ? piece.end : 0.0); }
  bool stands() const { return state != State::runs || piece.rests; }
};

/// Axes that shake under a motion that is the mean of its echoes.
class Shaker {
 public:
  Shaker(std::vector<Echo> echoes, const std::vector<Eigen::Index>& axes, std::vector<Shaken>& shaken,
         const VibrationWatch& watch)
      : echoes_(std::move(echoes)), axes_(axes), shaken_(shaken), watch_(watch) {}

  /// To the next time at which something changes. @return false when all is over
  bool run() {
    double next = kUnlimited;
    for (const Echo& e : echoes_) {
      if (e.state != Echo::State::is_over) next = std::min(next, e.next());
    }
    if (!(next < kUnlimited)) return false;
    if (next - time_ > 0) run_to(next);
    const bool stands = std::all_of(echoes_.begin(), echoes_.end(), [&](const Echo& e) {
      return e.stands() || (ends_now(e) && e.piece.stands_behind);
    });
    if (stands && time_ > 0) stop();
    for (Echo& e : echoes_) {
      if (e.state != Echo::State::is_over && ends_now(e)) go_on(e);
    }
    return true;
  }
  void stop() {
    for (Shaken& s : shaken_) s.stop(time_, move_);
  }
  double done() const { return echoes_.back().pieces.done(); }

 private:
  bool ends_now(const Echo& e) const { return e.next() - time_ <= kShortest; }

  void run_to(double next) {
    sums_.resize(shaken_.size());
    for (std::size_t i = 0; i < shaken_.size(); ++i) {
      AccelerationPolynomial sum = {};
      for (const Echo& e : echoes_) {
        if (e.state != Echo::State::runs) continue;
        const auto there = shifted(e.piece.axes[i].acceleration, time_ - e.impulse.time - e.piece.begin);
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += e.impulse.share * there[k];
      }
      sums_[i] = sum;
    }
    look(next);
    for (std::size_t i = 0; i < shaken_.size(); ++i) shaken_[i].run(sums_[i], next - time_, move_);
    time_ = next;
  }

  /// Before they run there.
  void look(double next) {
    if (!watch_.take) return;
    for (double t = rows_ * watch_.step; t < next; t = ++rows_ * watch_.step) {
      AxisVector row = AxisVector::Zero();
      for (std::size_t i = 0; i < shaken_.size(); ++i)
        row[axes_[i]] = shaken_[i].modes.displacement(sums_[i], std::max(0.0, t - time_));
      watch_.take(row);
    }
  }

  void go_on(Echo& e) {
    std::vector<double> before(shaken_.size(), 0.0);
    if (e.state == Echo::State::runs) {
      for (std::size_t i = 0; i < shaken_.size(); ++i) before[i] = e.piece.axes[i].speed_behind;
    }
    e.state = e.pieces.next(e.piece) ? Echo::State::runs : Echo::State::is_over;
    const bool runs = e.state == Echo::State::runs;
    if (runs && &e == &echoes_.front()) move_ = e.piece.move;
    for (std::size_t i = 0; i < shaken_.size(); ++i)
      shaken_[i].modes.step(e.impulse.share * ((runs ? e.piece.axes[i].speed_before : 0.0) - before[i]));
  }

  std::vector<Echo> echoes_;
  const std::vector<Eigen::Index>& axes_;
  std::vector<Shaken>& shaken_;
  const VibrationWatch& watch_;
  std::vector<AccelerationPolynomial> sums_;  ///< of the echoes, by shaken axis
  double time_ = 0, rows_ = 0;
  std::uint32_t move_ = 0;
};

}  // namespace

Result<Vibration> vibration(const Path& path, const MotionPlan& plan, const std::vector<double>& node_time,
                            const ServoMachine& servo, const Impulses& impulses, const Monitor& monitor,
                            const VibrationWatch& watch) {
  std::vector<Eigen::Index> axes;
  std::vector<Shaken> shaken;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (is_stiff(servo[axis])) continue;
    axes.push_back(static_cast<Eigen::Index>(axis));
    shaken.emplace_back(servo[axis]);
  }
  if (!shaken.empty() && !plan.phases.empty()) {
    const std::vector<double> breaks = breaks_of(plan, node_time);
    std::vector<Echo> echoes;
    for (const Impulse& impulse : impulses) echoes.push_back({impulse, Pieces(path, plan, breaks, axes)});
    Shaker shaker(std::move(echoes), axes, shaken, watch);
    for (std::size_t i = 1; shaker.run(); ++i) {
      if (i % kReportEvery != 0) continue;
      if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
      monitor.report(shaker.done());
    }
    shaker.stop();
  }
  Vibration all;
  for (std::size_t i = 0; i < shaken.size(); ++i) all[static_cast<std::size_t>(axes[i])] = std::move(shaken[i].found);
  return all;
}

std::optional<double> largest_residual(const Vibration& vibration) {
  std::optional<double> largest;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!vibration[axis]) continue;
    largest = std::max(largest.value_or(0.0), vibration[axis]->residual / axis_unit(axis).size);
  }
  return largest;
}

}  // namespace toolpace
