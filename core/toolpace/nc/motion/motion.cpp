#include "toolpace/nc/motion/motion.h"

#include "toolpace/nc/motion/arcs.h"
#include "toolpace/nc/motion/compensation.h"
#include "toolpace/nc/motion/corners.h"
#include "toolpace/nc/motion/cycles.h"
#include "toolpace/nc/motion/end_point.h"
#include "toolpace/nc/motion/probing.h"
#include "toolpace/nc/motion/splines.h"
#include "toolpace/nc/motion/threading.h"
#include "toolpace/nc/motion/turning.h"
#include "toolpace/nc/motion/turning_cycles.h"
#include "toolpace/nc/tool_tip.h"

namespace toolpace::nc {
namespace {

bool run_straight(Context& context, const Block& block, Code code) {
  const State& state = context.state;
  const bool machine_coordinates = block.code(GGroup::once) == 530;
  if (state.compensation.radius > 0.0 && machine_coordinates) {
    return context.faults.fail("g53-with-compensation", "G53 while cutter radius compensation is on",
                               "end it with G40 first", block.column_of(GGroup::once));
  }
  Position end;
  if (!find_end(context, block, end)) return false;
  if (points_tool(context, block) && !point_tool(context, block, end)) return false;
  if (code == 0 && context.rules.rapids_at_feed) code = 10;
  if (machine_coordinates && context.rules.machine_moves_rapid && !block.has(GGroup::motion)) code = 0;
  if (code == 10 && meets_corner(context, block)) return run_cornered_line(context, block, code, end);
  return go_straight(context, block, code, end);
}

// On lathes A, C, R, I and K of a straight move tell of its angle and its corner.
bool run_straight_move(Context& context, const Block& block, Code code) {
  if (!context.rules.lathe_words || !may_mean_corner(block)) return run_straight(context, block, code);
  return run_straight(context, with_corner_words(context, block, code), code);
}

// Group 00: the motion code before goes on behind them.
bool run_once_cycle(Context& context, const Block& block, Code code, Code before) {
  const bool good = code == kLatheThreads ? run_threads(context, block) : run_grooving(context, block, code);
  context.state.modal.motion = before;
  return good;
}

}  // namespace

bool go_straight(Context& context, const Block& block, Code code, const Position& end) {
  State& state = context.state;
  Feedrate feed;
  const Position& from = programmed_position(state);
  if (code == 10 && !find_straight_feedrate(context, block, from, end, feed)) return false;
  const MoveKind kind = code == 0 ? MoveKind::rapid : MoveKind::feed;
  if (state.modal.compensation != 400 && state.compensation.radius > 0.0) {
    return compensate_line(context, kind, end, feed);
  }
  context.out.line(kind, state.offsets, end, feed);
  state.position = end;
  state.compensation.arc_forbidden = false;
  return true;
}

bool run_motion(Context& context, const Block& block, Code code) {
  if (code == 0 || code == 10 || code == 20 || code == 30) context.state.plain_motion = code;
  const Code before = context.state.modal.motion;
  // On Fanuc controllers G80 ends cycles alone; the motion code before them goes on.
  context.state.modal.motion = code == 800 && context.rules.g80_keeps_motion ? context.state.plain_motion : code;
  if (code < kForeignCodes) context.state.turning.code = kNoCode;
  if (code != 50) context.state.spline.after_cubic = false;
  if (context.state.spline.collecting && code != 52 && code != 53) {
    context.faults.warn("spline-not-closed", "another motion before G5.3 gives the spline up",
                        "end the spline with G5.3", block.column_of(GGroup::motion));
    context.state.spline.collecting = false;
  }
  switch (code) {
    case 0:
    case 10: return run_straight_move(context, block, code);
    case 20:
    case 30: return run_arc(context, block, code);
    case 50: return run_cubic_spline(context, block);
    case 51: return run_quadratic_spline(context, block);
    case 52: return collect_nurbs(context, block);
    case 53: return finish_nurbs(context, block);
    case 330: return run_synchronised(context, block);
    case 331: return run_rigid_tap(context, block);
    case 382:
    case 383:
    case 384:
    case 385: return run_probe(context, block, code);
    case 760: return run_threading(context, block);
    case 800: return true;
    case kLatheThread: return run_lathe_thread(context, block);
    case kLatheFaceGroove:
    case kLatheGroove:
    case kLatheThreads: return run_once_cycle(context, block, code, before);
    case kLatheTurning:
    case kLatheFacing:
    case kLatheThreading: return run_turning(context, block, code);
    default: return run_cycle(context, block, code);
  }
}

}  // namespace toolpace::nc
