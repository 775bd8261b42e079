#pragma once
/// How people find a block of a program again.

#include <QString>
#include <cstdint>

#include "models/document.h"

namespace toolpace::ui {

/// "N103" where the line begins with that number, else "line 5"; "–" for 0.
QString block_name(const Document& document, std::uint32_t line);

}  // namespace toolpace::ui
