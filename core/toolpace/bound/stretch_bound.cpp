#include "toolpace/bound/stretch_bound.h"

#include <algorithm>
#include <cmath>

#include "toolpace/bound/envelope.h"
#include "toolpace/bound/timing_dual.h"
#include "toolpace/law/law_table.h"
#include "toolpace/limits/ceilings.h"
#include "toolpace/limits/curve_axes.h"
#include "toolpace/plan/plan.h"
#include "toolpace/plan/retime/stretch_retimer.h"

namespace toolpace::detail {
namespace {

using retime::ArcMotion;

constexpr double kCell = 0.004;  // [s]
constexpr std::size_t kLeastCells = 24, kMostCells = 4000;
constexpr double kNear = 0.99;            // of a plan's time: nothing to add
constexpr double kQuadrature = 1 - 3e-4;  // of the dual's value
constexpr double kSameCurvature = 1e-6;   // share of the larger one
constexpr double kStill = 1e-9;           // [mm/s]

/// The stretch as timings of it see it.
class TimedStretch {
 public:
  TimedStretch(const Outcome& outcome, std::size_t begin, std::size_t end)
      : path_(*outcome.path),
        commands_(*outcome.commands),
        machine_(under(outcome.job->machine, highest_ceiling(commands_, begin, end))),
        along_(machine_.path),
        axes_(curve_axes(machine_, true)),
        begin_(begin),
        end_(end) {
    const SpeedLimits part = slice(outcome.limits, begin, end);
    position_ = node_positions(part);
    PlanOptions options;
    options.law = LawKind::seven_phase;
    if (auto plan = plan_motion(part, options)) plan_ = std::move(*plan);
    for (std::size_t a = 0; a < kAxisCount; ++a) {
      if (moves(static_cast<Eigen::Index>(a))) rows_.push_back(a);
    }
  }

  double plan_time() const { return plan_.cycle_time(); }

  /// A motion near the fastest one.
  ArcMotion motion(const std::vector<double>& corner) const {
    ArcMotion start = retime::motion_of({plan_.phases, 0, 0.0, plan_time(), position_, 0, 0.0, position_.back(), {}});
    const retime::AlongLimits along{std::min(along_.acceleration, along_.deceleration),
                                    std::min(along_.jerk, along_.jerk_deceleration)};
    std::vector<double> speed;
    for (const Command& c : commands_) speed.push_back(c.speed);
    ArcMotion fast = retime::StretchRetimer({path_, axes_, along, speed, corner, begin_, end_}).run(start, {});
    return fast.empty() ? start : fast;
  }

  double bound(const ArcMotion& motion) {
    const double duration = motion.duration();
    const auto cells = std::max(kLeastCells, static_cast<std::size_t>(std::ceil(duration / kCell)));
    if (cells > kMostCells) return 0;
    const double cell = duration / static_cast<double>(cells);
    std::vector<TimingSample> samples;
    std::vector<std::size_t> joints;
    retime::PathSampler sampler(path_, begin_);
    const Envelope envelope = fastest_gain();
    std::size_t interval = 0;
    double knot = 0;
    for (std::size_t k = 0; k < cells; ++k) {
      for (const double place : kCellPlaces) {
        const double t = (static_cast<double>(k) + place) * cell;
        while (interval + 1 < motion.intervals() && knot + motion.step(interval) <= t) knot += motion.step(interval++);
        const ArcMotion::State s = motion.at(interval, (t - knot) / motion.step(interval));
        const std::size_t before = sampler.segment();
        sampler.go(s.distance);
        for (std::size_t i = before; i < sampler.segment(); ++i) add_joint(i, k, joints);
        samples.push_back(sample(s, sampler, envelope));
      }
    }
    return TimingDual(cell, std::move(samples), limits(), joints).maximise() * kQuadrature;
  }

 private:
  bool moves(Eigen::Index axis) const {
    for (std::size_t i = begin_; i < end_; ++i) {
      if (path_.node[i][axis] != path_.node[i + 1][axis]) return true;
      if (path_.kind[i] != SegmentKind::line && frame_at(path_, i, path_.length[i] / 2).second[axis] != 0) return true;
    }
    return false;
  }

  /// Curvature steps from one segment to the next.
  void add_joint(std::size_t segment, std::size_t cell, std::vector<std::size_t>& joints) const {
    const AxisVector end = frame_at(path_, segment, path_.length[segment]).second;
    const AxisVector begin = frame_at(path_, segment + 1, 0.0).second;
    if ((end - begin).norm() <= kSameCurvature * std::max(end.norm(), begin.norm())) return;
    if (cell > 0) joints.push_back(cell - 1);
    joints.push_back(cell);
  }

  /// More than any motion gains from a rest.
  Envelope fastest_gain() const {
    double acceleration = 0, jerk = 0, top = 0, bend = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      acceleration = std::hypot(acceleration, axes_[a].acceleration);
      jerk = std::hypot(jerk, axes_[a].jerk);
    }
    for (std::size_t i = begin_; i < end_; ++i) {
      if (path_.kind[i] == SegmentKind::line) continue;
      const CurveBounds b = curve_bounds(path_, i);
      // No motion turns faster than all axes together do.
      const double square = acceleration / std::max(least_curvature(i), 1e-12);
      top = std::max(top, std::min(commands_[i].speed, std::sqrt(square)));
      bend = std::max(bend, b.second.head<3>().squaredNorm());
    }
    return {std::min(acceleration, std::max(along_.acceleration, along_.deceleration)),
            std::min(jerk + bend * top * top * top, std::max(along_.jerk, along_.jerk_deceleration))};
  }

  double least_curvature(std::size_t i) const {
    return path_.kind[i] == SegmentKind::arc ? frame_at(path_, i, path_.length[i] / 2).second.head<3>().norm() / 1.01
                                             : 0;
  }

  TimingSample sample(const ArcMotion::State& s, const retime::PathSampler& sampler, const Envelope& envelope) const {
    const auto d = sampler.derivatives<static_cast<int>(kAxisCount)>();
    const double v = std::max(s.speed, kStill), length = position_.back();
    TimingSample out{};
    double top = commands_[sampler.segment()].speed;
    top = std::min({top, envelope.after(0, s.distance), envelope.after(0, std::max(0.0, length - s.distance))});
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const auto i = static_cast<Eigen::Index>(rows_[r]);
      out.first[r] = d.first[i] * v;
      out.second[r] = d.second[i] * v * v + d.first[i] * s.acceleration;
      if (d.first[i] != 0) top = std::min(top, axes_[rows_[r]].speed / std::abs(d.first[i]));
    }
    out.first[rows_.size()] = v;
    out.second[rows_.size()] = s.acceleration;
    out.fastest = std::max(1e-6, (top / v) * (top / v));
    return out;
  }

  TimingLimits limits() const {
    TimingLimits limits;
    for (const std::size_t a : rows_) {
      limits.acceleration[limits.rows] = axes_[a].acceleration;
      limits.jerk[limits.rows++] = axes_[a].jerk;
    }
    limits.acceleration[limits.rows] = std::max(along_.acceleration, along_.deceleration);
    limits.jerk[limits.rows++] = std::max(along_.jerk, along_.jerk_deceleration);
    return limits;
  }

  const Path& path_;
  const Commands& commands_;
  Machine machine_;  ///< under the highest limits that the program sets on the way
  const PathLimits& along_;
  std::array<AxisLimits, kAxisCount> axes_;
  std::size_t begin_, end_;
  NodePositions position_;
  MotionPlan plan_;
  std::vector<std::size_t> rows_;
};

}  // namespace

bool has_timing_bound(const Outcome& outcome, std::size_t begin, std::size_t end) {
  if (!law_row(outcome.job->options.law).bounds_jerk || !outcome.path->tellings.empty()) return false;
  bool is_curved = false;
  for (std::size_t i = begin; i < end; ++i) {
    is_curved |= outcome.path->kind[i] != SegmentKind::line;
    if (is_rotary_only(*outcome.path, i)) return false;
    const Cause cause = outcome.limits.node_cause[i];
    if (i > begin && (cause == Cause::corner || cause == Cause::stop)) return false;
  }
  return is_curved;
}

double timing_bound(const Outcome& outcome, std::size_t begin, std::size_t end, double known) {
  TimedStretch stretch(outcome, begin, end);
  if (!(stretch.plan_time() > 0) || known >= kNear * stretch.plan_time()) return 0;
  const std::vector<double> corner(outcome.path->size() + 1, kUnlimited);
  return stretch.bound(stretch.motion(corner));
}

}  // namespace toolpace::detail
