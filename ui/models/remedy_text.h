#pragma once
/// What a person can do about an error, in the language of the window.

#include <QString>
#include <span>
#include <string>

namespace toolpace::ui {

/// The core's remedies as the window knows them, translated in the context "remedies".
std::span<const char* const> remedy_sentences();

/// The core's sentence in the language of the window; as it is where nobody has translated it.
QString remedy_text(const std::string& english);

}  // namespace toolpace::ui
