#pragma once
/// Plans a stretch whose ramp limits change from block to block.

#include <vector>

#include "toolpace/law/phase.h"
#include "toolpace/plan/span/filter.h"
#include "toolpace/plan/span/kernel.h"
#include "toolpace/plan/span/mixed_hull.h"

namespace toolpace::detail {

/// Keeps its buffers between stretches.
class MixedPlanner {
 public:
  /// @param passes  rounds of shifting accelerations at the touched nodes, each kept only if it saves time
  explicit MixedPlanner(int passes) : passes_(passes) {}

  /// @param kernels  of the chain, tilts 0 but those of the ends, which stay; they are changed
  /// @return false where there is no such hull, and then nothing is written
  bool plan(const SpanChain& chain, std::vector<Kernel>& kernels, std::vector<Phase>& phases);

 private:
  bool build(const SpanChain& chain, std::vector<Kernel>& kernels);
  void tilt(std::vector<Kernel>& kernels) const;
  bool emit_within_caps(const SpanChain& chain, std::vector<Kernel>& kernels, double at_most);

  int passes_;
  MixedHull hull_;
  std::vector<Phase> trial_;
};

}  // namespace toolpace::detail
