#pragma once
/// What the system says about a file, as an error value people can act on.

#include <filesystem>
#include <string_view>

#include "toolpace/base/result.h"

namespace toolpace {

/// Error of kind io for a failed system call, or of kind cancelled where that is why it was given up.
///
/// @param number  errno of the call; ECANCELED = it was stopped
/// @param action  what was tried, as a verb: "open", "read", "write"
/// @return codes: file-not-found, is-directory, no-permission, disk-full, closed-pipe, file-too-large, file-trouble
Error file_error(int number, const std::filesystem::path& file, std::string_view action);

}  // namespace toolpace
