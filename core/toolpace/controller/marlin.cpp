/// Marlin 2.1 with junction deviation: grbl's planner, printers' habits.

#include <cmath>
#include <utility>

#include "toolpace/controller/chords.h"
#include "toolpace/controller/models.h"
#include "toolpace/controller/row_walk.h"
#include "toolpace/controller/window_planner.h"

namespace toolpace::detail::controller {
namespace {

constexpr double kMarlinStraight = 0.999999;
constexpr double kSmallSegment = 1.0;         // [mm] shorter ones count as parts of an arc
constexpr double kSmallTurn = -0.7071067812;  // cosine of 135°: deflections below 45°
constexpr double kMarlinFirstSpeed = 25.0;    // [mm/s] until the first F
constexpr double kLeastChord = 0.1, kMostChord = 1.0, kChordsOfCircle = 72;  // Configuration_adv.h
constexpr double kMostChordsOfArc = 1e7;
constexpr double kLeastSpeed2 = 0.05 * 0.05;  // MINIMUM_PLANNER_SPEED
constexpr std::size_t kMarlinRoom = 127;

class MarlinModel {
 public:
  explicit MarlinModel(const ModelInput& input)
      : input_(input),
        moves_(input.reading.moves),
        marlin_(std::get<MarlinSettings>(input.settings.values)),
        tally_(moves_.size(), input.options),
        planner_(static_cast<std::size_t>(std::max(marlin_.buffer, 3.0)) - 1, tally_, input.options, kMarlinRoom) {
    for (std::size_t k = 0; k < 3; ++k) steps_[static_cast<Eigen::Index>(k)] = marlin_.steps[k];
    position_ = (moves_.start.head<3>().array() * steps_.array()).round();
    place_ = moves_.start.head<3>();
    set_limits(0);
  }

  Result<Prediction> run() {
    RowWalk walk(input_.reading, input_.text);
    const auto read_line = [&](std::size_t line) {
      planner_.receive(walk.bytes(line));
      if ((walk.codes(line) & kFinishCode) != 0) stop();
    };
    const auto done = for_each_row(input_, [&](std::size_t row) {
      walk.advance_to(row, read_line);
      extrudes_ = moves_.file[row] == 0 && moves_.line[row] > 0 && (walk.codes(moves_.line[row]) & kExtruderWord) != 0;
      run_row(row);
    });
    if (!done) return tl::unexpected(done.error());
    planner_.finish();
    return tally_.finish(Controller::marlin);
  }

 private:
  void run_row(std::size_t row) {
    const auto& mode = moves_.modes[moves_.mode[row]];
    if (mode.ceiling != ceiling_) set_limits(mode.ceiling);
    switch (moves_.kind[row]) {
      case MoveKind::arc: return run_arc(row);
      case MoveKind::dwell: {
        stop();
        const double time = moves_.dwells[moves_.detail[row]];
        tally_.add_dwell(time, row);
        return planner_.wait(time);
      }
      case MoveKind::tool:
      case MoveKind::stop:
      case MoveKind::end: return stop();
      default: return run_line(moves_.end[row].head<3>(), row);
    }
  }

  void stop() {
    planner_.finish();
    planner_.wait(0);
    is_moving_ = false;
  }

  /// @source Marlin 2.1, gcode/motion/G2_G3.cpp, plan_arc()
  void run_arc(std::size_t row) {
    const ChordArc arc(moves_, row, place_);
    const double flat = arc.radius * arc.sweep;
    const double least = std::ceil(kChordsOfCircle * arc.sweep / kTwoPi);
    const double nominal = std::max(std::floor(flat / kMostChord), least);
    const double chord = std::max(std::clamp(flat / nominal, kLeastChord, kMostChord), flat / kMostChordsOfArc);
    const double whole = std::max(1.0, std::floor(flat / chord + 1e-9));
    const auto count = static_cast<std::size_t>(whole);
    const double part = std::min(1.0, chord * whole / flat) / whole;
    const bool has_rest = chord * whole < flat - 1e-4;
    for (std::size_t i = 1; i < count + (has_rest ? 1 : 0); ++i) run_line(arc.at(static_cast<double>(i) * part), row);
    run_line(arc.to, row);
  }

  /// @source Marlin 2.1, module/planner.cpp, _populate_block()
  void run_line(const Eigen::Vector3d& to, std::size_t row) {
    place_ = to;
    const Eigen::Vector3d target = (to.array() * steps_.array()).round();
    const Eigen::Vector3d way = (target - position_).array() / steps_.array();
    const double length = way.norm();
    if (length == 0) return;
    const Eigen::Vector3d direction = way / length;
    Block block{};
    block.length = length;
    block.row = static_cast<std::uint32_t>(row);
    block.is_rapid = moves_.kind[row] == MoveKind::rapid;
    const double wanted = std::max(printer_speed(input_.reading, row, kMarlinFirstSpeed),
                                   extrudes_ ? limits_.minimum_rate : limits_.minimum_travel_rate);
    const double rate = lowest(direction, limits_.rate, kUnlimited);
    block.cruise = wanted > rate ? TimeLimit::axis_speed : block.is_rapid ? TimeLimit::rapid : TimeLimit::feed;
    const double nominal = std::min(wanted, rate);
    block.nominal2 = nominal * nominal;
    block.acceleration =
        lowest(direction, limits_.axis_acceleration, extrudes_ ? limits_.acceleration : limits_.travel_acceleration);
    // A single step takes a time, so nothing is slower than that.
    const double steps = (target - position_).cwiseAbs().maxCoeff();
    block.rest2 = std::min(block.nominal2, std::max(kLeastSpeed2, 0.5 * block.acceleration * length / steps));
    if (is_moving_) {
      const double lower2 = std::min(block.nominal2, nominal2_), corner2 = corner(direction, block);
      block.start2 = std::min(std::max(corner2, block.rest2), lower2);
      block.starts_at_corner = corner2 < lower2;
    }
    position_ = target;
    direction_ = direction;
    nominal2_ = block.nominal2;
    is_moving_ = true;
    planner_.add(block);
  }

  double corner(const Eigen::Vector3d& direction, const Block& block) const {
    const double cosine = std::max(-direction_.dot(direction), -kMarlinStraight);
    if (cosine > kMarlinStraight) return kLeastSpeed2;
    const Eigen::Vector3d turn = direction - direction_;
    const double size = turn.norm();
    const double a = size > 0 ? lowest(turn / size, limits_.axis_acceleration, block.acceleration) : block.acceleration;
    const double sine = std::sqrt(0.5 * (1.0 - cosine));
    const double corner2 = a * limits_.junction_deviation * sine / (1.0 - sine);
    if (block.length >= kSmallSegment || cosine >= kSmallTurn) return corner2;
    return std::min(corner2, block.length * a / std::acos(-cosine));
  }

  static double lowest(const Eigen::Vector3d& direction, const XyzValues& limit, double least) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double part = std::abs(direction[static_cast<Eigen::Index>(k)]);
      if (part * least > limit[k]) least = limit[k] / part;
    }
    return least;
  }

  /// What the program sets by M201, M203, M204 and M205 holds instead of the report's.
  void set_limits(std::uint16_t index) {
    ceiling_ = index;
    limits_ = marlin_;
    const MotionCeiling& ceiling = moves_.ceilings[index];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      if (ceiling.speed[axis] < MotionCeiling::kNone) limits_.rate[k] = ceiling.speed[axis];
      if (ceiling.acceleration[axis] < MotionCeiling::kNone) limits_.axis_acceleration[k] = ceiling.acceleration[axis];
    }
    if (ceiling.path_acceleration < MotionCeiling::kNone) {
      limits_.acceleration = limits_.travel_acceleration = ceiling.path_acceleration;
    }
    if (ceiling.junction_deviation < MotionCeiling::kNone) limits_.junction_deviation = ceiling.junction_deviation;
  }

  const ModelInput& input_;
  const Moves& moves_;
  const MarlinSettings& marlin_;
  MarlinSettings limits_;  ///< those that hold now
  std::uint16_t ceiling_ = 0;
  Tally tally_;
  WindowPlanner planner_;
  Eigen::Vector3d steps_;
  Eigen::Vector3d position_;                             ///< [steps]
  Eigen::Vector3d place_;                                ///< [mm], not rounded
  Eigen::Vector3d direction_ = Eigen::Vector3d::Zero();  ///< of the block before
  double nominal2_ = 0;
  bool is_moving_ = false, extrudes_ = false;
};

}  // namespace

Result<Prediction> predict_marlin(const ModelInput& input) { return MarlinModel(input).run(); }

}  // namespace toolpace::detail::controller
