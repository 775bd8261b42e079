#pragma once
/// Turns one line of text into a Block: words, values, comments and delayed assignments.

#include <utility>
#include <vector>

#include "toolpace/nc/text/dialects.h"
#include "toolpace/nc/text/expression.h"
#include "toolpace/nc/text/words.h"

namespace toolpace::nc {

class BlockReader {
 public:
  BlockReader(Parameters& parameters, FaultSink& faults, Dialect dialect)
      : parameters_(parameters),
        faults_(faults),
        dialect_(dialect),
        expressions_(parameters, faults, dialect == Dialect::fanuc) {}

  /// Reads all words from the cursor to the end of the line into `block`; then makes the line's assignments.
  /// @return false after recording an error
  bool read(Scanner& text, Block& block);

  /// Steps over comments; the cursor then stands on something else or at the end of the line.
  bool skip_comments(Scanner& text, std::string* last_comment = nullptr);

  /// What ends a line is its end, not a NUL byte.
  bool is_at_end(const Scanner& text);

  ExpressionReader& expressions() { return expressions_; }
  Dialect dialect() const { return dialect_; }

 private:
  struct Assignment {
    ExpressionReader::Target target;
    double value;
    std::size_t column;
  };

  bool read_word(Scanner& text, char letter, Block& block);
  bool fail_without_value(const Scanner& text, char letter, std::size_t column);
  bool read_g(double value, std::size_t column, Block& block);
  bool read_m(double value, std::size_t column, Block& block);
  bool read_assignment(Scanner& text);
  bool store_word(std::size_t index, double value, std::size_t column, Block& block);
  bool assign();
  bool skip_printer_text(Scanner& text, const Block& block);

  Parameters& parameters_;
  FaultSink& faults_;
  Dialect dialect_;
  ExpressionReader expressions_;
  std::vector<Assignment> assignments_;
};

}  // namespace toolpace::nc
