#include "toolpace/machine/setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "toolpace/base/input_file.h"
#include "toolpace/base/nearest_word.h"
#include "toolpace/law/law_table.h"
#include "toolpace/machine/key_text.h"
#include "toolpace/machine/kinematics_section.h"
#include "toolpace/machine/modes_section.h"
#include "toolpace/machine/setup_keys.h"
#include "toolpace/machine/toml_values.h"
#include "toolpace/sample/shaper.h"

namespace toolpace {
namespace {

constexpr std::size_t kLongestFile = std::size_t{1} << 20;  ///< bytes; a file of settings has thousands

using detail::number_of;
using detail::place_in;
using detail::shown;

bool has_key(const SetupSection& section, const std::string& key) {
  const auto is_key = [&](const auto& known) { return known.name == key; };
  return std::any_of(section.numbers.begin(), section.numbers.end(), is_key) ||
         std::any_of(section.ranges.begin(), section.ranges.end(), is_key) ||
         std::find(section.words.begin(), section.words.end(), key) != section.words.end();
}

/// Reads one TOML document into a Setup.
class SetupReader {
 public:
  SetupReader(std::string name, UnknownKeys unknown) : name_(std::move(name)), unknown_(unknown) {
    setup_.machine.period = default_setup().machine.period;
    sections_ = setup_sections(setup_);
  }

  Result<Setup> read(const toml::table& root) {
    for (auto&& [key, node] : root) {
      const std::string section(key.str());
      const bool ok = section == "axes"         ? read_axes(node)
                      : section == "servo"      ? read_servo(node)
                      : section == "kinematics" ? read_chain(node)
                                                : read_named(section, key, node);
      if (!ok) return tl::unexpected(*error_);
    }
    PathLimits& path = setup_.machine.path;
    if (!deceleration_given_) path.deceleration = path.acceleration;
    if (!jerk_deceleration_given_) path.jerk_deceleration = path.jerk;
    return setup_;
  }

 private:
  bool fail(const char* code, std::string message, std::string remedy, const toml::source_region& source) {
    error_ = Error{ErrorKind::usage, code, std::move(message), std::move(remedy), place_in(name_, source), {}};
    return false;
  }

  bool unknown(const std::string& what, const toml::key& key, const std::vector<std::string>& known) {
    if (unknown_ == UnknownKeys::pass_over) return true;
    return fail("machine-key", fmt::format("there is no {} '{}'", what, key.str()),
                fmt::format("did you mean '{}'?", nearest_word(key.str(), known)), key.source());
  }

  bool read_chain(const toml::node& node) {
    auto kinematics = detail::read_kinematics(node, name_, unknown_);
    if (!kinematics) error_ = std::move(kinematics.error());
    if (kinematics) setup_.kinematics = *std::move(kinematics);
    return !error_;
  }

  bool unknown_axis(const toml::key& key) { return unknown("axis", key, {"X", "Y", "Z", "A", "B", "C"}); }

  bool read_axes(const toml::node& node) {
    const toml::table* axes = node.as_table();
    if (!axes) return fail("machine-value", "'axes' must be a table", "write [axes.X]", node.source());
    for (auto&& [key, axis] : *axes) {
      const std::string section = "axes." + std::string(key.str());
      const SetupSection* known = find(section);
      if (!(known ? read_section(*known, axis) : unknown_axis(key))) return false;
    }
    return true;
  }

  /// [servo] holds for every axis that knows the key, [servo.X] for one axis and over [servo].
  bool read_servo(const toml::node& node) {
    const toml::table* servo = node.as_table();
    if (!servo) return fail("machine-value", "'servo' must be a table", "write [servo] or [servo.X]", node.source());
    for (auto&& [key, value] : *servo) {
      if (!value.is_table() && !read_for_all_axes(key, value)) return false;
    }
    for (auto&& [key, value] : *servo) {
      if (!value.is_table()) continue;
      const std::string name(key.str());
      const SetupSection* known = find("servo." + name);
      const bool is_number = has_key(*find("servo.X"), name) || has_key(*find("servo.A"), name);
      const bool ok = known       ? read_section(*known, value)
                      : is_number ? read_for_all_axes(key, value)
                                  : unknown_axis(key);
      if (!ok) return false;
    }
    return true;
  }

  bool read_for_all_axes(const toml::key& key, const toml::node& value) {
    bool is_known = false;
    std::vector<std::string> known;
    for (const SetupSection& section : sections_) {
      if (section.name.rfind("servo.", 0) != 0) continue;
      for (const NumberKey& number : section.numbers) {
        known.push_back(number.name);
        if (number.name != key.str()) continue;
        if (!read_number(number, value)) return false;
        is_known = true;
      }
    }
    return is_known || unknown("key", key, known);
  }

  bool read_named(const std::string& section, const toml::key& key, const toml::node& node) {
    if (const SetupSection* found = find(section)) return read_section(*found, node);
    for (const SetupSection& other : sections_) {
      if (!has_key(other, section)) continue;
      return fail("machine-key", fmt::format("'{}' stands outside of any section", section),
                  fmt::format("write it under [{}]", other.name), key.source());
    }
    return unknown("section", key, {"machine", "path", "axes", "servo", "law", "lookahead", "kinematics"});
  }

  const SetupSection* find(const std::string& name) const {
    const auto at = std::find_if(sections_.begin(), sections_.end(), [&](const auto& s) { return s.name == name; });
    return at == sections_.end() ? nullptr : &*at;
  }

  bool read_section(const SetupSection& section, const toml::node& node) {
    const toml::table* table = node.as_table();
    if (!table) return fail("machine-value", "a section was expected", "write [" + section.name + "]", node.source());
    for (auto&& [key, value] : *table) {
      if (!read_key(section, key, value)) return false;
    }
    return true;
  }

  bool read_key(const SetupSection& section, const toml::key& key, const toml::node& value) {
    std::vector<std::string> known = section.words;
    for (const NumberKey& number : section.numbers) {
      if (number.name == key.str()) return read_number(number, value);
      known.push_back(number.name);
    }
    for (const RangeKey& range : section.ranges) {
      if (range.name == key.str()) return read_range(range, value);
      known.push_back(range.name);
    }
    if (std::find(section.words.begin(), section.words.end(), key.str()) != section.words.end()) {
      return key.str() == kModesKey ? read_axis_modes(section.name, value) : read_word(std::string(key.str()), value);
    }
    return unknown("key", key, known);
  }

  bool read_axis_modes(const std::string& section, const toml::node& node) {
    auto modes = detail::read_modes(node, name_, unknown_);
    if (!modes) error_ = std::move(modes.error());
    if (modes) setup_.machine.servo[axis_of_section(section)].modes = *std::move(modes);
    return !error_;
  }

  bool bad_value(const std::string& key, const std::string& allowed, const std::string& remedy,
                 const toml::node& node) {
    return fail("machine-value", fmt::format("{} is {}, but must be {}", key, shown(node), allowed), remedy,
                node.source());
  }

  bool read_number(const NumberKey& key, const toml::node& node) {
    const auto value = number_of(&node);
    if (!value || !is_in_range(*value, key.range)) {
      return bad_value(
          key.name, range_text(key.range),
          key.range.may_be_infinite ? "leave the key out for no limit" : "leave the key out for its default", node);
    }
    *key.value = *value * key.unit;
    if (key.name == "max_deceleration_mm_s2") deceleration_given_ = true;
    if (key.name == "max_jerk_deceleration_mm_s3") jerk_deceleration_given_ = true;
    return true;
  }

  bool read_range(const RangeKey& key, const toml::node& node) {
    const toml::array* pair = node.as_array();
    const bool is_pair = pair && pair->size() == 2;
    const auto low = number_of(is_pair ? pair->get(0) : nullptr), high = number_of(is_pair ? pair->get(1) : nullptr);
    if (low && high) {
      *key.low = *low * key.unit;
      *key.high = *high * key.unit;
    }
    if (!low || !high || !is_ordered(key))
      return bad_value(key.name, range_text(key), "leave the key out for no limit", node);
    return true;
  }

  bool read_word(const std::string& key, const toml::node& node) {
    if (key == "blocks") return read_blocks(node);
    const auto* text = node.as_string();
    if (!text) return bad_value(key, "a text", "put it in quotes", node);
    const std::string* word = &text->get();
    if (key == "name") {
      setup_.machine.name = *word;
      return true;
    }
    if (key == "kind") {
      const auto law = find_law(*word);
      if (!law) return fail("machine-value", "there is no law '" + *word + "'", "laws: " + law_ids(), node.source());
      setup_.options.law = *law;
      return true;
    }
    if (key == "shaper") return pick(shaper_names(), *word, setup_.options.shaper, node);
    return key == "ramps" ? pick(ramps_names(), *word, setup_.options.ramps, node)
                          : pick(corner_names(), *word, setup_.options.corner.rule, node);
  }

  bool read_blocks(const toml::node& node) {
    if (const auto* word = node.as_string(); word && word->get() == "all") {
      setup_.options.lookahead.reset();
      return true;
    }
    const auto blocks = number_of(&node);
    if (!blocks || !(*blocks >= 1 && *blocks <= double{kDeepestLookahead}) || *blocks != std::floor(*blocks)) {
      return bad_value("blocks", fmt::format("a whole number from 1 to {}, or \"all\"", kDeepestLookahead),
                       "leave the key out for its default", node);
    }
    setup_.options.lookahead = static_cast<std::size_t>(*blocks);
    return true;
  }

  template <class T>
  bool pick(const std::vector<Named<T>>& names, const std::string& word, T& target, const toml::node& node) {
    std::string list;
    for (const auto& n : names) {
      if (n.name == word) {
        target = n.value;
        return true;
      }
      list += (list.empty() ? "" : ", ") + std::string(n.name);
    }
    return fail("machine-value", "'" + word + "' is not known here", "one of " + list, node.source());
  }

  std::string name_;
  UnknownKeys unknown_;
  Setup setup_;
  std::vector<SetupSection> sections_;
  bool deceleration_given_ = false, jerk_deceleration_given_ = false;
  std::optional<Error> error_;
};

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

/// Whether a text in quotes goes on behind a backslash at the end of a line.
bool continues_a_line(std::string_view text) {
  if (text.find(R"(""")") == std::string_view::npos) return false;
  for (std::size_t at = text.find('\\'); at != std::string_view::npos; at = text.find('\\', at + 1)) {
    const std::size_t next = text.find_first_not_of(" \t\r", at + 1);
    if (next != std::string_view::npos && text[next] == '\n') return true;
  }
  return false;
}

Error syntax_error(std::string what, std::string remedy, const Location& where) {
  return {ErrorKind::usage, "machine-syntax", std::move(what), std::move(remedy), where, {}};
}

}  // namespace

Setup default_setup() {
  Setup setup;
  setup.machine.path = {100.0, 3000.0, 3000.0, 1e6, 1e6};
  return setup;
}

Result<Setup> parse_setup(std::string_view text, const std::string& name, UnknownKeys unknown) {
  if (text.rfind(kUtf8Mark, 0) == 0) text.remove_prefix(kUtf8Mark.size());
  // The parser is not safe against every letter outside of ASCII where there should be none: the structure is read
  // without them first.
  std::string plain(text);
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return !is_ascii(c); }, '?');
  if (plain != text) {
    const toml::parse_result structure = toml::parse(plain, name);
    if (!structure || continues_a_line(text)) {
      const Location where = structure ? Location{name, 0, 0} : place_in(name, structure.error().source());
      return tl::unexpected(syntax_error(
          structure ? "a line that goes on behind a backslash" : std::string(structure.error().description()),
          "letters outside of ASCII stand in comments and in texts of one line", where));
    }
  }
  const toml::parse_result parsed = toml::parse(text, name);
  if (!parsed) {
    return tl::unexpected(syntax_error(std::string(parsed.error().description()), "machine files are TOML",
                                       place_in(name, parsed.error().source())));
  }
  return SetupReader(name, unknown).read(parsed.table());
}

Result<std::string> read_settings_text(const std::filesystem::path& file, const Monitor& monitor) {
  const auto content = read_whole_file(file, monitor);
  if (!content) return tl::unexpected(content.error());
  if (content->bytes().size() > kLongestFile) {
    return tl::unexpected(
        syntax_error("the file is longer than 1 MiB", "machine files are short", {file.string(), 0, 0}));
  }
  return std::string(content->bytes());
}

}  // namespace toolpace
