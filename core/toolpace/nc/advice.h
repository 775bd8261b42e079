#pragma once
/// What those who begin may have meant by text that is no word: remedies of diagnostics.

#include <string>
#include <string_view>

#include "toolpace/nc/text/scanner.h"

namespace toolpace::nc {

inline constexpr const char* kMeantZero = "is this letter O meant to be the digit 0?";

/// The first character as a person knows it: itself, of UTF-8 with its number, or a byte.
std::string shown_character(std::string_view rest);

/// "word X has no number", and what stands there instead where that is hard to see.
std::string word_without_number(Scanner text, char letter);

/// What may be meant by text that stands where a word's number is wanted.
const char* meant_as_number(Scanner text);

/// What may be meant by a character that begins no word.
const char* meant_as_word(char c);

}  // namespace toolpace::nc
