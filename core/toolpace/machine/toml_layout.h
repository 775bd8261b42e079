#pragma once
/// Where things stand in a TOML text.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace toolpace {

struct TextSpan {
  std::size_t begin = 0, end = 0;  ///< bytes; `end` is behind the last one
};

using TomlPath = std::vector<std::string>;

/// Where keys stand together: the lines before the first header, those below a header, or an inline table.
struct TomlHome {
  TomlPath path;
  TextSpan span;  ///< of the header with its brackets, or of the inline table with its braces; empty before all headers
  bool is_inline = false;
};

struct TomlEntry {
  TomlPath path;  ///< of the whole key, that of its home included
  TextSpan key;
  TextSpan value;
  std::vector<TextSpan> elements;  ///< of a value that is an array
  std::size_t home = 0;            ///< index into `homes`
};

struct TomlLayout {
  std::vector<TomlHome> homes;  ///< the first one is that before all headers
  std::vector<TomlEntry> entries;
  std::vector<TextSpan> comments;  ///< without the ends of their lines
};

/// @param text  TOML that a parser has accepted. Of other texts the layout is none or has little to say, but nothing
///              breaks.
std::optional<TomlLayout> lay_out_toml(std::string_view text);

}  // namespace toolpace
