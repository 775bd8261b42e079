#pragma once
/// A single move as curves and phases to draw.

#include <QString>
#include <array>
#include <vector>

#include "toolpace/law/single_move.h"

namespace toolpace::ui {

/// Units of a single move: the calculation itself has none.
enum class MoveUnits { millimetres, pulses };

enum class MoveQuantity { length, speed, time, acceleration, jerk };

/// "mm/s²" or "pulse/cycle²"
QString move_unit_text(MoveQuantity quantity, MoveUnits units);

/// A stretch of the move that is drawn in one shade.
struct MovePhase {
  enum class Kind { speeding_up, cruise, slowing_down };
  double begin, duration;
  Kind kind;
};

/// Samples of the exact polynomials, both sides of every step of jerk.
struct MovePreview {
  SingleMove move;
  std::vector<MovePhase> phases;
  std::vector<double> time, speed, acceleration, jerk, distance;

  double end() const { return time.empty() ? 0.0 : time.back(); }
};

MovePreview preview_move(const SingleMove& move);

/// What a person types into the form.
struct MoveForm {
  LawKind law = LawKind::five_phase_time;
  MoveUnits units = MoveUnits::pulses;
  MoveRequest move;
  double t_acc = 35, t_dec = 20;
  double acceleration = 3000, deceleration = 3000, jerk = 1e6, jerk_deceleration = 1e6;

  /// The limits that the law looks at; the others are unbounded.
  Dynamics dynamics() const;
};

/// A named form to start from.
struct MovePreset {
  const char* id;
  MoveForm form;
};

/// Zheng's two moves (tables 1 and 2) and one for each other kind of limit.
const std::array<MovePreset, 4>& move_presets();

}  // namespace toolpace::ui
