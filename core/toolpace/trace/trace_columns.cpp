#include "toolpace/trace/trace_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "toolpace/base/axes.h"
#include "toolpace/base/axis_unit.h"
#include "toolpace/base/numbers.h"

namespace toolpace {
namespace {

struct UnitName {
  std::string_view name;
  double size;
};
constexpr std::array kTimes = {UnitName{"s", 1},       UnitName{"sec", 1},   UnitName{"ms", 1e-3},
                               UnitName{"us", 1e-6},   UnitName{"µs", 1e-6}, UnitName{"μs", 1e-6},
                               UnitName{"usec", 1e-6}, UnitName{"ns", 1e-9}, UnitName{"min", 60}};
constexpr std::array kLengths = {UnitName{"mm", 1},    UnitName{"um", 1e-3},  UnitName{"µm", 1e-3},
                                 UnitName{"μm", 1e-3}, UnitName{"nm", 1e-6},  UnitName{"m", 1e3},
                                 UnitName{"in", 25.4}, UnitName{"inch", 25.4}};
constexpr std::array kAngles = {UnitName{"deg", kRadiansPerDegree}, UnitName{"°", kRadiansPerDegree},
                                UnitName{"degree", kRadiansPerDegree}, UnitName{"rad", 1}};

using Words = std::vector<std::string>;

template <std::size_t N>
bool is_one_of(const std::string& word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

template <std::size_t N>
bool has_one_of(const Words& words, const std::array<std::string_view, N>& wanted) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& w) { return is_one_of(w, wanted); });
}

template <std::size_t N>
std::optional<double> find_unit(std::string_view name, const std::array<UnitName, N>& units) {
  const auto at = std::find_if(units.begin(), units.end(), [&](const UnitName& u) { return u.name == name; });
  return at == units.end() ? std::nullopt : std::optional(at->size);
}

constexpr std::array<std::string_view, 5> kTimeWords = {"t", "time", "zeit", "timestamp", "temps"};
constexpr std::array<std::string_view, 3> kSampleWords = {"sample", "tag", "cycle"};
constexpr std::array<std::string_view, 15> kActualWords = {"act",      "actual",      "ist",     "fb",     "feedback",
                                                           "measured", "meas",        "encoder", "enc",    "real",
                                                           "true",     "istposition", "istwert", "actpos", "fbpos"};
constexpr std::array<std::string_view, 18> kCommandedWords = {
    "cmd",    "command", "commanded", "set",  "soll",    "setpoint",     "target",   "ref",    "reference",
    "demand", "desired", "nominal",   "setp", "planned", "sollposition", "sollwert", "setpos", "cmdpos"};
/// Of what is no position.
constexpr std::array<std::string_view, 22> kOtherWords = {
    "error", "err", "ferror", "lag",  "diff",   "deviation", "contour", "following",    "vel",  "velocity", "speed",
    "velo",  "acc", "accel",  "jerk", "torque", "current",   "load",    "acceleration", "temp", "line",     "feed"};
constexpr std::array<std::string_view, 5> kNumberedWords = {"axis", "joint", "achse", "pos", "motor"};

/// Small letters; parts at signs, between a small and a capital letter, and between letters and digits.
Words words_of(std::string_view name) {
  Words words;
  char before = ' ';
  for (const char c : name) {
    const auto u = static_cast<unsigned char>(c);
    const bool is_letter = std::isalpha(u) != 0, is_digit = std::isdigit(u) != 0;
    const auto b = static_cast<unsigned char>(before);
    const bool begins = (!std::isalnum(b)) || (std::isupper(u) && std::islower(b)) || (is_digit && std::isalpha(b)) ||
                        (is_letter && std::isdigit(b));
    before = c;
    if (!is_letter && !is_digit) continue;
    if (begins || words.empty()) words.emplace_back();
    words.back() += static_cast<char>(std::tolower(u));
  }
  return words;
}

std::optional<std::size_t> axis_letter(const std::string& word) {
  constexpr std::string_view kLetters = "xyzabc";
  if (word.size() != 1 || kLetters.find(word[0]) == std::string_view::npos) return {};
  return kLetters.find(word[0]);
}

/// "axis.x.pos-cmd", "Axis 1.ActPos" (from 1), "joint.0.pos-fb" (from 0).
std::optional<std::size_t> axis_of(const Words& words) {
  for (const std::string& word : words) {
    if (const auto axis = axis_letter(word)) return axis;
  }
  for (const std::string& word : words) {  // "posX", "xpos" in small letters
    for (std::string_view base : {"pos", "act", "axis"}) {
      if (word.size() != base.size() + 1) continue;
      if (word.starts_with(base)) {
        if (const auto axis = axis_letter(word.substr(base.size()))) return axis;
      }
      if (word.ends_with(base)) {
        if (const auto axis = axis_letter(word.substr(0, 1))) return axis;
      }
    }
  }
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (!is_one_of(words[i], kNumberedWords) || words[i + 1].size() != 1 || !std::isdigit(words[i + 1][0])) continue;
    const auto number = static_cast<std::size_t>(words[i + 1][0] - '0');
    const std::size_t first = words[i] == "joint" ? 0 : 1;
    if (number >= first && number - first < kAxisCount) return number - first;
  }
  return {};
}

/// A unit in brackets at the end of a name, taken off it.
std::string take_bracket(std::string_view& name) {
  for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')}) {
    if (name.empty() || name.back() != close) continue;
    const std::size_t at = name.rfind(open);
    if (at == std::string_view::npos) continue;
    std::string unit(name.substr(at + 1, name.size() - at - 2));
    name = name.substr(0, at);
    while (name.ends_with(' ')) name.remove_suffix(1);
    return unit;
  }
  return {};
}

/// x_mm, t_ms, v_mm_s: behind the first underscore from which on all is a unit.
std::string take_suffix(std::string_view& name) {
  constexpr std::array<std::string_view, 16> kSuffixes = {
      "mm", "um", "nm", "deg", "rad", "in", "inch", "s", "ms", "us", "ns", "mm_s", "mm_s2", "mm_s3", "deg_s", "deg_s2"};
  for (std::size_t at = name.find('_'); at != std::string_view::npos; at = name.find('_', at + 1)) {
    const std::string_view rest = name.substr(at + 1);
    if (std::find(kSuffixes.begin(), kSuffixes.end(), rest) == kSuffixes.end()) continue;
    name = name.substr(0, at);
    return std::string(rest);
  }
  return {};
}

Error columns_error(ErrorKind kind, std::string message, std::string remedy, const std::string& file) {
  return {kind, "trace-columns", std::move(message), std::move(remedy), {file, 0, 0}, {}};
}

std::string names_text(const std::vector<TraceColumn>& columns) {
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(columns.size(), 12); ++i) {
    text += fmt::format("{}{} '{}'", i > 0 ? ", " : "", i + 1, columns[i].name);
  }
  return columns.size() > 12 ? text + ", …" : text;
}

/// The column that an entry of the mapping names, and the unit behind it.
std::optional<std::size_t> find_column(const std::vector<TraceColumn>& columns, std::string_view wanted) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].name == wanted) return i;
  }
  const auto number = parse_number(wanted);
  if (number && *number >= 1 && *number <= static_cast<double>(columns.size()) &&
      *number == static_cast<double>(static_cast<std::size_t>(*number))) {
    return static_cast<std::size_t>(*number) - 1;
  }
  return {};
}

Result<void> map_column(std::vector<TraceColumn>& columns, const TraceMapping& entry, const std::string& file) {
  std::string_view name = entry.column;
  std::string unit;
  auto at = find_column(columns, name);
  if (!at) {
    unit = take_bracket(name);
    at = find_column(columns, name);
  }
  if (!at) {
    return tl::unexpected(columns_error(ErrorKind::usage, fmt::format("--columns: there is no column '{}'", name),
                                        "the columns are " + names_text(columns), file));
  }
  TraceColumn& column = columns[*at];
  const bool is_time = entry.role == TraceRole::time;
  if (unit.empty() && !column.unit_name.empty()) unit = column.unit_name;
  const auto size = is_time ? time_unit(unit) : position_unit(unit, entry.axis);
  if (!size && !unit.empty()) {
    return tl::unexpected(columns_error(
        ErrorKind::usage, fmt::format("--columns: '{}' is no unit of {}", unit, is_time ? "a time" : "this axis"),
        is_time ? "give s, ms, us, ns or min in brackets" : "give mm, um, nm, m, in, deg or rad in brackets", file));
  }
  column.role = entry.role;
  column.axis = entry.axis;
  column.unit_name = unit;
  column.unit = size.value_or(is_time ? 1.0 : axis_unit(entry.axis).size);
  return {};
}

/// A plain position is what the file lacks: commanded beside an actual one, else what was measured.
void settle_plain(std::vector<TraceColumn>& columns) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto first = [&](TraceRole role) -> TraceColumn* {
      TraceColumn* found = nullptr;
      for (TraceColumn& c : columns) {
        if (c.role != role || c.axis != axis) continue;
        if (found) c.role = TraceRole::ignored;  // the first one counts
        if (!found) found = &c;
      }
      return found;
    };
    TraceColumn *actual = first(TraceRole::actual), *commanded = first(TraceRole::commanded),
                *plain = first(TraceRole::position);
    if (plain) {
      plain->role = !actual ? TraceRole::actual : commanded ? TraceRole::ignored : TraceRole::commanded;
    } else if (commanded && !actual) {
      commanded->role = TraceRole::actual;
    }
  }
}

}  // namespace

std::optional<double> time_unit(std::string_view name) { return find_unit(name, kTimes); }

std::optional<double> position_unit(std::string_view name, std::size_t axis) {
  return is_rotary(axis) ? find_unit(name, kAngles) : find_unit(name, kLengths);
}

Result<std::vector<TraceMapping>> parse_trace_mapping(std::string_view text) {
  std::vector<TraceMapping> mapping;
  for (std::size_t at = 0; at <= text.size() && !text.empty();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string_view entry = text.substr(at, end - at);
    at = end + 1;
    const std::size_t equals = entry.find('=');
    std::string key(entry.substr(0, std::min(equals, entry.size())));
    TraceMapping found;
    found.role = TraceRole::actual;
    for (const auto& [prefix, role] :
         {std::pair("commanded_", TraceRole::commanded), std::pair("actual_", TraceRole::actual)}) {
      if (!key.starts_with(prefix)) continue;
      key.erase(0, std::string_view(prefix).size());
      found.role = role;
    }
    const auto axis = axis_letter(key);
    if (equals == std::string_view::npos || equals + 1 == entry.size() || (!axis && key != "t")) {
      return tl::unexpected(columns_error(ErrorKind::usage, fmt::format("--columns does not understand '{}'", entry),
                                          "write t=NAME,x=NAME, … with names or numbers of columns; a unit may follow: "
                                          "x=3[um]; commanded positions are commanded_x",
                                          ""));
    }
    if (axis) found.axis = *axis;
    if (!axis) found.role = TraceRole::time;
    found.column = entry.substr(equals + 1);
    mapping.push_back(std::move(found));
  }
  return mapping;
}

TraceColumn guess_column(std::string_view name, std::string_view unit) {
  TraceColumn column;
  column.name = name;
  std::string told(unit);
  if (told.empty()) told = take_bracket(name);
  if (told.empty()) told = take_suffix(name);
  column.unit_name = told;
  const Words words = words_of(name);
  if (has_one_of(words, kTimeWords) && (told.empty() || time_unit(told))) {
    column.role = TraceRole::time;
    column.unit = told.empty() ? 1.0 : *time_unit(told);
    return column;
  }
  if (words.size() <= 2 && told.empty() && has_one_of(words, kSampleWords)) {
    column.role = TraceRole::sample;
    return column;
  }
  const auto axis = axis_of(words);
  if (!axis || has_one_of(words, kOtherWords)) return column;
  const auto size = position_unit(told, *axis);
  if (!size && !told.empty()) return column;
  column.axis = *axis;
  column.unit = size.value_or(axis_unit(*axis).size);
  column.role = has_one_of(words, kActualWords)      ? TraceRole::actual
                : has_one_of(words, kCommandedWords) ? TraceRole::commanded
                                                     : TraceRole::position;
  return column;
}

Result<void> settle_columns(std::vector<TraceColumn>& columns, const std::vector<TraceMapping>& mapping,
                            const std::string& file) {
  if (!mapping.empty()) {
    for (TraceColumn& c : columns) c.role = TraceRole::ignored;
    for (const TraceMapping& entry : mapping) {
      if (auto done = map_column(columns, entry, file); !done) return done;
    }
  }
  settle_plain(columns);
  bool has_time = false;
  for (TraceColumn& c : columns) {
    if (c.role != TraceRole::time) continue;
    if (has_time) c.role = TraceRole::ignored;
    has_time = true;
  }
  for (TraceColumn& c : columns) {
    if (c.role == TraceRole::sample && has_time) c.role = TraceRole::ignored;
  }
  const bool has_position =
      std::any_of(columns.begin(), columns.end(), [](const TraceColumn& c) { return c.role == TraceRole::actual; });
  if (has_position) return {};
  return tl::unexpected(columns_error(
      mapping.empty() ? ErrorKind::input : ErrorKind::usage, "no column is known to be the position of an axis",
      "say which is which: --columns t=1,x=2; the columns are " + names_text(columns), file));
}

}  // namespace toolpace
