#include "toolpace/plan/hold.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "toolpace/base/numbers.h"
#include "toolpace/law/law_table.h"
#include "toolpace/plan/brake.h"
#include "toolpace/plan/plan.h"

namespace toolpace {
namespace {

using detail::brake;
using detail::Brakes;
constexpr PhaseShape kJerk = PhaseShape::constant_jerk;
/// Share of the path's length below which two places are the same.
constexpr double kSamePlace = 1e-12;
/// Share of a phase's duration below which two moments are the same.
constexpr double kSameMoment = 1e-12;
/// Share of a cap by which the stop may pass it: rounding.
constexpr double kRounding = 1e-9;

double end_of(const std::vector<Phase>& phases) {
  return phases.empty() ? 0.0 : evaluate(phases.back(), phases.back().duration).distance;
}

class HoldInserter {
 public:
  HoldInserter(const SpeedLimits& limits, const MotionPlan& plan, const PlanOptions& options, const Hold& hold)
      : limits_(limits), plan_(plan), options_(options), hold_(hold), position_(node_positions(limits)) {}

  Result<MotionPlan> run(const Monitor& monitor) {
    find_start();
    MotionPlan result;
    result.phases.assign(plan_.phases.begin(), plan_.phases.begin() + static_cast<std::ptrdiff_t>(phase_));
    result.phases.insert(result.phases.end(), head_.begin(), head_.end());
    const double begin = result.cycle_time();
    for (Phase p : stop_) {
      p.begin += begin;
      p.node = node_;
      p.distance += state_.distance;
      result.phases.push_back(p);
    }
    const double at = state_.distance + end_of(stop_);
    if (hold_.pause > 0) result.phases.push_back({result.cycle_time(), hold_.pause, at, 0, 0, 0, kJerk, node_});
    auto rest = plan_rest(at, monitor);
    if (!rest) return tl::make_unexpected(rest.error());
    append_rest(*rest, at, result);
    return result;
  }

 private:
  double length() const { return position_.back(); }
  /// Path position where the stop begins.
  double here() const { return position_[node_] + state_.distance; }

  /// The first moment from the wanted one on at which a stop fits.
  void find_start() {
    const double last = plan_.cycle_time();
    double t = hold_.time, step = last * 1e-6;
    for (;;) {
      while (phase_ + 1 < plan_.phases.size() && plan_.phases[phase_ + 1].begin <= t) ++phase_;
      const Phase& p = plan_.phases[phase_];
      const bool rests = is_resting(p) || t >= last;
      cut(p, rests ? p.duration : std::clamp(t - p.begin, 0.0, p.duration));
      if (rests || find_stop()) return;
      // Later in this phase, or at its end; after some trials in larger steps.
      const double next = std::min(t + step, p.begin + p.duration);
      t = next > t ? next : std::nextafter(t, 2 * last);
      step *= 1.05;
    }
  }

  /// Keeps the phase's first `time` seconds.
  void cut(const Phase& p, double time) {
    head_.clear();
    stop_.clear();
    if (!(time > kSameMoment * p.duration)) time = 0;  // nothing is left to cut into pieces
    state_ = evaluate(p, time);
    node_ = p.node;
    if (time == 0) return;
    if (p.shape == kJerk || time >= p.duration) {
      head_.push_back(p);
      head_.back().duration = time;
    } else {
      cut_quintic(p, time);
    }
  }

  /// A part of a quintic is none of the ramps a plan may hold; pieces of constant jerk, each with the quintic's
  /// acceleration at its ends, stand in for it. Their jerk is a mean of the quintic's, so it keeps the limit; the speed is
  /// off by (time/64)²/12 of the jerk at the cut.
  void cut_quintic(const Phase& p, double time) {
    constexpr int kPieces = 64;
    Phase piece{p.begin, time / kPieces, p.distance, p.speed, p.acceleration, 0, kJerk, p.node};
    for (int i = 1; i <= kPieces; ++i) {
      piece.rate = (evaluate(p, time * i / kPieces).acceleration - piece.acceleration) / piece.duration;
      head_.push_back(piece);
      state_ = evaluate(piece, piece.duration);
      piece.begin = p.begin + time * i / kPieces;
      piece.distance = state_.distance;
      piece.speed = state_.speed;
      piece.acceleration = state_.acceleration;
    }
  }

  double start_of(const Phase& p) const { return position_[p.node] + p.distance; }

  static bool is_resting(const Phase& p) { return p.speed == 0 && p.rate == 0 && p.acceleration == 0; }

  std::size_t block_at(double distance) const {
    const auto after = std::upper_bound(position_.begin(), position_.end(), distance);
    const auto index = static_cast<std::size_t>(after - position_.begin());
    return std::min(index == 0 ? 0 : index - 1, limits_.size() - 1);
  }

  /// Brakes with the smallest limits of the blocks that the stop takes.
  bool find_stop() {
    const std::size_t first = block_at(here());
    Brakes brakes = brakes_of(first);
    std::size_t reached = first;
    for (;;) {
      auto phases = brake(std::max(0.0, state_.speed), state_.acceleration, brakes);
      if (!phases) return false;
      const double end = here() + end_of(*phases);
      if (end > length() * (1 + kSamePlace)) return false;
      const std::size_t last = block_at(end);
      if (last <= reached) {
        stop_ = std::move(*phases);
        return keeps_limits(first, last);
      }
      for (; reached < last; ++reached) {
        const Brakes next = brakes_of(reached + 1);
        brakes.deceleration = std::min(brakes.deceleration, next.deceleration);
        brakes.jerk = std::min(brakes.jerk, next.jerk);
        brakes.release = std::min(brakes.release, next.release);
      }
    }
  }

  Brakes brakes_of(std::size_t block) const {
    const Dynamics& d = limits_.dynamics_of(block);
    const double unlimited = std::numeric_limits<double>::infinity();
    const bool bounded = law_row(options_.law).bounds_jerk;
    return {d.down.acceleration, bounded ? d.down.jerk : unlimited, bounded ? d.up.jerk : unlimited};
  }

  /// Whether the stop stays below the caps, and an acceleration that it began with below what the next blocks allow.
  bool keeps_limits(std::size_t first, std::size_t last) const {
    for (std::size_t block = first;; ++block) {
      if (highest_in(block) > limits_.block_cap[block] * (1 + kRounding)) return false;
      if (block == last) return true;
      const PhaseState there = state_at(position_[block + 1]);
      const Dynamics& next = limits_.dynamics_of(block + 1);
      if (there.speed > limits_.node_cap[block + 1] * (1 + kRounding) + kRounding) return false;
      if (there.acceleration > next.up.acceleration * (1 + kRounding)) return false;
      if (-there.acceleration > next.down.acceleration * (1 + kRounding)) return false;
    }
  }

  /// Braking speeds fall, except while a positive acceleration is taken away.
  double highest_in(std::size_t block) const {
    double highest = state_at(std::max(position_[block], here())).speed;
    for (const Phase& p : stop_) {
      const double at = here() + p.distance;
      if (at >= position_[block] && at <= position_[block + 1]) highest = std::max(highest, p.speed);
    }
    return highest;
  }

  /// State of the stop at a place.
  PhaseState state_at(double distance) const {
    const double way = distance - here();
    for (const Phase& p : stop_) {
      if (evaluate(p, p.duration).distance < way) continue;
      double low = 0, high = p.duration;
      for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (evaluate(p, middle).distance < way ? low : high) = middle;
      }
      return evaluate(p, low);
    }
    return {distance, 0, 0, 0};
  }

  /// Plans from the stop to the end.
  /// @param at  from node_
  Result<MotionPlan> plan_rest(double at, const Monitor& monitor) {
    std::size_t first = block_at(position_[node_] + at);
    double left = position_.between(node_, first + 1) - at;
    if (left <= kSamePlace * length() && first + 1 <= limits_.size()) {
      ++first;
      left = first < limits_.size() ? limits_.length[first] : 0.0;
    }
    rest_ = static_cast<std::uint32_t>(first);
    if (first >= limits_.size()) return MotionPlan{};
    SpeedLimits rest = slice(limits_, first, limits_.size());
    rest.length.front() = left;
    return plan_motion(rest, options_, monitor);
  }

  /// Adds the new plan behind the stop, with the pauses that the old one had there.
  void append_rest(const MotionPlan& rest, double at, MotionPlan& result) const {
    const double same = kSamePlace * length();
    double begin = result.cycle_time();
    std::size_t old = phase_ + 1;
    const auto add_pauses = [&](double upto, double time) {
      for (; old < plan_.phases.size() && start_of(plan_.phases[old]) <= upto; ++old) {
        if (!is_resting(plan_.phases[old])) continue;
        result.phases.push_back(plan_.phases[old]);
        result.phases.back().begin = begin + time;
        begin += plan_.phases[old].duration;
      }
    };
    for (Phase p : rest.phases) {
      if (p.node == 0) {  // where the stop is
        p.node = node_;
        p.distance += at;
      } else {
        p.node += rest_;
      }
      if (p.speed == 0) add_pauses(start_of(p) + same, p.begin);
      p.begin += begin;
      result.phases.push_back(p);
    }
    add_pauses(length() + same, rest.cycle_time());
  }

  const SpeedLimits& limits_;
  const MotionPlan& plan_;
  const PlanOptions& options_;
  const Hold& hold_;
  NodePositions position_;
  std::size_t phase_ = 0;    ///< in which the hold begins
  std::uint32_t node_ = 0;   ///< from which it counts
  std::uint32_t rest_ = 0;   ///< first block of what is planned from the stop on
  std::vector<Phase> head_;  ///< what is left of it
  PhaseState state_{};       ///< at its end, its distance from the node
  std::vector<Phase> stop_;  ///< from there to rest, distances from there
};

}  // namespace

Result<void> check_hold(const Hold& hold) {
  if (hold.time >= 0 && hold.pause >= 0) return {};
  return tl::make_unexpected(
      Error{ErrorKind::usage, "hold-time", "a hold needs a time and a pause of 0 s or more", "", {}, {}});
}

Error hold_after_end(const Hold& hold, double cycle_time) {
  return {ErrorKind::infeasible,
          "hold-after-end",
          "the hold at " + to_text(hold.time) + " s (--hold-at-s) comes after the end of the program, which is at " +
              to_text(cycle_time) + " s",
          "choose a time before the end",
          {},
          cycle_time};
}

Result<MotionPlan> insert_hold(const SpeedLimits& limits, const MotionPlan& plan, const PlanOptions& options,
                               const Hold& hold, const Monitor& monitor) {
  if (auto checked = check_hold(hold); !checked) return tl::make_unexpected(checked.error());
  if (hold.time >= plan.cycle_time()) return tl::make_unexpected(hold_after_end(hold, plan.cycle_time()));
  return HoldInserter(limits, plan, options, hold).run(monitor);
}

}  // namespace toolpace
