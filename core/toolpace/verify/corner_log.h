#pragma once
/// Corners that were passed with a speed step: what they explain in the differences around them.

#include <algorithm>
#include <cstdint>
#include <deque>

#include "toolpace/base/axes.h"

namespace toolpace {

/// Steps of an axis' speed and acceleration between row interval−1 and row interval, magnitudes.
struct CornerEvent {
  std::int64_t interval = 0;
  std::int64_t corner = 0;  ///< which one, ever rising; a corner near a row may stand in two intervals
  AxisVector speed_step = AxisVector::Zero();         ///< [mm/s, rad/s]
  AxisVector acceleration_step = AxisVector::Zero();  ///< [mm/s², rad/s²]
  /// Of the place that the path tells: about the tool's tip that of the tip, elsewhere that of the axes.
  AxisVector place_step = AxisVector::Zero();  ///< [mm/s, rad/s]
};

/// How much longer than the straight line between two rows the program's way is where it crosses nodes.
struct Detour {
  std::int64_t interval;
  double length;  ///< [mm]
};

/// Events in the order of time; old ones are forgotten.
class CornerLog {
 public:
  void add(const CornerEvent& event) { events_.push_back(event); }
  void forget_before(std::int64_t interval) {
    while (!events_.empty() && events_.front().interval < interval) events_.pop_front();
    while (!detours_.empty() && detours_.front().interval < interval) detours_.pop_front();
  }
  void add(const Detour& detour) { detours_.push_back(detour); }
  /// Of a row interval [mm]; 0 where it crosses no node.
  double detour(std::int64_t interval) const {
    const auto at = std::lower_bound(detours_.begin(), detours_.end(), interval,
                                     [](const Detour& d, std::int64_t i) { return d.interval < i; });
    return at != detours_.end() && at->interval == interval ? at->length : 0.0;
  }
  /// Calls take(event) for those of the intervals first … last.
  template <class Take>
  void for_each(std::int64_t first, std::int64_t last, Take&& take) const {
    auto event = std::lower_bound(events_.begin(), events_.end(), first,
                                  [](const CornerEvent& e, std::int64_t at) { return e.interval < at; });
    for (; event != events_.end() && event->interval <= last; ++event) take(*event);
  }

 private:
  std::deque<CornerEvent> events_;
  std::deque<Detour> detours_;
};

}  // namespace toolpace
