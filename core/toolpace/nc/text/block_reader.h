#pragma once
/// Turns one line of text into a Block: words, values, comments and delayed assignments.

#include <utility>

#include "toolpace/nc/dialects/rules.h"
#include "toolpace/nc/text/assignments.h"
#include "toolpace/nc/text/expression.h"
#include "toolpace/nc/text/words.h"

namespace toolpace::nc {

class BlockReader {
 public:
  BlockReader(Parameters& parameters, FaultSink& faults, const DialectRules& rules)
      : faults_(faults),
        rules_(rules),
        expressions_(parameters, faults, rules.macro_statements),
        assignments_(parameters, faults, expressions_) {}

  /// Reads all words from the cursor to the end of the line into `block`; then makes the line's assignments.
  /// @return false after recording an error
  bool read(Scanner& text, Block& block);

  /// Steps over comments; the cursor then stands on something else or at the end of the line.
  bool skip_comments(Scanner& text, std::string* last_comment = nullptr);

  /// What ends a line is its end, not a NUL byte.
  bool is_at_end(const Scanner& text);

  /// True once after a comment that ends the program, (abort, …).
  bool take_aborted() { return std::exchange(aborted_, false); }

  /// Whether what stands behind a '/' in a block is left out.
  void delete_blocks(bool on) { deletes_blocks_ = on; }

  ExpressionReader& expressions() { return expressions_; }
  const DialectRules& rules() const { return rules_; }

 private:
  bool read_word(Scanner& text, char letter, Block& block);
  bool fail_without_value(const Scanner& text, char letter, std::size_t column);
  bool read_corner(Scanner& text, Block& block);
  void skip_slash(Scanner& text);
  bool take_system_b(Code code, std::size_t column, Block& block);
  bool read_g(double value, std::size_t column, Block& block);
  bool read_m(double value, std::size_t column, Block& block);
  void note_form(std::string_view number, char letter, Block& block) const;
  bool store_word(std::size_t index, double value, std::size_t column, Block& block);
  bool skip_printer_text(Scanner& text, const Block& block);

  FaultSink& faults_;
  const DialectRules& rules_;
  ExpressionReader expressions_;
  bool aborted_ = false;
  bool deletes_blocks_ = false;
  Assignments assignments_;
};

}  // namespace toolpace::nc
