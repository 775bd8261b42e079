#pragma once
/// Fields take what machine files and flags take.

#include <string>

#include "panels/number_field.h"

namespace toolpace::ui {

/// What a machine file or a flag takes for this number, see find_number().
NumberField::Range range_of_key(const std::string& section, const std::string& key);

}  // namespace toolpace::ui
