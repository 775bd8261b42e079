#pragma once
/// The text of a program with runs replaced.

#include <cstdint>
#include <string>
#include <vector>

#include "toolpace/rewrite/fit_run.h"
#include "toolpace/rewrite/program_lines.h"
#include "toolpace/rewrite/runs.h"

namespace toolpace::detail::rewrite {

/// A run and what replaces it.
struct Edit {
  Run run;
  std::vector<Stretch> stretches;  ///< of all its rows; none = it stays as it is
  int decimals = 4;                ///< of I J K
  bool plans_feeds = false;        ///< F is written as the spans have it
};

/// What a line of a composed text stands for.
struct Origin {
  std::size_t line = 0;  ///< of the program, from 1; 0 = it belongs to an edit
  std::size_t edit = 0, stretch = 0, span = 0;
};

struct Composed {
  std::string text;
  std::vector<Origin> origin;  ///< of each line, [0] is line 1
};

/// Replaces the runs that have stretches. All other lines stay byte for byte, and mean what they meant: behind a run the modal
/// motion, plane and feed are as they would be. Ends of blocks are written with the program's own numbers, without zeros at
/// their ends.
/// @param keeps_points  X100. is something else than X100
Composed compose(const ProgramLines& lines, const Moves& moves, const std::vector<Edit>& edits, bool keeps_points);

}  // namespace toolpace::detail::rewrite
