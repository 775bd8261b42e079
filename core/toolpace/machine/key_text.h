#pragma once
/// The values of a setup as the texts that a machine file has for them.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "toolpace/machine/setup_keys.h"

namespace toolpace {

inline constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";  ///< that some editors put in front of the text

struct KeyText {
  std::string name;
  std::vector<std::string> parts;  ///< two of a pair [min, max], else one

  std::string text() const;
  bool operator==(const KeyText&) const = default;
};

struct SectionText {
  std::string name;
  std::vector<KeyText> keys;  ///< every key that the section knows, in the order of new files
};

/// A value of the core in the unit of a file, in the shortest decimal that reads back to it.
std::string number_text(double value, double unit);

/// Numbers in the shortest decimal that reads back to the same value, or else to the nearest one.
std::vector<SectionText> texts_of(const Setup& setup);

/// What keys mean that are not there: the default, no limit, or for slowing down the limit of speeding up.
std::vector<SectionText> texts_of_absent_keys(const Setup& setup);

/// Whether a text says that there is no limit or no stepper, as an absent key does.
bool is_none(const KeyText& key);

/// The first value in which a machine file of one setup would differ from that of another: "[path] max_speed_mm_s".
std::optional<std::string> first_difference(const Setup& a, const Setup& b);

}  // namespace toolpace
