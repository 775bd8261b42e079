#pragma once
/// Which dialect a program is written in, found from its text.

#include <string>
#include <string_view>
#include <vector>

#include "toolpace/nc/dialect.h"
#include "toolpace/nc/text/scanner.h"

namespace toolpace::nc {

struct DialectGuess {
  Dialect dialect = Dialect::linuxcnc;  ///< never automatic
  std::vector<std::string> reasons;     ///< what in the text speaks for it, with its line
  bool marked = true;                   ///< false: nothing in the text or its name says so
  Dialect other = Dialect::automatic;   ///< what it may be as well; automatic = nothing near as likely
};

/// Looks at the beginning of `text`. `name` is the file's: its extension decides where nothing in the text does.
DialectGuess detect_dialect(std::string_view text, std::string_view name = {});

}  // namespace toolpace::nc
