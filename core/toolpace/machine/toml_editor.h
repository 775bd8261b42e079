#pragma once
/// Changes to a TOML text that leave all else of it as it is.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "toolpace/machine/key_text.h"
#include "toolpace/machine/toml_layout.h"

namespace toolpace {

/// "servo.X" -> {"servo", "X"}
TomlPath path_of(const std::string& section);

/// Collects changes to a TOML text, which stays as it is until result().
class TomlEditor {
 public:
  TomlEditor(std::string_view text, TomlLayout layout);

  const TomlLayout& layout() const { return layout_; }
  const std::string& newline() const { return newline_; }

  const TomlEntry* find(TomlPath path, const std::string& key) const;

  /// Of a pair only the end that differs is written, so that what stands between them stays.
  void replace(const TomlEntry& entry, const KeyText& from, const KeyText& to);
  void replace(const TomlEntry& entry, const std::string& value) { change(entry.value, value); }

  /// Takes a key away with its line, but for the comments there.
  void remove(const TomlEntry& entry, const KeyText& none);
  /// Takes a section away, header and keys, but for the comments there. @param home  its index
  void remove_section(std::size_t home);

  void insert(const TomlPath& section, const KeyText& key);
  /// Below the last key of a section that is there. @param home  its index, of no inline table
  void insert_into(std::size_t home, const KeyText& key);
  /// Whether a key of the section would go into braces.
  bool is_inline(const TomlPath& section) const;
  /// At the end of the text.
  void append(const std::string& sections) { appended_ += (appended_.empty() ? "" : newline_) + sections; }

  std::string result();

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
  void remove_lines(const TextSpan& from, std::size_t indented);
  std::size_t begin_of_line(std::size_t at) const;
  std::size_t end_of_line(std::size_t at) const;
  std::string indent_at(std::size_t key) const;
  void end_line(std::string& out) const;
  std::optional<Place> place_for(const TomlPath& section) const;
  bool is_table(std::size_t entry, const TomlPath& path) const { return layout_.entries[entry].path == path; }
  std::optional<std::size_t> last_entry(std::size_t home, std::size_t depth, const TomlPath& start) const;
  void insert_line(const Place& place, const std::string& assignment);
  void insert_inline(const Place& place, const std::string& assignment);

  std::string_view text_;
  TomlLayout layout_;
  std::string newline_;
  std::vector<Change> changes_;
  std::vector<std::size_t> filled_;  ///< inline tables that were empty and are no more
  std::map<TomlPath, std::string> new_sections_;
  std::vector<TomlPath> order_;
  std::string appended_;
};

}  // namespace toolpace
