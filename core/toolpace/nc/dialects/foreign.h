#pragma once
/// Programs that are none of RS-274: conversational ones, those of other controllers, drawings.

#include <cstddef>
#include <optional>
#include <string_view>

namespace toolpace::nc {

struct ForeignLanguage {
  const char* name = "";   ///< for people
  std::size_t line = 0;    ///< where the text says so, from 1
  std::size_t column = 0;  ///< from 1
};

/// Looks at the beginning of `text` for what no RS-274 program says.
std::optional<ForeignLanguage> find_foreign_language(std::string_view text);

}  // namespace toolpace::nc
