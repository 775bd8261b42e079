#pragma once
/// Questions before something would be lost.

#include <QString>

class QWidget;

namespace toolpace::studio {

enum class Answer { save, discard, cancel };

/// Asks what to do with changes that are not saved.
/// @param what  sentence that says whose they are
Answer ask_about_changes(QWidget* parent, const QString& what);

/// Asks whether to replace a file that was changed outside.
bool ask_to_replace(QWidget* parent, const QString& name);

}  // namespace toolpace::studio
