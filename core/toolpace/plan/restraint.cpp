#include "toolpace/plan/restraint.h"

#include <algorithm>
#include <optional>

namespace toolpace {
namespace {

/// A speed this close to a cap touches it.
constexpr double kTouch = 1e-6;
constexpr double kNearCap = 1e-3;

/// Part of a phase in which the jerk keeps its sign.
struct Piece {
  const Phase& phase;
  double begin, end;  ///< [s] within the phase
  double jerk;        ///< its sign counts
};

class Explainer {
 public:
  Explainer(const SpeedLimits& limits, const MotionPlan& plan, const std::vector<double>& node_time,
            const PlanOptions& options)
      : limits_(limits), plan_(plan), time_(node_time), slack_(1e-9 * plan.cycle_time()) {
    if (options.lookahead && *options.lookahead < limits.size()) unexplained_ = Cause::lookahead;
  }

  std::vector<Restraint> run() {
    for (const Phase& p : plan_.phases) {
      if (p.shape != PhaseShape::constant_jerk) {
        const double half = p.duration / 2;
        add({p, 0, half, p.rate});
        add({p, half, p.duration, -p.rate});
      } else if (p.rate == 0 && p.acceleration == 0) {
        add_cruise(p);
      } else {
        add({p, 0, p.duration, p.rate});
      }
    }
    return std::move(out_);
  }

 private:
  /// Moves on to the block under the tool at time t.
  void advance(double t) {
    while (block_ + 1 < limits_.size() && time_[block_ + 1] <= t + slack_) ++block_;
  }

  void push(double end, Cause cause) {
    if (!out_.empty() && out_.back().cause == cause) {
      out_.back().end = end;
      return;
    }
    out_.push_back({out_.empty() ? 0.0 : out_.back().end, end, static_cast<std::uint32_t>(block_), cause});
  }

  void add_cruise(const Phase& p) {
    const double end = p.begin + p.duration;
    if (p.speed == 0) {
      advance(p.begin);
      push(end, Cause::dwell);
      return;
    }
    for (double t = p.begin; t < end;) {
      advance(t);
      const bool is_last = block_ + 1 >= limits_.size() || time_[block_ + 1] >= end;
      const double next = is_last ? end : time_[block_ + 1];
      push(next, cause_of_cruise(p.speed));
      t = next;
    }
  }

  Cause cause_of_cruise(double speed) const {
    if (speed >= limits_.block_cap[block_] * (1 - kTouch)) return limits_.block_cause[block_];
    for (const std::size_t node : {block_, block_ + 1}) {
      if (limits_.node_cap[node] <= speed * (1 + kTouch)) return limits_.node_cause[node];
    }
    return unexplained_;
  }

  void add(const Piece& piece) {
    advance(piece.phase.begin + piece.begin);
    push(piece.phase.begin + piece.end, runs_at_cap(piece) ? limits_.block_cause[block_] : cause_of(piece));
  }

  /// Plans that were timed anew come this close to the speed they are held to, and rarely cruise; through curves they are
  /// faster than the block's cap, which has to leave room for changes of speed.
  bool runs_at_cap(const Piece& piece) const {
    const double low = limits_.block_cap[block_] * (1 - kNearCap);
    return speed_at(piece, piece.phase.begin + piece.begin) >= low &&
           speed_at(piece, piece.phase.begin + piece.end) >= low;
  }

  Cause cause_of(const Piece& piece) const {
    if (piece.jerk > 0) {
      if (const auto valley = cause_of_valley(piece)) return *valley;
      return is_stretched(piece.phase) ? cause_of_acceleration() : unexplained_;
    }
    return piece.jerk == 0 || is_stretched(piece.phase) ? cause_of_acceleration() : Cause::jerk;
  }

  /// Whether the acceleration limit and not the jerk decides how steep the phase is.
  bool is_stretched(const Phase& p) const {
    const Dynamics& d = limits_.dynamics_of(block_);
    const PhaseExtrema e = extrema(p);
    const RampLimits& r = e.max_acceleration >= e.max_deceleration ? d.up : d.down;
    return std::max(e.max_acceleration, e.max_deceleration) / r.acceleration > e.max_jerk / r.jerk;
  }

  Cause cause_of_acceleration() const {
    return limits_.dynamics_cause.empty() ? Cause::acceleration : limits_.dynamics_cause[limits_.ramp[block_]];
  }

  /// The lowest cap that is touched where the speed bends upwards.
  std::optional<Cause> cause_of_valley(const Piece& piece) const {
    const double begin = piece.phase.begin + piece.begin, end = piece.phase.begin + piece.end;
    std::optional<Cause> cause;
    double lowest = 0;
    const auto touch = [&](double speed, double cap, Cause of) {
      if (speed >= cap * (1 - kTouch) && (!cause || cap < lowest)) {
        cause = of;
        lowest = cap;
      }
    };
    std::size_t node = block_;
    while (node > 0 && time_[node - 1] >= begin - slack_) --node;
    for (; node < time_.size() && time_[node] <= end + slack_; ++node) {
      if (time_[node] < begin - slack_) continue;
      touch(speed_at(piece, time_[node]), limits_.node_cap[node], limits_.node_cause[node]);
    }
    if (cause) return cause;
    // Out of, or into, the cruise of a slower block.
    const std::size_t last = node == 0 ? 0 : std::min(node - 1, limits_.size() - 1);
    for (const std::size_t b : {block_ > 0 ? block_ - 1 : 0, block_, last}) {
      touch(speed_at(piece, begin), limits_.block_cap[b], limits_.block_cause[b]);
      touch(speed_at(piece, end), limits_.block_cap[b], limits_.block_cause[b]);
    }
    return cause;
  }

  static double speed_at(const Piece& piece, double time) {
    return evaluate(piece.phase, std::clamp(time - piece.phase.begin, piece.begin, piece.end)).speed;
  }

  const SpeedLimits& limits_;
  const MotionPlan& plan_;
  const std::vector<double>& time_;
  double slack_;
  std::size_t block_ = 0;
  Cause unexplained_ = Cause::jerk;
  std::vector<Restraint> out_;
};

}  // namespace

std::vector<Restraint> explain(const SpeedLimits& limits, const MotionPlan& plan, const std::vector<double>& node_time,
                               const PlanOptions& options) {
  if (limits.size() == 0) return {};
  return Explainer(limits, plan, node_time, options).run();
}

const Restraint* restraint_at(const std::vector<Restraint>& restraints, double time) {
  const auto after = std::upper_bound(restraints.begin(), restraints.end(), time,
                                      [](double t, const Restraint& r) { return t < r.begin; });
  return after == restraints.begin() ? nullptr : &*std::prev(after);
}

std::array<double, kCauseCount> time_by_cause(const std::vector<Restraint>& restraints) {
  std::array<double, kCauseCount> sum{};
  for (const Restraint& r : restraints) sum[static_cast<std::size_t>(r.cause)] += r.end - r.begin;
  return sum;
}

}  // namespace toolpace
