#pragma once
/// What the name of a file says of its format.

#include <filesystem>
#include <string>

namespace toolpace {

/// ASCII letters in their small form; everything else as it is.
std::string lower_case(std::string text);

/// The extension with its dot, in small letters: ".csv" of "PART.CSV"; empty where there is none.
std::string extension_of(const std::filesystem::path& file);

/// The one before it: ".pulses" of "part.Pulses.csv".
std::string inner_extension_of(const std::filesystem::path& file);

}  // namespace toolpace
