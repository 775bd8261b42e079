#pragma once
/// Files that people take for a controller's settings, and what they are.

#include <string_view>

namespace toolpace {

/// What a text is that is none of the settings read here, in words that follow "this is "; empty where nothing tells.
std::string_view kind_of_other_text(std::string_view text);

/// Whether it is a config.g of RepRapFirmware, whose M201 and M203 are no Marlin's: it counts in mm/min.
bool is_reprapfirmware(std::string_view text);

}  // namespace toolpace
