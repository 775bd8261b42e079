#pragma once
/// The path that whole-program benchmarks run on.

#include <cmath>
#include <random>

#include "toolpace/nc/moves.h"

namespace toolpace::bench {

/// A polyline of 0.05 … 0.5 mm chords along a curve whose curvature wanders, 6000 mm/min. The same for the same count.
inline Moves smooth_moves(std::size_t blocks) {
  Moves moves;
  moves.files = {"smooth"};
  std::mt19937 engine(20140401);
  const auto random = [&engine] { return static_cast<double>(engine()) / 4294967296.0; };
  AxisVector at = AxisVector::Zero();
  double heading = 0.0, curvature = 0.0;
  for (std::size_t i = 0; i < blocks; ++i) {
    const double length = 0.05 + 0.45 * random();
    curvature = 0.95 * curvature + 0.05 * (random() - 0.5);
    heading += curvature * length;
    at[0] += length * std::cos(heading);
    at[1] += length * std::sin(heading);
    moves.kind.push_back(MoveKind::feed);
    moves.line.push_back(static_cast<std::uint32_t>(i + 1));
    moves.file.push_back(0);
    moves.mode.push_back(0);
    moves.detail.push_back(kNoDetail);
    moves.end.push_back(at);
    moves.feed.push_back(100.0);
  }
  return moves;
}

}  // namespace toolpace::bench
