#include "toolpace/servo/vibration.h"

#include <algorithm>
#include <cmath>

#include "toolpace/base/axis_unit.h"
#include "toolpace/sample/motion.h"
#include "toolpace/servo/mode.h"

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

class Shaker {
 public:
  Shaker(const Path& path, const MotionPlan& plan, const ServoMachine& servo)
      : path_(path), plan_(plan), motion_(path, plan) {
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (!(servo[axis].resonance > 0)) continue;
      modes_.push_back(
          {static_cast<Eigen::Index>(axis), Mode(servo[axis].resonance, servo[axis].resonance_damping), {}});
      modes_.back().found.resonance = servo[axis].resonance;
      modes_.back().found.damping = servo[axis].resonance_damping;
    }
  }
  bool has_modes() const { return !modes_.empty(); }

  /// From one break to the next.
  void run(double begin, double end) {
    const double middle = (begin + end) / 2;
    const std::size_t segment = motion_.at(middle).segment();
    const std::uint32_t move = motion_.move();
    const bool is_straight = motion_.leaves_path() || path_.kind[segment] == SegmentKind::line;
    const bool is_polynomial =
        motion_.leaves_path() || (is_straight && plan_.phases[motion_.phase()].shape == PhaseShape::constant_jerk);
    const AxisMotion first = motion_.at(begin, segment).axes();
    for (Axis& a : modes_) a.mode.step(first.speed[a.axis] - a.speed);
    if (is_polynomial) {
      const AxisMotion here = motion_.at(middle, segment).axes();
      for (Axis& a : modes_) {
        const double jerk = here.jerk[a.axis];
        a.run({here.acceleration[a.axis] - jerk * (end - begin) / 2, jerk}, end - begin, move);
      }
    } else {
      const double pieces = is_straight ? 1 : pieces_on(segment, begin, end, middle);
      for (double k = 0; k < pieces; ++k)
        run_piece(begin + (end - begin) * k / pieces, begin + (end - begin) * (k + 1) / pieces, segment, move);
    }
    const AxisMotion last = motion_.at(end, segment).axes();
    const bool stands = std::abs(motion_.along().speed) < kStands;
    for (Axis& a : modes_) {
      a.speed = last.speed[a.axis];
      if (stands) a.stop(end, move);
    }
  }

  Vibration finish(double end) {
    Vibration all;
    for (Axis& a : modes_) {
      a.mode.step(-a.speed);
      a.stop(end, a.last_move);
      all[static_cast<std::size_t>(a.axis)] = a.found;
    }
    return all;
  }

 private:
  struct Axis {
    Eigen::Index axis;
    Mode mode;
    AxisVibration found;
    double speed = 0;  ///< of the drive, at the end of what was run
    std::uint32_t last_move = 0;

    void run(const AccelerationPolynomial& acceleration, double duration, std::uint32_t move) {
      mode.run(acceleration, duration);
      last_move = move;
      if (mode.peak() <= found.peak) return;
      found.peak = mode.peak();
      found.peak_time = mode.peak_time();
      found.peak_move = move;
    }
    void stop(double time, std::uint32_t move) {
      const double amplitude = mode.amplitude();
      if (amplitude <= found.residual) return;
      found.residual = amplitude;
      found.residual_time = time;
      found.residual_move = move;
    }
  };

  /// By how far the path turns in between.
  double pieces_on(std::size_t segment, double begin, double end, double middle) {
    const double way = motion_.at(end, segment).on_segment() - motion_.at(begin, segment).on_segment();
    double curvature = 0;
    for (const double t : {begin, middle, end}) {
      const Frame frame = frame_at(path_, segment, motion_.at(t, segment).on_segment());
      curvature = std::max(curvature, frame.second.head<3>().norm());
    }
    return std::clamp(std::ceil(std::abs(way) * curvature / kTurn), 1.0, kMostPieces);
  }

  void run_piece(double begin, double end, std::size_t segment, std::uint32_t move) {
    std::array<AxisVector, kAccelerationTerms> accelerations;
    for (std::size_t i = 0; i < accelerations.size(); ++i) {
      accelerations[i] = motion_.at(begin + (end - begin) * acceleration_places()[i], segment).axes().acceleration;
    }
    for (Axis& a : modes_) {
      std::array<double, kAccelerationTerms> values;
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = accelerations[i][a.axis];
      a.run(acceleration_through(values, end - begin), end - begin, move);
    }
  }

  const Path& path_;
  const MotionPlan& plan_;
  Motion motion_;
  std::vector<Axis> modes_;
};

}  // namespace

Result<Vibration> vibration(const Path& path, const MotionPlan& plan, const std::vector<double>& node_time,
                            const ServoMachine& servo, const Monitor& monitor) {
  Shaker shaker(path, plan, servo);
  if (!shaker.has_modes() || plan.phases.empty()) return shaker.finish(0);
  const std::vector<double> breaks = breaks_of(plan, node_time);
  double begin = 0;
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    if (!(breaks[i] - begin > kShortest)) continue;
    shaker.run(begin, breaks[i]);
    begin = breaks[i];
    if (i % kReportEvery != 0) continue;
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    monitor.report(static_cast<double>(i) / static_cast<double>(breaks.size()));
  }
  return shaker.finish(plan.cycle_time());
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
