#include "toolpace/nc/macro_calls.h"

#include <fmt/format.h>

#include "toolpace/nc/text/whole_number.h"

namespace toolpace::nc {
namespace {

// Which local variable each argument letter of G65 sets (argument specification I).
int local_of(char letter) {
  constexpr int kLocals[26] = {1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                               0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
  return kLocals[letter - 'a'];
}

bool is_centre(char letter) { return letter == 'i' || letter == 'j' || letter == 'k'; }

// I J K that come again count on: the second I is #7, the third #10 … (argument specification II).
std::vector<double> locals_of(const std::vector<MacroArgument>& arguments) {
  std::vector<double> locals(kFanucLocals, vacant());
  int set = 0;
  char last = '\0';
  for (const auto& argument : arguments) {
    int local = local_of(argument.letter);
    if (is_centre(argument.letter)) {
      if (is_centre(last) && argument.letter <= last) ++set;
      local += 3 * set;
      last = argument.letter;
    }
    if (local > 0 && local <= kFanucLocals) locals[static_cast<std::size_t>(local - 1)] = argument.value;
  }
  return locals;
}

}  // namespace

bool MacroCalls::run(const Block& block) {
  if (modal_.running_at && flow_.depth() <= *modal_.running_at) modal_.running_at.reset();
  if (!block.has(GGroup::macro)) {
    // A modal macro runs after every block that moves, but for its own.
    if (!modal_.active || !block.has_any(kAxisBits)) return true;
    if (modal_.running_at) return true;
    modal_.running_at = flow_.depth();
    return flow_.call_numbered(modal_.program, 1, 0, modal_.arguments);
  }
  const Code code = block.code(GGroup::macro);
  const std::size_t column = block.column_of(GGroup::macro);
  if (code == 670) {
    modal_.active = false;
    return true;
  }
  if (!block.has('p') && block.called.empty())
    return faults_.fail("macro-without-p", fmt::format("{} without P", code_text('G', code)), "name the macro with P",
                        column);
  const std::string program = block.called.empty() ? label_of(block.of('p')) : block.called;
  const std::vector<double> locals = locals_of(block.arguments);
  if (code == 660) {
    modal_ = {true, program, locals, std::nullopt};
    return true;
  }
  const double repeats = block.of('l', 1.0);
  const auto times = whole_number(repeats, 0, kMostCalls);
  if (!times)
    return faults_.fail("call-repeats", fmt::format("{:g} repeats of a macro", repeats),
                        "L is a whole number from 0 to 999999999", column);
  return flow_.call_numbered(program, *times, column, locals);
}

bool raise_alarm(Context& context, const Block& block) {
  if (!context.rules.macro_statements) return true;
  const double alarm = context.parameters.numbered(3000);
  const double stop = context.parameters.numbered(3006);
  context.parameters.set_numbered(3000, 0.0);
  context.parameters.set_numbered(3006, 0.0);
  if (alarm != 0.0 && !is_vacant(alarm)) {
    return context.faults.fail("program-alarm", fmt::format("the program raises alarm {:g}: {}", alarm, block.message),
                               "see to what the program complains of");
  }
  if (stop != 0.0 && !is_vacant(stop)) context.out.note(MoveKind::stop, block.message);
  return true;
}

}  // namespace toolpace::nc
