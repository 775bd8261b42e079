#pragma once
/// What lies between the cruises of a run, cut into windows.

#include <set>

#include "toolpace/plan/smooth/first_motion.h"

namespace toolpace::detail::tube {

template <int D>
struct Stretch {
  Bound<D> begin, end;
};

template <int D>
class StretchCutter {
 public:
  explicit StretchCutter(const TubeMiddle<D>& middle) : middle_(middle) {}

  /// @param without  cruises that are left out
  std::vector<Stretch<D>> cut(const std::vector<Cruise<D>>& cruises, const std::set<const Cruise<D>*>& without) {
    Bound<D> from;
    for (const Cruise<D>& cruise : cruises) {
      if (without.count(&cruise) > 0) continue;
      add(from, {cruise.first, 0, &cruise});
      from = {cruise.last, 0, &cruise};
    }
    add(from, {middle_.length(), middle_.segments(), nullptr});
    return std::move(stretches_);
  }

 private:
  static constexpr double kWindow = 3000;  // control points of a first motion that a window should have

  /// One stretch; where it is long, cut at vertices into windows that rest there.
  void add(Bound<D> from, const Bound<D>& to) {
    std::size_t v = middle_.segment_at(from.place);
    const std::size_t last = middle_.segment_at(to.place);
    double begin = middle_.vertex_time(v);
    const double steps = middle_.vertex_time(last + 1) - begin;
    const double share = steps / std::max(1.0, std::round(steps / kWindow));
    for (++v; v < last; ++v) {
      const double time = middle_.vertex_time(v);
      if (time - begin < share || middle_.vertex_time(last) - time < share / 2) continue;
      const Bound<D> rest = {middle_.vertex_place(v), v, nullptr};
      stretches_.push_back({from, rest});
      from = rest;
      begin = time;
    }
    stretches_.push_back({from, to});
  }

  const TubeMiddle<D>& middle_;
  std::vector<Stretch<D>> stretches_;
};

}  // namespace toolpace::detail::tube
