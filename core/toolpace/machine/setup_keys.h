#pragma once
/// The keys of a machine file and what their values may be: one table for reading, writing, checking, flags, imports and
/// fields of the window, and for naming the nearest known key.

#include <string>
#include <string_view>
#include <vector>

#include "toolpace/machine/setup.h"

namespace toolpace {

/// The numbers that make sense for a value, in the unit that its name says. What lies beyond is a slip of the pen or the
/// unit, and with it sums of speeds, times and lengths would lose their digits.
struct NumberRange {
  double least, most;            ///< both included
  const char* unit = "";         ///< "mm/s²"; empty for pure numbers
  bool may_be_zero = false;      ///< 0 too, as "none"
  bool may_be_infinite = false;  ///< inf too, as "no limit"
};

/// Rounding of the unit's conversion apart.
bool is_in_range(double value, const NumberRange& range);
/// "1e-6 to 1e9 mm/s, or inf for no limit"
std::string range_text(const NumberRange& range);

struct NumberKey {
  std::string name;
  double* value;
  double unit;  ///< core value = file value · unit
  NumberRange range;
};

/// Two numbers [min, max], min < max.
struct RangeKey {
  std::string name;
  double *low, *high;
  double unit;
  NumberRange range;  ///< of either end; −inf and inf leave it open
};
bool is_ordered(const RangeKey& key);
/// "[min, max] with min < max, each from −1e9 to 1e9 mm, or -inf and inf where it is open"
std::string range_text(const RangeKey& key);

/// Names of enumerated values, as flags and files spell them.
template <class T>
struct Named {
  std::string_view name;
  T value;
};
const std::vector<Named<Ramps>>& ramps_names();
const std::vector<Named<CornerRule>>& corner_names();
const std::vector<Named<ShaperKind>>& shaper_names();
inline constexpr std::size_t kDeepestLookahead = 1'000'000'000;  ///< blocks

/// Sections "machine", "path", "law", "lookahead", "axes.X" … "axes.C" and "servo.X" … "servo.C". The pointers point into
/// `setup`.
struct SetupSection {
  std::string name;
  std::vector<NumberKey> numbers;
  std::vector<RangeKey> ranges;
  std::vector<std::string> words;  ///< keys with other values: name, kind, blocks, ramps, corner, shaper, modes
};
std::vector<SetupSection> setup_sections(Setup& setup);

/// Of "axes.X" and "servo.X".
std::size_t axis_of_section(std::string_view section);

inline constexpr const char* kModesKey = "modes";  ///< of servo.X: a list of tables
/// The numbers of one of them; all but the frequency may be left out.
std::vector<NumberKey> mode_keys(AxisMode& mode);

/// What a job says and no machine file: overrides, the step of corners and the time of a feed hold where they are given.
SetupSection job_section(PlanOptions& options);

/// One number of setup_sections() or job_section() (section ""); the key must exist.
NumberKey find_number(Setup& setup, std::string_view section, std::string_view key);

}  // namespace toolpace
