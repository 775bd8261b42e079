#include "toolpace/plan/smooth/spline_restraint.h"

#include <algorithm>
#include <cmath>

#include "toolpace/limits/ceilings.h"

namespace toolpace {
namespace {

constexpr double kBinds = 0.9;  // share of a limit whose use holds the motion back

/// The limit used most so far.
struct Use {
  double share = 0;
  Cause cause = Cause::corner;
  void take(double value, double limit, Cause of) {
    if (!(limit < kUnlimited) || !(std::abs(value) > share * limit)) return;
    share = std::abs(value) / limit;
    cause = of;
  }
};

class SplineExplainer {
 public:
  SplineExplainer(const MotionPlan& plan, const Machine& machine, const Commands& commands,
                  const std::vector<double>& node_time)
      : plan_(plan),
        machine_(machine),
        under_program_(machines_under(machine, commands)),
        commands_(commands),
        node_time_(node_time) {}

  std::vector<Restraint> run(const std::vector<Restraint>& old) {
    std::size_t k = 0;
    double done = 0;  // everything before is in the new list
    const auto copy_to = [&](double end) {
      for (; k < old.size() && old[k].begin < end; ++k) {
        const double to = std::min(end, old[k].end);
        if (to > done) push(to, old[k].block, old[k].cause);
        if (old[k].end > end) break;
      }
      done = std::max(done, end);
    };
    for (const TimeSpline& spline : plan_.splines) {
      copy_to(spline.begin);
      add(spline);
      done = spline.begin + spline.duration();
      while (k < old.size() && old[k].end <= done) ++k;
    }
    copy_to(kUnlimited);
    return std::move(out_);
  }

 private:
  /// Each entry begins where the last one ends.
  void push(double end, std::uint32_t block, Cause cause) {
    if (!out_.empty() && out_.back().cause == cause) {
      out_.back().end = end;
    } else {
      out_.push_back({out_.empty() ? 0.0 : out_.back().end, end, block, cause});
    }
  }

  void add(const TimeSpline& spline) {
    const std::size_t cells = spline.points() - 3;
    for (std::size_t i = 0; i < cells; ++i) {
      const double begin = spline.begin + static_cast<double>(i) * spline.step;
      while (block_ + 2 < node_time_.size() && node_time_[block_ + 1] <= begin) ++block_;
      push(begin + spline.step, static_cast<std::uint32_t>(block_), cause_of(spline, i));
    }
  }

  Cause cause_of(const TimeSpline& spline, std::size_t cell) const {
    const auto axes = static_cast<std::size_t>(spline.axes);
    const double* c = spline.control.data() + cell * axes;
    AxisVector v = AxisVector::Zero(), a[2] = {v, v}, j = v;
    bool rests = true;
    for (std::size_t q = 0; q < axes; ++q) {
      const double c0 = c[q], c1 = c[axes + q], c2 = c[2 * axes + q], c3 = c[3 * axes + q];
      const auto axis = static_cast<Eigen::Index>(spline.axis[q]);
      rests = rests && c0 == c1 && c1 == c2 && c2 == c3;
      v[axis] = c2 - c1;
      a[0][axis] = c0 - 2 * c1 + c2;
      a[1][axis] = c1 - 2 * c2 + c3;
      j[axis] = c3 - 3 * (c2 - c1) - c0;
    }
    if (rests) return Cause::dwell;
    const double h = spline.step;
    Use use;
    take_speed(v / h, use);
    const Machine& m = under_program_[commands_[block_].ceiling];
    for (const AxisVector& part : a) {
      const double along = m.path.acceleration;
      take(part / (h * h), along, lowered(along, machine_.path.acceleration, Cause::acceleration), use);
      for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double limit = m.axes[k].acceleration;
        use.take(part[static_cast<Eigen::Index>(k)] / (h * h), limit,
                 lowered(limit, machine_.axes[k].acceleration, Cause::axis_acceleration));
      }
    }
    take(j / (h * h * h), machine_.path.jerk, Cause::jerk, use);
    for (std::size_t k = 0; k < kAxisCount; ++k) {
      use.take(j[static_cast<Eigen::Index>(k)] / (h * h * h), machine_.axes[k].jerk, Cause::jerk);
    }
    return use.share >= kBinds ? use.cause : Cause::corner;
  }

  void take_speed(const AxisVector& v, Use& use) const {
    const Command& command = commands_[block_];
    take(v, command.speed, command.cause, use);
    const Cause of_axis = command.is_rapid ? Cause::rapid : Cause::axis_speed;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
      const double limit = under_program_[command.ceiling].axes[k].speed;
      use.take(v[static_cast<Eigen::Index>(k)], limit, lowered(limit, machine_.axes[k].speed, of_axis));
    }
  }

  static Cause lowered(double limit, double own, Cause cause) { return limit < own ? Cause::program_limit : cause; }

  /// A limit of the path: of X Y Z together, or, where they stand still, of the rotary axes in degrees.
  static void take(const AxisVector& vector, double limit, Cause cause, Use& use) {
    use.take(Metric::along(vector.head<3>().isZero(0.0)).norm(vector), limit, cause);
  }

  const MotionPlan& plan_;
  const Machine& machine_;
  std::vector<Machine> under_program_;  // by ceiling
  const Commands& commands_;
  const std::vector<double>& node_time_;
  std::size_t block_ = 0;
  std::vector<Restraint> out_;
};

}  // namespace

std::vector<Restraint> explain_splines(const std::vector<Restraint>& restraints, const MotionPlan& plan,
                                       const Machine& machine, const Commands& commands,
                                       const std::vector<double>& node_time) {
  if (plan.splines.empty()) return restraints;
  return SplineExplainer(plan, machine, commands, node_time).run(restraints);
}

}  // namespace toolpace
