#pragma once
/// How turning and changing speed share the limits of the axes on a curve.

#include <cstdint>
#include <span>
#include <vector>

#include "toolpace/limits/curve_bounds.h"
#include "toolpace/limits/machine.h"
#include "toolpace/limits/ramp_limits.h"

namespace toolpace {

/// What changes of speed may use on a curve that is run no faster than some cap, along the path.
struct CurveShare {
  double acceleration;  ///< [mm/s²] > 0
  double jerk;          ///< [mm/s³] > 0
};

/// What a ramp may do at the cap of its block.
enum class AtCap : std::uint8_t {
  rests,   ///< its acceleration has come to zero there, as that of ramps inside one block
  changes  ///< any acceleration
};

/// Jerks along the path, on a curve that is run no faster than some cap [mm/s³].
struct JerkRange {
  double beside_all;    ///< the highest one that leaves the acceleration what it has beside turning alone
  double most;          ///< all that is left at constant speed; infinite without a jerk limit
  double acceleration;  ///< what it has with the first of them [mm/s²]
};

/// The limits of one axis on a curve: largest derivatives of it by path length, as parts of the axis' limits. Zero where it has
/// none.
struct CurveRow {
  double along, across, plane;             ///< of acceleration: first, second, together (curve_bounds.h)
  double jerk, turning, jerk_plane, rest;  ///< of jerk; what of the third is not against the direction
};

/// All motions along a segment that keep every axis inside its limits anywhere on it, as far as two inequalities an axis and
/// order tell; each of the two is enough. With v, a, j along the path and an axis' derivatives f, s, t by its length
///   f·|a| + s·v² ≤ A                            or  together·√(a² + κ²v⁴) ≤ A,
///   f·(|j| + bend·v³) + 3s·v·|a| ≤ J − rest·v³  or  together·√((|j| + bend·v³)² + (3κ·v·a)²) ≤ J − rest·v³,
/// the second ones by the right angle between the direction and the normal. Every axis has rows of its own, so higher limits
/// never leave less: what is allowed under some limits is allowed under higher ones, of whatever axis.
struct CurveBudget {
  double speed = kUnlimited;  ///< [mm/s] from the axes' top speeds
  double curvature = 0;       ///< κ [1/mm]
  double bend = 0;            ///< [1/mm²]
  std::array<CurveRow, kAxisCount> row;
  std::size_t count = 0;  ///< of rows

  std::span<const CurveRow> rows() const { return {row.data(), count}; }
  bool bends() const;

  /// [mm/s] at which turning leaves next to nothing.
  double top_speed() const;

  /// Constant limits for changes of speed under a cap ≤ top_speed(): a jerk, and all of the acceleration that goes with it.
  /// Where they rest at the cap, an acceleration a is met at speeds up to cap − a²/2j only: that much the speed still rises (has
  /// fallen) while jerk j takes a away. Then all of the normal part that the cap could ask for is not there yet. For the same cap
  /// and jerk, higher limits never leave a lower acceleration.
  /// @param split  −1 < split < 1 of the jerk's range: 0 leaves all of the acceleration, 1 is the most, −1 none. Nothing to
  ///               choose on lines, and without a jerk limit
  CurveShare at(double cap, double split, AtCap at_cap) const {
    return at(cap, jerk_range(cap, at_cap), split, at_cap);
  }

  /// The same with the range known, in a tenth of the time.
  CurveShare at(double cap, const JerkRange& range, double split, AtCap at_cap) const;
  JerkRange jerk_range(double cap, AtCap at_cap) const;
};

/// The split that suits most curves.
inline double usual_split(AtCap at_cap) { return at_cap == AtCap::rests ? 0.0 : 0.71; }

/// The budgets of many curves, without what never decides, in flat arrays.
class CurveBudgets {
 public:
  void add(const CurveBudget& budget);
  std::size_t size() const { return curves_.size(); }
  CurveBudget operator[](std::size_t index) const;

 private:
  struct Curve {
    double speed, curvature, bend;
    std::size_t end;  ///< of its rows
  };
  std::vector<Curve> curves_;
  std::vector<CurveRow> rows_;
};

/// Limits along the path, and no more than a share.
Dynamics within(const Dynamics& along, const CurveShare& share);

/// @param axes  limits of the axes (curve_axes.h)
CurveBudget curve_budget(const CurveBounds& bounds, const std::array<AxisLimits, kAxisCount>& axes);

}  // namespace toolpace
