#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

#include "toolpace/base/numbers.h"
#include "toolpace/law/law_table.h"
#include "toolpace/machine/setup.h"
#include "toolpace/machine/setup_keys.h"

namespace toolpace {
namespace {

template <class T>
std::string_view name_of(const std::vector<Named<T>>& names, T value) {
  return std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.value == value; })->name;
}

std::string format_words(const std::string& section, const Setup& s) {
  if (section == "machine") {
    std::ostringstream quoted;
    quoted << toml::value<std::string>(s.machine.name);
    return fmt::format("name = {}\n", quoted.str());
  }
  if (section == "law") return fmt::format("kind = \"{}\"\n", law_row(s.options.law).id);
  if (section == "lookahead") {
    return fmt::format("blocks = {}\nramps = \"{}\"\ncorner = \"{}\"\n",
                       s.options.lookahead ? std::to_string(*s.options.lookahead) : "\"all\"",
                       name_of(ramps_names(), s.options.ramps), name_of(corner_names(), s.options.corner.rule));
  }
  return "";
}

/// The shortest decimal of value/unit that reads back to the same value, else the nearest.
std::string file_number(double value, double unit) {
  const double in_file = value / unit;
  for (int digits = 6; digits <= 17; ++digits) {
    const std::string text = fmt::format("{:.{}g}", in_file, digits);
    if (std::stod(text) * unit == value) return text;
  }
  return to_text(in_file);
}

/// A section with those of its numbers that are not the usual ones.
std::string format_differences(const SetupSection& section, const SetupSection& usual) {
  std::string body;
  for (std::size_t i = 0; i < section.numbers.size(); ++i) {
    const NumberKey& key = section.numbers[i];
    if (*key.value != *usual.numbers[i].value)
      body += fmt::format("{} = {}\n", key.name, file_number(*key.value, key.unit));
  }
  return body.empty() ? body : fmt::format("\n[{}]\n{}", section.name, body);
}

}  // namespace

std::string format_setup(const Setup& setup) {
  Setup copy = setup;
  std::string text;
  Setup plain;
  const auto defaults = setup_sections(plain);
  std::size_t index = 0;
  for (const SetupSection& section : setup_sections(copy)) {
    const SetupSection& usual = defaults[index++];
    std::string body = format_words(section.name, setup);
    if (section.name.rfind("servo.", 0) == 0) {
      text += format_differences(section, usual);
      continue;
    }
    for (const NumberKey& key : section.numbers) {
      const bool is_default = !std::isfinite(*key.value) || (*key.value == 0 && key.name != "tool_change_s");
      if (!is_default) body += fmt::format("{} = {}\n", key.name, file_number(*key.value, key.unit));
    }
    for (const RangeKey& key : section.ranges) {
      if (!std::isfinite(*key.low) && !std::isfinite(*key.high)) continue;
      body +=
          fmt::format("{} = [{}, {}]\n", key.name, file_number(*key.low, key.unit), file_number(*key.high, key.unit));
    }
    if (!body.empty()) text += fmt::format("{}[{}]\n{}", text.empty() ? "" : "\n", section.name, body);
  }
  return text;
}

}  // namespace toolpace
