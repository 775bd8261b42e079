#pragma once
/// The text of a program with runs replaced.

#include <cstdint>
#include <string>
#include <vector>

#include "toolpace/rewrite/fit_run.h"
#include "toolpace/rewrite/program_lines.h"
#include "toolpace/rewrite/runs.h"

namespace toolpace::detail::rewrite {

/// A run and what replaces it; no spans = nothing does.
struct Edit {
  Run run;
  std::vector<Span> spans;
  int decimals = 4;  ///< of I J K
};

struct Composed {
  std::string text;
  /// Of each line, [0] is line 1: the line of the program that it is, from 1; or −k: it stands for run k of the edits.
  std::vector<std::int64_t> origin;
};

/// Replaces the runs that have spans. All other lines stay byte for byte, and mean what they meant: behind a run the modal
/// motion, plane and feed are as they would be. Ends of blocks are written with the program's own numbers, without zeros at
/// their ends.
/// @param keeps_points  X100. is something else than X100
Composed compose(const ProgramLines& lines, const Moves& moves, const std::vector<Edit>& edits, bool keeps_points);

}  // namespace toolpace::detail::rewrite
