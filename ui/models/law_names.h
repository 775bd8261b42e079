#pragma once
/// Velocity laws as people read them, in the language of the window.

#include <QString>

#include "toolpace/law/law_table.h"

namespace toolpace::ui {

QString law_title(const LawRow& row);

}  // namespace toolpace::ui
