#pragma once
/// What a line of codes that LinuxCNC runs first ([RS274NGC] RS274NGC_STARTUP_CODE) says of path control.

#include <cstddef>
#include <optional>
#include <string_view>

namespace toolpace {

/// How it leaves the path, until the program says otherwise.
struct StartupCode {
  enum class Control { none, exact_path, exact_stop, blend };  ///< none: nothing is said, or G64 without P

  Control control = Control::none;
  double unit = 1.0;                ///< [mm] of a number in it: G20 or G21
  std::optional<double> tolerance;  ///< [mm] of G64 P
  std::optional<double> naive;      ///< [mm] of its Q; where there is none, P counts for it
  std::size_t at = 0, length = 0;   ///< where the number behind P stands in the text
};

/// Of several G61, G61.1 and G64 the last one counts.
StartupCode read_startup_code(std::string_view text);

}  // namespace toolpace
