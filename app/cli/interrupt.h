#pragma once
/// Ctrl-C and progress, for commands that work long.

#include "toolpace/base/monitor.h"

namespace toolpace::cli {

/// Turns SIGINT and SIGTERM into a stop request for the rest of the process, and makes a closed pipe an error value.
/// Call once, before any thread is started.
void catch_interrupts();

/// Stops on Ctrl-C; shows progress on stderr where that is a terminal.
/// @param what  shown beside the percentage, such as "planning"
Monitor terminal_monitor(const char* what);

/// Ends the progress line, if one was shown.
void end_progress();

}  // namespace toolpace::cli
