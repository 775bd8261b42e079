#pragma once
/// From flags to a plan, for commands that need one.

#include "reading_flags.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/pipeline/setup.h"

namespace toolpace::cli {

/// Reads and plans the program; prints its diagnostics and warnings to stderr. A refused program is an error.
Result<Outcome> plan_program(const ReadingFlags& reading, const Setup& setup);

}  // namespace toolpace::cli
