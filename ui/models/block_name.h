#pragma once
/// How people name a block of a program, and a place in its motion.

#include <QString>
#include <cstdint>
#include <optional>

#include "models/document.h"

namespace toolpace::ui {

/// "N103" where the line begins with that number, else "line 5"; "–" for 0.
QString block_name(const Document& document, std::uint32_t line);

/// A place that was asked for: one of the two.
struct Place {
  std::optional<std::uint32_t> line;
  std::optional<double> time;  ///< [s]
};

/// "120" is a line, "N120" the first block of that number, "12.5 s" a time. Nothing where it is none of these, or not there.
std::optional<Place> place_named(const Document& document, const QString& text);

}  // namespace toolpace::ui
