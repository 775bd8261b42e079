#pragma once
/// Where the control words of a program text stand, and which belong together. Built once, when the first one is met.

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "toolpace/nc/text/scanner.h"

namespace toolpace::nc {

enum class Control : std::uint8_t {
  none,  ///< an O number alone: where M98 finds a sub-program
  sub,
  endsub,
  call,
  return_,
  while_,
  endwhile,
  do_,
  if_,
  elseif,
  else_,
  endif,
  break_,
  continue_,
  repeat,
  endrepeat,
  fanuc_while,
  fanuc_end,
  unknown
};

inline constexpr int kNoMatch = -1;

struct ControlLine {
  std::size_t begin = 0;  ///< offset of the line
  std::size_t next = 0;   ///< offset of the line after
  std::size_t line = 0;   ///< from 1
  Control control = Control::none;
  bool closes_do = false;  ///< a `while` that ends a `do`
  bool duplicate = false;  ///< opens a structure under a label that was used before in the same sub-program
  std::string label;
  int head = kNoMatch;   ///< index of the word that opens the structure; of a break or continue: the loop it leaves
  int after = kNoMatch;  ///< of the next word in an if … elseif … else … endif
  int tail = kNoMatch;   ///< of the word that closes the structure
};

class FlowIndex {
 public:
  FlowIndex(std::string_view text, bool fanuc);

  const std::vector<ControlLine>& lines() const { return lines_; }
  const ControlLine& at(int index) const { return lines_[static_cast<std::size_t>(index)]; }
  /// The control line that begins at `offset`, or kNoMatch.
  int find(std::size_t offset) const;
  /// The sub-program `label`, or kNoMatch.
  int find_sub(const std::string& label) const;
  /// Lines with an N number: for GOTO. @return offset and line, or false
  /// The last line with the number before `offset_limit`, else the first one behind it.
  bool find_number_before(double number, std::size_t offset_limit, std::size_t& offset, std::size_t& line);
  bool find_number(double number, std::size_t from, std::size_t& offset, std::size_t& line);

 private:
  struct Numbered {
    double number;
    std::size_t offset, line;
  };

  void scan();
  void scan_line(std::string_view line, std::size_t begin, std::size_t next, std::size_t number);
  void match();
  struct Open {
    int head;
    int last;  ///< of the branches of an if
  };
  struct Label {
    std::vector<Open> open;
    bool used = false;
  };
  void match_line(int index, std::unordered_map<std::string, Label>& labels, const std::string& scope);
  void index_numbers();

  std::string_view text_;
  bool fanuc_;
  std::vector<ControlLine> lines_;
  std::unordered_map<std::string, int> subs_;
  std::vector<Numbered> numbers_;
  bool has_numbers_ = false;
};

/// Reads the keyword behind an O label; `unknown` if there is another word.
Control read_control(Scanner& text);

/// Normal form of a label: whole numbers without leading zeros.
std::string label_of(double number);

}  // namespace toolpace::nc
