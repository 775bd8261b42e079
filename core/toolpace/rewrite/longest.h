#pragma once
/// The search for the longest block from a vertex on.

#include <array>
#include <cstddef>

#include "toolpace/rewrite/fit_run.h"

namespace toolpace::detail::rewrite {

inline constexpr std::size_t kSpansAReport = 256;  // fitted between two reports of progress

/// The farthest end up to `limit` that `fits`, looked for in doubling steps from `from`, which does.
template <class Fits>
std::size_t farthest(std::size_t from, std::size_t limit, const Fits& fits) {
  std::size_t step = 1;
  while (from + step <= limit && fits(from + step)) {
    from += step;
    step *= 2;
  }
  for (step /= 2; step > 0; step /= 2) {
    while (from + step <= limit && fits(from + step)) from += step;
  }
  return from;
}

class RunFitter {
 public:
  RunFitter(const Curve& curve, const FitRules& rules, int plane);

  /// Where a block from this vertex on has to end at the latest. To be asked along the run.
  std::size_t next_barrier(std::size_t vertex);

  /// The longest line or arc, or one row as it is where that gains too little.
  Span longest(std::size_t first, std::size_t limit);

  /// The longest arc in a plane that reaches farther than `from` and is accepted as accepts(arc, last); where there is none, it
  /// ends there.
  template <class Accepts>
  Span longest_arc(int plane, std::size_t first, std::size_t from, std::size_t limit, const Accepts& accepts) {
    Span arc = span(Span::Kind::arc, first, from);
    const auto fits = [&](std::size_t last) {
      const auto found = arcs_.fit(plane, first, last);
      if (!found || !accepts(*found, last)) return false;
      arc.arc = *found;
      return true;
    };
    arc.last = static_cast<std::uint32_t>(farthest(from, limit, fits));
    if (arc.last == from) return arc;
    // Close to a whole turn only its very end will do.
    while (const std::size_t closing = closing_vertex(plane, arc, limit)) {
      if (!fits(closing)) break;
      arc.last = static_cast<std::uint32_t>(farthest(closing, limit, fits));
    }
    return arc;
  }

  /// Few rows become one only where they were nearly that.
  bool is_worth_it(const Span& span) const;

  static Span span(Span::Kind kind, std::size_t first, std::size_t last) {
    return {kind, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last), {}, {}, {}};
  }

 private:
  std::size_t closing_vertex(int plane, const Span& found, std::size_t limit) const;

  const Curve& curve_;
  const FitRules& rules_;
  double tolerance_;
  ArcFitter arcs_;
  std::array<int, 3> planes_;
  std::size_t barrier_ = 0;
};

}  // namespace toolpace::detail::rewrite
