#include "toolpace/plan/block/block_plan.h"

#include <algorithm>

#include "toolpace/plan/block/block_profile.h"
#include "toolpace/plan/block/node_speeds.h"
#include "toolpace/plan/plan.h"

namespace toolpace::detail {

std::vector<double> joined_caps(const SpeedLimits& limits) {
  const std::size_t n = limits.size();
  std::vector<double> cap(limits.node_cap);
  for (std::size_t i = 0; i < n; ++i) {
    cap[i] = std::min(cap[i], limits.block_cap[i]);
    cap[i + 1] = std::min(cap[i + 1], limits.block_cap[i]);
  }
  cap.front() = 0.0;
  cap.back() = 0.0;
  return cap;
}

namespace {

template <class Law>
MotionPlan plan_with(const SpeedLimits& limits, std::size_t blocks, const Monitor& monitor) {
  const std::vector<double> cap = joined_caps(limits);
  const std::vector<MoveTerms> terms = terms_of<Law>(limits.dynamics);
  const Chain chain{limits.length, limits.ramp, limits.dynamics, terms, cap};
  const std::vector<double> v = node_speeds<Law>(chain, blocks, monitor);
  MotionPlan plan;
  if (v.empty()) return plan;
  plan.phases.reserve(limits.size() * 2);
  PhaseWriter writer(plan.phases);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    if ((i & 0xFFFF) == 0 && monitor.is_cancelled()) return {};
    writer.count_from(i);
    append_stretch<Law>({limits.length[i], limits.block_cap[i], v[i], v[i + 1]}, chain.drive(i), writer);
  }
  return plan;
}

template <class Law>
double time_with(const SpeedLimits& limits, std::size_t blocks, std::size_t margin) {
  const std::vector<double> cap = joined_caps(limits);
  const std::vector<MoveTerms> terms = terms_of<Law>(limits.dynamics);
  const Chain chain{limits.length, limits.ramp, limits.dynamics, terms, cap};
  const std::vector<double> v = node_speeds<Law>(chain, blocks, {});
  double sum = 0;
  for (std::size_t i = margin; i + margin < limits.size(); ++i) {
    sum += stretch_time({limits.length[i], limits.block_cap[i], v[i], v[i + 1]}, terms[limits.ramp[i]]);
  }
  return sum;
}

}  // namespace

BlockSpeeds block_ramp_speeds(const SpeedLimits& limits, LawKind law, std::size_t blocks) {
  return visit_law(law, [&](auto chosen) {
    using Law = decltype(chosen);
    const std::vector<double> cap = joined_caps(limits);
    const std::vector<MoveTerms> terms = terms_of<Law>(limits.dynamics);
    BlockSpeeds v{node_speeds<Law>({limits.length, limits.ramp, limits.dynamics, terms, cap}, blocks, {}), {}, 0.0};
    v.peak.reserve(limits.size());
    for (std::size_t i = 0; i < limits.size(); ++i) {
      const Stretch stretch{limits.length[i], limits.block_cap[i], v.node[i], v.node[i + 1]};
      const MoveTerms& t = terms[limits.ramp[i]];
      v.peak.push_back(peak_speed(stretch, t));
      v.time += stretch_time(stretch, v.peak.back(), t);
    }
    return v;
  });
}

double time_block_ramps(const SpeedLimits& limits, LawKind law, std::size_t blocks, std::size_t margin) {
  return visit_law(law, [&](auto chosen) { return time_with<decltype(chosen)>(limits, blocks, margin); });
}

MotionPlan plan_block_ramps(const SpeedLimits& limits, LawKind law, std::size_t blocks, const Monitor& monitor) {
  return visit_law(law, [&](auto chosen) { return plan_with<decltype(chosen)>(limits, blocks, monitor); });
}

}  // namespace toolpace::detail
