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

/// What a person reads lengths and speeds in. One choice holds everywhere; files and programs have their own.
struct Units {
  bool inch = false;  ///< lengths, and what is made of them, in inches; in mm else
  bool per_minute =
      false;  ///< speeds in units a minute, as programs have them; a second else. Not acceleration and jerk.
};

/// How a quantity is displayed: shown = core · factor, followed by `text`.
struct DisplayUnit {
  double factor;
  QString text;  ///< "mm/s²"
};
DisplayUnit display_unit(Quantity quantity, Units unit);

/// Of errors of a motion: µm, or thousandths of an inch.
DisplayUnit error_unit(Units unit);

/// How many decimals show as much of a quantity as `metric` decimals do in mm and s.
int decimals_of(Quantity quantity, int metric, Units units);

/// The same quantity of a rotary axis.
Quantity rotary(Quantity quantity);

/// `value` in core units as text with at most `digits` significant digits, digits grouped by thin spaces from 10 000
/// on; "∞" where unlimited, "–" where not a number. Always a point as the decimal mark.
QString number_text(double value, int digits = 6);
/// An error of a motion in that unit, without it: what is nothing but rounding (below a millionth of a unit) is 0.
QString error_text(double core_value, const DisplayUnit& unit, int digits = 4);
QString value_text(double core_value, Quantity quantity, Units unit, int digits = 6);

/// "12.345 s", "2 min 03.4 s", "1 h 02 min"
QString duration_text(double seconds);

}  // namespace toolpace::ui
