#pragma once
/// What a program asks the machine to do: one row a motion block, in machine coordinates, as flat arrays.
///
/// Rows about the tool's tip (MoveMode::chain) tell where the tip is: X Y Z of the workpiece as it lies while the rotary axes stand
/// at 0, beside the rotary axes themselves. Where rows of another chain follow, the machine stands still, and its place is told
/// anew.
///
/// This is the interface between reading (nc/) and geometry (path/). Geometry is exact: arcs stay arcs, splines stay
/// splines. Rows without motion (dwell, tool change, stop, end) stand in the same table because their order matters.

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "toolpace/base/axes.h"
#include "toolpace/kinematics/chain.h"

namespace toolpace {

enum class MoveKind : std::uint8_t { rapid, feed, arc, spline, probe, tap, dwell, tool, stop, end };

/// True for kinds that change the position.
constexpr bool is_motion(MoveKind kind) { return kind <= MoveKind::tap; }

/// Unit normal of an arc's plane. Those planes are level or upright, so two numbers say it, and blocks stay small.
class PlaneNormal {
 public:
  /// Straight up.
  PlaneNormal() = default;
  /// @pre `normal` has length 1 and is horizontal or points straight up
  template <class Vector>
  PlaneNormal(const Eigen::MatrixBase<Vector>& normal) : x_(normal.x()), y_(normal.y()) {}
  operator Eigen::Vector3d() const { return {x_, y_, x_ == 0.0 && y_ == 0.0 ? 1.0 : 0.0}; }

 private:
  double x_ = 0.0, y_ = 0.0;
};

/// Circular, helical or spiral motion about an axis through `centre`.
struct ArcDetail {
  Eigen::Vector3d centre;  ///< [mm], in the plane level of the start point
  PlaneNormal normal;      ///< right-hand
  double sweep = 0.0;      ///< [rad], signed about the normal, + counter-clockwise; magnitude may exceed 2π
};

/// Polynomial or rational B-spline in X Y Z; other axes follow linearly in the curve parameter.
struct SplineDetail {
  int degree = 3;
  std::vector<Eigen::Vector3d> points;  ///< control points [mm]; first and last are the ends
  std::vector<double> weights;          ///< one a control point; all 1 for polynomial curves
  std::vector<double> knots;            ///< points + degree + 1, clamped, non-decreasing
};

enum class PathControl : std::uint8_t { job_default, exact_path, exact_stop, blend };  ///< none/G64, G61, G61.1, G64 P

/// MoveMode::feed_mode of moves whose speed hangs on the spindle's turns: threads, rigid taps.
inline constexpr std::uint8_t kSynchronisedFeed = 33;

/// What a program lowers the machine's limits to. Infinite: nothing.
struct MotionCeiling {
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  AxisVector speed = AxisVector::Constant(kNone);         ///< of each axis [mm/s, rad/s] > 0
  AxisVector acceleration = AxisVector::Constant(kNone);  ///< of each axis [mm/s², rad/s²] > 0
  double path_speed = kNone;                              ///< [mm/s] > 0
  double path_acceleration = kNone;                       ///< [mm/s²] > 0
  // At corners that are crossed, and not rounded:
  AxisVector corner_step = AxisVector::Constant(kNone);  ///< of each axis' speed [mm/s, rad/s] ≥ 0
  double corner_speed = kNone;                           ///< [mm/s] ≥ 0 at a right angle
  double junction_deviation = kNone;                     ///< [mm] ≥ 0
  /// 0 … 1: how much accuracy is asked for at the cost of acceleration; what that means, the machine knows
  /// (PathLimits::fine_acceleration).
  double accuracy = 0.0;
  bool holds_overrides = false;  ///< overrides of feed and rapid do not count
  bool operator==(const MotionCeiling&) const = default;

  bool limits_corners() const;
};

/// Of each limit the lower one, or the higher one: what holds everywhere under both, and what no motion under one of them exceeds.
MotionCeiling lower_of(const MotionCeiling& a, const MotionCeiling& b);
MotionCeiling higher_of(const MotionCeiling& a, const MotionCeiling& b);

/// Modal state that planning needs, shared by many rows.
struct MoveMode {
  PathControl control = PathControl::job_default;
  double tolerance = 0.0;        ///< [mm] of G64 P
  double naive_tolerance = 0.0;  ///< [mm] of G64 Q
  std::uint8_t plane = 17;       ///< 17, 18, 19
  std::uint8_t feed_mode = 94;   ///< 93, 94, 95 or kSynchronisedFeed; feeds are converted already
  std::uint16_t ceiling = 0;     ///< index into ceilings
  std::uint16_t chain = 0;       ///< index into chains
  bool operator==(const MoveMode&) const = default;
};

inline constexpr std::uint32_t kNoDetail = 0xFFFFFFFFu;

/// Detail of the second row of a rigid tap, which goes back to where the first began.
inline constexpr std::uint32_t kTapReturn = 0xFFFFFFFEu;

/// Row i: kind[i] moves from end[i-1] (or start) to end[i] at feed[i].
struct Moves {
  AxisVector start = AxisVector::Zero();  ///< machine position before the first row, told by the axes

  std::vector<MoveKind> kind;
  std::vector<std::uint32_t> line;    ///< NC line, counted from 1, in files[file[i]]
  std::vector<std::uint16_t> file;    ///< index into files; 0 is the program itself
  std::vector<std::uint16_t> mode;    ///< index into modes
  std::vector<std::uint32_t> detail;  ///< index into arcs, splines, dwells or notes by kind; kTapReturn; else kNoDetail
  std::vector<AxisVector> end;        ///< [mm, rad]
  /// Programmed feedrate: mm/s along XYZ; rad/s where only A, B, C move. 0 for rapids and rows without motion;
  /// infinite = as fast as the machine allows (polylines without a feed column).
  std::vector<double> feed;

  std::vector<ArcDetail> arcs;
  std::vector<SplineDetail> splines;
  std::vector<double> dwells;      ///< [s]
  std::vector<std::string> notes;  ///< tool number, …
  std::vector<MoveMode> modes = std::vector<MoveMode>(1);
  std::vector<MotionCeiling> ceilings = std::vector<MotionCeiling>(1);  ///< [0] lowers nothing
  /// About whose tip rows are told; [0] has no joints: by the axes themselves.
  std::vector<Chain> chains = std::vector<Chain>(1);
  std::vector<std::string> files;  ///< names, [0] is the program

  std::size_t size() const { return kind.size(); }
  bool empty() const { return kind.empty(); }
  std::uint16_t chain_of(std::size_t i) const { return modes[mode[i]].chain; }
  bool has_tip() const { return chains.size() > 1; }
  /// Where row i begins, told as the row is; behind the last one, where that ends.
  AxisVector begin_of(std::size_t i) const;
};

}  // namespace toolpace
