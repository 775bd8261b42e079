#pragma once
/// Speed, acceleration, jerk and travel of each axis, from the positions alone.

#include <array>
#include <cstdint>
#include <optional>

#include "toolpace/limits/machine.h"
#include "toolpace/verify/corner_exemption.h"
#include "toolpace/verify/report.h"
#include "toolpace/verify/row_stream.h"
#include "toolpace/verify/worst.h"

namespace toolpace {

/// Differences of a motion whose derivative keeps a limit keep it too: they are its weighted means. So a difference
/// beyond limit + bound proves a broken limit, where
///   bound = 2ⁿ·u/Tsⁿ for the n-th difference, u = 2⁻⁵²·16·(way so far) + (2⁻⁵²·64 + 4e-13)·(extent of the geometry),
/// u covers the rounding of a position and of the path length it was computed from.
class LimitCheck {
 public:
  /// @param period  [s]
  /// @param extent  [mm] largest coordinate and centre + radius of the program; none = there is none
  LimitCheck(const Machine& machine, double period, std::optional<double> extent);

  /// Judges the rows of the window. @param corners  of these rows
  void take(const RowStream& stream, CornerExemption& corners);

  /// How far rounding may have moved a position of the rows so far, of any axis [mm, rad].
  double noise() const;

  void report(VerifyReport& report) const;

 private:
  struct AxisState {
    Worst speed, acceleration, jerk, low, high;
    double largest = 0.0;            ///< |position|
    double largest_allowance = 0.0;  ///< of the jerk that corners explain
    bool used = false;
  };
  void take_axis(const RowStream& stream, CornerExemption& corners, std::size_t axis);
  void take_path_speed(const RowStream& stream);
  double noise(const AxisState& state) const;

  Machine machine_;
  double period_;
  std::optional<double> extent_;
  double way_ = 0.0;  ///< [mm] so far
  std::array<AxisState, kAxisCount> axes_;
  Worst path_speed_;
};

}  // namespace toolpace
