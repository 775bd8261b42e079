/// Sub-programs: calls by O word, M98 and G65, and the ways back.

#include <fmt/format.h>

#include "toolpace/nc/flow/flow.h"

namespace toolpace::nc {

bool Flow::call_label(const std::string& label, Scanner& text, std::size_t column) {
  std::vector<double> arguments;
  if (!reader_.skip_comments(text)) return false;
  while (text.peek() == '[') {
    const std::size_t argument_column = text.column();
    double value = 0.0;
    if (!reader_.expressions().read_bracketed(text, value)) return false;
    if (arguments.size() >= static_cast<std::size_t>(kLinuxcncLocals)) {
      return faults_.fail("too-many-arguments", fmt::format("more than {} arguments of a call", kLinuxcncLocals),
                          "use global parameters", argument_column);
    }
    arguments.push_back(value);
    if (!reader_.skip_comments(text)) return false;
  }
  if (!end_of_line(text) || !enter(label, column, 1, false)) return false;
  parameters_.enter_call(arguments);
  has_returned_value_ = false;
  returned_value_ = 0.0;
  return true;
}

bool Flow::enter(const std::string& label, std::size_t column, int repeats, bool is_numbered) {
  if (calls_.size() >= limits_.call_depth) {
    return lose("calls-too-deep", fmt::format("more than {} calls within each other", limits_.call_depth),
                "check for a sub-program that calls itself; --max-call-depth raises the bound", column);
  }
  const bool fanuc = reader_.rules().macro_statements;
  Call call;
  call.back = here_;
  call.repeats = repeats;
  call.is_numbered = is_numbered;
  std::size_t file = here_.file;
  int at = index().find_sub(label);
  if (at == kNoMatch && file != 0) {
    at = files_.at(0).flow(fanuc).find_sub(label);
    if (at != kNoMatch) file = 0;
  }
  if (at == kNoMatch) {
    const FoundFile& found = files_.find(label, fanuc);
    const std::string name = !label.empty() && is_digit(label.front()) ? label : "<" + label + ">";
    if (files_.failure()) return lose("sub-program-refused", "a sub-program's file cannot be read", "", column);
    if (!found.trouble.empty()) {
      return faults_.fail("sub-program-refused", fmt::format("sub-program O{}: {}", name, found.trouble), found.remedy,
                          column);
    }
    if (!found.index && !reader_.rules().refuses_doubtful && is_numbered) {
      faults_.warn("sub-program-missing", fmt::format("there is no sub-program O{}; what it does is missing", name),
                   "put its file beside the program or into a folder given with --sub-path", column);
      was_missing_ = true;
      return false;
    }
    if (!found.index) {
      return faults_.fail(
          "sub-program-unknown", fmt::format("there is no sub-program O{}", name),
          "define it in this program, or put its file beside the program or into a folder given with --sub-path",
          column);
    }
    file = *found.index;
    at = files_.at(file).flow(fanuc).find_sub(label);
  }
  if (at != kNoMatch && !fanuc && (files_.at(file).flow(fanuc).at(at).control == Control::sub) == is_numbered) {
    return faults_.fail("sub-program-kind",
                        is_numbered ? fmt::format("M98 calls O{}, which is a sub", label)
                                    : fmt::format("a call of O{}, which is no sub", label),
                        "call a sub with O… call, an O number with M98", column);
  }
  calls_.push_back(std::move(call));
  here_.file = file;
  if (at == kNoMatch) {
    jump(0, 0);  // a file without a head of its own
  } else {
    jump_after(at);
  }
  calls_.back().start = here_;
  return true;
}

bool Flow::call_sub(int number, std::size_t column) {
  if (!enter(label_of(number), column, 1, false)) return false;
  parameters_.enter_call({});
  return true;
}

bool Flow::has_program(const std::string& label) {
  return index().find_sub(label) != kNoMatch ||
         files_.at(0).flow(reader_.rules().macro_statements).find_sub(label) != kNoMatch;
}

bool Flow::call_numbered(const std::string& label, int repeats, std::size_t column,
                         const std::optional<std::vector<double>>& arguments) {
  if (repeats == 0) return true;
  was_missing_ = false;
  if (!enter(label, column, repeats, true)) return was_missing_;
  calls_.back().arguments = arguments;
  if (arguments) {
    parameters_.enter_call(*arguments);
  } else {
    parameters_.enter_shared_call();
  }
  return true;
}

bool Flow::call_line(double number, int repeats, std::size_t column) {
  if (repeats == 0) return true;
  std::size_t offset = 0, line = 0;
  if (!index().find_number(number, 0, offset, line))
    return faults_.fail("line-number-unknown", fmt::format("there is no line N{:g}", number),
                        "check the number of the line", column);
  if (calls_.size() >= limits_.call_depth) {
    return lose("calls-too-deep", fmt::format("more than {} calls within each other", limits_.call_depth),
                "check for a sub-program that calls itself; --max-call-depth raises the bound", column);
  }
  Call call;
  call.back = here_;
  call.repeats = repeats;
  call.is_numbered = true;
  calls_.push_back(std::move(call));
  jump(offset, line - 1);
  calls_.back().start = here_;
  parameters_.enter_shared_call();
  return true;
}

bool Flow::return_from_call(std::optional<double> to_number) {
  if (calls_.empty()) return false;
  Call& call = calls_.back();
  if (call.is_numbered && --call.repeats > 0) {
    here_ = call.start;
    jumped_ = true;
    if (call.arguments) {
      parameters_.leave_call();
      parameters_.enter_call(*call.arguments);
    }
    count_turn();
    return true;
  }
  if (call.saved && call.saved->automatic) restored_ = call.saved->modal;
  here_ = call.back;
  jumped_ = true;
  calls_.pop_back();
  parameters_.leave_call();
  if (to_number) {
    std::size_t offset = 0, line = 0;
    if (!index().find_number(*to_number, 0, offset, line)) {
      lose("line-number-unknown", fmt::format("there is no line N{:g}", *to_number), "check the number behind P");
      return true;
    }
    jump(offset, line - 1);
    count_turn();
  }
  return true;
}

bool Flow::finish_sub(Scanner& text) {
  double value = 0.0;
  bool has_value = false;
  if (text.peek() == '[') {
    if (!reader_.expressions().read_bracketed(text, value)) return false;
    has_value = true;
  }
  if (!end_of_line(text)) return false;
  if (calls_.empty())
    return lose("return-without-call", "a return outside of a sub-program", "remove it, or call the sub-program");
  returned_value_ = has_value ? value : 0.0;
  has_returned_value_ = has_value;
  return_from_call();
  return true;
}

}  // namespace toolpace::nc
