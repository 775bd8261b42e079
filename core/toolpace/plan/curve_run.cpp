#include "toolpace/plan/curve_run.h"

#include <algorithm>

namespace toolpace::detail {

CurveRun::CurveRun(const SpeedLimits& all, std::size_t begin, std::size_t end, const CurveUse& use, std::size_t memory)
    : all_(all),
      begin_(begin),
      use_(use),
      limits_(slice(all, begin, end)),
      shared_(limits_.dynamics.size()),
      memory_(memory) {
  const auto first = std::lower_bound(all.curved.begin(), all.curved.end(), begin);
  const auto last = std::lower_bound(first, all.curved.end(), end);
  first_ = static_cast<std::size_t>(first - all.curved.begin());
  const auto count = static_cast<std::size_t>(last - first);
  top_.reserve(count);
  for (std::size_t c = 0; c < count; ++c) {
    const CurveBudget budget = all.budget[first_ + c];
    top_.push_back(budget.top_speed());
    for (const CurveRow& row : budget.rows()) has_jerk_ = has_jerk_ || row.jerk > 0;
  }
  range_.resize(count * memory_, {0.0, {}});
  oldest_.resize(count, 0);
  limits_.dynamics.resize(shared_ + count);
  for (std::size_t c = 0; c < count; ++c) {
    limits_.ramp[block(c)] = static_cast<std::uint32_t>(shared_ + c);
    now_.push_back(make(c, {1.0, usual_split(use_.at_cap)}));
    put(c);
  }
  before_ = now_;
}

void CurveRun::apply(const std::vector<CurveChoice>& choices) {
  for (std::size_t c = 0; c < choices.size(); ++c) {
    if (now_[c].choice == choices[c]) continue;
    std::swap(now_[c], before_[c]);
    if (now_[c].choice != choices[c]) now_[c] = make(c, choices[c]);
    put(c);
  }
}

void CurveRun::put(std::size_t c) {
  limits_.block_cap[block(c)] = now_[c].cap;
  limits_.dynamics[shared_ + c] = now_[c].dynamics;
}

CurveRun::Applied CurveRun::make(std::size_t c, const CurveChoice& choice) {
  const double cap = std::min(widest_cap(c), choice.share * top_[c]);
  const CurveBudget budget = all_.budget[first_ + c];
  const CurveShare share = budget.at(cap, range(c, budget, cap), choice.split, use_.at_cap);
  return {choice, cap, within(along(c).dynamics, share)};
}

/// The same one serves all splits that are tried with a cap.
const JerkRange& CurveRun::range(std::size_t c, const CurveBudget& budget, double cap) {
  const auto first = range_.begin() + static_cast<std::ptrdiff_t>(c * memory_);
  const auto last = first + static_cast<std::ptrdiff_t>(memory_);
  const auto known = std::find_if(first, last, [&](const auto& entry) { return entry.first == cap; });
  if (known != last) return known->second;
  auto& entry = range_[c * memory_ + oldest_[c]];
  oldest_[c] = static_cast<std::uint32_t>((oldest_[c] + 1) % memory_);
  entry = {cap, budget.jerk_range(cap, use_.at_cap)};
  return entry.second;
}

Cause CurveRun::cause(std::size_t block) const {
  if (limits_.ramp[block] < shared_) return all_.dynamics_cause[all_.ramp[begin_ + block]];
  return cause_of(limits_.dynamics_of(block), along(limits_.ramp[block] - shared_));
}

}  // namespace toolpace::detail
