/// Answers to $$ of grbl and its descendants, as consoles, senders and tables of them have them.

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "toolpace/machine/settings_text.h"

namespace toolpace {
namespace {

constexpr std::size_t kFarthestValue = 200;  // letters from a key of JSON to its value

bool is_digit_of_key(char c) { return c >= '0' && c <= '9'; }
bool is_blank_or_quote(char c) { return c == ' ' || c == '\t' || c == '"' || c == '\''; }
bool is_between_words(char c) { return is_blank_or_quote(c) || c == ',' || c == '\r' || c == '\n'; }
bool begins_number(std::string_view text) {
  return !text.empty() && (is_digit_of_key(text.front()) || text.front() == '-' || text.front() == '.');
}

std::size_t skip_all(std::string_view text, std::size_t at, bool (*is)(char)) {
  while (at < text.size() && is(text[at])) ++at;
  return at;
}

/// The value at the begin of a text. A comma is its end, unless it is one of decimals.
std::string_view value_at(std::string_view text, bool has_decimal_comma) {
  std::size_t end = std::min(text.find_first_of(" \t\r\n\"',;()<|}]"), text.size());
  if (has_decimal_comma && end + 1 < text.size() && text[end] == ',' && is_digit_of_key(text[end + 1]))
    end = std::min(text.find_first_of(" \t\r\n\"';()<|}]", end), text.size());
  return trimmed(text.substr(0, end));
}

/// Of a "value" that a list of JSON has behind its "key": "$110".
std::optional<std::string_view> named_value(std::string_view text) {
  constexpr std::string_view kValue = "value";
  text = text.substr(0, std::min(text.find_first_of("{}"), kFarthestValue));
  text.remove_prefix(skip_all(text, 0, is_between_words));
  if (!text.starts_with(kValue)) return std::nullopt;
  text.remove_prefix(skip_all(text, kValue.size(), is_blank_or_quote));
  if (!text.starts_with(':')) return std::nullopt;
  text.remove_prefix(skip_all(text, 1, is_blank_or_quote));
  return value_at(text, true);
}

/// The setting whose $ is the first letter of a text.
std::optional<std::pair<std::string_view, std::string_view>> setting_at(std::string_view text) {
  const std::size_t end = skip_all(text, 1, is_digit_of_key);
  if (end == 1) return std::nullopt;
  const std::string_view key = text.substr(0, end);
  const std::size_t mark = skip_all(text, end, is_blank_or_quote);
  if (mark >= text.size()) return std::nullopt;
  if (text[mark] == '=' || text[mark] == ':') {
    return std::pair(key, value_at(text.substr(skip_all(text, mark + 1, is_blank_or_quote)), true));
  }
  // A row of a table: commas, semicolons or tabs.
  const bool has_comma = text[mark] == ',' || text[mark] == ';';
  const std::string_view cell = text.substr(skip_all(text, mark + (has_comma ? 1 : 0), is_blank_or_quote));
  const bool has_tab = text.substr(end, mark - end).find('\t') != std::string_view::npos;
  if ((has_comma || has_tab) && begins_number(cell)) return std::pair(key, value_at(cell, false));
  if (!has_comma && text[mark] != '\r' && text[mark] != '\n') return std::nullopt;
  const auto value = named_value(text.substr(mark));
  return value ? std::optional(std::pair(key, *value)) : std::nullopt;
}

}  // namespace

std::optional<std::pair<std::string_view, std::string_view>> grbl_setting_in(std::string_view line) {
  for (std::size_t at = line.find('$'); at != std::string_view::npos; at = line.find('$', at + 1)) {
    if (auto setting = setting_at(line.substr(at))) return setting;
  }
  return std::nullopt;
}

bool is_setting_of_grbl(std::string_view key) {
  constexpr std::array<int, 34> kSettings = {0,   1,   2,   3,   4,   5,   6,   10,  11,  12, 13,  20,
                                             21,  22,  23,  24,  25,  26,  27,  30,  31,  32, 100, 101,
                                             102, 110, 111, 112, 120, 121, 122, 130, 131, 132};
  const std::string number(key.substr(1));
  return std::any_of(kSettings.begin(), kSettings.end(), [&](int k) { return std::to_string(k) == number; });
}

ImportedValues read_grbl_values(std::string_view text) {
  ImportedValues values;
  std::string_view rest = text;
  for (std::size_t line = 1; !rest.empty(); ++line) {
    const std::string_view content = take_line(rest);
    for (std::size_t at = content.find('$'); at != std::string_view::npos; at = content.find('$', at + 1)) {
      // The value may stand in a line behind.
      const auto setting = setting_at(text.substr(static_cast<std::size_t>(content.data() - text.data()) + at));
      if (!setting) continue;
      const auto& [key, value] = *setting;
      const auto place = static_cast<std::size_t>(value.data() - text.data());
      values.insert_or_assign(std::string(key), ImportedValue{std::string(value), line, place});
    }
  }
  return values;
}

}  // namespace toolpace
