#include "toolpace/plan/smooth/plan_tube.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "toolpace/plan/smooth/exact_motion.h"
#include "toolpace/plan/smooth/first_motion.h"
#include "toolpace/plan/smooth/hold_window.h"
#include "toolpace/plan/smooth/pass_through.h"
#include "toolpace/plan/smooth/stretches.h"
#include "toolpace/plan/smooth/task_progress.h"
#include "toolpace/plan/smooth/window_optimiser.h"

namespace toolpace {
namespace {

using detail::tube::MotionWindow;
using detail::tube::StepLimits;

/// Control points at either side of a stop that are planned anew without it: least, most, and what is added to the reach.
constexpr double kLeastReach = 60, kMostReach = 250, kQuickLeastReach = 24;
constexpr std::size_t kMoreReach = 40, kQuickMoreReach = 16;

template <int D>
class Planner {
  using Bound = detail::tube::Bound<D>;
  using Cruise = detail::tube::Cruise<D>;
  /// A window, after optimisation; its control points before `from` belong to the bridge before it.
  struct Planned {
    Bound begin, end;
    MotionWindow<D> window;
    std::size_t from = 0;
    double deviation = 0;
    bool stops = false;
    bool counted = false;
  };

 public:
  Planner(const TubePath& path, const StepLimits& limits, const ForEach& for_each, const Monitor& monitor)
      : path_(path),
        limits_(limits),
        for_each_(for_each),
        monitor_(monitor),
        middle_(path, limits),
        progress_(monitor, 2 * path.segments()) {}

  Result<TubeMotion> plan(const std::optional<TubeHold>& hold) {
    motion_.step = limits_.step;
    cruises_ = detail::tube::CruiseFinder<D>(path_, limits_, middle_).find();
    std::vector<Planned> windows = optimised();
    if (monitor_.is_cancelled()) return tl::unexpected(cancelled_error());
    join(windows);
    if (monitor_.is_cancelled()) return tl::unexpected(cancelled_error());
    if (hold && !insert_hold(*hold)) return tl::unexpected(cancelled_error());
    finish();
    return std::move(motion_);
  }

 private:
  template <class Task>
  void at_each(std::size_t count, Task task) {
    for_each_(count, [&](std::size_t i) {
      if (!monitor_.is_cancelled()) task(i);
    });
  }

  /// Windows from rest or cruise to rest or cruise. Where one resists, the cruises beside it are given up.
  std::vector<Planned> optimised() {
    std::vector<Planned> done;
    for (;;) {
      std::vector<Planned> windows = cut();
      std::vector<std::size_t> open;
      for (std::size_t i = 0, k = 0; i < windows.size(); ++i) {
        Planned& w = windows[i];
        while (k < done.size() && done[k].begin.place < w.begin.place) ++k;
        const bool is_known = k < done.size() && is_same(done[k].begin, w.begin) && is_same(done[k].end, w.end);
        if (is_known && done[k].window.size() > 0) {
          w = std::move(done[k]);
        } else {
          open.push_back(i);
        }
      }
      at_each(open.size(), [&](std::size_t i) { optimise(windows[open[i]]); });
      if (!give_up_cruises(windows) || monitor_.is_cancelled()) return windows;
      done = std::move(windows);
    }
  }

  static bool is_same(const Bound& a, const Bound& b) { return a.place == b.place && a.cruise == b.cruise; }

  /// Gives up the cruises beside windows that have no motion.
  bool give_up_cruises(std::vector<Planned>& windows) {
    bool any = false;
    for (Planned& w : windows) {
      if (w.window.size() > 0) continue;
      for (const Cruise* c : {w.begin.cruise, w.end.cruise}) {
        if (c) given_up_.insert(c);
      }
      any = true;
    }
    for (Planned& w : windows) {
      if (given_up_.count(w.begin.cruise) + given_up_.count(w.end.cruise) > 0) w.window = {};
    }
    return any;
  }

  std::vector<Planned> cut() const {
    std::vector<Planned> windows;
    for (const auto& stretch : detail::tube::StretchCutter<D>(middle_).cut(cruises_, given_up_)) {
      windows.push_back({stretch.begin, stretch.end, {}});
    }
    return windows;
  }

  MotionWindow<D> first_motion(const Bound& from, const Bound& to) const {
    return detail::tube::FirstMotion<D>(middle_, from, to).make();
  }
  Bound at_vertex(std::size_t i) const {
    Bound bound;
    bound.place = middle_.vertex_place(i);
    bound.vertex = i;
    return bound;
  }

  void optimise(Planned& p) {
    detail::tube::WindowOptimiser<D> optimiser(path_, limits_);
    p.window = first_motion(p.begin, p.end);
    const std::size_t segments = p.window.pass.size() + 1;
    if (p.begin.cruise || p.end.cruise) {
      if (!optimiser.improve(p.window, monitor_)) {
        p.window = {};
        return;
      }
    } else {
      p.stops = !improve(optimiser, p.window);
    }
    p.deviation = optimiser.check().deviation(p.window);
    progress_.add(segments);
  }

  /// Of a window from rest to rest.
  /// @return false if a part of the window had to be left with stops
  bool improve(detail::tube::WindowOptimiser<D>& optimiser, MotionWindow<D>& m) {
    const std::size_t begin = m.first, end = begin + m.pass.size() + 1, middle = (begin + end) / 2;
    if (optimiser.improve(m, monitor_)) return true;
    if (middle == begin || monitor_.is_cancelled()) {
      m = detail::tube::exact_motion<D>(path_, limits_, begin, end);
      return false;
    }
    // Whatever resists sits somewhere: halves, with a stop between them, save the rest.
    m = first_motion(at_vertex(begin), at_vertex(middle));
    MotionWindow<D> rest = first_motion(at_vertex(middle), at_vertex(end));
    improve(optimiser, m);
    improve(optimiser, rest);
    m = seam(m, 0, rest, rest.size());
    m.rest_begin = m.rest_end = true;
    return false;
  }

  /// Control points over which a stop is felt: the time to the top speed and some corners more.
  std::size_t reach() const {
    double most = 0;
    for (int a = 0; a < D; ++a) {
      double v = limits_.order[0][a];
      v = std::min(v, path_.feed.front() * limits_.step);
      double steps = 0;
      if (limits_.order[1][a] < TubeLimits::kNone) steps += v / limits_.order[1][a];
      if (limits_.order[2][a] < TubeLimits::kNone) {
        steps += std::min(limits_.order[1][a] / limits_.order[2][a], std::sqrt(v / limits_.order[2][a]));
      }
      if (std::isfinite(steps)) most = std::max(most, steps);
    }
    const bool is_quick = limits_.effort == TubeEffort::quick;
    const double least = is_quick ? kQuickLeastReach : kLeastReach;
    return static_cast<std::size_t>(std::clamp(1.5 * most, least, kMostReach)) +
           (is_quick ? kQuickMoreReach : kMoreReach);
  }

  /// Removes the stops between neighbours by windows around them, from moving to moving, planned anew, and writes all.
  void join(std::vector<Planned>& windows) {
    const std::size_t far = reach();
    std::vector<Planned> bridge(windows.size() - 1);
    std::vector<std::size_t> left(windows.size());
    for (std::size_t i = 0; i < windows.size(); ++i) {
      const std::size_t size = windows[i].window.size();
      left[i] = size;
      if (i == bridge.size() || windows[i].end.cruise) continue;
      left[i] = std::max({size - std::min(far, size), size / 2, windows[i].from});
      windows[i + 1].from = std::min(far, windows[i + 1].window.size() / 2);
    }
    at_each(bridge.size(), [&](std::size_t i) {
      if (!windows[i].end.cruise) {
        build_bridge(seam(windows[i].window, left[i], windows[i + 1].window, windows[i + 1].from), bridge[i]);
      }
    });
    for (std::size_t i = 0; i < windows.size(); ++i) {
      count(windows[i]);
      append(windows[i].window, windows[i].from, left[i]);
      if (i == bridge.size()) break;
      if (windows[i].end.cruise) {
        append(*windows[i].end.cruise);
      } else {
        append(bridge[i].window, 0, bridge[i].window.size());
        count(bridge[i]);
      }
    }
  }

  void build_bridge(MotionWindow<D>&& stopping, Planned& bridge) {
    detail::tube::WindowOptimiser<D> optimiser(path_, limits_);
    bridge.window = detail::tube::PassThrough<D>(path_, middle_).apply(stopping);
    if (!optimiser.improve(bridge.window, monitor_) || bridge.window.size() > stopping.size()) {
      bridge.window = std::move(stopping);
      bridge.stops = true;
    }
    bridge.deviation = optimiser.check().deviation(bridge.window);
    progress_.add(bridge.window.pass.size());
  }

  void count(Planned& p) {
    motion_.windows += p.counted ? 0 : 1;
    motion_.fallbacks += p.stops && !p.counted ? 1 : 0;
    motion_.deviation = std::max(motion_.deviation, p.deviation);
    p.counted = true;
  }

  /// Writes control points from … to − 1 of a window and the vertices passed between its neighbours.
  void append(const MotionWindow<D>& m, std::size_t from, std::size_t to) {
    const double shift = static_cast<double>(motion_.control.size() / D) - static_cast<double>(from);
    for (std::size_t k = from; k < to; ++k)
      motion_.control.insert(motion_.control.end(), m.c[k].data(), m.c[k].data() + D);
    const double low = from == 0 ? 0 : static_cast<double>(from) - 2;
    const double high = to == m.size() ? static_cast<double>(to) : static_cast<double>(to) + 1;
    for (const double u : m.pass) {
      if (u >= low && u < high) motion_.pass.push_back(u + shift);
    }
  }

  /// Writes a cruise behind the window before it and ahead of the one after it: three control points are shared with each.
  void append(const Cruise& cruise) {
    const MotionWindow<D>& m = cruise.motion;
    const double shift = static_cast<double>(motion_.control.size() / D) - 3;
    for (std::size_t k = 3; k + 3 < m.size(); ++k) {
      motion_.control.insert(motion_.control.end(), m.c[k].data(), m.c[k].data() + D);
    }
    for (const double u : m.pass) motion_.pass.push_back(u + shift);
    motion_.deviation = std::max(motion_.deviation, detail::tube::TubeCheck<D>(path_, limits_).deviation(m));
  }

  /// @return false if it was cancelled
  bool insert_hold(const TubeHold& hold) {
    MotionWindow<D> whole;
    for (std::size_t i = 0; i < motion_.control.size(); i += D) {
      whole.c.push_back(Eigen::Map<const Eigen::Matrix<double, D, 1>>(motion_.control.data() + i));
    }
    if (hold.time > (static_cast<double>(whole.size()) - 3) * limits_.step) return true;
    whole.pass = std::move(motion_.pass);
    const auto rest = static_cast<std::size_t>(std::lround(hold.pause / limits_.step));
    const auto held =
        detail::tube::HoldWindow<D>(path_, limits_).apply(whole, 1 + hold.time / limits_.step, rest, monitor_);
    if (!held) return false;
    motion_.control.clear();
    motion_.pass.clear();
    append(*held, 0, held->size());
    motion_.deviation = std::max(motion_.deviation, detail::tube::TubeCheck<D>(path_, limits_).deviation(*held));
    motion_.held = true;
    return true;
  }

  void finish() {
    motion_.duration = (static_cast<double>(motion_.control.size() / D) - 3) * limits_.step;
    for (double& u : motion_.pass) u = std::clamp((u - 1) * limits_.step, 0.0, motion_.duration);
    motion_.pass.insert(motion_.pass.begin(), 0.0);
    motion_.pass.push_back(motion_.duration);
  }

  const TubePath& path_;
  const StepLimits& limits_;
  const ForEach& for_each_;
  const Monitor& monitor_;
  const detail::tube::TubeMiddle<D> middle_;
  std::vector<Cruise> cruises_;
  std::set<const Cruise*> given_up_;
  detail::tube::TaskProgress progress_;
  TubeMotion motion_;
};

template <int D>
Result<TubeMotion> plan_in(const TubePath& path, const StepLimits& limits, const ForEach& for_each,
                           const Monitor& monitor, const std::optional<TubeHold>& hold) {
  return Planner<D>(path, limits, for_each, monitor).plan(hold);
}

/// The planner is compiled for 2, 3 and 6 coordinates; in between, coordinates that stand still are added and taken away.
Result<TubeMotion> plan_widened(const TubePath& path, int axes, const TubeLimits& limits, double period,
                                const ForEach& for_each, const Monitor& monitor, const std::optional<TubeHold>& hold,
                                TubeEffort effort) {
  TubePath wide = path;
  wide.axes = axes;
  if (wide.linear == 0) wide.linear = path.axes;
  wide.points.clear();
  for (std::size_t i = 0; i <= path.segments(); ++i) {
    wide.points.insert(wide.points.end(), path.point(i), path.point(i) + path.axes);
    wide.points.resize((i + 1) * static_cast<std::size_t>(axes), 0.0);
  }
  const StepLimits steps = detail::tube::step_limits(path, limits, period, effort);
  auto motion =
      axes == 2 ? plan_in<2>(wide, steps, for_each, monitor, hold) : plan_in<6>(wide, steps, for_each, monitor, hold);
  if (!motion) return motion;
  std::vector<double> control;
  for (std::size_t i = 0; i < motion->control.size(); i += static_cast<std::size_t>(axes)) {
    const auto at = motion->control.begin() + static_cast<std::ptrdiff_t>(i);
    control.insert(control.end(), at, at + path.axes);
  }
  motion->control.swap(control);
  return motion;
}

bool is_bounded(const TubePath& path, const TubeLimits& limits) {
  if (limits.path_acceleration < TubeLimits::kNone || limits.path_jerk < TubeLimits::kNone) return true;
  for (int a = 0; a < path.axes; ++a) {
    const auto axis = static_cast<std::size_t>(path.axis[static_cast<std::size_t>(a)]);
    if (!(limits.acceleration[axis] < TubeLimits::kNone || limits.jerk[axis] < TubeLimits::kNone)) return false;
  }
  return true;
}

}  // namespace

Result<TubeMotion> plan_tube(const TubePath& path, const TubeLimits& limits, double period, const ForEach& for_each,
                             const Monitor& monitor, const std::optional<TubeHold>& hold, TubeEffort effort) {
  if (!is_bounded(path, limits)) {
    return tl::unexpected(Error{ErrorKind::usage,
                                "tube-unbounded",
                                "neither acceleration nor jerk of a moving axis is bounded",
                                "give the path or every axis that moves an acceleration limit",
                                {},
                                {}});
  }
  if (path.axes == 2)
    return plan_in<2>(path, detail::tube::step_limits(path, limits, period, effort), for_each, monitor, hold);
  const int axes = path.axes == 1 ? 2 : path.axes <= 3 ? 3 : 6;
  if (path.axes != axes) return plan_widened(path, axes, limits, period, for_each, monitor, hold, effort);
  const StepLimits steps = detail::tube::step_limits(path, limits, period, effort);
  return axes == 3 ? plan_in<3>(path, steps, for_each, monitor, hold)
                   : plan_in<6>(path, steps, for_each, monitor, hold);
}

}  // namespace toolpace
