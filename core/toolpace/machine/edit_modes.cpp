#include "toolpace/machine/edit_modes.h"

#include <algorithm>

#include "toolpace/base/axes.h"
#include "toolpace/machine/modes_section.h"
#include "toolpace/machine/setup_keys.h"

namespace toolpace::detail {
namespace {

std::vector<std::size_t> sections_at(const TomlLayout& layout, const TomlPath& path) {
  std::vector<std::size_t> homes;
  for (std::size_t h = 0; h < layout.homes.size(); ++h) {
    if (layout.homes[h].path == path && !layout.homes[h].is_inline) homes.push_back(h);
  }
  return homes;
}

/// One section brought from a mode to another.
void edit_mode(TomlEditor& editor, std::size_t home, AxisMode had, AxisMode wanted) {
  const TomlPath& path = editor.layout().homes[home].path;
  const auto before = mode_keys(had), after = mode_keys(wanted);
  for (std::size_t k = 0; k < after.size(); ++k) {
    if (*before[k].value == *after[k].value) continue;
    const KeyText text = {after[k].name, {number_text(*after[k].value, after[k].unit)}};
    TomlPath whole = path;
    whole.push_back(text.name);
    const auto& entries = editor.layout().entries;
    const auto entry = std::find_if(entries.begin(), entries.end(),
                                    [&](const TomlEntry& e) { return e.home == home && e.path == whole; });
    entry == entries.end() ? editor.insert_into(home, text) : editor.replace(*entry, text.text());
  }
}

}  // namespace

void edit_modes(TomlEditor& editor, std::size_t axis, const std::vector<AxisMode>& had,
                const std::vector<AxisMode>& wanted) {
  if (had == wanted) return;
  const TomlPath of_axis = {"servo", std::string(1, kAxisNames[axis])};
  const KeyText as_list = {kModesKey, {inline_modes(wanted)}};
  if (const TomlEntry* list = editor.find(of_axis, kModesKey)) return editor.replace(*list, as_list.text());
  TomlPath path = of_axis;
  path.emplace_back(kModesKey);
  const std::vector<std::size_t> homes = sections_at(editor.layout(), path);
  if (homes.size() != had.size()) return;  // a layout that is not known: the proof of the text tells
  if (homes.empty() && editor.is_inline(of_axis)) return editor.insert(of_axis, as_list);
  for (std::size_t i = 0; i < homes.size(); ++i)
    i < wanted.size() ? edit_mode(editor, homes[i], had[i], wanted[i]) : editor.remove_section(homes[i]);
  if (wanted.size() <= homes.size()) return;
  const std::vector<AxisMode> more(wanted.begin() + static_cast<std::ptrdiff_t>(homes.size()), wanted.end());
  editor.append(modes_sections(kAxisNames[axis], more, editor.newline()));
}

}  // namespace toolpace::detail
