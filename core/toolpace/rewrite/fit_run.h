#pragma once
/// A run as fewer blocks.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/rewrite/fit_biarc.h"

namespace toolpace::detail::rewrite {

/// A block, or two, that stand for rows first … last − 1 of a run, and end where they do.
struct Span {
  /// kept: one row, as it was written; biarc: two blocks
  enum class Kind : std::uint8_t { kept, line, arc, biarc };
  Kind kind = Kind::kept;
  std::uint32_t first = 0, last = 0;
  FittedArc arc;                                    ///< of a biarc the first one
  FittedArc second;                                 ///< of a biarc; turns 0: a line
  Eigen::Vector3d joint = Eigen::Vector3d::Zero();  ///< of a biarc
  double programmed = 0.0;  ///< F that the program has there, in its units; where feeds are planned
  double feed = 0.0;        ///< F that is lower; 0 = the program's
};

/// Neighbouring blocks of a run that are written, or left, together.
struct Stretch {
  std::uint32_t first = 0, last = 0;  ///< rows of the run
  /// idle: there was nothing to gain; kept: all else would take longer
  enum class Fit : std::uint8_t { idle, kept, lines, arcs, smooth };
  Fit fit = Fit::idle;
  std::vector<Span> spans;  ///< of all its rows
};

struct FitRules {
  double tolerance = 0.01;  ///< [mm] > 0
  bool has_arcs = true;     ///< else lines alone
  ArcRules arc;
  PlaceGrid grid;                                  ///< for places between the program's own
  std::array<std::uint32_t, 3> named = {0, 0, 0};  ///< of X Y Z: first row of the run that gives it a number
};

/// Replaces by the longest line, arc or helix that fits, from the run's begin on, barrier by barrier.
///
/// What gains little is left: two or three rows become one only where they were as good as one. So that, and because the ends of blocks
/// are ends of rows, a run that was fitted before hardly changes again.
/// @param monitor  a run may be as long as the program; where it is cancelled, spans stop short of the run's end
std::vector<Span> fit_run(const Curve& curve, const FitRules& rules, int plane, const Monitor& monitor = {});

}  // namespace toolpace::detail::rewrite
