/// Klipper: limits along the path, Z's own, arcs by resolution, look-ahead without end.

#include <array>
#include <cmath>
#include <vector>

#include "toolpace/controller/chords.h"
#include "toolpace/controller/klipper_queue.h"
#include "toolpace/controller/models.h"
#include "toolpace/controller/row_walk.h"

namespace toolpace::detail::controller {
namespace {

constexpr double kLeastWay = 1e-9;   // [mm] shorter moves are none
constexpr double kMostChords = 1e7;  // of an arc: more would be a mistake of the program or the settings
constexpr double kMmOfInch = 25.4;
constexpr double kFirstSpeed = 25.0;  // [mm/s] until the first F

class KlipperModel {
 public:
  explicit KlipperModel(const ModelInput& input)
      : input_(input),
        moves_(input.reading.moves),
        klipper_(std::get<KlipperSettings>(input.settings.values)),
        tally_(moves_.size(), input.options),
        queue_(tally_),
        position_(moves_.start.head<3>()) {
    set_limits(0);
  }

  Result<Prediction> run() {
    RowWalk walk(input_.reading, input_.text);
    const auto read_line = [&](std::size_t line) {
      if ((walk.codes(line) & kFinishCode) != 0) queue_.finish();
      if (klipper_.has_extruder && line != line_of_row_) run_extruder(line);
    };
    const auto done = for_each_row(input_, [&](std::size_t row) {
      if (moves_.file[row] == 0) line_of_row_ = moves_.line[row];
      row_ = row;
      walk.advance_to(row, read_line);
      return run_row(row);
    });
    if (!done) return tl::unexpected(done.error());
    line_of_row_ = 0;
    walk.advance_to_end(read_line);
    queue_.finish();
    return tally_.finish(Controller::klipper);
  }

 private:
  Result<void> run_row(std::size_t row) {
    const auto& mode = moves_.modes[moves_.mode[row]];
    if (mode.ceiling != ceiling_) set_limits(mode.ceiling);
    switch (moves_.kind[row]) {
      case MoveKind::arc: return run_arc(row);
      case MoveKind::dwell:
        queue_.finish();
        tally_.add_dwell(moves_.dwells[moves_.detail[row]], row);
        break;
      case MoveKind::tool: break;
      case MoveKind::stop:
      case MoveKind::end: queue_.finish(); break;
      default: run_straight(row); break;
    }
    return {};
  }

  double extruded_at(std::size_t row) const {
    return klipper_.has_extruder && moves_.file[row] == 0 ? input_.text.extruded_in(moves_.line[row]) : 0.0;
  }

  void run_straight(std::size_t row) {
    const Eigen::Vector3d to = moves_.end[row].head<3>();
    const double length = (to - position_).norm(), extruded = extruded_at(row);
    if (length < kLeastWay && extruded != 0) return run_extruder(moves_.line[row]);
    run_line(to, row, printer_speed(input_.reading, row, kFirstSpeed), length > 0 ? extruded / length : 0.0);
  }

  /// A move of the extruder alone: filament drawn back, or pushed on.
  void run_extruder(std::size_t line) {
    const double way = input_.text.extruded_in(line);
    if (std::abs(way) < kLeastWay) return;
    const auto modal = input_.reading.modal.at(line);
    const double unit = modal && modal->units == 200 ? kMmOfInch : 1.0;
    const double speed = modal && modal->feed > 0 ? modal->feed * unit * kPerMinute : kFirstSpeed;
    KlipperMove move{};
    move.direction = Eigen::Vector3d::Zero();
    move.length = std::abs(way);
    move.extrusion = way < 0 ? -1.0 : 1.0;
    move.is_extruder_alone = true;
    move.acceleration = kUnlimited;
    finish_move(move, speed, kUnlimited, TimeLimit::feed);
  }

  /// @source Klipper, klippy/extras/gcode_arcs.py; in G18 arcs turn the other way than in RS-274
  Result<void> run_arc(std::size_t row) {
    if (!klipper_.has_arcs) {
      return tl::unexpected(Error{ErrorKind::input,
                                  "controller-refuses",
                                  "Klipper knows no G2 and G3 without [gcode_arcs]",
                                  "add [gcode_arcs] to the printer.cfg",
                                  {moves_.files.empty() ? "" : moves_.files[moves_.file[row]], moves_.line[row], 0},
                                  {}});
    }
    const ChordArc arc(moves_, row, position_, moves_.modes[moves_.mode[row]].plane == 18);
    const double length = std::hypot(arc.radius * arc.sweep, arc.rise);
    const auto count =
        static_cast<std::size_t>(std::clamp(std::floor(length / klipper_.arc_resolution), 1.0, kMostChords));
    const double extrusion = length > 0 ? extruded_at(row) / length : 0.0;
    arc.for_each_chord(count, [&](const Eigen::Vector3d& to) { run_line(to, row, moves_.feed[row], extrusion); });
    return {};
  }

  /// @source Klipper, klippy/toolhead.py, Move; klippy/kinematics/cartesian.py, check_move()
  void run_line(const Eigen::Vector3d& to, std::size_t row, double speed, double extrusion) {
    const Eigen::Vector3d way = to - position_;
    const double length = way.norm();
    if (length < kLeastWay) return;
    position_ = to;
    KlipperMove move{};
    move.length = length;
    move.direction = way / length;
    move.acceleration = limits_.max_accel;
    double limit = limits_.max_velocity;
    if (way.z() != 0) {
      const double ratio = length / std::abs(way.z());
      limit = std::min(limit, limits_.max_z_velocity * ratio);
      move.acceleration = std::min(move.acceleration, limits_.max_z_accel * ratio);
    }
    move.is_rapid = moves_.kind[row] == MoveKind::rapid;
    move.extrusion = extrusion;
    finish_move(move, speed, limit, move.is_rapid ? TimeLimit::rapid : TimeLimit::feed);
  }

  /// @param limit  of the axes [mm/s]
  void finish_move(KlipperMove& move, double speed, double limit, TimeLimit wanted) {
    const bool is_upright = move.direction.x() == 0 && move.direction.y() == 0;
    if (move.extrusion != 0 && (is_upright || move.extrusion < 0)) {
      const double ratio = 1.0 / std::abs(move.extrusion);
      limit = std::min(limit, klipper_.max_extrude_only_velocity * ratio);
      move.acceleration = std::min(move.acceleration, klipper_.max_extrude_only_accel * ratio);
    }
    move.cruise = speed > limit ? TimeLimit::axis_speed : wanted;
    const double v = std::min(speed, limit);
    move.max_cruise2 = v * v;
    move.delta2 = 2.0 * move.length * move.acceleration;
    move.smooth_delta2 =
        std::min(move.delta2, 2.0 * move.length * limits_.max_accel * (1.0 - limits_.minimum_cruise_ratio));
    move.extruder_step = klipper_.instantaneous_corner_velocity;
    move.row = static_cast<std::uint32_t>(row_);
    queue_.add(move, junction_deviation_);
  }

  /// What the program sets by SET_VELOCITY_LIMIT or M204 holds instead of the file's.
  void set_limits(std::uint16_t index) {
    ceiling_ = index;
    limits_ = klipper_;
    const MotionCeiling& ceiling = moves_.ceilings[index];
    if (ceiling.path_speed < MotionCeiling::kNone) limits_.max_velocity = ceiling.path_speed;
    if (ceiling.path_acceleration < MotionCeiling::kNone) limits_.max_accel = ceiling.path_acceleration;
    if (ceiling.corner_speed < MotionCeiling::kNone) limits_.square_corner_velocity = ceiling.corner_speed;
    const double corner = limits_.square_corner_velocity;
    junction_deviation_ = corner * corner * (std::sqrt(2.0) - 1.0) / limits_.max_accel;
  }

  const ModelInput& input_;
  const Moves& moves_;
  const KlipperSettings& klipper_;
  KlipperSettings limits_;  ///< those that hold now
  std::uint16_t ceiling_ = 0;
  double junction_deviation_ = 0;  ///< [mm]
  std::size_t row_ = 0, line_of_row_ = 0;
  Tally tally_;
  KlipperQueue queue_;
  Eigen::Vector3d position_;
};

}  // namespace

Result<Prediction> predict_klipper(const ModelInput& input) { return KlipperModel(input).run(); }

}  // namespace toolpace::detail::controller
