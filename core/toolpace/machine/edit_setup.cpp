#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "toolpace/machine/key_text.h"
#include "toolpace/machine/setup.h"
#include "toolpace/machine/setup_proof.h"
#include "toolpace/machine/toml_layout.h"

namespace toolpace {
namespace {

TomlPath path_of(const std::string& section) {
  const std::size_t dot = section.find('.');
  if (dot == std::string::npos) return {section};
  return {section.substr(0, dot), section.substr(dot + 1)};
}

bool begins_with(const TomlPath& path, const TomlPath& start) {
  return path.size() >= start.size() && std::equal(start.begin(), start.end(), path.begin());
}

/// Collects changes to a TOML text, which stays as it is until result().
class TomlEditor {
 public:
  TomlEditor(std::string_view text, TomlLayout layout) : text_(text), layout_(std::move(layout)) {
    const std::size_t end = text.find('\n');
    newline_ = end != std::string_view::npos && end > 0 && text[end - 1] == '\r' ? "\r\n" : "\n";
  }

  const TomlEntry* find(TomlPath path, const std::string& key) const {
    path.push_back(key);
    const auto at = std::find_if(layout_.entries.begin(), layout_.entries.end(),
                                 [&](const TomlEntry& entry) { return entry.path == path; });
    return at == layout_.entries.end() ? nullptr : &*at;
  }

  /// Of a pair only the end that differs is written, so that what stands between them stays.
  void replace(const TomlEntry& entry, const KeyText& from, const KeyText& to) {
    if (to.parts.size() == 1 || entry.elements.size() != to.parts.size()) return change(entry.value, to.text());
    for (std::size_t i = 0; i < to.parts.size(); ++i) {
      if (from.parts[i] != to.parts[i]) change(entry.elements[i], to.parts[i]);
    }
  }

  /// Takes a key away with its line, but for the comments there.
  void remove(const TomlEntry& entry, const KeyText& none) {
    if (layout_.homes[entry.home].is_inline) return change(entry.value, none.text());
    const TextSpan lines = {begin_of_line(entry.key.begin), end_of_line(entry.value.end)};
    std::string kept;
    for (const TextSpan& comment : layout_.comments) {
      if (comment.begin < lines.begin || comment.end > lines.end) continue;
      kept += indent_at(entry.key.begin) + std::string(text_.substr(comment.begin, comment.end - comment.begin));
      kept += newline_;
    }
    change(lines, kept);
  }

  void insert(const TomlPath& section, const KeyText& key) {
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

  std::string result() {
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
    return out;
  }

 private:
  struct Change {
    TextSpan span;
    std::string text;
    bool is_line = false;  ///< begins a line of its own
  };
  struct Place {
    std::size_t home;
    std::optional<std::size_t> after;  ///< the entry behind which a new one goes
  };

  void change(const TextSpan& span, std::string text) { changes_.push_back({span, std::move(text), false}); }

  std::size_t begin_of_line(std::size_t at) const {
    const std::size_t end = at == 0 ? std::string_view::npos : text_.rfind('\n', at - 1);
    return end == std::string_view::npos ? 0 : end + 1;
  }

  std::size_t end_of_line(std::size_t at) const {
    const std::size_t end = text_.find('\n', at);
    return end == std::string_view::npos ? text_.size() : end + 1;
  }

  std::string indent_at(std::size_t key) const {
    const std::size_t begin = begin_of_line(key);
    return std::string(text_.substr(begin, key - begin));
  }

  void end_line(std::string& out) const {
    if (!out.empty() && out.back() != '\n') out += newline_;
  }

  /// Where a key of a section goes: below its header, else where the section is spelt out in keys or in braces, be it
  /// in part. Nothing where the section may begin with a header of its own.
  std::optional<Place> place_for(const TomlPath& section) const {
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

  /// An entry that is the whole table `path`, as in path = { … }.
  bool is_table(std::size_t entry, const TomlPath& path) const { return layout_.entries[entry].path == path; }

  std::optional<std::size_t> last_entry(std::size_t home, std::size_t depth, const TomlPath& start) const {
    std::optional<std::size_t> last;
    for (std::size_t e = 0; e < layout_.entries.size(); ++e) {
      const TomlEntry& entry = layout_.entries[e];
      if (entry.home == home && entry.path.size() >= depth && begins_with(entry.path, start)) last = e;
    }
    return last;
  }

  void insert_line(const Place& place, const std::string& assignment) {
    const TomlHome& home = layout_.homes[place.home];
    const std::size_t before = place.after ? layout_.entries[*place.after].value.end : home.span.end;
    const std::size_t indented = place.after ? layout_.entries[*place.after].key.begin : home.span.begin;
    const std::size_t at = end_of_line(before);
    changes_.push_back({{at, at}, indent_at(indented) + assignment + newline_, true});
  }

  void insert_inline(const Place& place, const std::string& assignment) {
    const TomlHome& home = layout_.homes[place.home];
    const bool is_first = !place.after && std::find(filled_.begin(), filled_.end(), place.home) == filled_.end();
    const std::size_t at = place.after ? layout_.entries[*place.after].value.end : home.span.begin + 1;
    changes_.push_back({{at, at}, (is_first ? " " : ", ") + assignment, false});
    filled_.push_back(place.home);
  }

  std::string_view text_;
  TomlLayout layout_;
  std::string newline_;
  std::vector<Change> changes_;
  std::vector<std::size_t> filled_;  ///< inline tables that were empty and are no more
  std::map<TomlPath, std::string> new_sections_;
  std::vector<TomlPath> order_;
};

/// Brings one text to the values of a setup.
class SetupEditor {
 public:
  SetupEditor(TomlEditor& editor, const Setup& had, const Setup& wanted)
      : editor_(editor), had_(texts_of(had)), wanted_(texts_of(wanted)), absent_(texts_of_absent_keys(wanted)) {}

  void edit() {
    share_servo_keys();
    for (std::size_t s = 0; s < wanted_.size(); ++s) {
      for (std::size_t k = 0; k < wanted_[s].keys.size(); ++k) edit_key(s, k);
    }
  }

 private:
  void edit_key(std::size_t s, std::size_t k) {
    const KeyText &had = had_[s].keys[k], &wanted = wanted_[s].keys[k], &absent = absent_[s].keys[k];
    const TomlPath section = path_of(wanted_[s].name);
    const TomlEntry* entry = editor_.find(section, wanted.name);
    if (!entry) {
      if (wanted != absent) editor_.insert(section, wanted);
    } else if (wanted == had) {
      return;
    } else if (wanted == absent && is_none(wanted)) {
      editor_.remove(*entry, wanted);
    } else {
      editor_.replace(*entry, had, wanted);
    }
  }

  /// A key of [servo] holds for the axes that have none of their own, and changes where these agree on another value.
  void share_servo_keys() {
    std::vector<std::string> done;
    for (std::size_t s = 0; s < wanted_.size(); ++s) {
      if (!wanted_[s].name.starts_with("servo.")) continue;
      for (const KeyText& key : wanted_[s].keys) {
        if (std::find(done.begin(), done.end(), key.name) != done.end()) continue;
        done.push_back(key.name);
        if (const TomlEntry* shared = editor_.find({"servo"}, key.name)) share(*shared, key.name);
      }
    }
  }

  void share(const TomlEntry& entry, const std::string& name) {
    struct Follower {
      const KeyText *had, *wanted;
      KeyText* absent;
    };
    std::vector<Follower> followers;
    for (std::size_t s = 0; s < wanted_.size(); ++s) {
      if (!wanted_[s].name.starts_with("servo.") || editor_.find(path_of(wanted_[s].name), name)) continue;
      for (std::size_t k = 0; k < wanted_[s].keys.size(); ++k) {
        if (wanted_[s].keys[k].name != name) continue;
        followers.push_back({&had_[s].keys[k], &wanted_[s].keys[k], &absent_[s].keys[k]});
      }
    }
    if (followers.empty()) return;
    const KeyText had = *followers.front().had, first = *followers.front().wanted;
    const bool agree =
        std::all_of(followers.begin(), followers.end(), [&](const Follower& f) { return *f.wanted == first; });
    if (agree && first != had) editor_.replace(entry, had, first);
    for (const Follower& f : followers) *f.absent = agree ? first : had;
  }

  TomlEditor& editor_;
  std::vector<SectionText> had_, wanted_, absent_;
};

}  // namespace

Result<std::string> edit_setup(std::string_view text, const std::string& name, const Setup& setup) {
  const auto had = parse_setup(text, name, UnknownKeys::pass_over);
  if (!had) return tl::unexpected(had.error());
  const bool is_marked = text.starts_with(kUtf8Mark);
  const std::string_view body = text.substr(is_marked ? kUtf8Mark.size() : 0);
  auto layout = lay_out_toml(body);
  if (!layout) {
    return tl::unexpected(Error{ErrorKind::usage,
                                "machine-unwritable",
                                "this file is laid out in a way that cannot be edited",
                                "save the machine under another name",
                                {name, 0, 0},
                                {}});
  }
  TomlEditor editor(body, std::move(*layout));
  SetupEditor(editor, *had, setup).edit();
  return proven_text(std::string(text.substr(0, text.size() - body.size())) + editor.result(), setup,
                     UnknownKeys::pass_over);
}

}  // namespace toolpace
