#include "toolpace/machine/toml_layout.h"

#include "toolpace/machine/toml_library.h"

namespace toolpace {
namespace {

constexpr int kDeepest = 256;  // values within values, as the parser has it

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_end_of_line(char c) { return c == '\n' || c == '\r'; }

/// The word that a quoted key stands for.
std::string unquoted(std::string_view key) {
  const toml::parse_result parsed = toml::parse("key = " + std::string(key));
  if (!parsed) return std::string(key);
  return parsed.table()["key"].value_or(std::string(key));
}

class LayoutScanner {
 public:
  explicit LayoutScanner(std::string_view text) : text_(text) { layout_.homes.push_back({}); }

  std::optional<TomlLayout> scan() {
    std::size_t home = 0;
    for (skip_blank_lines(); !at_end(); skip_blank_lines()) {
      const bool done = peek() == '[' ? read_header(home) : read_entry(home, 0);
      if (!done) return std::nullopt;
    }
    return std::move(layout_);
  }

 private:
  bool at_end() const { return at_ >= text_.size(); }
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool take(char c) {
    if (at_end() || peek() != c) return false;
    ++at_;
    return true;
  }

  void skip_blanks() {
    while (!at_end() && is_blank(peek())) ++at_;
  }

  /// Blanks, ends of lines and comments.
  void skip_blank_lines() {
    while (!at_end()) {
      if (is_blank(peek()) || is_end_of_line(peek())) {
        ++at_;
      } else if (peek() == '#') {
        const std::size_t begin = at_;
        while (!at_end() && !is_end_of_line(peek())) ++at_;
        layout_.comments.push_back({begin, at_});
      } else {
        return;
      }
    }
  }

  bool read_header(std::size_t& home) {
    const std::size_t begin = at_;
    const bool is_list = peek(1) == '[';
    at_ += is_list ? 2 : 1;
    TomlPath path;
    if (!read_key(path) || !take(']') || (is_list && !take(']'))) return false;
    home = layout_.homes.size();
    layout_.homes.push_back({std::move(path), {begin, at_}, false});
    return true;
  }

  /// A dotted key, appended to `path`.
  bool read_key(TomlPath& path) {
    do {
      skip_blanks();
      const std::size_t begin = at_;
      const bool is_quoted = peek() == '"' || peek() == '\'';
      if (is_quoted ? !skip_string() : !skip_bare_key()) return false;
      const std::string_view word = text_.substr(begin, at_ - begin);
      path.push_back(is_quoted ? unquoted(word) : std::string(word));
      skip_blanks();
    } while (take('.'));
    return true;
  }

  bool skip_bare_key() {
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n.=[]{}#,\"'", at_), text_.size());
    const bool is_key = end > at_;
    at_ = end;
    return is_key;
  }

  bool read_entry(std::size_t home, int depth) {
    TomlEntry entry;
    entry.home = home;
    entry.path = layout_.homes[home].path;
    entry.key.begin = at_;
    if (!read_key(entry.path)) return false;
    entry.key.end = at_;
    if (!take('=')) return false;
    skip_blanks();
    entry.value.begin = at_;
    const std::size_t index = layout_.entries.size();
    layout_.entries.push_back(entry);
    std::vector<TextSpan> elements;
    const bool done = peek() == '{' ? read_inline_table(entry.path, depth + 1) : skip_value(depth, &elements);
    layout_.entries[index].value.end = at_;
    layout_.entries[index].elements = std::move(elements);
    return done;
  }

  bool read_inline_table(const TomlPath& path, int depth) {
    if (depth > kDeepest) return false;
    const std::size_t home = layout_.homes.size();
    layout_.homes.push_back({path, {at_, at_}, true});
    ++at_;
    for (skip_blank_lines(); !take('}'); skip_blank_lines()) {
      if (!read_entry(home, depth)) return false;
      skip_blank_lines();
      if (!take(',') && peek() != '}') return false;
    }
    layout_.homes[home].span.end = at_;
    return true;
  }

  /// @param elements  gets those of an array
  bool skip_value(int depth, std::vector<TextSpan>* elements = nullptr) {
    if (depth > kDeepest) return false;
    switch (peek()) {
      case '"':
      case '\'': return skip_string();
      case '[': return skip_group(']', depth + 1, elements);
      case '{': return skip_group('}', depth + 1, nullptr);
      default: return skip_plain_value();
    }
  }

  /// An array, or an inline table within one, whose keys belong to nobody here.
  bool skip_group(char close, int depth, std::vector<TextSpan>* elements) {
    ++at_;
    for (skip_blank_lines(); !take(close); skip_blank_lines()) {
      TomlPath ignored;
      if (close == '}' && (!read_key(ignored) || !take('='))) return false;
      skip_blanks();
      const std::size_t begin = at_;
      if (!skip_value(depth)) return false;
      if (elements) elements->push_back({begin, at_});
      skip_blank_lines();
      if (!take(',') && peek() != close) return false;
    }
    return true;
  }

  bool skip_plain_value() {
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of(",]}#\r\n", at_), text_.size());
    while (at_ > begin && is_blank(text_[at_ - 1])) --at_;
    return at_ > begin;
  }

  bool skip_string() {
    const char quote = peek();
    const bool has_escapes = quote == '"';
    const bool is_long = peek(1) == quote && peek(2) == quote;
    const std::size_t wanted = is_long ? 3 : 1;
    at_ += wanted;
    for (std::size_t quotes = 0; !at_end();) {
      const char c = text_[at_++];
      quotes = c == quote ? quotes + 1 : 0;
      if (quotes == wanted) {
        // Up to two quotes may stand before the three that close.
        for (int more = 0; is_long && more < 2 && peek() == quote; ++more) ++at_;
        return true;
      }
      if (has_escapes && c == '\\' && !at_end()) ++at_;
    }
    return false;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  TomlLayout layout_;
};

}  // namespace

std::optional<TomlLayout> lay_out_toml(std::string_view text) { return LayoutScanner(text).scan(); }

}  // namespace toolpace
