#pragma once
/// What the columns of a trace mean: guessed from their names and units, or told.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "toolpace/base/result.h"

namespace toolpace {

enum class TraceRole : std::uint8_t {
  ignored,
  time,
  sample,    ///< number of the sample, in place of a time
  position,  ///< of an axis; the name does not say whether commanded or actual
  commanded,
  actual
};

struct TraceColumn {
  std::string name = {};
  TraceRole role = TraceRole::ignored;
  std::size_t axis = 0;
  double unit = 1.0;           ///< value in s, mm or rad = number in the file · unit
  std::string unit_name = {};  ///< "mm"; empty where nothing tells it
};

/// One entry of `--columns t=…,x=…`: which column is the time, or where an axis is.
struct TraceMapping {
  TraceRole role = TraceRole::ignored;  ///< time, actual or commanded
  std::size_t axis = 0;
  std::string column = {};  ///< its name, or its number from 1; a unit in brackets may follow: 3[um]
};

/// Reads "t=time,x=3[um],commanded_x=2". Errors (usage): trace-columns.
Result<std::vector<TraceMapping>> parse_trace_mapping(std::string_view text);

/// s, ms, us, ns, min; mm, um, nm, m, in, deg, rad and other spellings. Nothing for words that are no unit of the kind.
std::optional<double> time_unit(std::string_view name);
std::optional<double> position_unit(std::string_view name, std::size_t axis);

/// What a name says, and the unit beside it (may be empty).
TraceColumn guess_column(std::string_view name, std::string_view unit);

/// Settles the columns of one file. Where an axis has both a commanded and an actual position, a name without a word for it
/// is the other one; where it has one alone, this is what was measured.
///
/// @param mapping  empty = by the guesses alone; else what it names, and nothing else
/// @param file     for messages
/// Errors: usage: trace-columns; input: trace-columns where nothing is a position.
Result<void> settle_columns(std::vector<TraceColumn>& columns, const std::vector<TraceMapping>& mapping,
                            const std::string& file);

}  // namespace toolpace
