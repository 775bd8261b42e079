#pragma once
/// A program's text as lines, and what stands in the plain ones.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace toolpace::detail::rewrite {

/// Lines count from 1, as the reader's do. The text has to outlive this.
class ProgramLines {
 public:
  explicit ProgramLines(std::string_view text);

  std::size_t count() const { return begin_.size() - 1; }
  /// With its end ("\n", "\r\n", or none at the end of the text).
  std::string_view whole(std::size_t line) const {
    return text_.substr(begin_[line - 1], begin_[line] - begin_[line - 1]);
  }
  /// Without.
  std::string_view content(std::size_t line) const;
  /// What ends the line.
  std::string_view ending(std::size_t line) const { return whole(line).substr(content(line).size()); }

 private:
  std::string_view text_;
  std::vector<std::size_t> begin_;  // of each line, and the end of the text
};

/// A line that says nothing but where a feed move leads: N, one of G1 G2 G3, X Y Z, I J K R, F, each at most once, with plain
/// numbers. Numbers are text as written.
struct PlainLine {
  std::string_view label;                ///< "N120"; empty = none
  int motion = 0;                        ///< 1, 2, 3; 0 = none is named
  std::array<std::string_view, 3> axis;  ///< numbers of X Y Z; empty = not there
  std::string_view feed;                 ///< number of F
  bool has_centre = false;               ///< I J K or R
  bool has_points = true;                ///< every coordinate has a decimal point
  bool is_spaced = false;                ///< blanks between its words
  bool is_lower = false;                 ///< written in small letters
};

/// @param content  of a line, without its end
std::optional<PlainLine> plain_line(std::string_view content);

/// The value of such a number: the double nearest to it, as the reader has it.
double value_of(std::string_view number);

/// Whether what follows a line, this one included, names its own motion before anything could depend on the modal one: only
/// blank lines, comments, N, M, S and T stand before G0 G1 G2 G3, or before the end of the text.
bool is_motion_named_from(const ProgramLines& lines, std::size_t line);

}  // namespace toolpace::detail::rewrite
