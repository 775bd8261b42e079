#include "toolpace/nc/motion/turning.h"

#include <algorithm>
#include <cmath>

#include "toolpace/nc/motion/cycle_fault.h"
#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/motion/spindle.h"

namespace toolpace::nc {
namespace {

// E is a finer F, and sticks while the cycle goes on.
double lead_of(const State& state, const Block& block) {
  if (block.has('e')) return length_of(state, block, 'e');
  return state.turning.lead > 0.0 ? state.turning.lead : state.modal.feed_linear;
}

// The lead counts along the axis that goes further.
bool find_lead(Context& context, const Block& block, const Position& from, const Position& to, Feedrate& feed) {
  const State& state = context.state;
  const double lead = lead_of(state, block);
  if (!(lead > 0.0)) return fail(context, block, "pitch-missing", "a thread without a lead", "give it with F or E");
  const double turns = spindle_turns(state, from[0], to[0]);
  if (turns == 0.0 || std::isinf(turns))
    return fail(context, block, "spindle-stopped", "a thread while the spindle stands still", "give S before");
  const double dx = std::fabs(to[0] - from[0]), dz = std::fabs(to[2] - from[2]);
  const double longer = std::max(dx, dz);
  feed.linear = lead * turns * (longer > 0.0 ? std::hypot(dx, dz) / longer : 1.0);
  return true;
}

bool go(Context& context, const Block& block, MoveKind kind, const Position& to) {
  State& state = context.state;
  Feedrate feed;
  if (kind == MoveKind::feed && !find_straight_feedrate(context, block, state.position, to, feed)) return false;
  context.out.line(kind, state.offsets, to, feed);
  state.position = to;
  return true;
}

// Words stick while the same cycle goes on.
bool remember_turning(Context& context, const Block& block, Code code, bool goes_on) {
  State& state = context.state;
  TurningMemory& memory = state.turning;
  if (!goes_on) memory = TurningMemory{};
  Position end;
  if (!find_end(context, block, end)) return false;
  for (const std::size_t axis : {std::size_t{0}, std::size_t{2}}) {
    if (names_axis(context, block, axis)) {
      memory.end[axis] = end[axis];
      memory.given[axis] = true;
    }
    if (!memory.given[axis]) {
      return fail(context, block, "cycle-words", code_text('G', code) + " without an end in X and Z",
                  "give X or U, and Z or W");
    }
  }
  const char old_taper = code == kLatheFacing ? 'k' : 'i';
  if (block.has('e')) memory.lead = length_of(state, block, 'e');
  if (block.has('r') || block.has(old_taper)) memory.taper = length_of(state, block, block.has('r') ? 'r' : old_taper);
  return true;
}

}  // namespace

bool cut_lathe_thread(Context& context, const Block& block, const Position& to, double away) {
  State& state = context.state;
  const Position from = state.position;
  Feedrate feed;
  if (!find_lead(context, block, from, to, feed)) return false;
  const double length = std::fabs(to[2] - from[2]);
  const double out = std::min({state.turning_setup.pull_out * lead_of(state, block), length, std::fabs(away)});
  context.out.set_mode(state.modal, false, true);
  Position end = to;
  if (out > 0.0) {
    const double share = 1.0 - out / length;
    Position full = to;
    for (const std::size_t axis : {std::size_t{0}, std::size_t{2}})
      full[axis] = from[axis] + (to[axis] - from[axis]) * share;
    context.out.line(MoveKind::feed, state.offsets, full, feed);
    end[0] += std::copysign(out, away);
  }
  context.out.line(MoveKind::feed, state.offsets, end, feed);
  context.out.set_mode(state.modal);
  state.position = end;
  return true;
}

bool run_lathe_thread(Context& context, const Block& block) {
  Position end;
  return find_end(context, block, end) && cut_lathe_thread(context, block, end, 0.0);
}

bool run_turning(Context& context, const Block& block, Code code) {
  State& state = context.state;
  if (state.compensation.radius > 0.0) {
    return fail(context, block, "cycle-with-compensation", "a turning cycle while cutter radius compensation is on",
                "end it with G40 first");
  }
  const bool goes_on = state.turning.code == code;
  if (!remember_turning(context, block, code, goes_on)) return false;
  TurningMemory& memory = state.turning;
  memory.code = code;
  const std::size_t to_work = code == kLatheFacing ? 2 : 0, along = code == kLatheFacing ? 0 : 2;
  const Position start = state.position;
  Position at = start;
  at[to_work] = memory.end[to_work] + memory.taper;
  if (!go(context, block, MoveKind::rapid, at)) return false;
  at[to_work] = memory.end[to_work];
  at[along] = memory.end[along];
  const bool threads = code == kLatheThreading;
  if (!(threads ? cut_lathe_thread(context, block, at, start[0] - at[0]) : go(context, block, MoveKind::feed, at)))
    return false;
  at[to_work] = start[to_work];
  return go(context, block, threads ? MoveKind::rapid : MoveKind::feed, at) &&
         go(context, block, MoveKind::rapid, start);
}

}  // namespace toolpace::nc
