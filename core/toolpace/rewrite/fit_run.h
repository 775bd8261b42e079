#pragma once
/// A run as fewer blocks.

#include <cstddef>
#include <vector>

#include "toolpace/rewrite/fit_arc.h"

namespace toolpace::detail::rewrite {

/// A block that stands for rows first … last − 1 of a run, and ends where they do.
struct Span {
  enum class Kind : std::uint8_t { kept, line, arc };  ///< kept: one row, as it was written
  Kind kind = Kind::kept;
  std::uint32_t first = 0, last = 0;
  FittedArc arc;
};

/// Neighbouring blocks of a run that are written, or left, together.
struct Stretch {
  std::uint32_t first = 0, last = 0;  ///< rows of the run
  enum class Fit : std::uint8_t { kept, lines, arcs };
  Fit fit = Fit::kept;
  std::vector<Span> spans;  ///< of all its rows
};

struct FitRules {
  double tolerance = 0.01;  ///< [mm] > 0
  bool has_arcs = true;     ///< else lines alone
  ArcRules arc;
};

/// Replaces by the longest line, arc or helix that fits, from the run's begin on, barrier by barrier.
///
/// What gains little is left: two or three rows become one only where they were as good as one. So that, and because the ends of blocks
/// are ends of rows, a run that was fitted before hardly changes again.
std::vector<Span> fit_run(const Curve& curve, const FitRules& rules, int plane);

}  // namespace toolpace::detail::rewrite
