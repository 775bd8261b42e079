#pragma once
/// The codes of errors and warnings that the window says in its own language.

#include <span>

namespace toolpace::ui {

/// Sorted. The translations stand in the context "codes".
std::span<const char* const> diagnostic_codes();

}  // namespace toolpace::ui
