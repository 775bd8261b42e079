#pragma once
/// Perceptual, colour-blind-safe maps from a level in 0 … 255 to a colour, for light and for dark ground.

#include <QRgb>
#include <QString>
#include <array>
#include <cstdint>
#include <optional>

namespace toolpace::ui {

enum class ColourMap : std::uint8_t { cividis, viridis, turbo };

/// "cividis", "viridis", "turbo": as preferences keep it.
QString colour_map_name(ColourMap map);
std::optional<ColourMap> colour_map_named(const QString& name);

/// What the map is drawn on. Towards the ground's own lightness a map loses contrast, so its far end is pulled away.
enum class Ground : std::uint8_t { light, dark };

using ColourTable = std::array<QRgb, 256>;

/// The map's colour at `fraction` in [0, 1] as published.
/// @source cividis: Nuñez, Anderton, Renslow 2018; viridis: Smith, van der Walt 2015; turbo: Mikhailov 2019
QRgb map_colour(ColourMap map, double fraction);

/// 256 colours, adapted so that each has a contrast of at least 2 against the ground of the theme; the lightness of
/// cividis and viridis still rises from level to level.
ColourTable colour_table(ColourMap map, Ground ground);

/// Of values with a sign: blue below zero, orange above it, and at zero (levels 127 and 128) a grey that stands back. Each has a
/// contrast of at least 2 against the ground, and to its ends it grows. Blue and orange differ for colour-blind eyes, too.
/// @source Moreland 2009, Diverging color maps for scientific visualization: two hues that meet in a neutral one
ColourTable diverging_table(Ground ground);

/// Contrast of two colours, 1 … 21. @source WCAG 2.1, relative luminance
double contrast(QRgb a, QRgb b);

/// Relative luminance, 0 … 1. @source WCAG 2.1
double luminance(QRgb colour);

}  // namespace toolpace::ui
