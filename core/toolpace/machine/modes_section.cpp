#include "toolpace/machine/modes_section.h"

#include <fmt/format.h>

#include <algorithm>

#include "toolpace/base/nearest_word.h"
#include "toolpace/machine/key_text.h"
#include "toolpace/machine/setup_keys.h"
#include "toolpace/machine/toml_values.h"

namespace toolpace::detail {
namespace {

constexpr std::size_t kMostModes = 16;  // of an axis: a frame has a handful that are seen

Error mode_error(const char* code, std::string message, std::string remedy, const toml::source_region& source,
                 const std::string& file) {
  return {ErrorKind::usage, code, std::move(message), std::move(remedy), place_in(file, source), {}};
}

Result<AxisMode> read_mode(const toml::table& table, const std::string& file, UnknownKeys unknown) {
  AxisMode mode;
  const std::vector<NumberKey> keys = mode_keys(mode);
  for (auto&& [key, value] : table) {
    const auto known = std::find_if(keys.begin(), keys.end(), [&](const NumberKey& k) { return k.name == key.str(); });
    if (known == keys.end()) {
      if (unknown == UnknownKeys::pass_over) continue;
      const std::string nearest = nearest_word(key.str(), {keys[0].name, keys[1].name, keys[2].name});
      return tl::unexpected(mode_error("machine-key", fmt::format("there is no key '{}'", key.str()),
                                       fmt::format("did you mean '{}'?", nearest), key.source(), file));
    }
    const auto number = number_of(&value);
    if (!number || !is_in_range(*number, known->range)) {
      return tl::unexpected(mode_error(
          "machine-value", fmt::format("{} is {}, but must be {}", known->name, shown(value), range_text(known->range)),
          known == keys.begin() ? "leave the mode out if there is none" : "leave the key out for its default",
          value.source(), file));
    }
    *known->value = *number;
  }
  if (mode.frequency > 0) return mode;
  return tl::unexpected(
      mode_error("machine-value", "a mode has no frequency_hz", "write its frequency_hz", table.source(), file));
}

}  // namespace

Result<std::vector<AxisMode>> read_modes(const toml::node& node, const std::string& file, UnknownKeys unknown) {
  const toml::array* list = node.as_array();
  const auto refuse = [&](std::string message, const toml::node& at) {
    return tl::unexpected(mode_error("machine-value", std::move(message),
                                     "write [[servo.X.modes]] with frequency_hz, damping and share", at.source(),
                                     file));
  };
  if (!list) return refuse(fmt::format("modes is {}, but must be a list", shown(node)), node);
  if (list->size() > kMostModes)
    return refuse(fmt::format("{} modes, but an axis has {} at most", list->size(), kMostModes), node);
  std::vector<AxisMode> modes;
  for (const toml::node& element : *list) {
    const toml::table* table = element.as_table();
    if (!table) return refuse(fmt::format("{} stands where a mode is due", shown(element)), element);
    auto mode = read_mode(*table, file, unknown);
    if (!mode) return tl::unexpected(std::move(mode.error()));
    modes.push_back(*mode);
  }
  return modes;
}

std::vector<ModeText> mode_texts(const AxisMode& mode) {
  AxisMode copy = mode, absent;
  const auto keys = mode_keys(copy), defaults = mode_keys(absent);
  std::vector<ModeText> texts;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (k == 0 || *keys[k].value != *defaults[k].value)
      texts.push_back({keys[k].name, number_text(*keys[k].value, keys[k].unit)});
  }
  return texts;
}

std::string inline_modes(const std::vector<AxisMode>& modes) {
  std::string text = "[";
  for (const AxisMode& mode : modes) {
    std::string one;
    for (const ModeText& t : mode_texts(mode)) one += (one.empty() ? "" : ", ") + t.key + " = " + t.value;
    text += (text.size() > 1 ? ", {" : "{") + one + "}";
  }
  return text + "]";
}

std::string modes_sections(char axis, const std::vector<AxisMode>& modes, const std::string& newline) {
  std::string text;
  for (const AxisMode& mode : modes) {
    text += fmt::format("{}[[servo.{}.modes]]{}", text.empty() ? "" : newline, axis, newline);
    for (const ModeText& t : mode_texts(mode)) text += t.key + " = " + t.value + newline;
  }
  return text;
}

}  // namespace toolpace::detail
