#include "plan_checker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

namespace toolpace::test {
namespace {

struct State {
  double s, v, a, j;
};

/// A phase that counts from the chain's begin.
struct PlacedPhase : Phase {};

/// Written out here once more, on purpose: the checker trusts none of the core's functions.
State state_at(const PlacedPhase& p, double t) {
  if (p.shape == PhaseShape::constant_jerk) {
    return {p.distance + t * (p.speed + t * (p.acceleration / 2 + t * p.rate / 6)),
            p.speed + t * (p.acceleration + t * p.rate / 2), p.acceleration + t * p.rate, p.rate};
  }
  const double T = p.duration, u = t / T, u2 = u * u, u3 = u2 * u;
  return {p.distance + p.speed * t + p.rate * T * u2 * u2 * (2.5 - 3 * u + u2),
          p.speed + p.rate * u3 * (10 - 15 * u + 6 * u2), p.rate / T * 30 * u2 * (1 - u) * (1 - u),
          p.rate / (T * T) * (60 * u - 180 * u2 + 120 * u3)};
}

double time_at(const PlacedPhase& p, double s) {
  double low = 0, high = p.duration;
  if (state_at(p, high).s <= s) return high;
  double t = high / 2;
  for (int i = 0; i < 200 && high - low > 1e-16 * p.duration; ++i) {
    const State x = state_at(p, t);
    if (std::abs(x.s - s) <= 1e-15 * s) break;
    (x.s < s ? low : high) = t;
    const double newton = x.v > 0 ? t - (x.s - s) / x.v : -1;
    t = newton > low && newton < high && i % 4 != 3 ? newton : (low + high) / 2;
  }
  return t;
}

class Measure {
 public:
  Measure(const SpeedLimits& limits, const MotionPlan& plan) : limits_(limits) {
    long double sum = 0;
    node_.push_back(0);
    for (const double length : limits.length) node_.push_back(static_cast<double>(sum += length));
    for (const Phase& p : plan.phases) {
      phases_.push_back({p});
      phases_.back().distance += node_[p.node];
    }
    top_ = *std::max_element(limits.block_cap.begin(), limits.block_cap.end());
  }

  PlanUse run() {
    for (std::size_t k = 0; k < phases_.size(); ++k) {
      if (k > 0) check_seam(phases_[k - 1], phases_[k]);
      walk(phases_[k]);
    }
    const State end = state_at(phases_.back(), phases_.back().duration);
    use_.end_position = std::abs(end.s - node_.back());
    use_.end_speed = std::abs(end.v);
    return use_;
  }

 private:
  void raise(double& slot, double value, const char* what, const PlacedPhase& p) {
    if (!(value > slot) && !std::isnan(value)) return;
    slot = std::isnan(value) ? 1e300 : value;
    if (value <= 1 + 1e-9) return;
    std::ostringstream text;
    text << what << " " << value << " in block " << block_ << " at t " << p.begin << " s " << p.distance << " for "
         << p.duration;
    use_.where = text.str();
  }

  void check_seam(const PlacedPhase& before, const PlacedPhase& after) {
    const State end = state_at(before, before.duration);
    const auto& d = limits_.dynamics_of(std::min(block_, limits_.size() - 1));
    use_.position_step = std::max(use_.position_step, std::abs(end.s - after.distance));
    use_.speed_step = std::max(use_.speed_step, std::abs(end.v - after.speed) / top_);
    use_.time_step = std::max(use_.time_step, std::abs(before.begin + before.duration - after.begin));
    const double limit = std::min(d.up.acceleration, d.down.acceleration);
    if (!std::isfinite(limit)) return;
    // Going back, the path's direction changes its sign, and with it an acceleration that does not.
    const double same = std::abs(end.a - after.acceleration), back = std::abs(end.a + after.acceleration);
    const bool turns = after.speed == 0 && after.distance == node_[after.node] &&
                       std::binary_search(limits_.reversals.begin(), limits_.reversals.end(), after.node);
    use_.acceleration_step = std::max(use_.acceleration_step, (turns ? back : same) / limit);
  }

  /// Runs through the blocks that the phase covers.
  void walk(const PlacedPhase& p) {
    const double end = state_at(p, p.duration).s;
    double t = 0;
    for (;;) {
      const bool leaves = block_ + 1 < node_.size() && node_[block_ + 1] <= end && block_ + 1 < limits_.size();
      const double next = leaves ? time_at(p, node_[block_ + 1]) : p.duration;
      check_stretch(p, std::min(t, next), next);
      if (!leaves) return;
      ++block_;
      check_node(p, state_at(p, next).v);
      t = next;
    }
  }

  /// What a rounding of the place is worth in speed², by the accelerations around the present block.
  double place_slack(double share) const {
    double a = 0;
    for (std::size_t i = block_ > 0 ? block_ - 1 : 0; i <= std::min(block_ + 1, limits_.size() - 1); ++i) {
      a = std::max({a, limits_.dynamics_of(i).up.acceleration, limits_.dynamics_of(i).down.acceleration});
    }
    if (!std::isfinite(a)) a = 1e5;
    return 2 * a * (share * std::max(1.0, node_.back()));
  }

  void check_node(const PlacedPhase& p, double v) {
    const double cap = limits_.node_cap[block_];
    raise(use_.node_speed, (v * v) / (cap * cap + place_slack(1e-10)), "node speed", p);
  }

  void check_stretch(const PlacedPhase& p, double t0, double t1) {
    std::vector<double> times = {t0, t1};
    const auto add = [&](double t) {
      if (t > t0 && t < t1) times.push_back(t);
    };
    if (p.shape == PhaseShape::quintic) {
      for (const double u : {0.5, (3 - std::sqrt(3.0)) / 6, (3 + std::sqrt(3.0)) / 6}) add(u * p.duration);
    } else if (p.rate != 0) {
      add(-p.acceleration / p.rate);
    }
    const auto& d = limits_.dynamics_of(block_);
    for (const double t : times) {
      const State x = state_at(p, t);
      const double cap = limits_.block_cap[block_];
      raise(use_.block_speed, x.v / std::sqrt(cap * cap + place_slack(1e-12)), "speed", p);
      use_.lowest_speed = std::min(use_.lowest_speed, x.v);
    }
    // A phase that ends at a node may reach past it by a rounding of the position, which is no time at all, except near
    // a rest, where it takes the cube root of that.
    if (state_at(p, t1).s - state_at(p, t0).s < 1e-12 * std::max(1.0, node_.back())) return;
    for (const double t : times) {
      const State x = state_at(p, t);
      raise(use_.acceleration, x.a > 0 ? x.a / d.up.acceleration : -x.a / d.down.acceleration, "acceleration", p);
      if (p.shape == PhaseShape::quintic) {
        raise(use_.jerk, std::abs(x.j) / (p.rate > 0 ? d.up.jerk : d.down.jerk), "jerk", p);
      }
    }
    if (p.shape == PhaseShape::quintic) return;
    // Constant jerk: it belongs to speeding up where the acceleration is positive inside the stretch.
    const double a0 = p.acceleration + t0 * p.rate, a1 = p.acceleration + t1 * p.rate;
    const double rounding = 1e-7 * std::max(std::abs(p.acceleration), std::abs(p.acceleration + p.duration * p.rate));
    if (std::max(a0, a1) > rounding) raise(use_.jerk, std::abs(p.rate) / d.up.jerk, "jerk", p);
    if (std::min(a0, a1) < -rounding) raise(use_.jerk, std::abs(p.rate) / d.down.jerk, "jerk", p);
  }

  const SpeedLimits& limits_;
  std::vector<PlacedPhase> phases_;
  std::vector<double> node_;
  std::size_t block_ = 0;
  double top_ = 0;
  PlanUse use_;
};

}  // namespace

PlanUse measure(const SpeedLimits& limits, const MotionPlan& plan) { return Measure(limits, plan).run(); }

std::string find_offence(const SpeedLimits& limits, const MotionPlan& plan, const CheckOptions& options) {
  if (plan.phases.empty()) return "no phases";
  const PlanUse use = measure(limits, plan);
  const double top = *std::max_element(limits.block_cap.begin(), limits.block_cap.end());
  double total = 0;
  for (const double length : limits.length) total += length;
  std::ostringstream out;
  const auto check = [&](const char* what, double value, double limit) {
    if (!(value <= limit)) out << what << " " << value << " > " << limit << "; ";
  };
  const double most = 1 + options.tolerance;
  check("block speed", use.block_speed, most);
  check("node speed squared", use.node_speed, most);
  check("acceleration", use.acceleration, most);
  if (options.jerk) check("jerk", use.jerk, most);
  if (options.continuous_acceleration) check("acceleration step", use.acceleration_step, 1e-6);
  check("speed step", use.speed_step, 1e-9);
  check("position step", use.position_step, 1e-10 * std::max(1.0, total));
  check("time step", use.time_step, 1e-10 * std::max(1.0, plan.cycle_time()));
  check("end position", use.end_position, 1e-10 * std::max(1.0, total));
  check("end speed", use.end_speed, 1e-6 * top);
  check("negative speed", -use.lowest_speed, 1e-9 * top);
  if (!std::isfinite(plan.cycle_time())) out << "cycle time is not finite; ";
  return out.str().empty() ? "" : out.str() + use.where;
}

}  // namespace toolpace::test
