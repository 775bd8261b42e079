#pragma once
/// The colours of the window, as plain values: widgets are given a Theme and never look one up.

#include <QColor>

namespace toolpace::ui {

struct Theme {
  bool dark = false;
  QColor window, surface, line;  ///< chrome, panels and plots, 1 px rules
  QColor text, secondary;        ///< contrast ≥ 4.5 against window and surface
  QColor accent, plan_b;         ///< plan A and the cursor; plan B, always dashed
  QColor axis_x, axis_y, axis_z;
  QColor warning, error, good;
};

inline Theme light_theme() {
  return {false,
          QColor(0xF5, 0xF6, 0xF8),
          QColor(0xFF, 0xFF, 0xFF),
          QColor(0xD7, 0xDB, 0xE0),
          QColor(0x1B, 0x1F, 0x24),
          QColor(0x5B, 0x64, 0x70),
          QColor(0x0B, 0x6B, 0xCB),
          QColor(0xC2, 0x57, 0x1A),
          QColor(0xD6, 0x45, 0x45),
          QColor(0x2E, 0x8B, 0x57),
          QColor(0x3B, 0x6F, 0xD4),
          QColor(0xB2, 0x5E, 0x00),
          QColor(0xC6, 0x28, 0x28),
          QColor(0x2E, 0x7D, 0x32)};
}

inline Theme dark_theme() {
  return {true,
          QColor(0x14, 0x17, 0x1B),
          QColor(0x1C, 0x20, 0x26),
          QColor(0x2E, 0x34, 0x3C),
          QColor(0xE6, 0xE9, 0xED),
          QColor(0x98, 0xA2, 0xAE),
          QColor(0x4D, 0xA3, 0xFF),
          QColor(0xFF, 0x9F, 0x5A),
          QColor(0xFF, 0x7B, 0x7B),
          QColor(0x5C, 0xC9, 0x8C),
          QColor(0x7F, 0xA6, 0xFF),
          QColor(0xFF, 0xB4, 0x54),
          QColor(0xFF, 0x6B, 0x6B),
          QColor(0x6B, 0xCB, 0x77)};
}

}  // namespace toolpace::ui
