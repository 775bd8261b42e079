#pragma once
/// That a program written anew does what the old one did, as read again.

#include <cstddef>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/nc/reading.h"
#include "toolpace/rewrite/write_run.h"

namespace toolpace::detail::rewrite {

/// A span of an edit.
struct SpanPlace {
  std::size_t edit = 0, stretch = 0, span = 0;
};

/// Rows of the new program.
struct Rows {
  std::size_t first = 0, last = 0;  ///< first … last − 1
};

struct Proof {
  bool holds_outside = false;           ///< all that stands outside of edits is as it was
  std::vector<SpanPlace> wrong;         ///< those that do not hold
  double deviation = 0.0;               ///< [mm] of all others, rounded up; 0 where there are none
  std::vector<std::vector<Rows>> rows;  ///< of each edit's stretches
  bool holds() const { return holds_outside && wrong.empty(); }
};

/// Outside of edits the rows have to be the same to the bit, in the same order, and the modal state at each line, too. Each span
/// has to begin and end at the same points to the bit, and to go from one to the other along the same path within the
/// tolerance: there has to be a walk along both, never back, that stays within it. Walked is by verify's own follower and its
/// geometry of lines and arcs, which the fit has no part in.
/// Errors: cancelled.
Result<Proof> prove(const Reading& before, const Reading& after, const Composed& composed,
                    const std::vector<Edit>& edits, double tolerance, const Monitor& monitor);

}  // namespace toolpace::detail::rewrite
