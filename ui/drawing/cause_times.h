#pragma once
/// How long each cause held the speed down between two instants, in logarithmic time whatever the length of the plan.

#include <array>
#include <vector>

#include "drawing/cause_style.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace::ui {

using CauseShares = std::array<double, kCauseCount>;  ///< [s] by index_of(cause)

class CauseTimes {
 public:
  CauseTimes() = default;
  /// @param restraints  consecutive; must outlive this object
  explicit CauseTimes(const std::vector<Restraint>& restraints);

  CauseShares between(double begin, double end) const;
  /// The restraint at a time; null outside the plan.
  const Restraint* at(double time) const;
  bool is_empty() const { return !restraints_ || restraints_->empty(); }

 private:
  CauseShares until(double time) const;

  const std::vector<Restraint>* restraints_ = nullptr;
  std::vector<CauseShares> sums_;  // before each 64th restraint
};

}  // namespace toolpace::ui
