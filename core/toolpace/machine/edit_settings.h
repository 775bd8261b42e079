#pragma once
/// Changes settings of a controller in their own text.

#include <string>
#include <string_view>

#include "toolpace/base/result.h"
#include "toolpace/machine/controller_settings.h"

namespace toolpace {

/// The text with one parameter changed, and nothing else: comments, order, what consoles put around it, and what other lines say
/// stay as they are. What stands twice is changed where it counts; what is missing gets a line of its own. A limit of an axis that
/// the text tells by joints is changed for each of them.
///
/// @param key       of parameters()
/// @param value     in the parameter's unit
/// @param included  as the text was read with
/// @return usage errors: "settings-included" for what stands in a file that this one includes; "settings-unwritable" where there is
///         no place for it, or where it would change something else; those of parse_controller_settings() for a value that the
///         controller does not take
Result<std::string> edit_controller_setting(std::string_view text, const std::string& name, Controller controller,
                                            const std::string& key, double value, const ReadIncluded& included = {});

}  // namespace toolpace
