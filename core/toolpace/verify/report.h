#pragma once
/// What verification found.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace toolpace {

enum class CheckKind : std::uint8_t {
  axis_speed,
  axis_acceleration,
  axis_jerk,  ///< by differences of the positions [mm or rad, s]
  travel_min,
  travel_max,  ///< [mm, rad]
  path_speed,  ///< by differences [mm/s]
  path_acceleration,
  path_deceleration,
  path_jerk,  ///< of the columns
  time_step,  ///< largest error of t against k·Ts [s]
  speed_column,
  acceleration_column,
  jerk_column,  ///< largest disagreement with the differences; of the columns of an axis where there is one
  line_column,  ///< rows whose line is not the one under the tool
  follows_path,
  deviation,
  tool_angle,  ///< between the tool and the programmed one [rad]
  end_point    ///< [mm]
};

/// "axis-speed", …: the key of JSON and translations.
const char* key_of(CheckKind kind);

/// One thing that was checked, with the worst that was found.
struct Check {
  CheckKind kind = CheckKind::axis_speed;
  std::optional<std::size_t> axis = {};  ///< for the axis_… and travel_… kinds, and columns of an axis
  double value = 0.0;                    ///< the worst
  /// What it may be; infinite = measured but not judged.
  double limit = std::numeric_limits<double>::infinity();
  double bound = 0.0;  ///< error bound: a value up to limit + bound holds, beyond it the limit is broken for certain
  std::int64_t row = 0;
  double time = 0.0;       ///< [s] of that row
  std::uint32_t line = 0;  ///< NC line of that row; 0 = unknown
  bool broken = false;
};

/// "X speed", "deviation from the path", …
std::string check_title(const Check& check);

/// In which unit people read a check: its value there is value / size.
struct CheckUnit {
  double size;         ///< in the core's own unit
  const char* symbol;  ///< mm/s, deg, …
  const char* key;     ///< the same in a key's name: mm_s
};
CheckUnit check_unit(const Check& check);

struct VerifyReport {
  std::int64_t rows = 0;
  double period = 0.0;    ///< [s]
  double duration = 0.0;  ///< [s]
  std::vector<Check> checks;
  /// Corners that were passed with a speed step and joints of different curvature that explain an excess of acceleration
  /// or jerk, and are exempt by as much as they explain.
  std::int64_t exempt_corners = 0;
  double largest_corner_step = 0.0;  ///< [mm/s]
  /// Largest distance between the path and the straight lines between setpoints [mm]; only with a program.
  std::optional<double> chord_error = {};
  /// A change of one position by more than this is caught, wherever it is [mm]; infinite = no limit that would tell.
  double position_resolution = std::numeric_limits<double>::infinity();
  std::vector<std::string> notes;  ///< what the reader should know, such as a period other than the machine's

  bool passes() const {
    for (const auto& check : checks) {
      if (check.broken) return false;
    }
    return true;
  }
};

}  // namespace toolpace
