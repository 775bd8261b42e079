#include "toolpace/plan/smooth/plan_tube.h"

#include <algorithm>
#include <cmath>

#include "toolpace/plan/smooth/exact_motion.h"
#include "toolpace/plan/smooth/first_motion.h"
#include "toolpace/plan/smooth/hold_window.h"
#include "toolpace/plan/smooth/pass_through.h"
#include "toolpace/plan/smooth/task_progress.h"
#include "toolpace/plan/smooth/window_optimiser.h"

namespace toolpace {
namespace {

using detail::tube::MotionWindow;
using detail::tube::StepLimits;

constexpr std::size_t kWindow = 3000;  ///< control points of a first motion that a window should have
constexpr std::size_t kBatch = 64;     ///< windows that are worked on at a time
constexpr std::size_t kMostSegments = 4096;

template <int D>
class Planner {
  /// A window after optimisation; its control points before `from` belong to the bridge before it.
  struct Planned {
    MotionWindow<D> window;
    std::size_t from = 0;
    double deviation = 0;
    bool stops = false;
    bool counted = false;
  };

 public:
  Planner(const TubePath& path, const StepLimits& limits, const ForEach& for_each, const Monitor& monitor)
      : path_(path), limits_(limits), for_each_(for_each), monitor_(monitor), progress_(monitor, 2 * path.segments()) {}

  Result<TubeMotion> plan(const std::optional<TubeHold>& hold) {
    motion_.step = limits_.step;
    std::vector<Planned> batch;
    std::size_t at = 0;
    while (at < path_.segments() && !monitor_.is_cancelled()) {
      const std::size_t old = batch.size();
      add_first_motions(batch, at);
      at_each(batch.size() - old, [&](std::size_t i) { optimise(batch[old + i]); });
      join(batch);
      batch.erase(batch.begin(), batch.end() - 1);
    }
    if (monitor_.is_cancelled()) return tl::unexpected(cancelled_error());
    append(batch.back().window, batch.back().from, batch.back().window.size());
    if (hold && !insert_hold(*hold)) return tl::unexpected(cancelled_error());
    finish();
    return std::move(motion_);
  }

  template <class Task>
  void at_each(std::size_t count, Task task) {
    for_each_(count, [&](std::size_t i) {
      if (!monitor_.is_cancelled()) task(i);
    });
  }

  /// First motions of the next windows; their sizes are chosen by trying.
  void add_first_motions(std::vector<Planned>& batch, std::size_t& at) {
    for (std::size_t made = 0; made < kBatch && at < path_.segments() && !monitor_.is_cancelled(); ++made) {
      std::size_t count = std::min(guess_, path_.segments() - at);
      auto m = detail::tube::FirstMotion<D>(path_, limits_, at, at + count).make();
      while (m.size() > 2 * kWindow && count > 1) {
        count = std::max<std::size_t>(1, count * kWindow / m.size());
        m = detail::tube::FirstMotion<D>(path_, limits_, at, at + count).make();
      }
      guess_ = std::clamp<std::size_t>(count * kWindow / m.size(), 1, kMostSegments);
      at += count;
      batch.emplace_back().window = std::move(m);
    }
  }

  void optimise(Planned& p) {
    const std::size_t segments = p.window.pass.size() + 1;
    detail::tube::WindowOptimiser<D> optimiser(path_, limits_);
    p.stops = !improve(optimiser, p.window);
    p.deviation = optimiser.check().deviation(p.window);
    progress_.add(segments);
  }

  /// @return false if a part of the window had to be left with stops
  bool improve(detail::tube::WindowOptimiser<D>& optimiser, MotionWindow<D>& m) {
    const std::size_t begin = m.first, end = begin + m.pass.size() + 1, middle = (begin + end) / 2;
    if (optimiser.improve(m, monitor_)) return true;
    if (middle == begin || monitor_.is_cancelled()) {
      m = detail::tube::exact_motion<D>(path_, limits_, begin, end);
      return false;
    }
    // Whatever resists sits somewhere: halves, with a stop between them, save the rest.
    m = detail::tube::FirstMotion<D>(path_, limits_, begin, middle).make();
    MotionWindow<D> rest = detail::tube::FirstMotion<D>(path_, limits_, middle, end).make();
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
    return static_cast<std::size_t>(std::clamp(1.5 * most, 60.0, 250.0)) + 40;
  }

  /// Removes the stops between neighbours: windows around them, from moving to moving, planned anew, and writes all but
  /// the last window's rest, whose end is open.
  void join(std::vector<Planned>& batch) {
    const std::size_t far = reach();
    std::vector<Planned> bridge(batch.size() - 1);
    std::vector<std::size_t> left(bridge.size());
    for (std::size_t i = 0; i < bridge.size(); ++i) {
      const std::size_t size = batch[i].window.size();
      left[i] = std::max({size - std::min(far, size), size / 2, batch[i].from});
      batch[i + 1].from = std::min(far, batch[i + 1].window.size() / 2);
    }
    at_each(bridge.size(), [&](std::size_t i) {
      const MotionWindow<D> stopping = seam(batch[i].window, left[i], batch[i + 1].window, batch[i + 1].from);
      detail::tube::WindowOptimiser<D> optimiser(path_, limits_);
      bridge[i].window = detail::tube::PassThrough<D>(path_, limits_).apply(stopping);
      if (!optimiser.improve(bridge[i].window, monitor_) || bridge[i].window.size() > stopping.size()) {
        bridge[i].window = stopping;
        bridge[i].stops = true;
      }
      bridge[i].deviation = optimiser.check().deviation(bridge[i].window);
      progress_.add(bridge[i].window.pass.size());
    });
    for (std::size_t i = 0; i < batch.size(); ++i) {
      count(batch[i]);
      batch[i].deviation = 0;
      if (i == bridge.size()) break;
      append(batch[i].window, batch[i].from, left[i]);
      append(bridge[i].window, 0, bridge[i].window.size());
      count(bridge[i]);
    }
  }

  void count(Planned& p) {
    motion_.windows += p.counted ? 0 : 1;
    motion_.fallbacks += p.stops && !p.counted ? 1 : 0;
    motion_.deviation = std::max(motion_.deviation, p.deviation);
    p.counted = true;
  }

  /// Control points left… of a and …right of b, with the stop between them.
  static MotionWindow<D> seam(const MotionWindow<D>& a, std::size_t left, const MotionWindow<D>& b, std::size_t right) {
    MotionWindow<D> m;
    m.rest_begin = m.rest_end = false;
    m.first = a.first;
    m.c.assign(a.c.begin() + static_cast<std::ptrdiff_t>(left), a.c.end());
    for (const double u : a.pass) {
      if (u < static_cast<double>(left) + 1) {
        ++m.first;
      } else {
        m.pass.push_back(u - static_cast<double>(left));
      }
    }
    m.pass.push_back(static_cast<double>(m.c.size()) - 2);
    const double shift = static_cast<double>(m.c.size()) - 3;  // the stop's three points are shared
    m.c.insert(m.c.end(), b.c.begin() + 3, b.c.begin() + static_cast<std::ptrdiff_t>(right));
    for (const double u : b.pass) {
      if (u < static_cast<double>(right) - 2) m.pass.push_back(u + shift);
    }
    return m;
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

  /// @return false if it was cancelled
  bool insert_hold(const TubeHold& hold) {
    MotionWindow<D> whole;
    for (std::size_t i = 0; i < motion_.control.size(); i += D) {
      whole.c.push_back(Eigen::Map<const Eigen::Matrix<double, D, 1>>(motion_.control.data() + i));
    }
    if (hold.time > (static_cast<double>(whole.size()) - 3) * limits_.step) return true;
    whole.pass = std::move(motion_.pass);
    const auto rest = static_cast<std::size_t>(std::lround(hold.pause / limits_.step));
    const auto held = detail::tube::HoldWindow<D>(path_, limits_).apply(whole, 1 + hold.time / limits_.step, rest, monitor_);
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
  detail::tube::TaskProgress progress_;
  TubeMotion motion_;
  std::size_t guess_ = 256;
};

template <int D>
Result<TubeMotion> plan_in(const TubePath& path, const StepLimits& limits, const ForEach& for_each,
                           const Monitor& monitor, const std::optional<TubeHold>& hold) {
  return Planner<D>(path, limits, for_each, monitor).plan(hold);
}

/// The planner is compiled for 2, 3 and 6 coordinates; in between, coordinates that stand still are added and taken away.
Result<TubeMotion> plan_widened(const TubePath& path, int axes, const TubeLimits& limits, double period,
                                const ForEach& for_each, const Monitor& monitor, const std::optional<TubeHold>& hold) {
  TubePath wide = path;
  wide.axes = axes;
  if (wide.linear == 0) wide.linear = path.axes;
  wide.points.clear();
  for (std::size_t i = 0; i <= path.segments(); ++i) {
    wide.points.insert(wide.points.end(), path.point(i), path.point(i) + path.axes);
    wide.points.resize((i + 1) * static_cast<std::size_t>(axes), 0.0);
  }
  const StepLimits steps = detail::tube::step_limits(path, limits, period);
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
                             const Monitor& monitor, const std::optional<TubeHold>& hold) {
  if (!is_bounded(path, limits)) {
    return tl::unexpected(Error{ErrorKind::usage,
                                "tube-unbounded",
                                "neither acceleration nor jerk of a moving axis is bounded",
                                "give the path or every axis that moves an acceleration limit",
                                {},
                                {}});
  }
  if (path.axes == 2) return plan_in<2>(path, detail::tube::step_limits(path, limits, period), for_each, monitor, hold);
  const int axes = path.axes == 1 ? 2 : path.axes <= 3 ? 3 : 6;
  if (path.axes != axes) return plan_widened(path, axes, limits, period, for_each, monitor, hold);
  const StepLimits steps = detail::tube::step_limits(path, limits, period);
  return axes == 3 ? plan_in<3>(path, steps, for_each, monitor, hold)
                   : plan_in<6>(path, steps, for_each, monitor, hold);
}

}  // namespace toolpace
