#include "drawing/cause_times.h"

#include <algorithm>

#include "toolpace/plan/restraint.h"

namespace toolpace::ui {
namespace {

constexpr std::size_t kStride = 64;

}  // namespace

CauseTimes::CauseTimes(const std::vector<Restraint>& restraints) : restraints_(&restraints) {
  sums_.reserve(restraints.size() / kStride + 1);
  CauseShares sum = {};
  for (std::size_t i = 0; i < restraints.size(); ++i) {
    if (i % kStride == 0) sums_.push_back(sum);
    sum[index_of(restraints[i].cause)] += restraints[i].end - restraints[i].begin;
  }
}

CauseShares CauseTimes::until(double time) const {
  const auto& list = *restraints_;
  const Restraint* last = restraint_at(list, time);
  if (!last) return {};
  const auto count = static_cast<std::size_t>(last - list.data()) + 1;
  const std::size_t block = (count - 1) / kStride;
  CauseShares sum = sums_[block];
  for (std::size_t i = block * kStride; i < count; ++i) {
    sum[index_of(list[i].cause)] += std::max(std::min(list[i].end, time) - list[i].begin, 0.0);
  }
  return sum;
}

CauseShares CauseTimes::between(double begin, double end) const {
  if (is_empty() || !(end > begin)) return {};
  CauseShares shares = until(end);
  const CauseShares before = until(begin);
  for (std::size_t i = 0; i < kCauseCount; ++i) shares[i] = std::max(shares[i] - before[i], 0.0);
  return shares;
}

const Restraint* CauseTimes::at(double time) const {
  if (is_empty()) return nullptr;
  return time > restraints_->back().end ? nullptr : restraint_at(*restraints_, time);
}

}  // namespace toolpace::ui
