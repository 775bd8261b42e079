#pragma once
/// From flags to a plan, for commands that need one.

#include "reading_flags.h"
#include "toolpace/machine/setup.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::cli {

/// Reads and plans the program, or plans it again from what the console kept; prints its diagnostics and warnings to stderr. A
/// refused program is a Failure.
tl::expected<Outcome, Failure> plan_program(const ReadingFlags& reading, const Setup& setup);

}  // namespace toolpace::cli
