#include "toolpace/verify/corner_exemption.h"

#include <algorithm>

#include "toolpace/verify/position_corners.h"

namespace toolpace {

Allowance CornerExemption::explain(const RowStream& stream, std::size_t local, std::size_t intervals, double noise) {
  Allowance sum;
  if (log_ != nullptr) {
    const std::int64_t first = stream.row(local);
    log_->for_each(first, first + static_cast<std::int64_t>(intervals) - 1,
                   [&](const CornerEvent& event) { take(event, sum); });
    return sum;
  }
  const CornerSight sight{limit_, period_, noise};
  bool has_curve =
      false;  // the runs around one leave no room for another, and a corner near a row could be in two intervals
  for (std::size_t k = 0; k < intervals; ++k) {
    CornerEvent event = corner_between_straights(stream, local + k, sight);
    if (is_none(event) && !has_curve) {
      event = corner_beside_curve(stream, local + k, sight);
      has_curve = !is_none(event);
    }
    take(event, sum);
  }
  return sum;
}

void CornerExemption::take(const CornerEvent& event, Allowance& sum) {
  sum.speed_step += event.speed_step;
  sum.acceleration_step += event.acceleration_step;
  sum.place_step += event.place_step;
  const double step = event.speed_step.norm();
  if (step == 0.0 && event.acceleration_step.isZero(0.0)) return;
  largest_step_ = std::max(largest_step_, step);
  if (event.corner > last_corner_) ++corners_;
  last_corner_ = std::max(last_corner_, event.corner);
}

void CornerExemption::report(VerifyReport& report) const {
  report.exempt_corners = corners_;
  report.largest_corner_step = largest_step_;
}

}  // namespace toolpace
