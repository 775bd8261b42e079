#pragma once
/// The distance of the actual path from the commanded one.

#include <cstdint>
#include <vector>

#include "toolpace/base/axes.h"

namespace toolpace {

/// Contour error: from an actual point to the nearest point of the commanded path, here the straight lines between
/// setpoints, which is what drives get. Not to be confused with the lag, from the actual point to the commanded one at the
/// same time. The nearest point is looked for within four lags before and behind the command along the path (no more than
/// the points of 64 setpoints ahead, and 65536 behind), so that another stroke that happens to pass by does not count.
/// Setpoints at rest are one point, so that memory and time do not grow with dwells.
///
/// Rotary axes count 1 deg as 1 mm.
class ContourMeter {
 public:
  struct Row {
    double lag;      ///< [mm]
    double contour;  ///< [mm] ≤ lag
  };

  /// Takes a commanded and an actual point (XYZ in mm, ABC in deg).
  void take(const AxisVector& commanded, const AxisVector& actual);
  /// A point of the commanded path where nothing was measured: between the rows of a slower trace.
  void pass(const AxisVector& commanded);
  /// Measures rows that have enough command after them, or all at the end, and hands them out in order.
  void measure(bool all, std::vector<Row>& rows);

 private:
  /// Of the commanded path.
  struct Point {
    AxisVector commanded;
    double way;  ///< along the commanded path [mm]
  };
  /// A setpoint that is not yet measured.
  struct Waiting {
    AxisVector actual;
    std::size_t point;  ///< where it is commanded to be: index into points_
  };
  /// Where the nearest point is looked for: chords from one point to the next.
  struct Window {
    std::size_t first, own, last;  ///< indices into points_
    double reach;                  ///< to either side [mm]
  };
  /// The nearest point found so far: its distance, and the chord that it is on.
  struct Nearest {
    double distance;
    std::size_t chord;
  };
  Row measure_one(std::size_t row);
  void look_at(const AxisVector& actual, std::size_t chord, Nearest& best) const;
  void look_back(const AxisVector& actual, const Window& window, Nearest& best) const;
  void look_ahead(const AxisVector& actual, const Window& window, Nearest& best) const;
  void drop_old();

  std::vector<Point> points_;  ///< window of the commanded path
  std::vector<Waiting> waiting_;
  std::size_t nearest_ = 0;  ///< chord that the last row was nearest to: a good place to begin with
};

}  // namespace toolpace
