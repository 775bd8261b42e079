#include "toolpace/nc/cycles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "toolpace/nc/motion.h"

namespace toolpace::nc {
namespace {

constexpr double kPeckClearance = 0.254;  // [mm] 0.010 in, of G73 and G83
constexpr double kMostPecks = 100000;

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
  void rapid_to(double first, double second) {
    Position end = context_.state.position;
    end[plane_.first] = first;
    end[plane_.second] = second;
    context_.out.line(MoveKind::rapid, context_.state.offsets, end);
    context_.state.position = end;
  }
  void dwell(double seconds) { context_.out.dwell(seconds); }
  double level() const { return context_.state.position[plane_.normal]; }

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

void drill(CycleRun& run, const Hole& hole, Code code, const CycleMemory& memory) {
  switch (code) {
    case 730: peck(run, hole, memory.peck, false); return;
    case 830: peck(run, hole, memory.peck, true); return;
    case 740:
    case 840:  // tapping: the spindle turns round at the bottom
      run.feed(hole.bottom);
      if (memory.dwell > 0.0) run.dwell(memory.dwell);
      run.feed(hole.retract);
      break;
    case 810: run.feed(hole.bottom); break;
    case 820:
    case 860:
    case 880:
      run.feed(hole.bottom);
      run.dwell(memory.dwell);
      break;
    case 850:
      run.feed(hole.bottom);
      run.feed(hole.retract);
      break;
    case 890:
      run.feed(hole.bottom);
      run.dwell(memory.dwell);
      run.feed(hole.retract);
      break;
    default: break;
  }
  run.rapid(hole.clear);
}

bool fail(Context& context, const Block& block, const char* code, std::string what, const char* remedy) {
  return context.faults.fail(code, std::move(what), remedy, block.column_of(GGroup::motion));
}

// Takes the words that stick from hole to hole.
bool remember(Context& context, const Block& block, Code code, bool same_series) {
  State& state = context.state;
  CycleMemory& memory = state.cycle;
  if (!same_series) memory = CycleMemory{};
  const PlaneAxes plane = plane_axes(state.modal.plane);
  const char depth_word = kAxisLetters[plane.normal];
  if (block.has('r')) {
    memory.r = length_of(state, block, 'r');
    memory.has_r = true;
  }
  if (block.has(depth_word)) {
    memory.bottom = block.of(depth_word) * state.modal.unit();
    memory.has_bottom = true;
  }
  const std::string name = code_text('G', code);
  if (!memory.has_r)
    return fail(context, block, "cycle-without-r", name + " without R", "give the retract level with R");
  if (!memory.has_bottom) {
    return fail(context, block, "cycle-without-depth",
                fmt::format("{} without {}", name, static_cast<char>(depth_word - 32)), "give the depth");
  }
  if (code == 730 || code == 830) {
    if (block.has('q')) memory.peck = length_of(state, block, 'q');
    if (!(memory.peck > 0.0))
      return fail(context, block, "cycle-peck", name + " without a positive Q", "give the depth of a peck with Q");
  }
  if (block.has('p')) memory.dwell = block.of('p');
  if ((code == 820 || code == 860 || code == 880 || code == 890) && !block.has('p') && !same_series) {
    if (context.dialect == Dialect::linuxcnc)
      return fail(context, block, "cycle-without-dwell", name + " without P", "give the dwell in s with P");
    memory.dwell = 0.0;
  }
  if (memory.dwell < 0.0) return fail(context, block, "dwell-negative", "a dwell below 0 s", "give a positive P");
  return true;
}

bool find_repeats(Context& context, const Block& block, int& repeats) {
  const char letter = context.dialect == Dialect::fanuc && block.has('k') ? 'k' : 'l';
  const double value = block.of(letter, 1.0);
  if (!(value >= 0.0 && value < 1e9) || std::fabs(value - std::round(value)) > 1e-3) {
    return fail(context, block, "cycle-repeats", fmt::format("{:g} repeats of a cycle", value),
                "L is a whole number from 0");
  }
  repeats = static_cast<int>(std::round(value));
  return true;
}

bool check_cycle(Context& context, const Block& block, Code code) {
  const Modal& modal = context.state.modal;
  if (code == 870)
    return fail(context, block, "cycle-unsupported", "G87 (back boring) is not supported", "write the moves out");
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
  if ((code == 740 || code == 840) && modal.spindle_speed == 0.0) {
    return fail(context, block, "spindle-stopped", "tapping without a spindle speed", "give S before");
  }
  return true;
}

}  // namespace

bool run_cycle(Context& context, const Block& block, Code code) {
  State& state = context.state;
  const bool same_series = state.cycle.initial_level.has_value();
  if (!check_cycle(context, block, code) || !remember(context, block, code, same_series)) return false;
  const PlaneAxes plane = plane_axes(state.modal.plane);
  int repeats = 1;
  Feedrate feed;
  if (!find_repeats(context, block, repeats) || !find_feedrate(context, block, 0.0, 0.0, feed)) return false;
  Position target;
  if (!find_end(context, block, target)) return false;

  CycleMemory& memory = state.cycle;
  double level = state.position[plane.normal];
  if (!memory.initial_level) memory.initial_level = level;
  const bool incremental = state.modal.incremental();
  Hole hole{plane, target[plane.first], target[plane.second], memory.r, memory.bottom, 0.0};
  if (incremental) {
    hole.retract = memory.r + level;
    hole.bottom = memory.bottom + hole.retract;
  }
  if (hole.retract < hole.bottom)
    return fail(context, block, "cycle-r-below-depth", "R lies below the bottom of the hole", "check R and the depth");
  if ((code == 730 || code == 830) && (hole.retract - hole.bottom) / memory.peck > kMostPecks) {
    return fail(context, block, "cycle-peck", fmt::format("more than {:g} pecks in one hole", kMostPecks),
                "give a larger Q");
  }
  hole.clear = state.modal.retract == 980 ? std::max(*memory.initial_level, hole.retract) : hole.retract;
  CycleRun run(context, plane, feed);
  if (level < hole.retract) run.rapid(hole.retract);
  context.out.set_mode(state.modal, true);
  for (int i = 0; i < repeats && !context.out.is_full(); ++i) {
    if (incremental && i > 0) {  // the words count again from where the tool is now
      if (!find_end(context, block, target)) return false;
      hole.first = target[plane.first];
      hole.second = target[plane.second];
    }
    run.rapid_to(hole.first, hole.second);
    if (run.level() != hole.retract) run.rapid(hole.retract);
    drill(run, hole, code, memory);
  }
  context.out.set_mode(state.modal);
  return true;
}

}  // namespace toolpace::nc
