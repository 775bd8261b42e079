#pragma once
/// What the window calls the parts of a prediction, and the sentence that it comes to.

#include <QString>
#include <optional>
#include <string>

#include "toolpace/controller/prediction.h"

namespace toolpace::ui {

/// "X acceleration" of parameters(), in the language of the window.
QString setting_title(const std::string& title);
/// A setting as people look for it: its key, and what it is where the key does not say so: "$120 X acceleration".
QString setting_name(const std::string& key, const std::string& title);
/// "mm/min"; nothing for ratios and for what is on or off.
QString setting_unit(const std::string& unit);

/// "stops": what holds a controller's motion down.
QString time_limit_title(TimeLimit limit);

/// "On grbl 2 h 41 min, 3 min of it for blocks that have not come; as setpoints 1 h 58 min".
/// @param as_setpoints  [s]; none = not known yet
QString controller_verdict(const Prediction& prediction, std::optional<double> as_setpoints);

}  // namespace toolpace::ui
