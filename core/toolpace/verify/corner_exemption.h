#pragma once
/// What corners that are passed with a step of speed explain of an excess, and how many did.

#include "toolpace/verify/corner_limit.h"
#include "toolpace/verify/corner_log.h"
#include "toolpace/verify/report.h"
#include "toolpace/verify/row_stream.h"

namespace toolpace {

/// Sum of the steps of each axis over a few intervals, magnitudes.
struct Allowance {
  AxisVector speed_step = AxisVector::Zero();         ///< [mm/s, rad/s]
  AxisVector acceleration_step = AxisVector::Zero();  ///< [mm/s², rad/s²]
  AxisVector place_step = AxisVector::Zero();         ///< of the place that the path tells [mm/s, rad/s]
};

/// Corners come from a log, where the program is known, or are seen in the positions.
class CornerExemption {
 public:
  /// @param period  [s]
  CornerExemption(const CornerLimit& limit, double period) : limit_(limit), period_(period) {}

  /// The corners from now on. @param log  null = they are looked for in the positions
  void use(const CornerLog* log) { log_ = log; }

  /// What the corners of the row intervals local … local + intervals − 1 explain (interval k ends with row k); they count as
  /// exempt.
  ///
  /// @param noise  [mm] rounding of a position
  Allowance explain(const RowStream& stream, std::size_t local, std::size_t intervals, double noise);

  /// How much longer than its chord the program says that the row interval `local` is [mm]; 0 where it is not known.
  double detour(const RowStream& stream, std::size_t local) const {
    return log_ != nullptr ? log_->detour(stream.row(local)) : 0.0;
  }

  void report(VerifyReport& report) const;

 private:
  void take(const CornerEvent& event, Allowance& sum);

  CornerLimit limit_;
  double period_;
  const CornerLog* log_ = nullptr;
  std::int64_t corners_ = 0;
  std::int64_t last_corner_ = -1;
  double largest_step_ = 0.0;
};

}  // namespace toolpace
