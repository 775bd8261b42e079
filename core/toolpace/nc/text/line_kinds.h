#pragma once
/// Lines that are no blocks: heads of programs, macros of senders and printers. Cursors stand on the first character.

#include <cstddef>
#include <optional>
#include <string_view>

#include "toolpace/nc/text/scanner.h"

namespace toolpace::nc {

/// "O1234" or ":1234": the head of a program, and nothing that it does.
bool begins_program_number(Scanner text);

/// "<NAME>": the same of Fanuc's 30i.
bool is_program_name(Scanner text);

/// "%wait", "%X0=posx" of senders.
bool is_sender_macro(Scanner text);

/// MSG "…", DLGMSG "…": what the operator shall read.
bool is_message(Scanner text);

/// "00024": digits, and comments at most.
bool is_number_alone(Scanner text);

/// "$1" alone, "!L1", "!2": of machines that run several programs side by side.
bool begins_channel(Scanner text);

/// The first line that moves an axis, from 0, in a text that holds no sub-program.
std::optional<std::size_t> find_stray_motion(std::string_view text);

/// START_PRINT BED=60: three letters in a row, or an underscore, begin no block.
bool is_macro_line(Scanner text);

}  // namespace toolpace::nc
