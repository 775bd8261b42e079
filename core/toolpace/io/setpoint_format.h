#pragma once
/// The formats of setpoint files: the table that writing, reading, the command line, the window and messages ask.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "toolpace/base/input_file.h"
#include "toolpace/base/result.h"
#include "toolpace/io/output_file.h"

namespace toolpace {

class SetpointFile;
class SetpointWriter;
struct SetpointFileOptions;

struct SetpointFormat {
  std::string_view id;      ///< "csv"
  std::string_view suffix;  ///< of file names, in small letters: ".csv"
  const char* title;        ///< for people: "Comma-separated"
  OutputFile::Access access;
  bool names_columns;  ///< so that there may be more of them than readers know
  Result<std::unique_ptr<SetpointWriter>> (*write)(OutputFile file, const SetpointFileOptions& options);
  /// First bytes of such a file; empty = of text, which only the suffix tells from other text.
  std::string_view magic;
  Result<std::unique_ptr<SetpointFile>> (*read)(InputFile file, const std::string& name);
};

/// The first one is that of names without a suffix, and of text that nothing else tells.
std::span<const SetpointFormat> setpoint_formats();

/// Null where no format has this id.
const SetpointFormat* format_named(std::string_view id);
/// By the longest suffix that fits, in letters of any case; the first where the name has none; null for one that names none.
const SetpointFormat* format_of(const std::filesystem::path& file);
/// ".csv, .npy, .npz, .halstream or .semicolon.csv"
std::string setpoint_suffixes();

}  // namespace toolpace
