#include "toolpace/nc/motion/turning.h"

#include <cmath>

#include "toolpace/nc/motion/cycle_fault.h"
#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/motion/spindle.h"

namespace toolpace::nc {
namespace {

// The lead counts along the axis that goes further.
bool find_lead(Context& context, const Block& block, const Position& from, const Position& to, Feedrate& feed) {
  const State& state = context.state;
  if (!(state.modal.feed_linear > 0.0))
    return fail(context, block, "pitch-missing", "a thread without a lead", "give it with F");
  const double turns = spindle_turns(state, from[0], to[0]);
  if (turns == 0.0 || std::isinf(turns))
    return fail(context, block, "spindle-stopped", "a thread while the spindle stands still", "give S before");
  const double dx = std::fabs(to[0] - from[0]), dz = std::fabs(to[2] - from[2]);
  const double longer = std::max(dx, dz);
  feed.linear = state.modal.feed_linear * turns * (longer > 0.0 ? std::hypot(dx, dz) / longer : 1.0);
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
bool remember(Context& context, const Block& block, Code code, bool goes_on) {
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
  if (block.has('r') || block.has(old_taper)) memory.taper = length_of(state, block, block.has('r') ? 'r' : old_taper);
  return true;
}

}  // namespace

bool cut_lathe_thread(Context& context, const Block& block, const Position& to) {
  State& state = context.state;
  Feedrate feed;
  if (!find_lead(context, block, state.position, to, feed)) return false;
  context.out.set_mode(state.modal, false, true);
  context.out.line(MoveKind::feed, state.offsets, to, feed);
  context.out.set_mode(state.modal);
  state.position = to;
  return true;
}

bool run_lathe_thread(Context& context, const Block& block) {
  Position end;
  return find_end(context, block, end) && cut_lathe_thread(context, block, end);
}

bool run_turning(Context& context, const Block& block, Code code) {
  State& state = context.state;
  if (state.compensation.radius > 0.0) {
    return fail(context, block, "cycle-with-compensation", "a turning cycle while cutter radius compensation is on",
                "end it with G40 first");
  }
  const bool goes_on = state.turning.code == code;
  if (!remember(context, block, code, goes_on)) return false;
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
  if (!(threads ? cut_lathe_thread(context, block, at) : go(context, block, MoveKind::feed, at))) return false;
  at[to_work] = start[to_work];
  return go(context, block, threads ? MoveKind::rapid : MoveKind::feed, at) &&
         go(context, block, MoveKind::rapid, start);
}

}  // namespace toolpace::nc
