#include "toolpace/verify/origin_text.h"

#include <charconv>
#include <cmath>
#include <map>
#include <string_view>

#include "toolpace/limits/corner_names.h"

namespace toolpace::detail {
namespace {

/// The members of an object that are no arrays or objects themselves: texts without their quotes, else as they stand.
class FlatObject {
 public:
  explicit FlatObject(std::string_view text) : rest_(text) { read(); }

  const std::string* find(const std::string& key) const {
    const auto found = members_.find(key);
    return found == members_.end() ? nullptr : &found->second;
  }

 private:
  void read() {
    if (!take('{')) return;
    do {
      std::string key, value;
      if (!take_text(key) || !take(':') || !take_value(value)) return;
      members_[key] = value;
    } while (take(','));
  }

  void skip_space() {
    while (!rest_.empty() && std::string_view(" \t\r\n").find(rest_.front()) != std::string_view::npos)
      rest_.remove_prefix(1);
  }

  bool take(char c) {
    skip_space();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  /// Escapes but \" and \\ stay as they are: no value that is looked for has any.
  bool take_text(std::string& text) {
    if (!take('"')) return false;
    while (!rest_.empty() && rest_.front() != '"') {
      const bool escaped = rest_.front() == '\\' && rest_.size() > 1 && (rest_[1] == '"' || rest_[1] == '\\');
      if (escaped) rest_.remove_prefix(1);
      text += rest_.front();
      rest_.remove_prefix(1);
    }
    return take('"');
  }

  /// Up to the end of an array, whose texts may hold brackets.
  bool skip_array() {
    for (std::size_t depth = 0; !rest_.empty();) {
      std::string text;
      skip_space();
      if (rest_.empty()) return false;
      const char c = rest_.front();
      if (c == '"') {
        if (!take_text(text)) return false;
        continue;
      }
      rest_.remove_prefix(1);
      if (c == '[' || c == '{') ++depth;
      if ((c == ']' || c == '}') && --depth == 0) return true;
    }
    return false;
  }

  bool take_value(std::string& value) {
    skip_space();
    if (rest_.empty()) return false;
    if (rest_.front() == '"') return take_text(value);
    if (rest_.front() == '[' || rest_.front() == '{') return skip_array();
    const std::size_t end = rest_.find_first_of(",}] \t\r\n");
    if (end == 0 || end == std::string_view::npos) return false;
    value = std::string(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return true;
  }

  std::string_view rest_;
  std::map<std::string, std::string> members_;
};

std::optional<double> length_of(const FlatObject& object, const char* key) {
  const std::string* const text = object.find(key);
  double value = 0.0;
  if (text == nullptr) return std::nullopt;
  const auto read = std::from_chars(text->data(), text->data() + text->size(), value);
  return read.ec == std::errc() && std::isfinite(value) && value >= 0 ? std::optional(value) : std::nullopt;
}

std::optional<CornerRule> rule_named(const std::string& name) {
  for (const CornerRule rule : kCornerRules) {
    if (name == corner_rule_name(rule)) return rule;
  }
  return std::nullopt;
}

}  // namespace

SetpointOrigin origin_of_text(const std::string& json) {
  const FlatObject object(json);
  SetpointOrigin origin;
  if (const auto* law = object.find("law")) origin.law = *law;
  if (const auto* shaper = object.find("shaper")) origin.shaper = *shaper;
  if (const auto* control = object.find("path_control")) origin.has_path_control = *control == "true";
  const auto* const name = object.find("corner");
  const auto rule = name != nullptr ? rule_named(*name) : std::nullopt;
  if (!rule) return origin;
  CornerOptions corner;
  corner.rule = *rule;
  corner.step = length_of(object, "corner_step_mm_s");
  corner.tolerance = length_of(object, "tolerance_mm").value_or(corner.tolerance);
  corner.junction_deviation = length_of(object, "junction_deviation_mm").value_or(corner.junction_deviation);
  origin.corner = corner;
  return origin;
}

}  // namespace toolpace::detail
