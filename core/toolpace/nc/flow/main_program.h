#pragma once
/// Files that begin with sub-programs: where the program itself stands.

#include <optional>
#include <string_view>

#include "toolpace/nc/text/scanner.h"

namespace toolpace::nc {

struct MainProgram {
  std::size_t offset = 0;  ///< of its head
  std::size_t line = 0;    ///< of its head, from 1
  std::string_view name;   ///< "O1000"
};

/// The first program of a file that ends with M2 or M30, if every one before it ends with M99 and is headed by an O number or
/// ":" and a number; nothing where the file begins with it.
std::optional<MainProgram> find_main_program(std::string_view text);

}  // namespace toolpace::nc
