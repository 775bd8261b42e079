#include "toolpace/nc/flow/flow.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

namespace toolpace::nc {

Flow::Flow(ProgramFiles& files, Parameters& parameters, FaultSink& faults, BlockReader& reader,
           const ReadLimits& limits)
    : files_(files), parameters_(parameters), faults_(faults), reader_(reader), limits_(limits) {}

bool Flow::next_line(std::string_view& line) {
  const std::string_view text = files_.at(here_.file).text;
  if (here_.offset >= text.size()) {
    taken_ = here_;
    return false;
  }
  begin_ = here_.offset;
  const char* const start = text.data() + here_.offset;
  const std::size_t left = text.size() - here_.offset;
  const void* const found = std::memchr(start, '\n', left);
  const std::size_t length = found ? static_cast<std::size_t>(static_cast<const char*>(found) - start) : left;
  line = {start, length};
  here_.offset += length + (found ? 1 : 0);
  ++here_.line;
  count_work(length);
  taken_ = {here_.file, begin_, here_.line};
  return true;
}

bool Flow::lose(const char* code, std::string what, std::string remedy, std::size_t column) {
  lost_ = true;
  return faults_.fail(code, std::move(what), std::move(remedy), column);
}

bool Flow::jump_after_end(int at) {
  const int tail = index().at(at).tail;
  if (tail == kNoMatch) {
    return lose("o-word-unmatched", fmt::format("O{} is not closed", index().at(at).label),
                "close it under the same label");
  }
  jump_after(tail);
  return true;
}

void Flow::jump(std::size_t offset, std::size_t line) {
  here_.offset = offset;
  here_.line = line;
  jumped_ = true;
}

bool Flow::count_turn() {
  if (++turns_ <= limits_.loop_turns) return true;
  return lose("too-many-turns", fmt::format("the program's loops turn more than {} times", limits_.loop_turns),
              "check that the loop ends; --max-loop-turns raises the bound");
}

const ControlLine* Flow::current_line(int& at) {
  at = index().find(begin_);
  return at == kNoMatch ? nullptr : &index().at(at);
}

bool Flow::read_condition(Scanner& text, bool& holds) {
  const std::size_t column = text.column();
  if (text.peek() != '[') return lose("bracket-missing", "a condition in [] is missing", "write [condition]", column);
  double value = 0.0;
  if (!reader_.expressions().read_bracketed(text, value)) {
    lost_ = true;
    return false;
  }
  holds = value != 0.0 && !is_vacant(value);
  return true;
}

bool Flow::end_of_line(Scanner& text) {
  if (!reader_.skip_comments(text)) return false;
  if (text.peek() == '\0') return true;
  return faults_.fail("text-after-o-word", "further text stands behind a control word", "put it on a line of its own",
                      text.column());
}

bool Flow::read_label(Scanner& text, std::string& label, bool& computed) {
  const std::size_t column = text.column();
  computed = false;
  if (text.peek() == '<') return read_name(text, faults_, label);
  computed = !is_digit(text.peek());
  double number = 0.0;
  if (!reader_.expressions().read_value(text, number)) return false;
  if (!(number >= 0.0 && number < 1e9))
    return faults_.fail("o-word-label", "an O word needs a name or a number", "write O100 or O<name>", column);
  label = label_of(number);
  return true;
}

bool Flow::run_o_word(Scanner& text) {
  const std::size_t column = text.column();
  std::string label;
  bool computed = false;
  if (!read_label(text, label, computed)) {
    lost_ = true;
    return false;
  }
  const std::size_t keyword_column = text.column();
  Control control = read_control(text);
  if (control == Control::unknown && reader_.rules().macro_statements) control = Control::none;
  if (control == Control::unknown) {
    return lose("o-word-unknown", fmt::format("O{} is followed by no control word", label),
                "sub endsub call return if elseif else endif while endwhile do repeat "
                "endrepeat break continue",
                keyword_column);
  }
  if (computed && control != Control::call) {
    return lose("o-word-computed", "the label of a control word is computed", "only calls may compute their label",
                column);
  }
  return run_control(control, label, text, column);
}

bool Flow::run_control(Control control, const std::string& label, Scanner& text, std::size_t column) {
  int at = kNoMatch;
  const ControlLine* const line = current_line(at);
  const bool matched = line != nullptr && line->head != kNoMatch && line->tail != kNoMatch;
  const auto unmatched = [&] {
    return lose("o-word-unmatched", fmt::format("control word O{} has no counterpart", label),
                "check that every sub, if, while, do "
                "and repeat is closed under the same label",
                column);
  };
  if (line != nullptr && line->duplicate) {
    return lose("o-word-duplicate", fmt::format("label O{} is used a second time", label),
                "give each sub, if, while, do and repeat a label of its own", column);
  }
  const bool opened = line != nullptr && line->head != kNoMatch;
  switch (control) {
    case Control::none: return true;  // an O number: a program's head, or a sub-program that is run into
    case Control::call: return call_label(label, text, column);
    case Control::return_: return finish_sub(text);
    case Control::endsub: return matched ? finish_sub(text) : unmatched();
    case Control::sub:
      if (!matched) return unmatched();
      jump_after(line->tail);
      return end_of_line(text);
    case Control::break_:
    case Control::continue_: return at != kNoMatch && end_of_line(text) && leave_or_continue(control, label, at);
    case Control::if_: return opened ? run_if(at, text) : unmatched();
    case Control::elseif:
    case Control::else_:
      if (!matched) return unmatched();
      jump_after(line->tail);  // the branch before has been run
      return true;
    case Control::endif: return matched ? end_of_line(text) : unmatched();
    default: return opened ? run_loop(control, at, text) : unmatched();
  }
}

bool Flow::run_if(int at, Scanner& text) {
  FlowIndex& flow = index();
  bool holds = false;
  if (!read_condition(text, holds) || !end_of_line(text)) return false;
  while (!holds) {
    if (flow.at(at).after == kNoMatch) return jump_after_end(at);
    at = flow.at(at).after;
    const ControlLine& branch = flow.at(at);
    jump_after(at);
    if (branch.control != Control::elseif) return true;
    // The condition stands on the branch's own line.
    taken_ = {here_.file, branch.begin, branch.line};
    count_work(branch.next - branch.begin);
    Scanner there(files_.at(here_.file).text.substr(branch.begin, branch.next - branch.begin));
    std::string label;
    bool computed = false;
    while (there.peek() != 'o' && there.peek() != '\0') there.take();
    there.take();
    if (!read_label(there, label, computed)) return false;
    read_control(there);
    if (!read_condition(there, holds)) return false;
  }
  return true;
}

bool Flow::run_loop(Control control, int at, Scanner& text) {
  FlowIndex& flow = index();
  const ControlLine& line = flow.at(at);
  bool holds = false;
  switch (control) {
    case Control::do_: return end_of_line(text);
    case Control::while_:
      if (!read_condition(text, holds) || !end_of_line(text)) return false;
      if (line.closes_do) {
        if (!holds) return true;
        jump_after(line.head);
        return count_turn();
      }
      return holds || jump_after_end(at);
    case Control::endwhile: jump_to(line.head); return end_of_line(text) && count_turn();
    case Control::repeat: return run_repeat(at, text);
    case Control::endrepeat: {
      int& left = counters()[line.head];
      if (--left <= 0) return end_of_line(text);
      jump_after(line.head);
      return end_of_line(text) && count_turn();
    }
    default: return true;
  }
}

bool Flow::run_repeat(int at, Scanner& text) {
  const std::size_t column = text.column();
  double count = 0.0;
  if (text.peek() != '[')
    return lose("bracket-missing", "the number of repeats is missing", "write repeat [count]", column);
  if (!reader_.expressions().read_bracketed(text, count)) {
    lost_ = true;
    return false;
  }
  if (!end_of_line(text)) return false;
  if (!(count < 1e9)) return lose("too-many-turns", fmt::format("{:g} repeats", count), "give a smaller count", column);
  const int turns = static_cast<int>(std::round(count));
  if (turns <= 0) {
    return jump_after_end(at);
  }
  counters()[at] = turns;
  return true;
}

bool Flow::leave_or_continue(Control control, const std::string& label, int at) {
  FlowIndex& flow = index();
  const int head = flow.at(at).head;
  if (head == kNoMatch) {
    return lose("o-word-unmatched", fmt::format("no loop O{} is running here", label),
                "name the loop around this line");
  }
  const int tail = flow.at(head).tail;
  if (control == Control::break_) return jump_after_end(head);
  if (flow.at(head).control == Control::while_) {
    jump_to(head);
    return count_turn();
  } else {
    if (tail == kNoMatch) return jump_after_end(head);
    jump_to(tail);
  }
  return true;
}

}  // namespace toolpace::nc
