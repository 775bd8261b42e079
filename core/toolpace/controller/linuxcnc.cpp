/// LinuxCNC 2.9: what its interpreter hands to motion, and how motion runs it.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "toolpace/controller/linuxcnc_run.h"
#include "toolpace/controller/models.h"
#include "toolpace/controller/row_walk.h"
#include "toolpace/machine/startup_code.h"

namespace toolpace::detail::controller {
namespace {

// The interpreter's waits, in its own cycles, and what motion needs to come to rest, in the servo thread's; measured.
constexpr double kCyclesToSeeRest = 1.5, kCyclesOfSpindle = 3.0, kCyclesToRest = 2.0;
constexpr std::size_t kLongestChain = 100;  // points that lines may be merged from
constexpr double kZero = 1e-9;              // [mm, rad]

/// What the settings say of path control before the program does.
MoveMode startup_mode(const LinuxcncSettings& settings) {
  const StartupCode code = read_startup_code(settings.startup_code);
  MoveMode mode;
  switch (code.control) {
    case StartupCode::Control::none: break;
    case StartupCode::Control::exact_path: mode.control = PathControl::exact_path; break;
    case StartupCode::Control::exact_stop: mode.control = PathControl::exact_stop; break;
    case StartupCode::Control::blend:
      mode.control = PathControl::blend;
      mode.tolerance = settings.blend_tolerance;
      mode.naive_tolerance = code.naive.value_or(settings.blend_tolerance);
  }
  return mode;
}

/// A line that may still grow: G64 P merges what lies within Q.
struct Chain {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> points;
  std::size_t row = 0;
  double feed = 0;
};

class LinuxcncModel {
 public:
  explicit LinuxcncModel(const ModelInput& input)
      : input_(input),
        moves_(input.reading.moves),
        linuxcnc_(std::get<LinuxcncSettings>(input.settings.values)),
        tally_(moves_.size(), input.options),
        run_(linuxcnc_, joint_limits(), tally_, input.monitor),
        position_(moves_.start),
        startup_(startup_mode(linuxcnc_)) {}

  Result<Prediction> run() {
    RowWalk walk(input_.reading, input_.text);
    const auto read_line = [&](std::size_t line) {
      if ((walk.codes(line) & (kSpindleCode | kCoolantCode)) != 0) wait(kCyclesOfSpindle);
      if ((walk.codes(line) & kPathCode) != 0) startup_.control = PathControl::job_default;
    };
    const auto done = for_each_row(input_, [&](std::size_t row) {
      walk.advance_to(row, read_line);
      run_row(row);
    });
    if (!done) return tl::unexpected(done.error());
    finish();
    if (input_.monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    if (has_moved_) tally_.add(TimeLimit::stops, kCyclesToRest * linuxcnc_.period);
    return tally_.finish(Controller::linuxcnc);
  }

 private:
  JointLimits joint_limits() const {
    JointLimits limits;
    limits.axis_acceleration = linuxcnc_.axis_acceleration.head<3>();
    limits.axis_velocity = linuxcnc_.axis_velocity.head<3>();
    limits.cycle = linuxcnc_.period;
    limits.kink_ratio = linuxcnc_.kink_ratio;
    limits.feed_scale = linuxcnc_.feed_scale;
    limits.gap_cycles = linuxcnc_.gap_cycles;
    limits.arc_blends = linuxcnc_.arc_blends != 0;
    return limits;
  }

  void run_row(std::size_t row) {
    switch (moves_.kind[row]) {
      case MoveKind::rapid:
        flush();
        add_line(moves_.end[row], row, kUnlimited, true);
        break;
      case MoveKind::arc: add_arc(row); break;
      case MoveKind::dwell:
        wait(0);
        tally_.add_dwell(moves_.dwells[moves_.detail[row]], row);
        break;
      case MoveKind::tool:
      case MoveKind::stop: wait(0); break;
      case MoveKind::end: finish(); break;
      default: add_feed(row); break;
    }
    if (is_motion(moves_.kind[row])) position_ = moves_.end[row];
  }

  void finish() {
    flush();
    run_.finish();
  }

  /// The interpreter goes on when all has come to rest. @param cycles  of its own that it needs then
  void wait(double cycles) {
    finish();
    if (!std::exchange(has_moved_, false)) return;
    tally_.add(TimeLimit::stops, kCyclesToRest * linuxcnc_.period + (kCyclesToSeeRest + cycles) * linuxcnc_.task_cycle);
  }

  /// As the program says, or else the startup code.
  MoveMode mode_of(std::size_t row) const {
    MoveMode mode = moves_.modes[moves_.mode[row]];
    if (mode.control != PathControl::job_default) return mode;
    mode.control = startup_.control;
    mode.tolerance = startup_.tolerance;
    mode.naive_tolerance = startup_.naive_tolerance;
    return mode;
  }

  Ending ending_of(std::size_t row) const {
    switch (mode_of(row).control) {
      case PathControl::exact_path: return Ending::exact;
      case PathControl::exact_stop: return Ending::stop;
      default: return Ending::parabolic;
    }
  }

  double merging_of(std::size_t row) const {
    return mode_of(row).control == PathControl::blend ? mode_of(row).naive_tolerance : 0.0;
  }

  void add_feed(std::size_t row) {
    const AxisVector way = moves_.end[row] - position_;
    const bool has_rotary = way.tail<3>().cwiseAbs().maxCoeff() > kZero;
    if (has_rotary || merging_of(row) <= 0) {
      flush();
      return add_line(moves_.end[row], row, moves_.feed[row], false);
    }
    add_point(moves_.end[row].head<3>(), row);
  }

  void add_point(const Eigen::Vector3d& point, std::size_t row) {
    const bool same = !chain_.points.empty() && chain_.feed == moves_.feed[row];
    if (!chain_.points.empty() && !(same && links(point, merging_of(row)))) flush();
    if (chain_.points.empty()) {
      chain_.from = chained_to_;
      chain_.feed = moves_.feed[row];
    }
    chain_.row = row;
    chain_.points.push_back(point);
  }

  /// Whether all points of the chain lie near the line to a new one. @source LinuxCNC 2.9, emccanon.cc, in other words
  bool links(const Eigen::Vector3d& point, double tolerance) const {
    if (chain_.points.size() > kLongestChain || point == chain_.from) return false;
    const Eigen::Vector3d way = point - chain_.from;
    return std::all_of(chain_.points.begin(), chain_.points.end(), [&](const Eigen::Vector3d& p) {
      const double t = std::clamp(way.dot(p - chain_.from) / way.squaredNorm(), 0.0, 1.0);
      return (p - chain_.from - t * way).norm() <= tolerance;
    });
  }

  void flush() {
    if (chain_.points.empty()) return;
    AxisVector end = position_;
    end.head<3>() = chain_.points.back();
    chain_.points.clear();
    add_line(end, chain_.row, chain_.feed, false);
  }

  /// @param feed  [mm/s] of the program, or none
  void add_line(const AxisVector& end, std::size_t row, double feed, bool is_rapid) {
    AxisVector start = position_;
    start.head<3>() = chained_to_;
    const AxisVector way = end - start;
    chained_to_ = end.head<3>();
    Segment s = segment_of(row, is_rapid);
    const double linear = way.head<3>().norm();
    s.has_rotary = way.tail<3>().cwiseAbs().maxCoeff() > kZero;
    s.length = linear > kZero ? linear : way.tail<3>().norm();
    if (s.length <= kZero) return;
    const double v = s.length / way.cwiseAbs().cwiseQuotient(linuxcnc_.axis_velocity).maxCoeff();
    s.acceleration = s.length / way.cwiseAbs().cwiseQuotient(linuxcnc_.axis_acceleration).maxCoeff();
    set_speed(s, v, feed);
    s.start_tangent = linear > kZero ? Eigen::Vector3d(way.head<3>() / linear) : Eigen::Vector3d::Zero();
    s.end_tangent = s.start_pull = s.end_pull = s.start_tangent;
    s.from = start.head<3>();
    s.to = end.head<3>();
    add(s);
  }

  Segment segment_of(std::size_t row, bool is_rapid) const {
    Segment s;
    s.row = static_cast<std::uint32_t>(row);
    s.is_rapid = is_rapid;
    s.ending = ending_of(row);
    s.tolerance = mode_of(row).control == PathControl::blend ? mode_of(row).tolerance : 0.0;
    return s;
  }

  void set_speed(Segment& s, double axes, double feed) const {
    s.top = std::min(axes, linuxcnc_.velocity);
    s.wanted = std::min(feed, s.top);
    s.cruise = s.is_rapid ? TimeLimit::rapid : feed > s.top ? TimeLimit::axis_speed : TimeLimit::feed;
    s.programmed = s.length;
  }

  /// An axis that the .ini does not have bounds nothing.
  static bool can_run(const Segment& s) {
    return s.acceleration > 0 && s.acceleration < kUnlimited && s.top > 0 && s.top < kUnlimited && s.wanted > 0;
  }

  void leave_out(std::size_t row) {
    if (std::exchange(has_left_out_, true)) return;
    const auto& files = moves_.files;
    tally_.warn({Severity::warning,
                 "axis-absent",
                 "the .ini has no [AXIS_…] limits for the axes of this move, which is left out",
                 "",
                 {files.empty() ? "" : files[moves_.file[row]], moves_.line[row], 0},
                 {}});
  }

  void add(const Segment& segment) {
    if (!can_run(segment)) return leave_out(segment.row);
    has_moved_ = true;
    run_.add(segment);
  }

  /// A short arc that hardly bends is two lines where lines are merged.
  bool is_nearly_straight(std::size_t row, const Segment& s) const {
    return mode_of(row).plane == 17 && merging_of(row) > 0 && s.sweep < 3.0 &&
           s.radius * (1.0 - std::cos(0.5 * s.sweep)) < merging_of(row);
  }

  void add_arc(std::size_t row) {
    const ArcDetail& arc = moves_.arcs[moves_.detail[row]];
    Segment s = segment_of(row, false);
    s.shape = Shape::arc;
    s.normal = Eigen::Vector3d(arc.normal) * (arc.sweep < 0 ? -1.0 : 1.0);
    s.sweep = std::abs(arc.sweep);
    s.from = position_.head<3>();
    s.to = moves_.end[row].head<3>();
    const Eigen::Vector3d rise = s.normal * s.normal.dot(s.to - s.from);
    const Eigen::Vector3d out = s.from - arc.centre, first = out - s.normal * s.normal.dot(out);
    s.radius = first.norm();
    s.centre = s.to - (rotated(first, s));
    if (is_nearly_straight(row, s)) {
      add_point(s.from - first + Eigen::AngleAxisd(0.5 * s.sweep, s.normal) * first + 0.5 * rise, row);
      return add_point(s.to, row);
    }
    flush();
    chained_to_ = s.to;
    finish_arc(s, first, rise, row);
  }

  static Eigen::Vector3d rotated(const Eigen::Vector3d& out, const Segment& s) {
    return Eigen::AngleAxisd(s.sweep, s.normal) * out;
  }

  void finish_arc(Segment& s, const Eigen::Vector3d& first, const Eigen::Vector3d& rise, std::size_t row) {
    const double flat = s.radius * s.sweep, height = rise.norm();
    s.length = std::hypot(flat, height);
    if (s.length <= kZero) return;
    const auto in_plane = [&](const AxisVector& of_axes) {
      double least = kUnlimited;
      for (Eigen::Index k = 0; k < 3; ++k) {
        if (std::abs(s.normal[k]) < 0.5) least = std::min(least, of_axes[k]);
      }
      return least;
    };
    const double a = in_plane(linuxcnc_.axis_acceleration);
    const double slope = height / s.sweep;
    s.bend = s.radius + slope * slope / s.radius;
    const double v = std::min(in_plane(linuxcnc_.axis_velocity), std::sqrt(kNormalShare * a * s.bend));
    double axial_time = 0, axial_push = 0;
    for (Eigen::Index k = 0; k < 3; ++k) {
      axial_time = std::max(axial_time, std::abs(rise[k]) / linuxcnc_.axis_velocity[k]);
      axial_push = std::max(axial_push, std::abs(rise[k]) / linuxcnc_.axis_acceleration[k]);
    }
    s.acceleration = s.length / std::max(flat / a, axial_push);
    s.tangential = kTangentialShare;
    set_speed(s, s.length / std::max(flat / v, axial_time), moves_.feed[row]);
    const Eigen::Vector3d last = rotated(first, s);
    const auto tangent = [&](const Eigen::Vector3d& out) -> Eigen::Vector3d {
      return (s.normal.cross(out) * s.sweep + rise).normalized();
    };
    const auto pull = [&](const Eigen::Vector3d& out) -> Eigen::Vector3d {
      const double inwards = 0.25 * s.wanted * s.wanted / s.radius;
      return (s.normal.cross(out).normalized() * s.acceleration - out.normalized() * inwards).normalized();
    };
    s.start_tangent = tangent(first);
    s.end_tangent = tangent(last);
    s.start_pull = pull(first);
    s.end_pull = pull(last);
    add(s);
  }

  const ModelInput& input_;
  const Moves& moves_;
  const LinuxcncSettings& linuxcnc_;
  Tally tally_;
  LinuxcncRun run_;
  AxisVector position_;
  Chain chain_;
  Eigen::Vector3d chained_to_ = position_.head<3>();  ///< where the last segment that was handed on ends
  bool has_moved_ = false, has_left_out_ = false;
  MoveMode startup_;
};

}  // namespace

Result<Prediction> predict_linuxcnc(const ModelInput& input) { return LinuxcncModel(input).run(); }

}  // namespace toolpace::detail::controller
