#pragma once
/// Widgets as they stay.

namespace toolpace::ui {

/// Handles events until none is left: what was asked for is laid out and painted.
void finish_drawing();

}  // namespace toolpace::ui
