#pragma once
/// What is wrong with a cycle, told at the word that it stands for.

#include <string>

#include "toolpace/nc/context.h"

namespace toolpace::nc {

/// Records an error at a word of the block, or at its motion word where there is none. @return false
inline bool fail(Context& context, const Block& block, const char* code, std::string what, std::string remedy,
                 char letter = '\0') {
  const bool at_motion = letter == '\0' || !block.has(letter);
  const std::size_t column = at_motion ? block.column_of(GGroup::motion) : block.column_of(letter);
  return context.faults.fail(code, std::move(what), std::move(remedy), column);
}

}  // namespace toolpace::nc
