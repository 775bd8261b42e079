#pragma once
/// The keys of a machine file, one table for reading, writing and naming the nearest known key.

#include <string>
#include <string_view>
#include <vector>

#include "toolpace/machine/setup.h"

namespace toolpace {

enum class KeyRange : std::uint8_t { positive, not_negative, share };

bool is_in_range(double value, KeyRange range);
/// "> 0", "≥ 0", "between 0 and 1"
const char* range_text(KeyRange range);

struct NumberKey {
  std::string name;
  double* value;
  double unit;  ///< core value = file value · unit
  KeyRange range;
};

/// Two numbers [min, max].
struct RangeKey {
  std::string name;
  double *low, *high;
  double unit;
};

/// Names of enumerated values, as flags and files spell them.
template <class T>
struct Named {
  std::string_view name;
  T value;
};
const std::vector<Named<Ramps>>& ramps_names();
const std::vector<Named<CornerRule>>& corner_names();

/// Sections "machine", "path", "law", "lookahead" and "axes.X" … "axes.C". The pointers point into `setup`.
struct SetupSection {
  std::string name;
  std::vector<NumberKey> numbers;
  std::vector<RangeKey> ranges;
  std::vector<std::string> words;  ///< keys with other values: name, kind, blocks, ramps, corner
};
std::vector<SetupSection> setup_sections(Setup& setup);

/// The least number of letters to insert, drop or change that makes one word the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate with the least edit distance to `word`.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace toolpace
