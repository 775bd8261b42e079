#pragma once
/// Settings of other controllers as text: which values stand in it, under which keys.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "toolpace/machine/controller.h"
#include "toolpace/machine/importer.h"

namespace toolpace {

/// The text of a file that another one includes; nothing where it cannot be read. A pattern such as "parts/*.cfg" gives the
/// texts of all that fit, in the order of their names.
using ReadIncluded = std::function<std::vector<std::string>(std::string_view name)>;

/// "$110" and "6000.000" of a line that has such a setting, whatever a sender or a console puts around it: a time, an arrow,
/// "(x max rate, mm/min)", the quotes and colons of JSON. Nothing where there is none.
std::optional<std::pair<std::string_view, std::string_view>> grbl_setting_in(std::string_view line);
/// Whether grbl 1.1 itself has a setting of this key; others are those of its descendants.
bool is_setting_of_grbl(std::string_view key);
/// By "$110". A dump may come more than once in the log of a console: what comes last counts.
ImportedValues read_grbl_values(std::string_view text);

/// One command of a report of M503: its number and words, as "M203 X500.00 Y500.00".
struct MarlinWords {
  std::string code;                                      ///< "M203"
  std::vector<std::pair<char, std::string_view>> words;  ///< letter and number, which is part of the line
};
/// What a line of a report says, with what a console puts before it; nothing where it is no command of settings.
std::optional<MarlinWords> marlin_words_in(std::string_view line);
/// The key of a report that is in inches.
inline constexpr std::string_view kInchesOfMarlin = "G20";
/// By "M203 X"; what comes last counts.
ImportedValues read_marlin_values(std::string_view text);

/// By "TRAJ.MAX_LINEAR_VELOCITY", upper case; the first one counts. Lines #INCLUDE FILE are followed.
ImportedValues read_ini_values(std::string_view text, const ReadIncluded& included = {});

/// By "printer.max_accel", lower case, comments and lines that go on left out; the last one counts, that of the block of
/// SAVE_CONFIG (lines of #*#) above all. Sections [include FILE] are followed; each other one is there as "gcode_arcs.", too, as
/// some say by being there what they say.
ImportedValues read_klipper_values(std::string_view text, const ReadIncluded& included = {});

/// As the controller's texts are read.
ImportedValues read_controller_values(std::string_view text, Controller controller, const ReadIncluded& included = {});
/// The key among these values of what people know as "[printer] max_accel", "$110" or "M203 X".
std::string key_in_values(const std::string& key, Controller controller);

}  // namespace toolpace
