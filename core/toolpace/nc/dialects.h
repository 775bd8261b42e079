#pragma once
/// Dialects of RS-274: which codes each one has, and how to tell which one a program is written in.

#include <optional>
#include <string_view>

#include "toolpace/nc/reader.h"
#include "toolpace/nc/words.h"

namespace toolpace::nc {

/// The dialect that the beginning of `text` is written in; never automatic.
Dialect detect_dialect(std::string_view text);

const char* dialect_name(Dialect dialect);

/// What a dialect does with a code.
template <class Group>
struct CodeUse {
  Group group;
  bool by_dialect = true;  ///< false: the code exists, but not in this dialect
};

/// @return none where no dialect has the code
std::optional<CodeUse<GGroup>> g_code_use(Code tenths, Dialect dialect);
std::optional<CodeUse<MGroup>> m_code_use(int number, Dialect dialect);

}  // namespace toolpace::nc
