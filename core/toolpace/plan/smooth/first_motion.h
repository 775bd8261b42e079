#pragma once
/// A first, unambitious motion along a stretch of the path, for the optimiser to improve.

#include "toolpace/plan/smooth/cruise.h"

namespace toolpace::detail::tube {

/// Where a motion begins or ends: at rest at a vertex, or in motion, where a cruise ends or begins.
template <int D>
struct Bound {
  double place = 0;  ///< of the vertex, or of the cruise's outermost control point
  std::size_t vertex = 0;
  const Cruise<D>* cruise = nullptr;
};

template <int D>
class FirstMotion {
 public:
  FirstMotion(const TubeMiddle<D>& middle, const Bound<D>& from, const Bound<D>& to)
      : middle_(middle), from_(from), to_(to) {}

  MotionWindow<D> make() {
    march();
    if (to_.cruise) arrive();
    soften();
    return window();
  }

 private:
  static constexpr std::size_t kPad = 2;
  static constexpr double kMostSpread = 200;  // steps

  /// Places, a step apart, from the stretch's beginning to its end.
  void march() {
    const double j = middle_.room(middle_.direction(middle_.segment_at((from_.place + to_.place) / 2)), 2);
    const double most_gain = 0.5 * std::cbrt(j * j * (to_.place - from_.place));
    double s = from_.place, spread = 0;
    std::size_t i = middle_.segment_at(s);
    place_ = {s};
    while (s < to_.place) {
      i = middle_.segment_at(s, i);
      const double a = std::min(middle_.gain(i), most_gain);
      double v = middle_.speed_at(s, i);
      if (!from_.cruise) v = std::min(v, std::sqrt(2 * a * (s - from_.place)));
      if (!to_.cruise) v = std::min(v, std::sqrt(2 * a * (to_.place - s)));
      s += std::max(v, 0.5 * a);
      place_.push_back(s);
      spread = std::max(spread, std::min(a / middle_.room(middle_.direction(i), 2), kMostSpread));
    }
    half_ = static_cast<std::size_t>(std::ceil(0.35 * spread));
    if (!to_.cruise) place_.back() = to_.place;
  }

  /// Meets the place of the end after whole steps.
  void arrive() {
    const double over = place_.back() - to_.place, n = static_cast<double>(place_.size()) - 1;
    for (std::size_t k = 0; k < place_.size(); ++k) {
      const double x = static_cast<double>(k) / n;
      place_[k] -= over * x * x * x * (10 - 15 * x + 6 * x * x);
    }
    place_.back() = to_.place;
  }

  double place(std::ptrdiff_t k) const {
    const auto last = static_cast<std::ptrdiff_t>(place_.size()) - 1;
    if (k < 0) return from_.cruise ? place_[0] + static_cast<double>(k) * (place_[1] - place_[0]) : place_[0];
    if (k <= last) return place_[static_cast<std::size_t>(k)];
    const double before = place_[static_cast<std::size_t>(last) - 1];
    return to_.cruise ? place_.back() + static_cast<double>(k - last) * (place_.back() - before) : place_.back();
  }

  /// Averages over time; at rest ends that takes longer.
  void soften() {
    const auto half = static_cast<std::ptrdiff_t>(half_);
    const std::ptrdiff_t begin = from_.cruise ? 0 : -half - static_cast<std::ptrdiff_t>(kPad);
    const std::ptrdiff_t end =
        static_cast<std::ptrdiff_t>(place_.size()) + (to_.cruise ? 0 : half + static_cast<std::ptrdiff_t>(kPad));
    std::vector<double> soft;
    double sum = 0;
    for (std::ptrdiff_t k = begin - half; k <= begin + half; ++k) sum += place(k);
    for (std::ptrdiff_t k = begin; k < end; ++k) {
      soft.push_back(std::clamp(sum / static_cast<double>(2 * half_ + 1), from_.place, to_.place));
      sum += place(k + half + 1) - place(k - half);
    }
    const std::size_t n = soft.size();
    for (std::size_t k = 0; k < (from_.cruise ? 1 : std::min<std::size_t>(3, n)); ++k) soft[k] = from_.place;
    for (std::size_t k = 0; k < (to_.cruise ? 1 : std::min<std::size_t>(3, n)); ++k) soft[n - 1 - k] = to_.place;
    place_.swap(soft);
  }

  MotionWindow<D> window() const {
    MotionWindow<D> m;
    m.rest_begin = !from_.cruise;
    m.rest_end = !to_.cruise;
    std::size_t i = middle_.segment_at(from_.place);
    if (from_.cruise) {  // its last control point is the first place
      const auto& c = from_.cruise->motion.c;
      m.c.assign(c.end() - 3, c.end() - 1);
    }
    std::size_t first_point = m.size();
    for (const double s : place_) {
      i = middle_.segment_at(s, i);
      const double most = std::min(from_.cruise ? 1e300 : s - from_.place, to_.cruise ? 1e300 : to_.place - s);
      m.c.push_back(middle_.point(s, i, most));
    }
    if (from_.cruise) m.c[2] = from_.cruise->motion.c.back();
    if (to_.cruise) {
      const auto& c = to_.cruise->motion.c;
      m.c.back() = c[0];
      m.c.insert(m.c.end(), c.begin() + 1, c.begin() + 3);
    }
    add_passes(m, static_cast<double>(first_point));
    return m;
  }

  void add_passes(MotionWindow<D>& m, double first_point) const {
    m.first = from_.cruise ? middle_.segment_at(from_.cruise->end) : from_.vertex;
    std::size_t end = to_.vertex;
    if (to_.cruise) end = middle_.segment_at(to_.cruise->begin) + 1;
    std::size_t k = 0;
    for (std::size_t v = m.first + 1; v < end; ++v) {
      const double s = middle_.vertex_place(v);
      while (k + 2 < place_.size() && place_[k + 1] < s) ++k;
      const double d = place_[k + 1] - place_[k];
      const double u = first_point + static_cast<double>(k) + (d > 0 ? std::clamp((s - place_[k]) / d, 0.0, 1.0) : 0.0);
      m.pass.push_back(std::clamp(u, 1.0, static_cast<double>(m.size()) - 2));
    }
  }

  const TubeMiddle<D>& middle_;
  const Bound<D>&from_, &to_;
  std::vector<double> place_;
  std::size_t half_ = 0;
};

}  // namespace toolpace::detail::tube
