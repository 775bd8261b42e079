#pragma once
/// What a person meant who typed a word that is not known.

#include <string>
#include <string_view>
#include <vector>

namespace toolpace {

/// The least number of letters to insert, drop or change that makes one word the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate with the least edit distance to `word`. `candidates` is not empty.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace toolpace
