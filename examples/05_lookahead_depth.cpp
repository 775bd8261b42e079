/// How far must a controller look ahead? Plans the 20 blocks of Ning et al. 2014 straight from arrays, without any
/// program, and prints the cycle time over the look-ahead depth.

#include <cstdio>
#include <optional>
#include <vector>

#include "toolpace/plan/plan.h"

namespace {

struct Block {
  double length;  // [mm]
  double feed;    // [mm/s]
};

constexpr Block kBlocks[] = {{0.88, 100}, {1.68, 100}, {1.51, 100}, {0.56, 100}, {1.83, 100}, {0.55, 80}, {1.71, 80},
                             {0.68, 80},  {0.37, 80},  {2.21, 80},  {2.14, 80},  {0.41, 50},  {1.27, 50}, {0.996, 50},
                             {0.56, 50},  {0.86, 100}, {0.43, 100}, {0.68, 100}, {1.43, 100}, {3.40, 100}};

/// A straight line: between two blocks nothing but their feeds limits the speed.
toolpace::SpeedLimits straight_line() {
  using toolpace::Cause;
  toolpace::SpeedLimits limits;
  const toolpace::RampLimits ramp{.acceleration = 3000.0, .jerk = 1e6};
  limits.dynamics = {{ramp, ramp}};
  limits.node_cap = {0.0};
  limits.node_cause = {Cause::stop};
  for (const auto& block : kBlocks) {
    limits.length.push_back(block.length);
    limits.block_cap.push_back(block.feed);
    limits.block_cause.push_back(Cause::feed);
    limits.ramp.push_back(0);
    limits.node_cap.push_back(block.feed);
    limits.node_cause.push_back(Cause::feed);
  }
  limits.node_cap.back() = 0.0;
  limits.node_cause.back() = Cause::stop;
  return limits;
}

}  // namespace

int main() {
  const auto limits = straight_line();
  for (const std::optional<std::size_t> depth : {std::optional<std::size_t>(1), {2}, {4}, {8}, {}}) {
    const auto plan = toolpace::plan_motion(limits, {.law = toolpace::LawKind::quintic, .lookahead = depth});
    if (!plan) {
      std::fprintf(stderr, "%s\n", plan.error().message.c_str());
      return 1;
    }
    std::printf("N = %-3s  %8.3f ms\n", depth ? std::to_string(*depth).c_str() : "all", 1000 * plan->cycle_time());
  }
}
