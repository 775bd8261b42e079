#pragma once
/// Core units (mm, s, rad) as people read them.

#include <QString>

namespace toolpace::ui {

enum class Quantity {
  length,
  speed,
  acceleration,
  jerk,
  angle,
  angular_speed,
  angular_acceleration,
  angular_jerk,
  time
};

enum class LengthUnit { mm, inch };

/// How a quantity is displayed: shown = core · factor, followed by `text`.
struct DisplayUnit {
  double factor;
  QString text;  ///< "mm/s²"
};
DisplayUnit display_unit(Quantity quantity, LengthUnit unit);

/// Of errors of a motion: µm, or thousandths of an inch.
DisplayUnit error_unit(LengthUnit unit);

/// The same quantity of a rotary axis.
Quantity rotary(Quantity quantity);

/// `value` in core units as text with at most `digits` significant digits, digits grouped by thin spaces from 10 000
/// on; "∞" where unlimited, "–" where not a number. Always a point as the decimal mark.
QString number_text(double value, int digits = 6);
QString value_text(double core_value, Quantity quantity, LengthUnit unit, int digits = 6);

/// "12.345 s", "2 min 03.4 s", "1 h 02 min"
QString duration_text(double seconds);

}  // namespace toolpace::ui
