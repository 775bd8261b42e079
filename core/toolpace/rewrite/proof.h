#pragma once
/// That a program written anew does what the old one did, as read again.

#include <cstddef>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/nc/reading.h"
#include "toolpace/rewrite/write_run.h"

namespace toolpace::detail::rewrite {

struct Proof {
  bool holds_outside = false;      ///< all that stands outside of replaced runs is as it was
  std::vector<std::size_t> wrong;  ///< indices of edits that do not hold
  double deviation = 0.0;          ///< [mm] of those that do, at least verify's kOnPath where there are any
  bool holds() const { return holds_outside && wrong.empty(); }
};

/// Outside of replaced runs the rows have to be the same to the bit, in the same order, and the modal state at each line, too.
/// Runs have to begin and end at the same points to the bit, and to go from one to the other along the same path within the
/// tolerance: there has to be a walk along both, never back, that stays within it. Walked is by verify's own follower and its
/// geometry of lines and arcs, which the fit has no part in.
/// Errors: cancelled.
Result<Proof> prove(const Reading& before, const Reading& after, const Composed& composed,
                    const std::vector<Edit>& edits, double tolerance, const Monitor& monitor);

}  // namespace toolpace::detail::rewrite
