#pragma once
/// Stretches where nothing but the commanded speed binds: they are run along the tube's middle, and need no optimiser.

#include "toolpace/plan/smooth/tube_check.h"
#include "toolpace/plan/smooth/tube_middle.h"

namespace toolpace::detail::tube {

template <int D>
struct Cruise {
  MotionWindow<D> motion;  ///< in motion at both ends; keeps every limit
  // Places on the tube's middle: of the outermost control points, and of the knots at which it begins and ends.
  double first = 0, begin = 0, end = 0, last = 0;
};

/// Finds the stretches that are run at one speed for so long that the ramps at their ends are far away.
template <int D>
class CruiseFinder {
 public:
  using Vec = Eigen::Matrix<double, D, 1>;
  CruiseFinder(const TubePath& path, const StepLimits& limits, const TubeMiddle<D>& middle)
      : middle_(middle), check_(path, limits) {}

  std::vector<Cruise<D>> find() {
    for (std::size_t i = 0; i < middle_.segments(); ++i) {
      const double v = middle_.top(i), square = v * v, a = 2 * middle_.gain(i);
      const double from = middle_.vertex_place(i), to = middle_.vertex_place(i + 1);
      const double begin = from + lost(square, middle_.vertex_speed(i)) / a;
      const double end = to - lost(square, middle_.vertex_speed(i + 1)) / a;
      if (open_ && (begin > from || std::abs(v - speed_) > kSame * v)) close();
      if (!(begin < end)) continue;
      if (!open_) begin_ = begin;
      open_ = true;
      speed_ = v;
      end_ = end;
      if (end < to) close();
    }
    if (open_) close();
    return std::move(found_);
  }

 private:
  static constexpr double kSame = 1e-9;           // of a speed
  static constexpr std::size_t kSoft = 2;         // control points to either side
  static constexpr std::size_t kMargin = 48;      // control points at either end that are left to the optimiser
  static constexpr std::size_t kLeast = 300;      // control points: each costs half a step on the average
  static constexpr std::size_t kMost = 1u << 16;  // control points of one

  /// Difference of the squares of two speeds, 0 where they are the same.
  static double lost(double square, double speed) {
    const double difference = square - speed * speed;
    return difference > kSame * square ? difference : 0.0;
  }

  void close() {
    open_ = false;
    double at = begin_;
    while (end_ - at > static_cast<double>(kLeast + 2 * (kMargin + kSoft)) * speed_) at = run(at);
  }

  /// Runs from a place on at one speed, to the end or for so many steps.
  /// @return where it came to
  double run(double s) {
    place_ = {s};
    MotionWindow<D> m;
    m.rest_begin = m.rest_end = false;
    std::size_t i = middle_.segment_at(s);
    m.c = {middle_.point(s, i)};
    while (m.size() < kMost) {
      const double before = s;
      Vec p;
      s += speed_;
      for (int round = 0; round < 3; ++round) {  // chords of one length, whatever the middle cuts off
        i = middle_.segment_at(s, i);
        p = middle_.point(s, i);
        const double way = (p - m.c.back()).norm();
        if (std::abs(way - speed_) < kSame * speed_ || !(way > 0)) break;
        if (round < 2) s = before + (s - before) * std::min(speed_ / way, 2.0);
      }
      if (s > end_) break;
      m.c.push_back(p);
      place_.push_back(s);
    }
    const bool goes_on = m.size() == kMost;
    if (m.size() > kLeast + 2 * (kMargin + kSoft)) {
      soften(m);
      add_passes(m, 0);
      keep_good(m);
    }
    return goes_on ? s : end_;
  }

  /// Averages over time what corners rounded along the way still have of jerk; no speed and no acceleration grows by that.
  void soften(MotionWindow<D>& m) {
    const std::vector<Vec> c = std::move(m.c);
    m.c.clear();
    for (std::size_t k = kSoft; k + kSoft < c.size(); ++k) {
      Vec off = Vec::Zero();
      for (std::size_t q = k - kSoft; q <= k + kSoft; ++q) off += c[q] - c[k];
      m.c.push_back(c[k] + off / (2 * kSoft + 1));
    }
    place_.erase(place_.begin(), place_.begin() + kSoft);
    place_.resize(m.size());
  }

  /// @param from  the place of the motion's first control point
  void add_passes(MotionWindow<D>& m, std::size_t from) const {
    const std::size_t begin = from + 1, end = from + m.size() - 2;
    m.first = middle_.segment_at(place_[begin]);
    std::size_t k = begin;
    for (std::size_t v = m.first + 1; v < middle_.segments() && middle_.vertex_place(v) <= place_[end]; ++v) {
      const double s = middle_.vertex_place(v);
      while (k + 1 < end && place_[k + 1] < s) ++k;
      const double share = std::clamp((s - place_[k]) / (place_[k + 1] - place_[k]), 0.0, 1.0);
      m.pass.push_back(static_cast<double>(k - from) + share);
    }
  }

  void keep_good(const MotionWindow<D>& m) {
    const Use use = check_.measure(m);
    std::size_t from = 1;
    for (const std::size_t k : use.over) {
      keep(m, from, k);
      from = k + 3;
    }
    keep(m, from, m.size() - 2);
  }

  /// Keeps knots from … to of a motion, but for the margins.
  void keep(const MotionWindow<D>& m, std::size_t from, std::size_t to) {
    from += kMargin;
    if (to < from + kMargin + kLeast) return;
    to -= kMargin;
    Cruise<D> cruise;
    cruise.motion.rest_begin = cruise.motion.rest_end = false;
    cruise.motion.c.assign(m.c.begin() + static_cast<std::ptrdiff_t>(from) - 1,
                           m.c.begin() + static_cast<std::ptrdiff_t>(to) + 2);
    add_passes(cruise.motion, from - 1);
    cruise.first = place_[from - 1];
    cruise.begin = place_[from];
    cruise.end = place_[to];
    cruise.last = place_[to + 1];
    found_.push_back(std::move(cruise));
  }

  const TubeMiddle<D>& middle_;
  TubeCheck<D> check_;
  bool open_ = false;
  double begin_ = 0, end_ = 0, speed_ = 0;
  std::vector<double> place_;
  std::vector<Cruise<D>> found_;
};

}  // namespace toolpace::detail::tube
