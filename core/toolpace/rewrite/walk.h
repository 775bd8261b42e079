#pragma once
/// The distance between two stretches of programs, by verify's own walk.

#include <cstddef>
#include <optional>

#include "toolpace/nc/moves.h"

namespace toolpace::detail::rewrite {

struct MoveRows {
  const Moves& moves;
  std::size_t first, last;  ///< rows first … last − 1
};

/// Keeps the largest distance of all pairs that it is shown.
class WalkMeter {
 public:
  explicit WalkMeter(double tolerance);

  /// Fréchet distance of two stretches against the tolerance: exact to a hundredth of it where it is the largest so far.
  /// @return whether it is within the tolerance
  bool take(const MoveRows& before, const MoveRows& after);

  /// [mm] rounded up
  double largest() const { return largest_; }

 private:
  double tolerance_;
  double largest_;
};

}  // namespace toolpace::detail::rewrite
