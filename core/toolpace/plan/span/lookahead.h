#pragma once
/// Look-ahead for ramps that run across blocks: at every node the machine can stop inside its window.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "toolpace/law/law.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/motion_plan.h"
#include "toolpace/plan/span/turns.h"

namespace toolpace::detail {

/// What a window of N blocks asks for: from node i the machine must be able to rest at node i + N − 1 (where the path does
/// not end before that). N = 1: a stop at every node.
class StopWindow {
 public:
  StopWindow(const SpeedLimits& limits, LawKind law, std::size_t blocks);

  /// Lowers caps to what can be stopped from, with zero acceleration, by the law's own ramp.
  void lower(std::vector<double>& cap) const;

  /// Lowers the accelerations of turns to what can be taken away and stopped from; to 0 where they gain nothing then.
  void lower(std::vector<Turn>& turns, const std::vector<double>& cap) const;

  /// Whether the plan could stop inside its window at every node. With an acceleration a > 0 that takes v·a/J + a³/3J² to be
  /// brought to zero, and a²/2J more speed to be stopped from.
  bool holds(const MotionPlan& plan) const;

  enum class Step : std::uint8_t {
    newton,  ///< one Newton step towards the speed from which the stop fits
    climb    ///< the same, and behind the node no faster than ramps that end at each node can climb
  };

  /// Lowers the caps of nodes where the plan could not stop.
  /// @return how many of these there were
  std::size_t lower_where_too_fast(const MotionPlan& plan, Step step, std::vector<double>& cap) const;

 private:
  double stop_length(double speed, double acceleration, const Dynamics& d) const;
  void climb(std::size_t node, std::vector<double>& cap) const;
  double slower(const PhaseState& there, std::size_t node, double excess) const;
  template <class F>
  void for_each_too_fast(const MotionPlan& plan, F&& f) const;

  const SpeedLimits& limits_;
  LawKind law_;
  std::vector<double> way_;         ///< length of each node's window [mm]; infinite where it holds the end
  std::vector<Dynamics> dynamics_;  ///< smallest limits in each node's window; one entry where all are the same
  bool never_binds_ = false;        ///< even the highest speed and acceleration can be stopped in the shortest window

  const Dynamics& dynamics_of(std::size_t node) const { return dynamics_.size() == 1 ? dynamics_[0] : dynamics_[node]; }
};

}  // namespace toolpace::detail
