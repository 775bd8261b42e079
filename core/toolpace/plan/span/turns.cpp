#include "toolpace/plan/span/turns.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toolpace::detail {
namespace {

/// Of a³/J²: the length that a turn leaves its block for coming from, or going to, anything else. 2/3 is the least between two
/// equal turns; from a turn to rest it is 0.687, to a slow node 0.718. What is given away here is hardly a thousandth of the time.
constexpr double kRoom = 0.75;
constexpr double kSpeedToTurn = 0.45;  // of a²/2J
constexpr double kSpeedRoom = 1 - 1e-6;
/// Rounds of taking away turns, each of which may join stretches.
constexpr int kMostRounds = 8;

constexpr double kCrossed = -1;  // in place of the acceleration of a turn

double least_jerk(const Dynamics& d) { return std::min(d.up.jerk, d.down.jerk); }

/// Between two nodes that rest or turn.
struct TurningStretch {
  std::size_t last;     ///< node
  double acceleration;  ///< the least of all blocks; 0 where it has curves [mm/s²]
  double jerk;          ///< the same [mm/s³]
};

/// Chooses among nodes all of which part the chain.
class TurnChooser {
 public:
  TurnChooser(const SpeedLimits& limits, const std::vector<double>& cap, const std::vector<std::uint32_t>& nodes)
      : limits_(limits), cap_(cap), nodes_(nodes) {}

  /// A turn a node; kCrossed where it should be crossed.
  std::vector<Turn> run() const {
    std::vector<Turn> turns;
    TurningStretch before = stretch_from(0, 0);
    while (before.last < limits_.size()) {
      const TurningStretch after = stretch_from(before.last, turns.size() + is_next(before.last, turns.size()));
      if (is_next(before.last, turns.size())) turns.push_back(turn_between(before, after));
      before = after;
    }
    return turns;
  }

 private:
  bool is_next(std::size_t node, std::size_t next) const { return next < nodes_.size() && nodes_[next] == node; }

  /// @param next  index of the first of the nodes behind
  TurningStretch stretch_from(std::size_t first, std::size_t next) const {
    TurningStretch s{first + 1, kNoLimit, kNoLimit};
    include(first, s);
    for (; s.last < limits_.size() && cap_[s.last] > 0 && !is_next(s.last, next); ++s.last) {
      if (limits_.ramp[s.last] != limits_.ramp[s.last - 1]) include(s.last, s);
    }
    const auto curve = std::lower_bound(limits_.curved.begin(), limits_.curved.end(), first);
    if (curve != limits_.curved.end() && *curve < s.last) s.acceleration = 0;
    return s;
  }

  void include(std::size_t block, TurningStretch& s) const {
    const Dynamics& d = limits_.dynamics_of(block);
    s.acceleration = std::min({s.acceleration, d.up.acceleration, d.down.acceleration});
    s.jerk = std::min(s.jerk, least_jerk(d));
  }

  Turn turn_between(const TurningStretch& before, const TurningStretch& after) const {
    const auto node = static_cast<std::uint32_t>(before.last);
    const double to = room(before, node - 1), from = room(after, node), speed = cap_[node];
    const bool has_to = is_worth_turning(to, before.jerk, speed), has_from = is_worth_turning(from, after.jerk, speed);
    if (has_to && has_from) return {node, std::min(to, from)};
    return {node, speed == 0 || has_to || has_from ? 0.0 : kCrossed};
  }

  /// The acceleration that a block beside a turn has room for.
  double room(const TurningStretch& s, std::size_t block) const {
    return std::min({s.acceleration, std::cbrt(limits_.length[block] * s.jerk * s.jerk / kRoom),
                     std::sqrt(2 * s.jerk * limits_.block_cap[block]) * kSpeedRoom});
  }

  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  const SpeedLimits& limits_;
  const std::vector<double>& cap_;
  const std::vector<std::uint32_t>& nodes_;
};

}  // namespace

// A stroke between two turns whose room is used up lasts 2.29·∛(L/J). As long it takes between nodes that are crossed at
// 0.45·a²/2J, and longer strokes gain more by turning.
bool is_worth_turning(double acceleration, double jerk, double speed) {
  return kSpeedToTurn * acceleration * acceleration > 2 * jerk * speed;
}

std::vector<Turn> possible_turns(const SpeedLimits& limits, const std::vector<double>& cap,
                                 std::vector<std::uint32_t> nodes) {
  std::erase_if(nodes, [&](std::uint32_t node) { return node == 0 || node == limits.size(); });
  for (int round = 0; round < kMostRounds && !nodes.empty(); ++round) {
    std::vector<Turn> turns = TurnChooser(limits, cap, nodes).run();
    std::erase_if(turns, [](const Turn& turn) { return turn.acceleration == kCrossed; });
    if (turns.size() == nodes.size()) return turns;
    nodes.clear();
    for (const Turn& turn : turns) nodes.push_back(turn.node);
  }
  return {};
}

}  // namespace toolpace::detail
