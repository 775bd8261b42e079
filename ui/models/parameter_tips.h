#pragma once
/// What a setting does, in one sentence with its formula.

#include <QString>

namespace toolpace::ui {

/// Of a field of the tuning panel, by its name; empty where there is none.
QString parameter_tip(const QString& field);

}  // namespace toolpace::ui
