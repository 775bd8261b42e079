#pragma once
/// Lines that are no blocks: heads of programs, macros of senders and printers. Cursors stand on the first character.

#include "toolpace/nc/text/scanner.h"

namespace toolpace::nc {

/// "O1234" or ":1234": the head of a program, and nothing that it does.
bool begins_program_number(Scanner text);

/// "<NAME>": the same of Fanuc's 30i.
bool is_program_name(Scanner text);

/// "%wait", "%X0=posx" of senders.
bool is_sender_macro(Scanner text);

/// START_PRINT BED=60: three letters in a row, or an underscore, begin no block.
bool is_macro_line(Scanner text);

}  // namespace toolpace::nc
