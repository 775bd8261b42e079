#include "toolpace/bound/lower_bound.h"

#include <algorithm>
#include <cmath>

#include "toolpace/bound/path_bound.h"
#include "toolpace/bound/stretch_bound.h"
#include "toolpace/bound/tube_bound.h"
#include "toolpace/limits/ceilings.h"
#include "toolpace/limits/curve_bounds.h"
#include "toolpace/path/axis_curve.h"
#include "toolpace/path/blend_path.h"
#include "toolpace/path/build_path.h"
#include "toolpace/pipeline/job_rules.h"
#include "toolpace/pipeline/prove.h"

namespace toolpace {
namespace {

constexpr double kSameRadius = 1e-9;  // relative: an arc whose ends differ by more is a spiral

/// What X, Y and Z can do together on one curve.
struct Together {
  double acceleration = 0, jerk = 0;  ///< [mm/s², mm/s³], infinite where an axis that moves has no limit
};

Together axes_together(const CurveBounds& bounds, const Machine& machine) {
  Together together;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (bounds.first[i] == 0 && bounds.second[i] == 0 && bounds.third[i] == 0) continue;
    const double acceleration = std::min(machine.axes[k].acceleration, machine.path.acceleration);
    together.acceleration = std::hypot(together.acceleration, acceleration);
    together.jerk = std::hypot(together.jerk, machine.axes[k].jerk);
  }
  return together;
}

/// Curvature that a segment has everywhere [1/mm]: that of circles and helices; splines and corner curves may have none.
double least_curvature(const Path& path, std::size_t segment) {
  if (path.kind[segment] != SegmentKind::arc) return 0.0;
  const ArcCurve& arc = path.arcs[path.detail[segment]];
  if (std::abs(arc.end_radius - arc.start_radius) > kSameRadius * arc.start_radius) return 0.0;
  return frame_at(path, segment, path.length[segment] / 2).second.head<3>().norm() * (1 - kSameRadius);
}

class Opener {
 public:
  explicit Opener(const Outcome& outcome)
      : outcome_(outcome), path_(*outcome.path), curve_(path_), open_(outcome.limits) {}

  SpeedLimits run() {
    for (std::size_t i = 0; i < path_.size(); ++i) {
      if (!curve_.is_path(i)) {
        open_tip(i);
      } else if (path_.kind[i] != SegmentKind::line) {
        open_curve(i);
      }
    }
    for (std::size_t i = 1; i < path_.size(); ++i) {
      const Cause cause = outcome_.limits.node_cause[i];
      if (cause == Cause::corner || cause == Cause::stop || open_.node_cap[i] == 0) continue;
      open_.node_cap[i] = std::min(
          {open_.block_cap[i - 1], open_.block_cap[i], axes_cap(i - 1, path_.length[i - 1]), axes_cap(i, 0.0)});
    }
    return std::move(open_);
  }

 private:
  void open_curve(std::size_t i) {
    const Machine machine = under(outcome_.job->machine, outcome_.commands->ceiling_of(i));
    const CurveBounds bounds = curve_bounds(path_, i);
    const Together axes = axes_together(bounds, machine);
    const double curvature = least_curvature(path_, i);
    double cap = (*outcome_.commands)[i].speed;
    if (curvature > 0) cap = std::min(cap, std::sqrt(axes.acceleration / curvature));
    const double bend = bounds.second.head<3>().squaredNorm();
    const double jerk = axes.jerk + bend * cap * cap * cap;
    Dynamics d = outcome_.limits.dynamics_of(i);
    d.up.acceleration = std::min(machine.path.acceleration, axes.acceleration);
    d.down.acceleration = std::min(machine.path.deceleration, axes.acceleration);
    d.up.jerk = std::min(machine.path.jerk, jerk);
    d.down.jerk = std::min(machine.path.jerk_deceleration, jerk);
    open_.block_cap[i] =
        std::max(cap, open_.block_cap[i]);  // at a cusp the planner's cap is no bound either, but never 0
    if (!(open_.dynamics.back() == d)) {
      open_.dynamics.push_back(d);
      open_.dynamics_cause.push_back(Cause::axis_acceleration);
    }
    open_.ramp[i] = static_cast<std::uint32_t>(open_.dynamics.size() - 1);
  }

  /// About the tool's tip: inside it the path's own limits, and what the axes must do at its ends (axes_cap()).
  void open_tip(std::size_t i) {
    const Machine machine = under(outcome_.job->machine, outcome_.commands->ceiling_of(i));
    const PathLimits& p = machine.path;
    open_.block_cap[i] = std::max(open_.block_cap[i], (*outcome_.commands)[i].speed);
    const double time = outcome_.limits.dynamics_of(i).up.time, end_time = outcome_.limits.dynamics_of(i).down.time;
    open_.dynamics.push_back({{p.acceleration, p.jerk, time}, {p.deceleration, p.jerk_deceleration, end_time}});
    open_.dynamics_cause.push_back(Cause::acceleration);
    open_.ramp[i] = static_cast<std::uint32_t>(open_.dynamics.size() - 1);
  }

  /// The speed along the path beyond which no change of it keeps all axes inside their limits at a place about the tip: with q' and
  /// q'' by its length, |q'_k|·v ≤ V_k, and for some a |q'_k·a + q''_k·v²| ≤ A_k for all axes k. Of two axes, with slopes x = q'
  /// and turns y = q'', the bands in the plane of a and v² meet up to v² = (A₁|x₂| + A₂|x₁|) / |y₁x₂ − y₂x₁|.
  double axes_cap(std::size_t i, double s) const {
    if (curve_.is_path(i)) return kUnlimited;
    const Machine& machine = outcome_.job->machine;
    const Frame f = curve_.frame_at(i, s);
    double speed = kUnlimited, square = kUnlimited;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
      const auto one = static_cast<Eigen::Index>(k);
      const double x = f.first[one], y = f.second[one], most = machine.axes[k].acceleration;
      if (x != 0) speed = std::min(speed, machine.axes[k].speed / std::abs(x));
      for (std::size_t l = 0; l < k; ++l) {
        const auto other = static_cast<Eigen::Index>(l);
        const double apart = std::abs(y * f.first[other] - f.second[other] * x);
        const double room = most * std::abs(f.first[other]) + machine.axes[l].acceleration * std::abs(x);
        if (apart > 0 && room > 0) square = std::min(square, room / apart);
      }
    }
    return std::min(speed, std::sqrt(square)) * (1 + kSameRadius);
  }

  const Outcome& outcome_;
  const Path& path_;
  AxisCurve curve_;
  SpeedLimits open_;
};

}  // namespace

SpeedLimits open_limits(const Outcome& outcome) { return Opener(outcome).run(); }

namespace {

/// Sum over the stretches between the rests that every plan of the job makes.
double bound_along_path(const Outcome& outcome, const Monitor& monitor) {
  const SpeedLimits open = open_limits(outcome);
  const LawKind law = outcome.job->options.law;
  if (open.curved.empty()) return path_bound(open, law);
  double sum = 0;
  for (std::size_t begin = 0, end = 0; begin < open.size() && !monitor.is_cancelled(); begin = end) {
    for (end = begin + 1; end < open.size() && open.node_cap[end] > 0;) ++end;
    const double known = path_bound(slice(open, begin, end), law);
    const bool has_more = detail::has_timing_bound(outcome, begin, end);
    sum += has_more ? std::max(known, detail::timing_bound(outcome, begin, end, known)) : known;
  }
  return sum;
}

}  // namespace

Result<double> lower_bound(const Outcome& outcome, const Monitor& monitor) {
  const Job& job = *outcome.job;
  // Rounded corners lie in the tube, whichever way of planning rounds them.
  const bool leaves_path = is_through_tube(job) || blends_everywhere(job) || asks_for_blends(job.program->moves);
  if (!leaves_path) return bound_along_path(outcome, monitor) + outcome.summary.dwell_time;
  const auto programmed = build_path(job.program->moves, job.machine.tool_change, monitor);
  if (!programmed) return tl::unexpected(programmed.error());
  // Limits of X, Y and Z say nothing of how fast a tip may go that rotary axes carry.
  const bool is_about_axes = programmed->tellings.empty();
  const double tolerance = judged_tolerance(job.program->moves, job.options.corner);
  const Commands commands = command(*programmed, job);
  Machine machine = under(job.machine, highest_ceiling(commands, 0, commands.size()));
  if (!is_about_axes) std::fill_n(machine.axes.begin(), 3, AxisLimits{});
  return tube_bound(*programmed, commands, machine, tolerance) + outcome.summary.dwell_time;
}

}  // namespace toolpace
