#include "toolpace/nc/motion/cycles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "toolpace/nc/motion/cycle_fault.h"
#include "toolpace/nc/motion/cycle_words.h"
#include "toolpace/nc/motion/drilling.h"
#include "toolpace/nc/motion/end_point.h"
#include "toolpace/nc/motion/feedrate.h"
#include "toolpace/nc/motion/increments.h"
#include "toolpace/nc/scaling.h"

namespace toolpace::nc {
namespace {

constexpr double kMostPecks = 100000;
constexpr double kWholeDepth = 1e9;  // [mm] the peck of a hole that is drilled at once

// What one block drills, but for the places of its holes.
struct Cycle {
  Code form = kNoCode;
  Hole hole{};
  Feedrate feed;
  double initial = 0.0;  // level that the series began at
};

// I, J and K in place of Q. Without K pecks do not shrink.
void find_shrinking_peck(Context& context, const Block& block) {
  CycleMemory& memory = context.state.cycle;
  memory.peck = std::fabs(length_of(context.state, block, 'i'));
  memory.k = block.has('k') ? std::fabs(length_of(context.state, block, 'k')) : 0.0;
  memory.j = block.has('j') && memory.k > 0.0 ? std::fabs(length_of(context.state, block, 'j')) : 0.0;
}

// Whole numbers that would be deeper than the hole are least increments where they may be.
bool find_peck(Context& context, const Block& block, const Cycle& cycle) {
  CycleMemory& memory = context.state.cycle;
  const double depth = cycle.hole.retract - cycle.hole.bottom;
  if (context.rules.pecks_shrink && block.has('i') && !block.has('q')) find_shrinking_peck(context, block);
  if (block.has('q')) {
    memory.j = memory.k = 0.0;
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
  const double least = memory.j > 0.0 ? std::min(memory.k, memory.peck) : memory.peck;
  if (depth * scale_of(context.state.offsets, cycle.hole.plane.normal) / least <= kMostPecks) return true;
  return fail(context, block, "cycle-peck", fmt::format("more than {:g} pecks in one hole", kMostPecks),
              "give a larger Q");
}

// Fanuc's lathes count R from the level before, towards the work; where that leads away from it, R is a level.
double lathe_retract_level(Context& context, const Block& block, double initial) {
  const CycleMemory& memory = context.state.cycle;
  if (!memory.has_r) return initial;
  const bool is_level =
      memory.r > 0.0 && memory.r <= initial && !memory.bottom_is_increment && memory.r >= memory.bottom;
  if (is_level && block.has('r') && !std::exchange(context.state.lathe_level_told, true)) {
    context.faults.warn(
        "lathe-level",
        fmt::format("R{:g} of a drilling cycle is read as a level; counted from the level before it would "
                    "lead away from the work",
                    block.of('r')),
        "", block.column_of('r'));
  }
  return is_level ? memory.r : initial + memory.r;
}

bool begin_block(Context& context, const Block& block, Code code, Cycle& cycle) {
  State& state = context.state;
  CycleMemory& memory = state.cycle;
  const bool first_of_series = !memory.initial_level.has_value();
  const bool same_series = !first_of_series && memory.code == code;
  if (!check_cycle(context, block) || !remember_cycle_words(context, block, code, same_series) ||
      !find_feedrate(context, block, {0.0, 0.0, state.position[0], state.position[0]}, cycle.feed))
    return false;
  const PlaneAxes plane = cycle_plane(context, code);
  if (first_of_series) memory.initial_level = state.position[plane.normal];
  cycle.form = cycle_of(context, code);
  cycle.initial = *memory.initial_level;
  Hole& hole = cycle.hole;
  hole = {plane, 0.0, 0.0, memory.r, memory.bottom, 0.0};
  if (context.rules.lathe_words) {
    hole.retract = lathe_retract_level(context, block, cycle.initial);
    if (memory.bottom_is_increment) hole.bottom = hole.retract + memory.bottom;
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
