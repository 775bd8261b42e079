#include "toolpace/nc/motion/cycles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "toolpace/nc/dwell.h"
#include "toolpace/nc/motion/cycle_fault.h"
#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/text/whole_number.h"

namespace toolpace::nc {
namespace {

constexpr double kPeckClearance = 0.254;  // [mm] 0.010 in, of G73 and G83
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

// One hole, in work coordinates; levels along the plane's normal axis.
struct Hole {
  PlaneAxes plane;
  double first, second;  // its place in the plane
  double retract;        // R
  double bottom;
  double clear;  // level to leave at
};

class CycleRun {
 public:
  CycleRun(Context& context, const PlaneAxes& plane, const Feedrate& feed)
      : context_(context), plane_(plane), feed_(feed) {}

  void rapid(double level) { move(MoveKind::rapid, level); }
  void feed(double level) { move(MoveKind::feed, level); }
  void rapid_to(double first, double second) { rapid_to(first, second, context_.state.position[plane_.normal]); }
  void rapid_to(double first, double second, double at_level) {
    Position end = context_.state.position;
    end[plane_.normal] = at_level;
    end[plane_.first] = first;
    end[plane_.second] = second;
    context_.out.line(MoveKind::rapid, context_.state.offsets, end);
    context_.state.position = end;
  }
  void dwell(double seconds) { context_.out.dwell(seconds); }

 private:
  void move(MoveKind kind, double level) {
    Position end = context_.state.position;
    end[plane_.normal] = level;
    context_.out.line(kind, context_.state.offsets, end, feed_);
    context_.state.position = end;
  }

  Context& context_;
  PlaneAxes plane_;
  Feedrate feed_;
};

void peck(CycleRun& run, const Hole& hole, double step, bool full_retract) {
  for (double depth = hole.retract - step; depth > hole.bottom; depth -= step) {
    run.feed(depth);
    if (full_retract) run.rapid(hole.retract);
    run.rapid(depth + kPeckClearance);
  }
  run.feed(hole.bottom);
  run.rapid(hole.clear);
}

bool check_spindle(Context& context, const Block& block, Code code) {
  const int direction = context.state.modal.spindle_direction;
  const bool needs_any = code == 860 || code == 870 || code == 880;
  const int wanted = code == 740 ? -1 : code == 840 ? 1 : 0;
  if (needs_any && direction == 0 && context.rules.refuses_doubtful) {
    return fail(context, block, "spindle-stopped", code_text('G', code) + " while the spindle stands still",
                "start it with M3 or M4");
  }
  if (wanted == 0 || wanted == direction || !context.rules.refuses_doubtful) return true;
  return fail(context, block, "spindle-direction",
              fmt::format("{} while the spindle does not turn that way", code_text('G', code)),
              wanted > 0 ? "start it with M3 before G84" : "start it with M4 before G74");
}

// Back boring: down beside the hole, sideways into it, up to `top` with the tool, and all of it back.
void back_bore(CycleRun& run, const Hole& hole, const CycleMemory& memory, double top) {
  const double beside_first = hole.first + memory.i, beside_second = hole.second + memory.j;
  run.rapid_to(beside_first, beside_second);
  run.rapid(hole.bottom);
  run.rapid_to(hole.first, hole.second);
  run.feed(top);
  run.feed(hole.bottom);
  run.rapid_to(beside_first, beside_second);
  run.rapid(hole.clear);
  run.rapid_to(hole.first, hole.second);
}

bool drill(Context& context, CycleRun& run, const Block& block, const Hole& hole, Code code) {
  const CycleMemory& memory = context.state.cycle;
  if (!check_spindle(context, block, code)) return false;
  const bool incremental = context.state.modal.incremental();
  const bool as_linuxcnc = context.rules.linuxcnc_cycles;
  switch (code) {
    case 730:
    case 830: peck(run, hole, memory.peck, code == 830); return true;
    case 870: back_bore(run, hole, memory, memory.k + (incremental ? hole.bottom : 0.0)); return true;
    case 880:  // the operator retracts by hand
      run.feed(hole.bottom);
      run.dwell(memory.dwell);
      context.out.note(MoveKind::stop, "M0");
      if (as_linuxcnc) context.state.position[hole.plane.normal] = hole.clear;
      return true;
    case 810: run.feed(hole.bottom); break;
    case 820:
    case 860:
      run.feed(hole.bottom);
      run.dwell(memory.dwell);
      break;
    case 850:
      run.feed(hole.bottom);
      run.feed(hole.retract);
      break;
    case 740:
    case 840:  // tapping: the spindle turns round at the bottom
    case 890:
      run.feed(hole.bottom);
      run.dwell(memory.dwell);
      run.feed(as_linuxcnc ? hole.clear : hole.retract);
      break;
    default: break;
  }
  run.rapid(hole.clear);
  return true;
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
  if (form == 730 || form == 830) {
    if (block.has('q')) memory.peck = length_of(state, block, 'q');
    if (!(memory.peck > 0.0) && context.rules.lathe_words) memory.peck = kWholeDepth;
    if (!(memory.peck > 0.0))
      return fail(context, block, "cycle-peck", name + " without a positive Q", "give the depth of a peck with Q");
  }
  if (block.has('p')) memory.dwell = dwell_of(context, block);
  if ((form == 820 || form == 860 || form == 880 || form == 890) && !block.has('p') && !same_series) {
    if (context.rules.refuses_doubtful)
      return fail(context, block, "cycle-without-dwell", name + " without P", "give the dwell in s with P");
    memory.dwell = 0.0;
  }
  if (form == 870 && !remember_back_boring(context, block, same_series)) return false;
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
  if (block.has_any(kRotaryBits))
    return fail(context, block, "cycle-rotary", "a rotary axis in a canned cycle", "turn it in a block before");
  return true;
}

}  // namespace

bool run_cycle(Context& context, const Block& block, Code code) {
  State& state = context.state;
  const bool first_of_series = !state.cycle.initial_level.has_value();
  const bool same_series = !first_of_series && state.cycle.code == code;
  if (!check_cycle(context, block) || !remember(context, block, code, same_series)) return false;
  const PlaneAxes plane = cycle_plane(context, code);
  const Code form = cycle_of(context, code);
  int repeats = 1;
  Feedrate feed;
  if (!find_repeats(context, block, repeats) ||
      !find_feedrate(context, block, {0.0, 0.0, state.position[0], state.position[0]}, feed))
    return false;
  Position target;
  if (!find_end(context, block, target)) return false;

  CycleMemory& memory = state.cycle;
  if (first_of_series) memory.initial_level = state.position[plane.normal];
  const double initial = *memory.initial_level;
  const bool incremental = state.modal.incremental();
  Hole hole{plane, target[plane.first], target[plane.second], memory.r, memory.bottom, 0.0};
  if (context.rules.lathe_words) {
    hole.retract = memory.has_r ? initial + memory.r : initial;
  } else if (incremental) {
    hole.retract = memory.r + initial;
    hole.bottom = memory.bottom + hole.retract;
  }
  if (hole.retract < hole.bottom)
    return fail(context, block, "cycle-r-below-depth", "R lies below the bottom of the hole", "check R and the depth");
  if ((form == 730 || form == 830) && (hole.retract - hole.bottom) / memory.peck > kMostPecks) {
    return fail(context, block, "cycle-peck", fmt::format("more than {:g} pecks in one hole", kMostPecks),
                "give a larger Q");
  }
  hole.clear = state.modal.retract == 980 ? std::max(initial, hole.retract) : hole.retract;
  CycleRun run(context, plane, feed);
  if (initial < hole.retract) run.rapid(hole.retract);
  context.out.set_mode(state.modal, true);
  // Holes are reached without going down, under G98 at the initial level at least.
  const double here = std::max(state.position[plane.normal], hole.retract);
  double approach = state.modal.retract == 980 ? std::max(initial, here) : here;
  for (int i = 0; i < repeats && !context.out.is_full(); ++i) {
    if (incremental && i > 0) {  // the words count again from where the tool is now
      if (!find_end(context, block, target)) return false;
      hole.first = target[plane.first];
      hole.second = target[plane.second];
    }
    run.rapid_to(hole.first, hole.second, approach);
    if (approach != hole.retract) run.rapid(hole.retract);
    if (!drill(context, run, block, hole, form)) return false;
    approach = hole.clear;
  }
  context.out.set_mode(state.modal);
  return true;
}

}  // namespace toolpace::nc
