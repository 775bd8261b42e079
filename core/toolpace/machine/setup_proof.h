#pragma once
/// What is written can be read again.

#include <string>
#include <string_view>

#include "toolpace/machine/setup.h"

namespace toolpace {

/// The text, if it reads back to the values of `setup`. Errors: "bad-limit" of check_setup(), "machine-unwritable".
Result<std::string> proven_text(std::string text, const Setup& setup, UnknownKeys unknown);

}  // namespace toolpace
