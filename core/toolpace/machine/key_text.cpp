#include "toolpace/machine/key_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "toolpace/base/numbers.h"
#include "toolpace/law/law_table.h"
#include "toolpace/machine/modes_section.h"
#include "toolpace/sample/shaper.h"

namespace toolpace {
namespace {

template <class T>
std::string_view name_of(const std::vector<Named<T>>& names, T value) {
  return std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.value == value; })->name;
}

std::string toml_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7f) {
      quoted += fmt::format("\\u{:04X}", code);
    } else {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += c;
    }
  }
  return quoted + '"';
}

std::string word_text(const Setup& setup, std::string_view section, const std::string& key) {
  const PlanOptions& options = setup.options;
  if (key == "name") return toml_text(setup.machine.name);
  if (key == "kind") return toml_text(law_row(options.law).id);
  if (key == "blocks") return options.lookahead ? std::to_string(*options.lookahead) : toml_text("all");
  if (key == "ramps") return toml_text(name_of(ramps_names(), options.ramps));
  if (key == "shaper") return toml_text(shaper_name(options.shaper));
  if (key == kModesKey) return detail::inline_modes(setup.machine.servo[axis_of_section(section)].modes);
  return toml_text(name_of(corner_names(), options.corner.rule));
}

}  // namespace

std::string number_text(double value, double unit) {
  const double in_file = value / unit + 0.0;  // 0, not -0
  for (int digits = 6; digits <= 17; ++digits) {
    const std::string text = fmt::format("{:.{}g}", in_file, digits);
    if (const auto read = parse_number(text); read && *read * unit == value) return text;
  }
  return to_text(in_file);
}

std::string KeyText::text() const { return parts.size() == 1 ? parts[0] : fmt::format("[{}, {}]", parts[0], parts[1]); }

std::vector<SectionText> texts_of(const Setup& setup) {
  Setup copy = setup;
  std::vector<SectionText> texts;
  for (const SetupSection& section : setup_sections(copy)) {
    SectionText& text = texts.emplace_back(SectionText{section.name, {}});
    for (const std::string& word : section.words) text.keys.push_back({word, {word_text(setup, section.name, word)}});
    for (const NumberKey& key : section.numbers) text.keys.push_back({key.name, {number_text(*key.value, key.unit)}});
    for (const RangeKey& key : section.ranges)
      text.keys.push_back({key.name, {number_text(*key.low, key.unit), number_text(*key.high, key.unit)}});
  }
  return texts;
}

std::vector<SectionText> texts_of_absent_keys(const Setup& setup) {
  Setup absent;
  absent.machine.path.deceleration = setup.machine.path.acceleration;
  absent.machine.path.jerk_deceleration = setup.machine.path.jerk;
  return texts_of(absent);
}

bool is_none(const KeyText& key) {
  const std::string text = key.text();
  return text == "inf" || text == "[]" || (key.name == "shaper" && text == "\"none\"") || text == "[-inf, inf]" ||
         (text == "0" && key.name.starts_with("steps_per"));
}

std::optional<std::string> first_difference(const Setup& a, const Setup& b) {
  const auto of_a = texts_of(a), of_b = texts_of(b);
  for (std::size_t s = 0; s < of_a.size(); ++s) {
    for (std::size_t k = 0; k < of_a[s].keys.size(); ++k) {
      if (of_a[s].keys[k] != of_b[s].keys[k]) return fmt::format("[{}] {}", of_a[s].name, of_a[s].keys[k].name);
    }
  }
  return std::nullopt;
}

bool is_same_file(const Setup& a, const Setup& b) { return !first_difference(a, b); }

}  // namespace toolpace
