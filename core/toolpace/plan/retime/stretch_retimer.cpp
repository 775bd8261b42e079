#include "toolpace/plan/retime/stretch_retimer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "toolpace/path/axis_curve.h"

namespace toolpace::detail::retime {
namespace {

constexpr std::size_t kWindow = 256;               // intervals
constexpr double kHeadroom = 0.99;                 // of the limits, aimed at by the rounds
constexpr double kAimedShare = 0.9995;             // of the limits, aimed at where they are broken
constexpr int kLeastPlaces = 4, kMostPlaces = 12;  // of a curve in an interval
constexpr double kBetween = 2.0 / 8;               // of a second difference: a parabola rises by an eighth of it
constexpr int kMostSlowDowns = 12;
constexpr double kOpen = 1e6, kTouch = 1.0002;       // of b: no speed limit near; a little room where there is none
constexpr double kStill = 1e-9;                      // [mm/s]
constexpr double kUnknown = -1;                      // excess that has to be looked for
constexpr double kRounding = 1e-9;                   // of a speed that is kept up all the way
constexpr std::size_t kHeldEnd = 3;                  // intervals at a moving end that stay as they are
constexpr std::size_t kStretchReach = 3;             // intervals away in which a stretched one changes the motion
constexpr double kLeastReach = 6, kMostReach = 200;  // of a slow-down [intervals]

using Hurry = StretchRetimer::Hurry;

constexpr std::array<Hurry, 4> kHurries = {{{2e-3, 3, false}, {3e-4, 3, false}, {1e-4, 12, true}, {1e-4, 12, true}}};
/// Slower, but never far outside the limits: where the quick ones have gained less than this share, and where it costs little.
constexpr std::array<Hurry, 4> kCarefulHurries = {
    {{3e-3, 12, true}, {1e-3, 12, true}, {3e-4, 12, true}, {1e-4, 12, true}}};
constexpr double kGained = 0.03, kBrief = 10;  // [s]
/// A round is done again while it changes the duration by more than this share.
constexpr double kStillGains = 0.01;
constexpr int kMostRounds = 12;

/// The quadratic spline of b at share x of interval k.
double value(const std::vector<double>& b, std::size_t k, double x) {
  const double y = 1 - x;
  return (b[k] * y * y + b[k + 1] * (1 + 2 * x * y) + b[k + 2] * x * x) / 2;
}

/// ∫ du/√b over an interval, in intervals.
double time_of(const std::vector<double>& b, std::size_t k) {
  const double g = 0.3872983346207417;  // three-point Gauss rule
  return (5 / std::sqrt(value(b, k, 0.5 - g)) + 8 / std::sqrt(value(b, k, 0.5)) + 5 / std::sqrt(value(b, k, 0.5 + g))) /
         18;
}

}  // namespace

/// Derivatives of each axis by time, and the speed's ratio to the highest allowed.
struct StretchRetimer::Sample {
  std::array<double, kMostAxes> first, second, third;
  double speed_ratio;
};

StretchRetimer::StretchRetimer(const StretchTask& task) : task_(task) {
  AxisVector low = task.path.node[task.begin], high = low;
  for (std::size_t i = task.begin; i <= task.end; ++i) {
    low = low.cwiseMin(task.path.node[i]);
    high = high.cwiseMax(task.path.node[i]);
  }
  for (std::size_t a = 0; a < kAxisCount; ++a) {
    const auto i = static_cast<Eigen::Index>(a);
    bool moves = high[i] > low[i];
    // A full circle returns to where it began, and about the tool's tip every axis may go along with what turns.
    for (std::size_t k = task.begin; k < task.end && !moves && a < 3; ++k) {
      moves = task.path.kind[k] == SegmentKind::arc || task.path.chain_of(k) != nullptr;
    }
    if (moves) axes_.push_back(a);
  }
  is_limited_along_ = std::min(task.along.acceleration, task.along.jerk) < kUnlimited;
}

ArcMotion StretchRetimer::run(const ArcMotion& start, const Monitor& monitor) {
  ArcMotion quick = run(start, kHurries, monitor);
  const bool has_gained = quick.empty() || quick.duration() <= (1 - kGained) * start.duration();
  if (has_gained && start.duration() > kBrief) return quick;
  ArcMotion careful = run(start, kCarefulHurries, monitor);
  if (careful.empty() || quick.empty()) return careful.empty() ? quick : careful;
  return careful.duration() < quick.duration() ? careful : quick;
}

ArcMotion StretchRetimer::run(ArcMotion motion, std::span<const Hurry> hurries, const Monitor& monitor) {
  excess_.clear();
  int rounds = 0;
  for (const Hurry& h : hurries) {
    for (double before = 0, after = motion.duration();
         std::abs(after - before) > kStillGains * before && rounds < kMostRounds; ++rounds) {
      if (monitor.is_cancelled()) return {};
      if (h.is_slowed && find_peaks(motion) > 1.0) slow_down(motion);
      measure(motion, h.samples);
      motion = hurry(motion, rounds, h.weight);
      excess_.clear();
      before = after;
      after = motion.duration();
    }
  }
  double peak = find_peaks(motion);
  for (int round = 0; round < kMostSlowDowns && peak > 1.0; ++round) {
    slow_down(motion);
    peak = find_peaks(motion);
  }
  if (motion.ends().begin > 0 || motion.ends().end > 0) return peak > 1.0 ? ArcMotion() : motion;
  // What no interval uses is given to all, and what could not be mended where it is, is mended everywhere.
  if (peak < kAimedShare || peak > 1.0) motion.stretch(std::vector<double>(motion.intervals(), peak / kAimedShare));
  return motion;
}

void StretchRetimer::set_limits(double step, double share) {
  const double square = step * step * share, cube = step * step * step * share;
  limits_.count = axes_.size();
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    limits_.acceleration[i] = task_.axes[axes_[i]].acceleration * square;
    limits_.jerk[i] = task_.axes[axes_[i]].jerk * cube;
  }
  if (!is_limited_along_) return;
  limits_.acceleration[limits_.count] = task_.along.acceleration * square;
  limits_.jerk[limits_.count] = task_.along.jerk * cube;
  ++limits_.count;
}

StretchRetimer::Sample StretchRetimer::sample(const ArcMotion::State& s, const PathSampler& sampler) const {
  const bool turns = !axes_.empty() && is_rotary(axes_.back());
  return turns ? sample_along(s, sampler, sampler.derivatives<static_cast<int>(kAxisCount)>())
               : sample_along(s, sampler, sampler.derivatives<3>());
}

template <int rows>
StretchRetimer::Sample StretchRetimer::sample_along(const ArcMotion::State& s, const PathSampler& sampler,
                                                    const CurveDerivatives<rows>& d) const {
  const double v = s.speed, a = s.acceleration;
  Sample r;
  r.speed_ratio = v / task_.speed[sampler.segment()];
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(axes_[i]);
    r.first[i] = d.first[k] * v;
    r.second[i] = d.second[k] * v * v + d.first[k] * a;
    r.third[i] = d.third[k] * v * v * v + 3 * d.second[k] * v * a + d.first[k] * s.jerk;
    r.speed_ratio = std::max(r.speed_ratio, std::abs(r.first[i]) / task_.axes[axes_[i]].speed);
  }
  r.speed_ratio *= 1 - kRounding;
  if (is_limited_along_) {
    r.first[axes_.size()] = v;
    r.second[axes_.size()] = a;
    r.third[axes_.size()] = s.jerk;
  }
  return r;
}

/// Of each axis the sample counts that comes nearest to a limit.
void StretchRetimer::measure_interval(const ArcMotion& motion, std::size_t k, int samples, PathSampler& sampler) {
  const double last = motion.knot(k + 1).distance;
  IntervalUse& use = use_[k];
  const double h = motion.step(k), scale = motion.step(0) / h;
  std::array<double, kMostAxes> nearest;
  nearest.fill(-1.0);
  double fastest = 1 / std::sqrt(kOpen);
  sampler.go(motion.knot(k).distance);
  for (; sampler.end() < last && sampler.segment() + 1 < task_.end; sampler.enter_next()) {
    fastest = std::max(fastest, corner_ratio(motion, k, sampler));
  }
  for (int q = 0; q < samples; ++q) {
    const ArcMotion::State state = motion.at(k, (q + 0.5) / samples);
    sampler.go(state.distance);
    const Sample s = sample(state, sampler);
    fastest = std::max(fastest, s.speed_ratio);
    for (std::size_t a = 0; a < limits_.count; ++a) {
      const double x = std::abs(s.second[a]) * h * h * scale * scale / limits_.acceleration[a];
      const double y = std::abs(s.third[a]) * h * h * h * scale * scale * scale / limits_.jerk[a];
      if (!(std::max(x, y) > nearest[a])) continue;
      nearest[a] = std::max(x, y);
      use.first[a] = s.first[a] * h;
      use.second[a] = s.second[a] * h * h;
      use.third[a] = s.third[a] * h * h * h;
    }
  }
  use.fastest = std::max(1 / (fastest * fastest), kTouch);
}

/// Speed at the node at which the sampler's segment ends, inside interval k, as a part of what the corner allows.
double StretchRetimer::corner_ratio(const ArcMotion& motion, std::size_t k, const PathSampler& sampler) const {
  const double most = task_.corner[sampler.segment() + 1];
  return most < kUnlimited ? motion.at(k, motion.share_at(k, sampler.end(), 0.0)).speed / most : 0.0;
}

void StretchRetimer::measure(const ArcMotion& motion, int samples) {
  set_limits(motion.step(0), kHeadroom);
  use_.resize(motion.intervals());
  PathSampler sampler(task_.path, task_.begin);
  for (std::size_t k = 0; k < motion.intervals(); ++k) measure_interval(motion, k, samples, sampler);
}

/// By how much time has to be stretched in a stretch of an interval within one segment. Along a line acceleration is linear
/// and jerk is constant, so its ends tell all; on curves there are places between them, and what a peak between two places
/// may add is judged by the second differences.
double StretchRetimer::peak_of_piece(const ArcMotion& motion, std::size_t k, double from, double to,
                                     PathSampler& sampler) const {
  const bool is_line = AxisCurve(task_.path).is_straight(sampler.segment());
  const int parts =
      is_line ? 1 : std::clamp(static_cast<int>(std::ceil((to - from) * kMostPlaces)), kLeastPlaces, kMostPlaces);
  const double h = motion.step(0), part = (to - from) / parts * motion.step(k);
  double fastest = 0, most_acceleration = 0, most_jerk = 0;  // as parts of their limits
  std::array<Sample, 3> last;                                // of place q at q % 3
  for (int q = 0; q <= parts; ++q) {
    const ArcMotion::State state = motion.at(k, from + (to - from) * q / parts);
    sampler.go_inside(state.distance);
    const Sample& s = last[static_cast<std::size_t>(q) % 3] = sample(state, sampler);
    // The speed's parabola rises between two places if the acceleration changes its sign there.
    const double now = state.acceleration, change = state.jerk * part;
    const double rise = std::min(now * (now + change), now * (now - change)) < 0 ? std::abs(change) * part / 8 : 0.0;
    fastest = std::max(fastest, s.speed_ratio * (state.speed + rise) / std::max(state.speed, kStill));
    for (std::size_t a = 0; a < limits_.count; ++a) {
      double second = std::abs(s.second[a]), third = std::abs(s.third[a]);
      if (q >= 2) {
        const Sample &before = last[static_cast<std::size_t>(q - 2) % 3],
                     &middle = last[static_cast<std::size_t>(q - 1) % 3];
        const auto peak = [](double p, double m, double n) { return std::abs(m) + kBetween * std::abs(p - 2 * m + n); };
        second = std::max(second, peak(before.second[a], middle.second[a], s.second[a]));
        third = std::max(third, peak(before.third[a], middle.third[a], s.third[a]));
      }
      most_acceleration = std::max(most_acceleration, second * h * h / limits_.acceleration[a]);
      most_jerk = std::max(most_jerk, third * h * h * h / limits_.jerk[a]);
    }
  }
  return std::max({fastest, std::sqrt(most_acceleration), std::cbrt(most_jerk)});
}

/// Where curves meet their third derivatives step: each segment in the interval is looked at by itself, up to its ends.
double StretchRetimer::peak_of_interval(const ArcMotion& motion, std::size_t k, PathSampler& sampler) const {
  sampler.go(motion.knot(k).distance);
  const double last = motion.knot(k + 1).distance;
  double excess = 0;
  for (double from = 0;;) {
    const bool ends_beyond = sampler.end() >= last || sampler.segment() + 1 >= task_.end;
    const double to = ends_beyond ? 1.0 : motion.share_at(k, sampler.end(), from);
    excess = std::max(excess, peak_of_piece(motion, k, from, to, sampler));
    if (ends_beyond) return excess;
    excess = std::max(excess, corner_ratio(motion, k, sampler));
    sampler.enter_next();
    from = to;
  }
}

double StretchRetimer::find_peaks(const ArcMotion& motion) {
  set_limits(motion.step(0), 1.0);
  excess_.resize(motion.intervals(), kUnknown);
  PathSampler sampler(task_.path, task_.begin);
  double most = 0;
  for (std::size_t k = 0; k < motion.intervals(); ++k) {
    if (excess_[k] == kUnknown) excess_[k] = peak_of_interval(motion, k, sampler);
    most = std::max(most, excess_[k]);
  }
  return most;
}

/// Every other round the windows lie half a window further.
ArcMotion StretchRetimer::hurry(const ArcMotion& motion, int round, double weight) {
  const std::size_t n = motion.intervals();
  b_.assign(n + 2, 1.0);
  for (std::size_t begin = 0, end = round % 2 == 0 ? kWindow : kWindow / 2; begin < n; end = begin + kWindow) {
    if (end + kWindow / 4 > n) end = n;
    const auto& b = window_.run(use_.data() + begin, end - begin, limits_, begin > 0 || motion.ends().begin > 0,
                                end < n || motion.ends().end > 0, weight);
    std::copy(b.begin(), b.end(), b_.begin() + static_cast<std::ptrdiff_t>(begin));
    begin = end;
  }
  return resample(motion);
}

/// The motion run with u̇ = √b, on uniform knots in the new time.
ArcMotion StretchRetimer::resample(const ArcMotion& motion) const {
  const std::size_t n = motion.intervals();
  std::vector<double> time(n + 1, 0.0);
  for (std::size_t k = 0; k < n; ++k) time[k + 1] = time[k] + motion.step(k) * time_of(b_, k);
  const auto count = std::max(kLeastIntervals, static_cast<std::size_t>(std::ceil(time.back() / kInterval)));
  const double step = time.back() / static_cast<double>(count);
  std::vector<double> position(count + 1);
  std::size_t k = 0;
  for (std::size_t j = 0; j <= count; ++j) {
    const double t = static_cast<double>(j) * step;
    while (k + 1 < n && time[k + 1] <= t) ++k;
    // u by t is nearly a cubic: its third derivative √b·b″/2 hardly changes inside an interval.
    const double width = time[k + 1] - time[k], y = std::clamp((t - time[k]) / width, 0.0, 1.0), z = 1 - y;
    const double speed = width / motion.step(k);
    const double from = std::sqrt(value(b_, k, 0)) * speed, to = std::sqrt(value(b_, k, 1)) * speed;
    position[j] = motion.at(k, std::clamp(y * y * (3 - 2 * y) + y * z * (from * z - to * y), 0.0, 1.0)).distance;
  }
  position.front() = motion.knot(0).distance;
  position.back() = motion.knot(n).distance;
  return ArcMotion(position, step, motion.ends());
}

/// Stretches time smoothly around each interval that uses too much, so far that what this changes of acceleration and jerk is
/// a quarter of what it mends.
void StretchRetimer::slow_down(ArcMotion& motion) {
  const std::size_t n = motion.intervals();
  const double jerk =
      *std::min_element(limits_.jerk.begin(), limits_.jerk.begin() + static_cast<std::ptrdiff_t>(limits_.count));
  const double h = motion.step(0);
  std::vector<double> b(n, 1.0);
  for (std::size_t k = 0; k < n; ++k) {
    if (excess_[k] <= 1) continue;
    const double depth = 1 - kAimedShare * kAimedShare / (excess_[k] * excess_[k]);
    const ArcMotion::State s = motion.at(k, 0.5);
    const double reach = std::max(std::sqrt(10 * s.speed * h / jerk), 4 * std::abs(s.acceleration) * h * h / jerk);
    const auto most = static_cast<std::size_t>(std::clamp(reach, kLeastReach, kMostReach));
    for (std::size_t i = k - std::min(k, most); i < std::min(n, k + most + 1); ++i) {
      const double x = (static_cast<double>(i) - static_cast<double>(k)) / static_cast<double>(most + 1);
      const double bump = std::cos(x * std::numbers::pi / 2);
      b[i] = std::min(b[i], 1 - depth * bump * bump);
    }
  }
  for (int pass = 0; pass < 3; ++pass) {  // where bumps meet
    double before = b[0];
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double here = b[i];
      b[i] = (before + 2 * here + b[i + 1]) / 4;
      before = here;
    }
  }
  for (std::size_t k = 0; k < std::min(kHeldEnd, n); ++k) {
    if (motion.ends().begin > 0) b[k] = 1;
    if (motion.ends().end > 0) b[n - 1 - k] = 1;
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (b[k] == 1) continue;
    b[k] = 1 / std::sqrt(b[k]);
    for (std::size_t i = k - std::min(k, kStretchReach); i <= std::min(n - 1, k + kStretchReach); ++i) {
      excess_[i] = kUnknown;
    }
  }
  motion.stretch(b);
}

}  // namespace toolpace::detail::retime
