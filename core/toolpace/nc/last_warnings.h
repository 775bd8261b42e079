#pragma once
/// What can be said of a program only when all of it has been read.

#include <cstddef>
#include <string_view>

#include "toolpace/nc/diagnostic_log.h"
#include "toolpace/nc/dialects/rules.h"
#include "toolpace/nc/flow/program_files.h"
#include "toolpace/nc/moves.h"
#include "toolpace/nc/state.h"

namespace toolpace::nc {

struct ReadingEnd {
  const DialectRules& rules;
  const State& state;
  const Moves& moves;
  ProgramFiles& files;
  DiagnosticLog& log;
};

/// Arcs that were mended, units that were never given, rotary axes that may have moved about the tool's tip.
void warn_at_the_end(const ReadingEnd& end);

/// Motion in `rest`, which stands behind the end of the program in `line` and is no sub-program.
void warn_of_text_behind_end(const ReadingEnd& end, std::size_t line, std::string_view rest);

}  // namespace toolpace::nc
