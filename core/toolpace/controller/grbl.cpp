/// grbl 1.1 and grblHAL's core: RS-274 in whole steps, arcs as chords, a ring of blocks.

#include <array>
#include <cmath>
#include <utility>

#include "toolpace/controller/chords.h"
#include "toolpace/controller/last_step.h"
#include "toolpace/controller/models.h"
#include "toolpace/controller/row_walk.h"
#include "toolpace/controller/window_planner.h"

namespace toolpace::detail::controller {
namespace {

constexpr double kStraight = 0.999999;     // cosine beyond which two directions are one
constexpr double kDwellStep = 0.05;        // [s]
constexpr double kNeverIdle = 0.2545;      // [s] $1=255 and what rounds to it
constexpr double kLeastFeed = 1.0 / 60.0;  // [mm/s]
// A step is made in the midst of its time; measured.
constexpr double kAfterLastStep = 0.5, kHalAfterLastStep = 0.375;
constexpr double kIdleAfterLastStep = 0.125;  // slow steps take 8 interrupts
constexpr double kGrblClock = 16e6;           // [Hz] of the timer of steps; grblHAL's boards have faster ones
constexpr std::size_t kGrblRoom = 127, kGrblhalRoom = 1023;  // bytes that a sender puts into the receive buffer

class GrblModel {
 public:
  explicit GrblModel(const ModelInput& input)
      : input_(input),
        moves_(input.reading.moves),
        grbl_(std::get<GrblSettings>(input.settings.values)),
        is_hal_(input.settings.controller == Controller::grblhal),
        tally_(moves_.size(), input.options),
        planner_(std::max<std::size_t>(static_cast<std::size_t>(grbl_.buffer), 2) - 1, tally_, input.options,
                 is_hal_ ? kGrblhalRoom : kGrblRoom, is_hal_ ? 0.0 : kGrblClock) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      steps_[axis] = grbl_.steps[k];
      mm_[axis] = 1.0 / grbl_.steps[k];
      position_[axis] = std::round(moves_.start[axis] * grbl_.steps[k]);
    }
  }

  Result<Prediction> run() {
    RowWalk walk(input_.reading, input_.text);
    const auto read_line = [&](std::size_t line) {
      planner_.receive(walk.bytes(line));
      if (walk.codes(line) != 0 && waits_at(line, walk.codes(line))) stop();
    };
    const auto done = for_each_row(input_, [&](std::size_t row) {
      walk.advance_to(row, read_line);
      run_row(row);
    });
    if (!done) return tl::unexpected(done.error());
    planner_.finish();
    if (planner_.has_moved() && !ends_in_dwell_) take_back_last_step();
    return tally_.finish(input_.settings.controller);
  }

 private:
  void run_row(std::size_t row) {
    switch (moves_.kind[row]) {
      case MoveKind::arc: return run_arc(row);
      case MoveKind::dwell: return run_dwell(row);
      case MoveKind::tool:
      case MoveKind::stop:
      case MoveKind::end: return stop();
      case MoveKind::rapid: return run_line(moves_.end[row].head<3>(), row, true, 0.0);
      default: return run_line(moves_.end[row].head<3>(), row, false, moves_.feed[row]);
    }
  }

  void run_dwell(std::size_t row) {
    stop();
    pay_idle();
    const double time = std::ceil(moves_.dwells[moves_.detail[row]] / kDwellStep - 1e-9) * kDwellStep;
    tally_.add_dwell(time, row);
    planner_.wait(time);
    ends_in_dwell_ = true;
  }

  /// @source grbl 1.1, motion_control.c, mc_arc()
  void run_arc(std::size_t row) {
    const Eigen::Vector3d from = row == 0 ? moves_.start.head<3>() : moves_.end[row - 1].head<3>();
    const ChordArc arc(moves_, row, from);
    const double sagitta = grbl_.arc_tolerance * (2.0 * arc.radius - grbl_.arc_tolerance);
    const double chords = sagitta > 0 ? std::floor(0.5 * arc.sweep * arc.radius / std::sqrt(sagitta)) : 1.0;
    const auto count = static_cast<std::size_t>(std::clamp(chords, 1.0, 65535.0));
    double feed = moves_.feed[row];
    if (moves_.modes[moves_.mode[row]].feed_mode == 93) {
      feed *= static_cast<double>(count) / std::hypot(arc.sweep * arc.radius, arc.rise);
    }
    arc.for_each_chord(count, [&](const Eigen::Vector3d& to) { run_line(to, row, false, feed); });
  }

  /// @source grbl 1.1, planner.c, plan_buffer_line()
  void run_line(const Eigen::Vector3d& to, std::size_t row, bool is_rapid, double feed) {
    Eigen::Vector3d target, way;
    for (Eigen::Index k = 0; k < 3; ++k) {
      target[k] = std::round(to[k] * steps_[k]);
      way[k] = (target[k] - position_[k]) * mm_[k];
    }
    const double length = way.norm();
    if (length == 0) return;
    pay_idle();
    const Eigen::Vector3d direction = way / length;
    Block block{};
    block.length = length;
    block.row = static_cast<std::uint32_t>(row);
    block.is_rapid = is_rapid;
    block.acceleration = along(direction, grbl_.acceleration);
    steps_of_last_ = ((target - position_).cwiseAbs()).maxCoeff();
    block.steps_a_mm = steps_of_last_ / length;
    const double rate = along(direction, grbl_.rate);
    block.cruise = is_rapid ? TimeLimit::rapid : feed > rate ? TimeLimit::axis_speed : TimeLimit::feed;
    const double nominal = is_rapid ? rate : std::max(std::min(feed, rate), kLeastFeed);
    block.nominal2 = nominal * nominal;
    if (is_moving_) set_start(block, direction);
    position_ = target;
    direction_ = direction;
    nominal2_ = block.nominal2;
    ends_in_dwell_ = false;
    is_moving_ = true;
    late_ = 0;
    planner_.add(block);
  }

  void set_start(Block& block, const Eigen::Vector3d& direction) {
    const double lower2 = std::min(block.nominal2, nominal2_);
    const double corner2 = corner(direction);
    block.start2 = std::min(corner2, lower2);
    block.starts_at_corner = corner2 < lower2;
  }

  /// Square of the speed at which the corner from direction_ to `direction` may be passed.
  double corner(const Eigen::Vector3d& direction) const {
    const double cosine = -direction_.dot(direction);
    if (cosine > kStraight) return 0.0;
    if (cosine < -kStraight) return kUnlimited;
    const Eigen::Vector3d turn = (direction - direction_).normalized();
    const double sine = std::sqrt(0.5 * (1.0 - cosine));
    return along(turn, grbl_.acceleration) * grbl_.junction_deviation * sine / (1.0 - sine);
  }

  static double along(const Eigen::Vector3d& direction, const XyzValues& limit) {
    double least = 1e38;
    for (std::size_t k = 0; k < 3; ++k) {
      const double part = std::abs(direction[static_cast<Eigen::Index>(k)]);
      if (part != 0 && limit[k] < least * part) least = limit[k] / part;
    }
    return least;
  }

  /// Whether the parser waits at a line until all motion has ended.
  bool waits_at(std::size_t line, std::uint8_t codes) const {
    if ((codes & kOriginCode) != 0) return true;
    if ((codes & (kSpindleCode | kCoolantCode | kOffsetCode)) == 0) return false;
    const ModalSnapshot before = input_.reading.modal.at(line - 1).value_or(ModalSnapshot{});
    const ModalSnapshot after = input_.reading.modal.at(line).value_or(before);
    const bool turns = after.spindle_direction != before.spindle_direction ||
                       (after.spindle_direction != 0 && after.spindle_speed != before.spindle_speed);
    return (turns && grbl_.laser != 1) || after.mist != before.mist || after.flood != before.flood ||
           after.system != before.system;
  }

  void stop() {
    if (!std::exchange(is_moving_, false)) return;
    planner_.finish();
    // The interrupt that finds nothing left to do comes a while after the last step.
    const double late = is_hal_ ? 0.0 : kIdleAfterLastStep * time_of_last_step(planner_.last(), steps_of_last_);
    tally_.add(TimeLimit::stops, late);
    planner_.wait(late);
    late_ = late;
    owes_idle_ = !is_hal_ && grbl_.idle_delay < kNeverIdle;
  }

  /// The drives are held for $1 after each motion. After the last one nobody waits for it.
  void pay_idle() {
    if (!owes_idle_) return;
    owes_idle_ = false;
    tally_.add(TimeLimit::stops, grbl_.idle_delay);
    planner_.wait(grbl_.idle_delay);
  }

  void take_back_last_step() {
    const double part = is_hal_ ? kHalAfterLastStep : kAfterLastStep;
    tally_.take_back(late_);
    tally_.take_back(part * time_of_last_step(planner_.last(), steps_of_last_), planner_.last().block.is_rapid);
  }

  const ModelInput& input_;
  const Moves& moves_;
  const GrblSettings& grbl_;
  bool is_hal_;
  Tally tally_;
  WindowPlanner planner_;
  Eigen::Vector3d steps_, mm_;
  Eigen::Vector3d position_;                             ///< [steps]
  Eigen::Vector3d direction_ = Eigen::Vector3d::Zero();  ///< of the block before
  double nominal2_ = 0;
  double steps_of_last_ = 0;
  double late_ = 0;  ///< [s] that the stop after the last motion took
  bool is_moving_ = false, owes_idle_ = false, ends_in_dwell_ = false;
};

}  // namespace

Result<Prediction> predict_grbl(const ModelInput& input) { return GrblModel(input).run(); }

}  // namespace toolpace::detail::controller
