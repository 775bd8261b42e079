#pragma once
/// Dialects of RS-274: which codes each one has, and how to tell which one a program is written in.

#include <optional>
#include <string_view>

#include "toolpace/nc/dialect.h"
#include "toolpace/nc/text/scanner.h"
#include "toolpace/nc/text/words.h"

namespace toolpace::nc {

/// The dialect that the beginning of `text` is written in; never automatic.
Dialect detect_dialect(std::string_view text);

/// Whether a grbl program is rather one for a 3D printer: those dwell in ms.
bool looks_like_printing(std::string_view text);

/// A line that senders pass to the controller beside the program: "$…", or a realtime character ? ! ~ alone.
bool is_sender_command(Scanner text);

const char* dialect_name(Dialect dialect);

/// What a dialect does with a code.
template <class Group>
struct CodeUse {
  Group group;
  bool by_dialect = true;  ///< false: the code exists, but not in this dialect
};

/// What a code does that the dialect has and this reader does not follow; null if there is no such code.
const char* unfollowed_code(Code tenths, Dialect dialect);

/// @return none where no dialect has the code
std::optional<CodeUse<GGroup>> g_code_use(Code tenths, Dialect dialect);
std::optional<CodeUse<MGroup>> m_code_use(int number, Dialect dialect);

}  // namespace toolpace::nc
