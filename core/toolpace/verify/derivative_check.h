#pragma once
/// The columns of each axis: speed, acceleration and jerk against the differences of its positions.

#include <array>

#include "toolpace/verify/report.h"
#include "toolpace/verify/row_stream.h"
#include "toolpace/verify/worst.h"

namespace toolpace {

/// The columns are the differences over the period that ends with the row, at rest before the first row:
/// v = (p − p₋₁)/Ts, a = (v − v₋₁)/Ts, j = (a − a₋₁)/Ts. They follow from the positions, so that they agree but for rounding:
/// of the positions, of units, and of the period.
class DerivativeCheck {
 public:
  explicit DerivativeCheck(double period);

  void take(const RowStream& stream);
  void report(VerifyReport& report) const;

 private:
  void take_axis(const RowStream& stream, std::size_t axis);

  double period_;
  std::array<double, kAxisCount> largest_ = {};  ///< |position| so far [mm, rad]
  std::array<std::array<Worst, kAxisCount>, kDerivatives> worst_;
  std::array<std::array<bool, kAxisCount>, kDerivatives> used_ = {};
};

}  // namespace toolpace
