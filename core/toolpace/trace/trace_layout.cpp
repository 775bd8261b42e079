#include "toolpace/trace/trace_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "toolpace/base/axes.h"
#include "toolpace/trace/trace_columns.h"

namespace toolpace::detail {
namespace {

constexpr std::size_t kLongestPreamble = 400;  // lines; TwinCAT's has about 25
constexpr std::size_t kLongestNumber = 64;
constexpr std::size_t kRowsForGuesses = 32;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::array kSeparators = {'\t', ';', ',', ' ', '|'};

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (is_blank(text.front()) || text.front() == '"')) text.remove_prefix(1);
  while (!text.empty() && (is_blank(text.back()) || text.back() == '"')) text.remove_suffix(1);
  return text;
}

/// The numbers of a line, if it holds nothing else.
std::optional<std::vector<double>> numbers_of(std::string_view line, char separator) {
  std::vector<double> numbers;
  for (const std::string_view field : split_line(line, separator)) {
    double value = 0;
    if (take_number(field, separator, value) != field.size() || field.empty()) return {};
    numbers.push_back(value);
  }
  return numbers.empty() ? std::nullopt : std::optional(numbers);
}

struct Row {
  char separator = ',';
  std::vector<double> numbers;
};

/// By the separator that makes most of it.
std::optional<Row> row_of(std::string_view line) {
  std::optional<Row> best;
  for (const char separator : kSeparators) {
    auto numbers = numbers_of(line, separator);
    if (numbers && (!best || numbers->size() > best->numbers.size())) best = Row{separator, std::move(*numbers)};
  }
  return best;
}

bool is_unit(std::string_view field) {
  return time_unit(field) || position_unit(field, 0) || position_unit(field, kAxisCount - 1);
}

std::vector<std::string> texts_of(std::string_view line, char separator) {
  if (line.starts_with('#')) line.remove_prefix(1);
  std::vector<std::string> texts;
  for (const std::string_view field : split_line(line, separator)) texts.emplace_back(field);
  return texts;
}

/// Names and units in the lines above the rows.
void read_names(const std::vector<std::string>& above, std::size_t columns, TraceLayout& layout) {
  for (const std::string& line : above) {
    auto fields = texts_of(line, layout.separator);
    if (fields.size() < columns) continue;
    fields.resize(columns);
    if (fields[0] == "Name" && columns > 1) {
      layout.names = fields;
      layout.is_twincat = true;
    } else if (layout.is_twincat && fields[0] == "Unit") {
      layout.units = fields;
    }
  }
  if (layout.is_twincat) return;
  for (std::size_t i = above.size(); i-- > 0;) {
    if (trimmed(above[i]).empty()) continue;
    auto fields = texts_of(above[i], layout.separator);
    while (fields.size() > columns && fields.back().empty()) fields.pop_back();
    if (fields.size() != columns) return;
    std::vector<std::string> units = fields;
    for (std::string& unit : units) {
      if (unit.size() > 2 && (unit.front() == '[' || unit.front() == '(')) unit = unit.substr(1, unit.size() - 2);
    }
    if (i > 0 && layout.units.empty() && std::all_of(units.begin(), units.end(), is_unit)) {
      layout.units = units;
      continue;
    }
    layout.names = fields;
    return;
  }
}

Error layout_error(const char* code, std::string message, std::string remedy, const std::string& file) {
  return {ErrorKind::input, code, std::move(message), std::move(remedy), {file, 1, 0}, {}};
}

}  // namespace

std::vector<std::string_view> split_line(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  if (separator == ' ') {
    for (std::size_t at = 0; at < line.size();) {
      while (at < line.size() && is_blank(line[at])) ++at;
      std::size_t end = at;
      while (end < line.size() && !is_blank(line[end])) ++end;
      if (end > at) fields.push_back(line.substr(at, end - at));
      at = end;
    }
    return fields;
  }
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(separator, at), line.size());
    fields.push_back(trimmed(line.substr(at, end - at)));
    at = end + 1;
  }
  if (fields.size() > 1 && fields.back().empty()) fields.pop_back();  // a separator ends each line
  return fields;
}

std::size_t take_number(std::string_view text, char separator, double& value) {
  const std::size_t sign = text.starts_with('+') ? 1 : 0;
  const char *begin = text.data() + sign, *end = text.data() + text.size();
  auto [stop, error] = std::from_chars(begin, end, value);
  if (separator != ',' && (stop == end ? end : stop) != end && *stop == ',') {
    std::array<char, kLongestNumber> copy;
    const auto length = std::min(static_cast<std::size_t>(end - begin), copy.size());
    std::copy_n(begin, length, copy.begin());
    copy[static_cast<std::size_t>(stop - begin)] = '.';
    const auto [copy_stop, copy_error] = std::from_chars(copy.data(), copy.data() + length, value);
    return copy_error == std::errc{} ? sign + static_cast<std::size_t>(copy_stop - copy.data()) : 0;
  }
  return error == std::errc{} ? sign + static_cast<std::size_t>(stop - begin) : 0;
}

Result<TraceLayout> find_layout(LineReader& lines, const std::string& file) {
  TraceLayout layout;
  std::vector<std::string> above;
  std::optional<Row> before;
  std::uint64_t place = lines.at();
  for (std::size_t n = 0; n < kLongestPreamble; ++n) {
    const std::uint64_t here = lines.at();
    const std::size_t lines_before = lines.line();
    auto line = lines.next();
    if (!line) return tl::unexpected(line.error());
    if (!*line) break;
    std::string_view text = **line;
    if (n == 0 && text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    auto row = row_of(text);
    if (before) {  // blanks and tabs may stand for each other
      auto same = numbers_of(text, before->separator);
      if (same && same->size() == before->numbers.size()) row = Row{before->separator, std::move(*same)};
    }
    if (row && before && row->separator == before->separator && row->numbers.size() == before->numbers.size()) {
      layout.separator = row->separator;
      layout.body = place;
      layout.body_line = lines_before - 1;
      above.pop_back();
      read_names(above, row->numbers.size(), layout);
      layout.begin = {before->numbers, row->numbers};
      while (layout.begin.size() < kRowsForGuesses) {
        line = lines.next();
        if (!line) return tl::unexpected(line.error());
        auto more = *line ? numbers_of(**line, layout.separator) : std::nullopt;
        if (!more || more->size() != row->numbers.size()) break;
        layout.begin.push_back(std::move(*more));
      }
      return layout;
    }
    place = here;
    before = std::move(row);
    above.emplace_back(text);
  }
  if (above.empty()) return tl::unexpected(layout_error("trace-empty", "the file is empty", "", file));
  return tl::unexpected(layout_error("trace-broken", "there are no two lines of numbers one below the other",
                                     "a trace is a table of numbers with a name above each column", file));
}

}  // namespace toolpace::detail
