#include "toolpace/machine/toml_values.h"

#include <fmt/format.h>

#include "toolpace/base/numbers.h"

namespace toolpace::detail {

Location place_in(const std::string& file, const toml::source_region& source) {
  return {file, source.begin.line, source.begin.column};
}

std::optional<double> number_of(const toml::node* node) {
  if (node == nullptr) return std::nullopt;
  if (const auto* real = node->as_floating_point()) return real->get();
  if (const auto* whole = node->as_integer()) return static_cast<double>(whole->get());
  return std::nullopt;
}

std::string shown(const toml::node& node) {
  if (const auto number = number_of(&node)) return to_text(*number);
  if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  if (const auto* list = node.as_array()) {
    if (list->size() == 2 && number_of(list->get(0)) && number_of(list->get(1)))
      return fmt::format("[{}, {}]", shown(*list->get(0)), shown(*list->get(1)));
    return "a list";
  }
  if (node.is_string()) return "a text";
  return node.is_table() ? "a section" : "a date or a time";
}

}  // namespace toolpace::detail
