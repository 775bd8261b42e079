#pragma once
/// Lengths that Fanuc's controllers take in their least increments.

#include "toolpace/nc/state.h"

namespace toolpace::nc {

/// [mm] 0.001 mm, under G20 0.0001 in.
double least_increment(const State& state);

inline constexpr double kSmallestCount = 10.0;

/// [mm] Whole numbers from `from` on without a point are counts of least increments, others lengths.
double increments_of(const State& state, const Block& block, char letter, double from = kSmallestCount);

/// Makes lengths and angles of the words that are written without a point (Block::counted).
void count_increments(Block& block, const State& state);

}  // namespace toolpace::nc
