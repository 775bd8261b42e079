#pragma once
/// Which move is under the tool on a path whose segments were merged, trimmed and replaced by corner curves.

#include <algorithm>

#include "toolpace/path/path.h"

namespace toolpace {

/// Carries the moves of an old path over to a new one that follows it: `tell` is called for each stretch of the old path, in
/// order, with the segment of the new path that stands for it.
class MoveTeller {
 public:
  /// A stretch of a segment by path length.
  struct Stretch {
    std::size_t segment;
    double begin, end;
  };

  MoveTeller(const Path& from, Path& to) : from_(from), to_(to) {}

  /// Does a segment of the old path, that is told next, stand for several moves?
  bool is_divided(std::size_t segment) const {
    const auto& given = from_.handovers;
    const auto next = std::find_if(given.begin() + static_cast<std::ptrdiff_t>(next_), given.end(),
                                   [&](const Path::Handover& h) { return h.segment >= segment; });
    return next != given.end() && next->segment == segment;
  }

  /// `old` runs along `now`, both from begin to end. Neither may start before where the last one did.
  void tell(const Stretch& old, const Stretch& now) {
    const auto& given = from_.handovers;
    if (old.segment != segment_ || present_ == kNoDetail) present_ = from_.move[segment_ = old.segment];
    const auto is_passed = [&](const Path::Handover& h) {
      return h.segment < old.segment || (h.segment == old.segment && h.at <= old.begin);
    };
    for (; next_ < given.size() && is_passed(given[next_]); ++next_) {
      if (given[next_].segment == old.segment) present_ = given[next_].move;
    }
    hand_over(now, now.begin);
    const double scale = (now.end - now.begin) / (old.end - old.begin);
    for (; next_ < given.size() && given[next_].segment == old.segment && given[next_].at < old.end; ++next_) {
      present_ = given[next_].move;
      hand_over(now, now.begin + scale * (given[next_].at - old.begin));
    }
  }

 private:
  void hand_over(const Stretch& now, double at) {
    const bool begun = !to_.handovers.empty() && to_.handovers.back().segment == now.segment;
    const std::uint32_t told = begun ? to_.handovers.back().move : to_.move[now.segment];
    if (told != present_) to_.handovers.push_back({static_cast<std::uint32_t>(now.segment), present_, at});
  }

  const Path& from_;
  Path& to_;
  std::size_t segment_ = 0;
  std::uint32_t present_ = kNoDetail;  // move under the tool
  std::size_t next_ = 0;               // first handover of the old path beyond it
};

}  // namespace toolpace
