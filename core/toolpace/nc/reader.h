#pragma once
/// Reading a program file, of whatever kind, into moves.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/nc/modal_log.h"
#include "toolpace/nc/moves.h"

namespace toolpace {

enum class Dialect : std::uint8_t { automatic, linuxcnc, fanuc, grbl };

/// Bounds that keep any program, however odd, from running without end. Reaching one is an error that names it.
struct ReadLimits {
  std::size_t call_depth = 50;         ///< calls within each other
  std::size_t loop_turns = 2'000'000;  ///< of all loops of a program together
  std::size_t blocks = 8'000'000;      ///< motion blocks, besides one a line of the program
  std::size_t lines = 25'000'000;      ///< lines run again by loops and calls; a line of 16·n bytes counts n + 1 times
};

struct ReadOptions {
  Dialect dialect = Dialect::automatic;
  bool strict = false;                                ///< every warning is an error
  bool block_delete = false;                          ///< skip lines that start with '/'
  std::filesystem::path tools = {};                   ///< LinuxCNC tool table; empty = none
  std::filesystem::path parameters = {};              ///< numbered parameters; empty = none
  std::vector<std::filesystem::path> sub_paths = {};  ///< folders searched for sub-programs, besides the program's own
  ReadLimits limits = {};
};

/// What was understood. `refused` = at least one error: `moves` then holds the motion up to the first one.
struct Reading {
  Moves moves;
  Diagnostics diagnostics;
  ModalLog modal;                       ///< what was modal at which line; empty for polylines
  Dialect dialect = Dialect::linuxcnc;  ///< the dialect it was read in
  bool refused = false;
};

/// Reads RS-274 text, or a CSV polyline where `name` ends in .csv. Never throws on bad input.
///
/// @param name  shown in diagnostics; its extension chooses the format, or, of "-", the text's first word
/// @return an Error only for what leaves nothing to show (cancelled, not text at all, empty)
Result<Reading> read_text(std::string_view text, const std::string& name, const ReadOptions& options = {},
                          const Monitor& monitor = {});

/// The same from a file ("-" = standard input). Errors: io for what cannot be read, or is changed meanwhile.
Result<Reading> read_file(const std::filesystem::path& file, const ReadOptions& options = {},
                          const Monitor& monitor = {});

}  // namespace toolpace
