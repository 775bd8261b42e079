#pragma once
/// Reading a program file, of whatever kind, into moves.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/nc/moves.h"

namespace toolpace {

enum class Dialect : std::uint8_t { automatic, linuxcnc, fanuc, grbl };

struct ReadOptions {
  Dialect dialect = Dialect::automatic;
  bool strict = false;        ///< every warning is an error
  bool block_delete = false;  ///< skip lines that start with '/'
  std::filesystem::path tools;       ///< LinuxCNC tool table; empty = none
  std::filesystem::path parameters;  ///< numbered parameters; empty = none
  std::vector<std::filesystem::path> sub_paths;  ///< folders searched for sub-programs, besides the program's own
};

/// What was understood. `refused` = at least one error: `moves` then holds the motion up to the first one.
struct Reading {
  Moves moves;
  Diagnostics diagnostics;
  bool refused = false;
};

/// Reads RS-274 text, or a CSV polyline where `name` ends in .csv. Never throws on bad input.
///
/// @param name  shown in diagnostics; its extension chooses the format
/// @return an Error only for what leaves nothing to show (cancelled, not text at all, empty)
Result<Reading> read_text(std::string_view text, const std::string& name, const ReadOptions& options = {},
                          const Monitor& monitor = {});

/// The same from a file ("-" = standard input), memory-mapped where possible. Errors: io for what cannot be opened.
Result<Reading> read_file(const std::filesystem::path& file, const ReadOptions& options = {}, const Monitor& monitor = {});

}  // namespace toolpace
