#include "toolpace/nc/motion/cycles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "toolpace/nc/dwell.h"
#include "toolpace/nc/motion/cycle_fault.h"
#include "toolpace/nc/motion/drilling.h"
#include "toolpace/nc/motion/end_point.h"
#include "toolpace/nc/motion/feedrate.h"
#include "toolpace/nc/motion/increments.h"
#include "toolpace/nc/scaling.h"
#include "toolpace/nc/text/whole_number.h"

namespace toolpace::nc {
namespace {

constexpr double kMostPecks = 100000;
constexpr double kWholeDepth = 1e9;  // [mm] the peck of a hole that is drilled at once
constexpr int kMostRepeats = 1'000'000;

// Lathes drill along Z by G83 to G85 and along X by G87 to G89, whatever the plane.
PlaneAxes cycle_plane(const Context& context, Code code) {
  if (!context.rules.lathe_words) return plane_axes(context.state.modal.plane);
  return code >= 870 ? PlaneAxes{1, 2, 0} : PlaneAxes{0, 1, 2};
}

// G87 to G89 of lathes are G83 to G85 from the side.
Code cycle_of(const Context& context, Code code) {
  return context.rules.lathe_words && code >= 870 ? static_cast<Code>(code - 40) : code;
}

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

// Takes the words that stick from hole to hole.
bool remember(Context& context, const Block& block, Code code, bool same_series) {
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

// What one block drills, but for the places of its holes.
struct Cycle {
  Code form = kNoCode;
  Hole hole{};
  Feedrate feed;
  double initial = 0.0;  // level that the series began at
};

// Whole numbers that would be deeper than the hole are least increments where they may be.
bool find_peck(Context& context, const Block& block, const Cycle& cycle) {
  CycleMemory& memory = context.state.cycle;
  const double depth = cycle.hole.retract - cycle.hole.bottom;
  if (block.has('q')) {
    memory.peck = length_of(context.state, block, 'q');
    const double counted = increments_of(context.state, block, 'q');
    if (context.rules.integers_may_count && memory.peck > depth && counted != memory.peck) {
      memory.peck = counted;
      if (!std::exchange(context.state.increments_told, true)) {
        context.faults.warn(
            "peck-in-increments",
            fmt::format("a peck of Q{:g} is read in least increments, as {:g} mm", block.of('q'), counted),
            "write a decimal point where it is a length", block.column_of('q'));
      }
    }
  }
  if (!(memory.peck > 0.0) && context.rules.lathe_words) memory.peck = kWholeDepth;
  if (!(memory.peck > 0.0)) {
    return fail(context, block, "cycle-peck", code_text('G', memory.code) + " without a positive Q",
                "give the depth of a peck with Q");
  }
  if (depth * scale_of(context.state.offsets, cycle.hole.plane.normal) / memory.peck <= kMostPecks) return true;
  return fail(context, block, "cycle-peck", fmt::format("more than {:g} pecks in one hole", kMostPecks),
              "give a larger Q");
}

bool begin_block(Context& context, const Block& block, Code code, Cycle& cycle) {
  State& state = context.state;
  CycleMemory& memory = state.cycle;
  const bool first_of_series = !memory.initial_level.has_value();
  const bool same_series = !first_of_series && memory.code == code;
  if (!check_cycle(context, block) || !remember(context, block, code, same_series) ||
      !find_feedrate(context, block, {0.0, 0.0, state.position[0], state.position[0]}, cycle.feed))
    return false;
  const PlaneAxes plane = cycle_plane(context, code);
  if (first_of_series) memory.initial_level = state.position[plane.normal];
  cycle.form = cycle_of(context, code);
  cycle.initial = *memory.initial_level;
  Hole& hole = cycle.hole;
  hole = {plane, 0.0, 0.0, memory.r, memory.bottom, 0.0};
  if (context.rules.lathe_words) {
    hole.retract = memory.has_r ? cycle.initial + memory.r : cycle.initial;
  } else if (state.modal.incremental()) {
    hole.retract = memory.r + cycle.initial;
    hole.bottom = memory.bottom + hole.retract;
  }
  hole.clear = state.modal.retract == 980 ? std::max(cycle.initial, hole.retract) : hole.retract;
  if (cycle.form == kBackBoring) {
    hole.clear = std::max(cycle.initial, hole.bottom);
    return true;
  }
  if (hole.retract < hole.bottom)
    return fail(context, block, "cycle-r-below-depth", "R lies below the bottom of the hole", "check R and the depth");
  return (cycle.form != 730 && cycle.form != 830) || find_peck(context, block, cycle);
}

// Holes are reached without going down, under G98 at the initial level at least.
class Holes {
 public:
  Holes(Context& context, const Cycle& cycle)
      : context_(context), cycle_(cycle), run_(context, cycle.hole.plane, cycle.feed) {
    const State& state = context.state;
    const Hole& hole = cycle.hole;
    if (cycle.form == kBackBoring) {
      approach_ = hole.clear;
      return;
    }
    if (cycle.initial < hole.retract) run_.rapid(hole.retract);
    const double here = std::max(state.position[hole.plane.normal], hole.retract);
    approach_ = state.modal.retract == 980 ? std::max(cycle.initial, here) : here;
  }

  bool drill_at(const Block& block, const Position& place) {
    Hole hole = cycle_.hole;
    hole.first = place[hole.plane.first];
    hole.second = place[hole.plane.second];
    for (std::size_t i = 0; i < kAxisCount; ++i) {
      if (is_rotary(i)) context_.state.position[i] = place[i];
    }
    run_.rapid_to(hole.first, hole.second, approach_);
    if (cycle_.form == kBackBoring) {
      bore_back(context_, run_, hole);
      return true;
    }
    if (approach_ != hole.retract) run_.rapid(hole.retract);
    approach_ = hole.clear;
    return drill(context_, run_, block, hole, cycle_.form);
  }

 private:
  Context& context_;
  const Cycle& cycle_;
  CycleRun run_;
  double approach_ = 0.0;
};

}  // namespace

bool run_cycle(Context& context, const Block& block, Code code) {
  Cycle cycle;
  int repeats = 1;
  Position target;
  if (!begin_block(context, block, code, cycle) || !find_repeats(context, block, repeats) ||
      !find_end(context, block, target))
    return false;
  if (repeats == 0 && !context.rules.linuxcnc_cycles) return true;  // the words are kept for later blocks
  Holes holes(context, cycle);
  context.out.set_mode(context.state.modal, true);
  for (int i = 0; i < repeats && !context.out.is_full(); ++i) {
    // Under G91 the words count again from where the tool is now.
    if (context.state.modal.incremental() && i > 0 && !find_end(context, block, target)) return false;
    if (!holes.drill_at(block, target)) return false;
  }
  context.out.set_mode(context.state.modal);
  return true;
}

bool run_cycle_at(Context& context, Code code, const std::vector<Position>& places) {
  Cycle cycle;
  Block none;
  none.clear();
  if (!begin_block(context, none, code, cycle)) return false;
  Holes holes(context, cycle);
  context.out.set_mode(context.state.modal, true);
  for (const Position& place : places) {
    if (context.out.is_full()) break;
    if (!holes.drill_at(none, place)) return false;
  }
  context.out.set_mode(context.state.modal);
  return true;
}

}  // namespace toolpace::nc
