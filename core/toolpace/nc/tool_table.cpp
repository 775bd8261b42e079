#include "toolpace/nc/tool_table.h"
#include "toolpace/nc/tool_tip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "toolpace/nc/coordinates.h"
#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/text/scanner.h"
#include "toolpace/nc/text/whole_number.h"

namespace toolpace::nc {
namespace {

// Numbers of tools, pockets and orientations are whole.
bool store_whole(int& target, double value, int highest) {
  const auto whole = whole_number(value, 0, highest);
  if (whole) target = *whole;
  return whole.has_value();
}

bool read_tool_line(Scanner& text, Tool& tool, bool& has_number, Fault& fault) {
  for (char c = text.peek(); c != '\0' && c != ';'; c = text.peek()) {
    const std::size_t column = text.column();
    text.take();
    double value = 0.0;
    if (!is_letter(c) || text.take_number(value) != NumberStatus::ok) {
      fault = {"tool-table-word", "this is no word of a tool table",
               "words are a letter and a number, such as T1 P1 D6 Z50", column, Severity::error};
      return false;
    }
    bool good = true;
    switch (c) {
      case 't':
        good = store_whole(tool.number, value, kHighestTool);
        has_number = true;
        break;
      case 'p': good = store_whole(tool.pocket, value, kHighestTool); break;
      case 'd': tool.diameter = value; break;
      case 'i': tool.front_angle = value; break;
      case 'j': tool.back_angle = value; break;
      case 'q': good = store_whole(tool.orientation, value, kHighestOrientation); break;
      default:
        for (std::size_t i = 0; i < kAxisCount; ++i) {
          if (kAxisLetters[i] == c) tool.offset[i] = value;
        }
    }
    if (!good) {
      fault = {"tool-table-number", fmt::format("{}{:g} is out of range", static_cast<char>(c - 32), value),
               "T and P are whole numbers from 0 to 99999999, Q is one from 0 to 9", column, Severity::error};
      return false;
    }
  }
  return true;
}

void mirror_length(Context& context) { store_position(context.parameters, 5401, context.state.offsets.tool_length); }

void set_length_offset(Context& context, const Position& offset) {
  State& state = context.state;
  const Position machine = to_machine(state.offsets, state.position);
  state.offsets.tool_length = offset;
  state.position = to_work(state.offsets, machine);
  mirror_length(context);
}

bool take_tool_number(Context& context, const Block& block, char letter, int& number) {
  const double value = block.of(letter);
  const auto whole = whole_number(value, 0, kHighestTool);
  if (!whole) {
    return context.faults.fail("tool-number",
                               fmt::format("{}{:g} is no tool number", static_cast<char>(letter - 32), value),
                               "tool numbers are whole numbers from 0 to 99999999", block.column_of(letter));
  }
  number = *whole;
  return true;
}

}  // namespace

void read_tool_table(std::string_view text, State& state,
                     const std::function<void(std::size_t line, Fault)>& on_fault) {
  state.has_tool_table = true;
  std::size_t line = 0;
  while (!text.empty()) {
    ++line;
    const std::size_t length = std::min(text.find('\n'), text.size());
    Scanner scanner(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
    Tool tool;
    bool has_number = false;
    Fault fault;
    if (!read_tool_line(scanner, tool, has_number, fault)) {
      on_fault(line, std::move(fault));
    } else if (has_number) {
      state.tools[tool.number] = tool;
    }
  }
}

bool find_tool(Context& context, int number, std::size_t column, Tool& tool) {
  const auto found = context.state.tools.find(number);
  if (found != context.state.tools.end()) {
    tool = found->second;
    return true;
  }
  tool = Tool{};
  tool.number = number;
  if (!context.state.has_tool_table || number == 0) return true;
  return context.faults.fail("tool-unknown", fmt::format("tool {} is not in the tool table", number),
                             "add it to the tool table", column);
}

void miss_tool_table(Context& context, int number, std::size_t column) {
  State& state = context.state;
  if (state.has_tool_table || number == 0 || state.tools.count(number) > 0) return;
  if (std::exchange(state.tool_table_told, true)) return;
  context.faults.warn("tool-table-missing", "there is no tool table: lengths and radii of tools count as 0",
                      "give a tool table with --tools", column);
}

namespace {

// T0101 of lathes: tool 1 with offset 1. The turret turns at once.
bool turn_turret(Context& context, const Block& block, int word) {
  State& state = context.state;
  const int number = word >= 100 ? word / 100 : word;
  const int offset = word >= 100 ? word % 100 : word;
  Tool tool, with_offset;
  if (!find_tool(context, number, block.column_of('t'), tool)) return false;
  if (offset != 0 && !find_tool(context, offset, block.column_of('t'), with_offset)) return false;
  state.selected_tool = number;
  state.tool_selected = true;
  if (state.loaded.number != number) context.out.note(MoveKind::tool, fmt::format("T{}", number));
  state.loaded = tool;
  set_length_offset(context, with_offset.offset);
  return true;
}

}  // namespace

bool select_tool(Context& context, const Block& block) {
  int number = 0;
  Tool tool;
  if (!take_tool_number(context, block, 't', number)) return false;
  if (context.rules.lathe_words) return turn_turret(context, block, number);
  if (context.rules.refuses_doubtful && !find_tool(context, number, block.column_of('t'), tool)) return false;
  context.state.selected_tool = number;
  context.state.tool_selected = true;
  return true;
}

bool change_tool(Context& context, const Block& block) {
  State& state = context.state;
  const std::size_t column = block.column_of(MGroup::tool);
  if (state.modal.compensation != 400 && (context.rules.refuses_doubtful || state.compensation.radius > 0.0)) {
    return context.faults.fail("tool-change-with-compensation", "a tool change while cutter radius compensation is on",
                               "end it with G40 first", column);
  }
  int number = state.selected_tool;
  const bool declared = block.code(MGroup::tool) == 61;
  if (declared) {
    if (!block.has('q'))
      return context.faults.fail("tool-number", "M61 without a tool number", "give it with Q", column);
    if (!take_tool_number(context, block, 'q', number)) return false;
  }
  if (!declared && !state.tool_selected) {
    context.faults.warn("tool-not-selected", "a tool change without a tool selected before",
                        "select the tool with T, such as T1 M6", column);
  }
  Tool tool;
  if (!find_tool(context, number, column, tool)) return false;
  const bool has_turned = context.rules.lathe_words && state.loaded.number == number;  // T has changed it
  state.loaded = tool;
  if (!declared && context.rules.refuses_doubtful) state.modal.spindle_direction = 0;  // the change stops it
  if (!declared && !has_turned) context.out.note(MoveKind::tool, fmt::format("T{}", number));
  return true;
}

bool set_tool_length(Context& context, const Block& block) {
  State& state = context.state;
  const Code code = block.code(GGroup::tool_length);
  const std::size_t column = block.column_of(GGroup::tool_length);
  if (state.modal.compensation != 400 && state.compensation.radius > 0.0) {
    return context.faults.fail("offset-with-compensation",
                               "a tool length change while cutter radius compensation is on", "end it with G40 first",
                               column);
  }
  if (begins_tip(code)) return begin_tip(context, block);
  end_tip(context);
  Position offset{};
  if (code == 431) {
    if (!block.has_any(kLinearBits | kRotaryBits) && context.rules.refuses_doubtful) {
      return context.faults.fail("g43.1-without-axes", "G43.1 without axis words", "give the offset, such as Z10",
                                 column);
    }
    offset = state.offsets.tool_length;
    for (std::size_t i = 0; i < kAxisCount; ++i) {
      const char letter = kAxisLetters[i];
      if (block.has(letter)) offset[i] = is_rotary(i) ? block.of(letter) : length_of(state, block, letter);
    }
  } else if (code == 430 || code == 432 || code == 440) {
    int number = state.loaded.number;
    Tool tool = state.loaded;
    if (block.has('h')) {
      if (!take_tool_number(context, block, 'h', number) || !find_tool(context, number, block.column_of('h'), tool))
        return false;
      if (number == 0) tool = state.loaded;  // pocket 0 is the spindle
    } else if (code == 432) {
      return context.faults.fail("g43.2-without-h", "G43.2 without a tool", "name the tool with H", column);
    }
    miss_tool_table(context, number, column);
    offset = tool.offset;
    if (code == 440) {
      for (double& value : offset) value = -value;
    }
    if (code == 432) {
      for (std::size_t i = 0; i < kAxisCount; ++i) offset[i] += state.offsets.tool_length[i];
    }
  }
  state.modal.tool_length = code;
  if (!state.tip.everywhere) {
    set_length_offset(context, offset);
  } else if (code != 490) {
    take_tip_length(context, offset[2]);
  }
  return true;
}

bool write_tool_offset(Context& context, const Block& block, int form) {
  State& state = context.state;
  int number = 0;
  if (!block.has('p') || !block.has('r')) {
    return context.faults.fail("g10-without-p", fmt::format("G10 L{} without P or R", form),
                               "name the offset with P, give it with R", block.column_of(GGroup::once));
  }
  if (!take_tool_number(context, block, 'p', number)) return false;
  Tool& tool = state.tools[number];
  tool.number = number;
  const double value = length_of(state, block, 'r');
  const bool adds = form == 11 || form == 13 || state.modal.incremental();
  if (form <= 11) {
    tool.offset[2] = (adds ? tool.offset[2] : 0.0) + value;
  } else {
    tool.diameter = (adds ? tool.diameter : 0.0) + 2.0 * value;
  }
  if (state.loaded.number == number) state.loaded = tool;
  return true;
}

bool write_tool_entry(Context& context, const Block& block, int form) {
  State& state = context.state;
  int number = 0;
  if (!block.has('p')) {
    return context.faults.fail("g10-without-p", "G10 without P", "name the tool with P", block.column_of(GGroup::once));
  }
  if (!take_tool_number(context, block, 'p', number)) return false;
  Tool tool;
  if (!find_tool(context, number, block.column_of('p'), tool)) return false;
  // L10: the current point shall read the given values with this tool; L11: the same in G59.3's fixture.
  Offsets frame = state.offsets;
  if (form == 11) frame = system_offsets(context, kSystemCount);
  frame.tool_length = Position{};
  const Position machine = to_machine(state.offsets, state.position);
  const Position here = to_work(frame, machine);
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const char letter = kAxisLetters[i];
    if (!block.has(letter)) continue;
    const double value = is_rotary(i) ? block.of(letter) : length_of(state, block, letter);
    tool.offset[i] = form == 1 ? value : here[i] - value;
  }
  if (block.has('r')) tool.diameter = 2.0 * length_of(state, block, 'r');
  if (block.has('i')) tool.front_angle = block.of('i');
  if (block.has('j')) tool.back_angle = block.of('j');
  if (block.has('q') && !store_whole(tool.orientation, block.of('q'), kHighestOrientation)) {
    return context.faults.fail("tool-orientation", fmt::format("Q{:g} is no tool orientation", block.of('q')),
                               "orientations go from 0 to 9", block.column_of('q'));
  }
  state.tools[number] = tool;
  if (state.loaded.number == number) state.loaded = tool;
  return true;
}

}  // namespace toolpace::nc
