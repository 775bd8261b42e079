#include "toolpace/machine/toml_editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace toolpace {
namespace {

bool begins_with(const TomlPath& path, const TomlPath& start) {
  return path.size() >= start.size() && std::equal(start.begin(), start.end(), path.begin());
}

}  // namespace

TomlPath path_of(const std::string& section) {
  const std::size_t dot = section.find('.');
  if (dot == std::string::npos) return {section};
  return {section.substr(0, dot), section.substr(dot + 1)};
}

TomlEditor::TomlEditor(std::string_view text, TomlLayout layout) : text_(text), layout_(std::move(layout)) {
  const std::size_t end = text.find('\n');
  newline_ = end != std::string_view::npos && end > 0 && text[end - 1] == '\r' ? "\r\n" : "\n";
}

const TomlEntry* TomlEditor::find(TomlPath path, const std::string& key) const {
  path.push_back(key);
  const auto at = std::find_if(layout_.entries.begin(), layout_.entries.end(),
                               [&](const TomlEntry& entry) { return entry.path == path; });
  return at == layout_.entries.end() ? nullptr : &*at;
}

void TomlEditor::replace(const TomlEntry& entry, const KeyText& from, const KeyText& to) {
  if (to.parts.size() == 1 || entry.elements.size() != to.parts.size()) return change(entry.value, to.text());
  for (std::size_t i = 0; i < to.parts.size(); ++i) {
    if (from.parts[i] != to.parts[i]) change(entry.elements[i], to.parts[i]);
  }
}

void TomlEditor::remove(const TomlEntry& entry, const KeyText& none) {
  if (layout_.homes[entry.home].is_inline) return change(entry.value, none.text());
  remove_lines({entry.key.begin, entry.value.end}, entry.key.begin);
}

/// Whole lines, but for the comments in them.
void TomlEditor::remove_lines(const TextSpan& from, std::size_t indented) {
  const TextSpan lines = {begin_of_line(from.begin), end_of_line(from.end)};
  std::string kept;
  for (const TextSpan& comment : layout_.comments) {
    if (comment.begin < lines.begin || comment.end > lines.end) continue;
    kept += indent_at(indented) + std::string(text_.substr(comment.begin, comment.end - comment.begin));
    kept += newline_;
  }
  change(lines, kept);
}

void TomlEditor::remove_section(std::size_t home) {
  const TextSpan& header = layout_.homes[home].span;
  remove_lines(header, header.begin);
  for (const TomlEntry& entry : layout_.entries) {
    if (entry.home == home) remove_lines({entry.key.begin, entry.value.end}, entry.key.begin);
  }
}

void TomlEditor::insert_into(std::size_t home, const KeyText& key) {
  const TomlPath& path = layout_.homes[home].path;
  insert_line({home, last_entry(home, path.size(), path)}, key.name + " = " + key.text());
}

bool TomlEditor::is_inline(const TomlPath& section) const {
  const auto place = place_for(section);
  return place && layout_.homes[place->home].is_inline;
}

void TomlEditor::insert(const TomlPath& section, const KeyText& key) {
  const std::string assignment = " = " + key.text();
  const auto place = place_for(section);
  if (!place) {
    new_sections_[section] += key.name + assignment + newline_;
    if (std::find(order_.begin(), order_.end(), section) == order_.end()) order_.push_back(section);
    return;
  }
  const TomlHome& home = layout_.homes[place->home];
  std::string name;
  for (std::size_t i = home.path.size(); i < section.size(); ++i) name += section[i] + ".";
  name += key.name;
  home.is_inline ? insert_inline(*place, name + assignment) : insert_line(*place, name + assignment);
}

std::string TomlEditor::result() {
  // What is inserted where something is replaced goes before it.
  std::stable_sort(changes_.begin(), changes_.end(), [](const Change& a, const Change& b) {
    return std::pair(a.span.begin, a.span.end) < std::pair(b.span.begin, b.span.end);
  });
  std::string out;
  std::size_t at = 0;
  for (const Change& c : changes_) {
    out += text_.substr(at, c.span.begin - at);
    if (c.is_line) end_line(out);
    out += c.text;
    at = c.span.end;
  }
  out += text_.substr(at);
  for (const TomlPath& section : order_) {
    end_line(out);
    out += fmt::format("{}[{}]{}{}", out.empty() ? "" : newline_, fmt::join(section, "."), newline_,
                       new_sections_[section]);
  }
  if (!appended_.empty()) {
    end_line(out);
    out += (out.empty() ? "" : newline_) + appended_;
  }
  return out;
}

std::size_t TomlEditor::begin_of_line(std::size_t at) const {
  const std::size_t end = at == 0 ? std::string_view::npos : text_.rfind('\n', at - 1);
  return end == std::string_view::npos ? 0 : end + 1;
}

std::size_t TomlEditor::end_of_line(std::size_t at) const {
  const std::size_t end = text_.find('\n', at);
  return end == std::string_view::npos ? text_.size() : end + 1;
}

std::string TomlEditor::indent_at(std::size_t key) const {
  const std::size_t begin = begin_of_line(key);
  return std::string(text_.substr(begin, key - begin));
}

void TomlEditor::end_line(std::string& out) const {
  if (!out.empty() && out.back() != '\n') out += newline_;
}

/// Where a key of a section goes: below its header, else where the section is spelt out in keys or in braces, be it
/// in part. Nothing where the section may begin with a header of its own.
std::optional<TomlEditor::Place> TomlEditor::place_for(const TomlPath& section) const {
  for (std::size_t h = 1; h < layout_.homes.size(); ++h) {
    if (layout_.homes[h].path == section) return Place{h, last_entry(h, section.size(), section)};
  }
  for (std::size_t depth = section.size(); depth > 0; --depth) {
    const TomlPath start(section.begin(), section.begin() + static_cast<std::ptrdiff_t>(depth));
    for (std::size_t h = 0; h < layout_.homes.size(); ++h) {
      const TomlHome& home = layout_.homes[h];
      if (home.is_inline && home.path == start) return Place{h, last_entry(h, depth, start)};
      if (home.path.size() >= depth || !begins_with(section, home.path)) continue;
      if (const auto after = last_entry(h, depth, start); after && !is_table(*after, start)) return Place{h, after};
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> TomlEditor::last_entry(std::size_t home, std::size_t depth, const TomlPath& start) const {
  std::optional<std::size_t> last;
  for (std::size_t e = 0; e < layout_.entries.size(); ++e) {
    const TomlEntry& entry = layout_.entries[e];
    if (entry.home == home && entry.path.size() >= depth && begins_with(entry.path, start)) last = e;
  }
  return last;
}

void TomlEditor::insert_line(const Place& place, const std::string& assignment) {
  const TomlHome& home = layout_.homes[place.home];
  const std::size_t before = place.after ? layout_.entries[*place.after].value.end : home.span.end;
  const std::size_t indented = place.after ? layout_.entries[*place.after].key.begin : home.span.begin;
  const std::size_t at = end_of_line(before);
  changes_.push_back({{at, at}, indent_at(indented) + assignment + newline_, true});
}

void TomlEditor::insert_inline(const Place& place, const std::string& assignment) {
  const TomlHome& home = layout_.homes[place.home];
  const bool is_first = !place.after && std::find(filled_.begin(), filled_.end(), place.home) == filled_.end();
  const std::size_t at = place.after ? layout_.entries[*place.after].value.end : home.span.begin + 1;
  changes_.push_back({{at, at}, (is_first ? " " : ", ") + assignment, false});
  filled_.push_back(place.home);
}

}  // namespace toolpace
