#pragma once
/// Planning a program again after some of its parameters changed.

#include "toolpace/pipeline/job.h"

namespace toolpace {

/// The same as run(job), to the bit, but takes over from an earlier plan of the same program what its parameters have
/// left as it was: the path, and with it the speed limits where only law, ramps or look-ahead changed. A path taken over
/// is the very same object, so whatever was made from it still fits.
///
/// @param before  any outcome; one of another program is of no use and does no harm
Result<Outcome> replan(std::shared_ptr<const Job> job, const Outcome& before, const Monitor& monitor = {});

}  // namespace toolpace
