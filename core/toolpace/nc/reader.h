#pragma once
/// Reading a program file, of whatever kind, into moves.

#include <filesystem>
#include <string>
#include <string_view>

#include "toolpace/base/monitor.h"
#include "toolpace/nc/read_options.h"
#include "toolpace/nc/reading.h"

namespace toolpace {

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
