#pragma once
/// Where ramps that end at nodes may have to end.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "toolpace/law/peak_speed.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/path/node_positions.h"
#include "toolpace/plan/block/block_profile.h"

namespace toolpace::detail {

/// By how much ramp limits differ between two blocks: the largest ratio of two accelerations or jerks, ≥ 1.
double ratio_of(const Dynamics& a, const Dynamics& b);

/// Whether ramp limits differ by more than `ratio` on both sides of an inner node.
bool is_seam(const SpeedLimits& limits, std::size_t node, double ratio);

/// A stretch that is planned as one block.
struct Span {
  double length = 0.0;
  double touched_feed = std::numeric_limits<double>::infinity();  ///< lowest feed that the optimum touches [mm/s]
  double highest_feed = 0.0;                                      ///< [mm/s]
  Dynamics dynamics;
  MoveTerms terms;

  double cap() const { return std::isfinite(touched_feed) ? touched_feed : highest_feed; }

  void include(const Span& o) {
    length += o.length;
    touched_feed = std::min(touched_feed, o.touched_feed);
    highest_feed = std::max(highest_feed, o.highest_feed);
    include(dynamics.up, o.dynamics.up);
    include(dynamics.down, o.dynamics.down);
  }

  template <class Law>
  void prepare() {
    terms = move_terms<Law>(dynamics);
  }

  Drive drive() const { return {dynamics, terms}; }

 private:
  static void include(RampLimits& a, const RampLimits& b) {
    a.acceleration = std::min(a.acceleration, b.acceleration);
    a.jerk = std::min(a.jerk, b.jerk);
    a.time = std::max(a.time, b.time);
  }
};

/// Every place that may be an anchor, and the spans between neighbours.
struct Anchors {
  NodePositions position;         ///< of all nodes of the chain
  std::vector<double> cap;        ///< one a place
  std::vector<std::size_t> node;  ///< one a place
  std::vector<Span> span;         ///< from place i to i + 1
};

/// Nodes that the acceleration-limited optimum touches, where caps are lower than feeds or feeds change; and seams.
Anchors find_anchors(const SpeedLimits& limits, const std::vector<double>& cap, double seam_ratio);

}  // namespace toolpace::detail
