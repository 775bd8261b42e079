#include <fmt/format.h>

#include "toolpace/nc/flow/flow.h"
#include "toolpace/nc/text/whole_number.h"

namespace toolpace::nc {

namespace {

// Macro words may be cut off behind their second letter: WH, GO, EN.
bool take_macro_word(Scanner& text, std::string_view word) {
  if (!text.take_word(word.substr(0, 2))) return false;
  std::size_t i = 2;
  for (; i < word.size() && text.peek() == word[i]; ++i) text.take();
  return i == word.size() || !is_letter(text.peek());  // THEN GOTO, GOTO N10
}

}  // namespace

bool Flow::go_to_number(double number, std::size_t column) {
  std::size_t offset = 0, line = 0;
  if (!index().find_number(number, here_.offset, offset, line)) {
    return lose("line-number-unknown", fmt::format("there is no line N{:g}", number), "check the number of the line",
                column);
  }
  const bool backward = offset <= begin_;
  jump(offset, line - 1);
  return !backward || count_turn();
}

bool Flow::find_contour(double first, double last, bool before, Place& begin, std::size_t& last_line) {
  std::size_t offset = 0, line = 0;
  const bool found = before ? index().find_number_before(first, begin_, offset, line)
                            : index().find_number(first, here_.offset, offset, line);
  if (!found) return false;
  begin = {here_.file, offset, line - 1};
  return index().find_number(last, offset, offset, last_line) && last_line >= line;
}

bool Flow::run_goto(Scanner& text) {
  const std::size_t column = text.column();
  double number = 0.0;
  if (text.peek() == 'n') text.take();
  if (!reader_.expressions().read_value(text, number)) {
    lost_ = true;
    return false;
  }
  return go_to_number(number, column);
}

// SETVN n[NAME,NAME,…]: names of #n and those that follow.
bool Flow::name_variables(Scanner& text) {
  const auto unreadable = [&] {
    return faults_.fail("setvn-unreadable", "SETVN needs the first variable and names in []",
                        "write SETVN 500[NAME,NAME]", text.column());
  };
  double first = 0.0;
  if (text.take_number(first) != NumberStatus::ok || text.peek() != '[') return unreadable();
  const auto whole = whole_number(first, 1, parameters_.count() - 1);
  if (!whole) return unreadable();
  int variable = *whole;
  for (char mark = '['; mark != ']'; mark = text.peek(), ++variable) {
    text.take();
    std::string name;
    for (; text.peek() != ',' && text.peek() != ']'; text.take()) {
      if (text.peek() == '\0') return unreadable();
      name += text.peek();
    }
    if (!parameters_.has_number(variable)) return unreadable();
    if (!name.empty()) parameters_.name_numbered(name, variable);
  }
  text.take();
  return true;
}

bool Flow::run_fanuc_statement(Scanner& text, bool& good) {
  good = true;
  Scanner ahead = text;
  if (take_macro_word(ahead, "goto")) {
    text = ahead;
    good = run_goto(text);
    return true;
  }
  if (ahead.take_word("if") && ahead.peek() == '[') {
    text = ahead;
    bool holds = false;
    good = read_condition(text, holds);
    if (!good) return true;
    if (take_macro_word(text, "goto")) {
      if (holds) good = run_goto(text);
      return true;
    }
    if (take_macro_word(text, "then")) {
      if (!holds) return true;
      return run_fanuc_statement(text, good);  // THEN GOTO, or the rest of the line is a block
    }
    good = faults_.fail("then-missing", "GOTO or THEN is missing behind IF []",
                        "write IF [..] GOTO n or IF [..] THEN #n = ..", text.column());
    return true;
  }
  for (const char* output : {"dprnt", "bprnt", "popen", "pclos"}) {
    ahead = text;
    if (!ahead.take_word(output)) continue;
    faults_.warn("output-ignored", "what the program writes to a port is left out", "", text.column());
    return true;
  }
  ahead = text;
  if (ahead.take_word("setvn")) {
    good = name_variables(text = ahead);
    return true;
  }
  ahead = text;
  const bool has_condition = take_macro_word(ahead, "while") && ahead.peek() == '[';
  const bool is_do = !has_condition && (ahead = text, ahead.take_word("do")) && is_digit(ahead.peek());
  const bool is_end =
      !has_condition && !is_do && (ahead = text, take_macro_word(ahead, "end")) && is_digit(ahead.peek());
  if (!has_condition && !is_do && !is_end) return false;
  text = ahead;
  bool holds = true;
  if (has_condition) good = read_condition(text, holds);
  if (!good) return true;
  int at = kNoMatch;
  const ControlLine* const line = current_line(at);
  if (line == nullptr || line->head == kNoMatch || line->tail == kNoMatch) {
    good = lose("loop-unmatched", "WHILE … DO and END do not pair up", "close DO1 with END1 in the same program",
                text.column());
    return true;
  }
  if (is_end) {
    jump_to(line->head);
    good = count_turn();
  } else if (!holds) {
    jump_after(line->tail);
  }
  return true;
}

}  // namespace toolpace::nc
