#pragma once
/// What the readers of other controllers' settings share: values by key, carried to the keys of a machine file.

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "toolpace/base/result.h"
#include "toolpace/machine/setup.h"

namespace toolpace {

struct ImportedValue {
  std::string text;
  std::size_t line;
  /// Where `text` begins in the text that was read; nothing for what stands in a file that this one includes.
  std::optional<std::size_t> at = {};
  std::optional<std::size_t> again = {};  ///< a line that gives the key another value, which does not count
};
using ImportedValues = std::map<std::string, ImportedValue, std::less<>>;  ///< by key; the first one counts

std::string_view trimmed(std::string_view text);
std::string upper(std::string_view text);

/// Takes the first line off a text that is not empty. @return it, without its end: "\n", "\r\n", or "\r" alone
inline std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end);
  text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, text.size()));
  return line;
}

/// Calls take(line, number) for each line, trimmed.
template <class Take>
void for_each_line(std::string_view text, const Take& take) {
  for (std::size_t number = 1; !text.empty(); ++number) take(trimmed(take_line(text)), number);
}

/// Carries values of a controller to the keys of a machine file. The first thing that is wrong stops it.
class Importer {
 public:
  Importer(ImportedValues values, std::string name) : values_(std::move(values)), name_(std::move(name)) {}

  Setup& setup() { return setup_; }
  const ImportedValues& values() const { return values_; }

  const ImportedValue* find(std::string_view key) const;

  /// The number under `key`, if it is there, times `unit`.
  std::optional<double> take(std::string_view key, double unit);

  /// Stores the number under the first of `keys` that is there as one of a machine file.
  /// @param none  a value that stands for no limit
  void take(const std::string& section, const std::string& key, std::initializer_list<std::string_view> keys,
            double unit, std::optional<double> none = {});
  /// Stores a number that was taken.
  void put(const std::string& section, const std::string& key, double value);

  /// @param low, high  in mm or degrees
  void set_travel(std::size_t axis, double low, double high);

  /// Says that the value under `key`, which is there, is none of what it must be.
  void refuse(std::string_view key, std::string_view must_be);

  /// Something that the settings leave open. @param line  0 = no line says it
  void warn(std::string code, std::string message, std::string remedy, std::size_t line);

  /// @param what  whose settings they should be, with its article
  Result<Setup> finish(const char* what);

 private:
  void fail(std::string message);

  ImportedValues values_;
  std::string name_;
  Setup setup_;
  std::optional<Error> error_;
  std::string last_key_;
  std::size_t last_line_ = 0;
  int taken_ = 0;
};

}  // namespace toolpace
