#pragma once
/// Diagnostics in the language of the window.

#include <QString>
#include <string>

namespace toolpace::ui {

/// What a diagnostic says. English: its message. Otherwise the translation of its code where there is one, followed by the
/// English message, which holds the figures.
QString message_text(const std::string& code, const std::string& english);

}  // namespace toolpace::ui
