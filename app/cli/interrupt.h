#pragma once
/// Ctrl-C and progress, for commands that work long.

#include "toolpace/base/monitor.h"

namespace toolpace::cli {

/// Turns SIGINT, SIGTERM, SIGHUP and SIGQUIT into a stop request for the rest of the process, which also wakes the calling
/// thread from whatever the system lets it wait for; the same signal again ends the process at once. Makes a closed pipe
/// and a file that grows too large error values. Call once, on the thread that runs the commands, before any other is
/// started.
void catch_interrupts();

/// Whether the process was asked to stop.
bool is_interrupted();

/// Stops on Ctrl-C; shows progress on stderr where that is a terminal. Where a console has its place (console.h), that
/// one's.
/// @param what  shown beside the percentage, such as "planning"
Monitor terminal_monitor(const char* what);

/// Ends the progress line, if one was shown.
void end_progress();

}  // namespace toolpace::cli
