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

constexpr double kLeastWay = 1e-9;       // [mm] shorter moves are none
constexpr double kMostChords = 1e7;      // of an arc: more would be a mistake of the program or the settings
constexpr double kFirstSpeed = 25.0;     // [mm/s] until the first F

class KlipperModel {
 public:
  explicit KlipperModel(const ModelInput& input)
      : input_(input), moves_(input.reading.moves), klipper_(std::get<KlipperSettings>(input.settings.values)),
        tally_(moves_.size(), input.options), queue_(tally_), position_(moves_.start.head<3>()) {
    set_limits(0);
  }

  Result<Prediction> run() {
    RowWalk walk(input_.reading, input_.text);
    const auto read_line = [&](std::size_t line) {
      if ((walk.codes(line) & kFinishCode) != 0) queue_.finish();
    };
    for (std::size_t row = 0; row < moves_.size(); ++row) {
      if (row % kReportEvery == 0) {
        if (input_.monitor.is_cancelled()) return tl::unexpected(cancelled_error());
        input_.monitor.report(static_cast<double>(row) / static_cast<double>(moves_.size()));
      }
      walk.advance_to(row, read_line);
      if (auto done = run_row(row); !done) return tl::unexpected(done.error());
    }
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
      default: run_line(moves_.end[row].head<3>(), row, printer_speed(input_.reading, row, kFirstSpeed)); break;
    }
    return {};
  }

  /// @source Klipper, klippy/extras/gcode_arcs.py; in G18 arcs turn the other way than in RS-274
  Result<void> run_arc(std::size_t row) {
    if (!klipper_.has_arcs) {
      return tl::unexpected(Error{ErrorKind::input, "controller-refuses",
                                  "Klipper knows no G2 and G3 without [gcode_arcs]", "add [gcode_arcs] to the printer.cfg",
                                  {moves_.files.empty() ? "" : moves_.files[moves_.file[row]], moves_.line[row], 0}, {}});
    }
    const ChordArc arc(moves_, row, position_, moves_.modes[moves_.mode[row]].plane == 18);
    const double length = std::hypot(arc.radius * arc.sweep, arc.rise);
    const auto count = static_cast<std::size_t>(std::clamp(std::floor(length / klipper_.arc_resolution), 1.0, kMostChords));
    arc.for_each_chord(count, [&](const Eigen::Vector3d& to) { run_line(to, row, moves_.feed[row]); });
    return {};
  }

  /// @source Klipper, klippy/toolhead.py, Move; klippy/kinematics/cartesian.py, check_move()
  void run_line(const Eigen::Vector3d& to, std::size_t row, double speed) {
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
    const bool is_rapid = moves_.kind[row] == MoveKind::rapid;
    move.cruise = speed > limit ? TimeLimit::axis_speed : is_rapid ? TimeLimit::rapid : TimeLimit::feed;
    const double v = std::min(speed, limit);
    move.max_cruise2 = v * v;
    move.delta2 = 2.0 * length * move.acceleration;
    move.smooth_delta2 = std::min(move.delta2, 2.0 * length * limits_.max_accel * (1.0 - limits_.minimum_cruise_ratio));
    move.row = static_cast<std::uint32_t>(row);
    move.is_rapid = is_rapid;
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
  KlipperSettings limits_;          ///< those that hold now
  std::uint16_t ceiling_ = 0;
  double junction_deviation_ = 0;   ///< [mm]
  Tally tally_;
  KlipperQueue queue_;
  Eigen::Vector3d position_;
};

}  // namespace

Result<Prediction> predict_klipper(const ModelInput& input) { return KlipperModel(input).run(); }

}  // namespace toolpace::detail::controller
