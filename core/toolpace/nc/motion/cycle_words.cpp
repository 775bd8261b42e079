#include "toolpace/nc/motion/cycle_words.h"

#include <fmt/format.h>

#include <cmath>

#include "toolpace/nc/dwell.h"
#include "toolpace/nc/motion/cycle_fault.h"
#include "toolpace/nc/motion/end_point.h"
#include "toolpace/nc/motion/increments.h"
#include "toolpace/nc/scaling.h"
#include "toolpace/nc/text/whole_number.h"

namespace toolpace::nc {
namespace {

constexpr int kMostRepeats = 1'000'000;

bool remember_back_boring(Context& context, const Block& block, bool same_series) {
  CycleMemory& memory = context.state.cycle;
  for (const char letter : {'i', 'j', 'k'}) {
    if (block.has(letter) || same_series) continue;
    return fail(context, block, "cycle-words", fmt::format("G87 without {}", static_cast<char>(letter - 32)),
                "G87 needs I J K");
  }
  if (block.has('i')) memory.i = length_of(context.state, block, 'i');
  if (block.has('j')) memory.j = length_of(context.state, block, 'j');
  if (block.has('k')) memory.k = length_of(context.state, block, 'k');
  return true;
}

// Fine and back boring of Fanuc's kind: I J, or Q along the plane's first axis, is the way off the wall.
void remember_shift(Context& context, const Block& block, const PlaneAxes& plane) {
  const State& state = context.state;
  CycleMemory& memory = context.state.cycle;
  const char first = static_cast<char>('i' + plane.first), second = static_cast<char>('i' + plane.second);
  const double scale = scale_of(state.offsets, plane.first);
  if (block.has('q')) {
    memory.i = std::fabs(increments_of(state, block, 'q')) / scale;
    memory.j = 0.0;
  }
  if (!block.has(first) && !block.has(second)) return;
  memory.i = block.has(first) ? length_of(state, block, first) / scale : 0.0;
  memory.j = block.has(second) ? length_of(state, block, second) / scale : 0.0;
}

// A cycle that begins forgets the words of the one before, but not its dwell and the level that the series began at.
void begin_cycle(CycleMemory& memory, Code code) {
  CycleMemory fresh;
  fresh.initial_level = memory.initial_level;
  fresh.dwell = memory.dwell;
  memory = fresh;
  memory.code = code;
}

}  // namespace

PlaneAxes cycle_plane(const Context& context, Code code) {
  if (!context.rules.lathe_words) return plane_axes(context.state.modal.plane);
  return code >= 870 ? PlaneAxes{1, 2, 0} : PlaneAxes{0, 1, 2};
}

Code cycle_of(const Context& context, Code code) {
  return context.rules.lathe_words && code >= 870 ? static_cast<Code>(code - 40) : code;
}

bool remember_cycle_words(Context& context, const Block& block, Code code, bool same_series) {
  State& state = context.state;
  CycleMemory& memory = state.cycle;
  if (!same_series) begin_cycle(memory, code);
  const PlaneAxes plane = cycle_plane(context, code);
  const char depth_word = kAxisLetters[plane.normal];
  if (block.has('r')) {
    memory.r = length_of(state, block, 'r');
    memory.has_r = true;
  }
  if (block.has(depth_word)) {
    memory.bottom = length_of(state, block, depth_word);
    if (depth_word == 'x' && state.modal.lathe_diameter == 70) memory.bottom /= 2.0;
    memory.has_bottom = true;
    memory.bottom_is_increment = false;
  }
  const char increment_word = depth_word == 'x' ? 'u' : 'w';
  if (context.rules.lathe_words && block.has(increment_word)) {
    memory.bottom = length_of(state, block, increment_word);
    if (depth_word == 'x' && state.modal.lathe_diameter == 70) memory.bottom /= 2.0;
    memory.has_bottom = memory.bottom_is_increment = true;
  }
  const std::string name = code_text('G', code);
  if (!memory.has_r && !context.rules.lathe_words && !context.rules.refuses_doubtful) {
    memory.r = state.modal.incremental() ? 0.0 : state.position[plane.normal];
    memory.has_r = true;
    context.faults.warn("cycle-without-r", name + " without R: it begins where the tool stands", "", 0);
  }
  if (!memory.has_r && !context.rules.lathe_words)
    return fail(context, block, "cycle-without-r", name + " without R", "give the retract level with R");
  if (!memory.has_bottom) {
    return fail(context, block, "cycle-without-depth",
                fmt::format("{} without {}", name, static_cast<char>(depth_word - 32)),
                fmt::format("give the depth with {}", static_cast<char>(depth_word - 32)));
  }
  const Code form = cycle_of(context, code);
  if (block.has('p')) memory.dwell = dwell_of(context, block);
  if ((form == 820 || form == 860 || form == 880 || form == 890) && !block.has('p') && !same_series) {
    if (context.rules.refuses_doubtful)
      return fail(context, block, "cycle-without-dwell", name + " without P", "give the dwell in s with P");
    memory.dwell = 0.0;
  }
  if (form == 870 && !remember_back_boring(context, block, same_series)) return false;
  if (form == kFineBoring || form == kBackBoring) remember_shift(context, block, plane);
  if (!is_dwell(memory.dwell)) {
    return fail(context, block, "dwell-negative", fmt::format("a dwell of {:g} s", memory.dwell),
                "give a time of 0 to 1e9 s");
  }
  return true;
}

bool find_repeats(Context& context, const Block& block, int& repeats) {
  const char letter = context.rules.repeats_by_k && block.has('k') ? 'k' : 'l';
  const double value = block.of(letter, 1.0);
  const auto number = whole_number(value, 0, kMostRepeats);
  if (!number) {
    return fail(context, block, "cycle-repeats", fmt::format("{:g} repeats of a cycle", value),
                "repeats are a whole number from 0 to 1000000");
  }
  repeats = *number;
  return true;
}

bool check_cycle(Context& context, const Block& block) {
  const Modal& modal = context.state.modal;
  if (context.state.compensation.radius > 0.0) {
    return fail(context, block, "cycle-with-compensation", "a canned cycle while cutter radius compensation is on",
                "end it with G40 first");
  }
  if (block.code(GGroup::once) == 530)
    return fail(context, block, "cycle-with-g53", "G53 with a canned cycle", "use G53 with G0 or G1");
  if (modal.feed_mode == 930)
    return fail(context, block, "cycle-inverse-time", "a canned cycle in inverse-time mode", "use G94");
  if (block.has_any(kRotaryBits) && context.rules.refuses_doubtful)
    return fail(context, block, "cycle-rotary", "a rotary axis in a canned cycle", "turn it in a block before");
  return true;
}

}  // namespace toolpace::nc
