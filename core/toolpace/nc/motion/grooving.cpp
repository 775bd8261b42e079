/// G74, G75 and G76 of Fanuc's lathes.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "toolpace/nc/motion/cycle_fault.h"
#include "toolpace/nc/motion/increments.h"
#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/motion/turning.h"
#include "toolpace/nc/motion/turning_cycles.h"
#include "toolpace/nc/text/whole_number.h"

namespace toolpace::nc {
namespace {

constexpr double kMostGrooveSteps = 100000;
constexpr int kMostThreadFinishes = 99;

bool go_axis(Context& context, const Block& block, MoveKind kind, std::size_t axis, double to) {
  State& state = context.state;
  Position end = state.position;
  end[axis] = to;
  Feedrate feed;
  if (kind == MoveKind::feed && !find_straight_feedrate(context, block, state.position, end, feed)) return false;
  context.out.line(kind, state.offsets, end, feed);
  state.position = end;
  return true;
}

struct Groove {
  std::size_t deep, aside;  // axes
  double bottom, last;      // where it ends
  double peck, step;        // > 0
  double retract;
};

// One plunge, in pecks.
bool plunge(Context& context, const Block& block, const Groove& groove, double top) {
  const double sense = groove.bottom < top ? -1.0 : 1.0;
  const double whole = std::fabs(groove.bottom - top);
  for (double depth = groove.peck; depth < whole; depth += groove.peck) {
    const double at = top + sense * depth;
    if (!go_axis(context, block, MoveKind::feed, groove.deep, at) ||
        !go_axis(context, block, MoveKind::rapid, groove.deep, at - sense * groove.retract))
      return false;
  }
  return go_axis(context, block, MoveKind::feed, groove.deep, groove.bottom) &&
         go_axis(context, block, MoveKind::rapid, groove.deep, top);
}

bool check_steps(Context& context, const Block& block, const Groove& groove, const Position& start) {
  const double pecks = std::fabs(groove.bottom - start[groove.deep]) / groove.peck;
  const double steps = std::fabs(groove.last - start[groove.aside]) / groove.step;
  if (pecks <= kMostGrooveSteps && steps <= kMostGrooveSteps && pecks * steps <= kMostGrooveSteps) return true;
  return fail(context, block, "cycle-peck", "too many steps in one groove", "give larger steps");
}

// From these on, R without a point counts least increments.
constexpr double kLargestLastCut = 1.0, kLargestRetract = 20.0;

}  // namespace

bool run_grooving(Context& context, const Block& block, Code code) {
  State& state = context.state;
  const bool in_face = code == kLatheFaceGroove;
  Position end;
  if (!find_end(context, block, end)) return false;
  const bool names_end = names_axis(context, block, 0) || names_axis(context, block, 2);
  if (!names_end) {  // the first block of two
    if (block.has('r')) state.turning_setup.retract = increments_of(state, block, 'r', kLargestRetract);
    return true;
  }
  const Position start = state.position;
  Groove groove{in_face ? std::size_t{2} : std::size_t{0},
                in_face ? std::size_t{0} : std::size_t{2},
                0.0,
                0.0,
                0.0,
                0.0,
                state.turning_setup.retract};
  groove.bottom = end[groove.deep];
  groove.last = end[groove.aside];
  // P and I count along X, Q and K along Z.
  const auto step = [&](char letter, char old, double otherwise) {
    if (block.has(letter)) return increments_of(state, block, letter);
    return block.has(old) ? increments_of(state, block, old) : otherwise;
  };
  const double whole_x = std::fabs(end[0] - start[0]), whole_z = std::fabs(end[2] - start[2]);
  const double along_x = std::fabs(step('p', 'i', whole_x)), along_z = std::fabs(step('q', 'k', whole_z));
  groove.peck = std::max(in_face ? along_z : along_x, kVanishing);
  groove.step = std::max(in_face ? along_x : along_z, kVanishing);
  if (!check_steps(context, block, groove, start)) return false;
  const double sense = groove.last < start[groove.aside] ? -1.0 : 1.0;
  const double whole = std::fabs(groove.last - start[groove.aside]);
  for (double moved = 0.0; !context.out.is_full(); moved = std::min(moved + groove.step, whole)) {
    if (moved > 0.0 && !go_axis(context, block, MoveKind::rapid, groove.aside, start[groove.aside] + sense * moved))
      return false;
    if (!plunge(context, block, groove, start[groove.deep])) return false;
    if (moved >= whole) break;
  }
  return go_axis(context, block, MoveKind::rapid, groove.aside, start[groove.aside]);
}

bool run_threads(Context& context, const Block& block) {
  State& state = context.state;
  TurningSetup& setup = state.turning_setup;
  Position end;
  if (!find_end(context, block, end)) return false;
  if (!names_axis(context, block, 0) && !names_axis(context, block, 2)) {
    if (block.has('p')) {  // mmrraa: finishing passes, chamfer, angle of the thread
      const auto word = whole_number(block.of('p'), 0, 999999);
      if (!word) return fail(context, block, "thread-words", "P of G76 is no number of six digits", "", 'p');
      setup.finishing_passes = std::clamp(*word / 10000, 1, kMostThreadFinishes);
      setup.pull_out = *word / 100 % 100 / 10.0;
      setup.flank_angle = *word % 100 / 2.0 * kRadiansPerDegree;
    }
    if (block.has('q')) setup.least_cut = increments_of(state, block, 'q');
    if (block.has('r')) setup.last_cut = std::fabs(increments_of(state, block, 'r', kLargestLastCut));
    return true;
  }
  const bool one_block = block.has('k') || block.has('d');
  const char height = one_block ? 'k' : 'p', first = one_block ? 'd' : 'q', taper = one_block ? 'i' : 'r';
  if (one_block && block.has('a')) setup.flank_angle = block.of('a') / 2.0 * kRadiansPerDegree;
  for (const char letter : {height, first}) {
    if (block.has(letter) && increments_of(state, block, letter) > 0.0) continue;
    return fail(context, block, "thread-words",
                fmt::format("G76 without a positive {}", static_cast<char>(letter - 32)),
                "give the height of the thread and the depth of the first cut");
  }
  const double whole = increments_of(state, block, height), cut = increments_of(state, block, first);
  const double slope = block.has(taper) ? length_of(state, block, taper) : 0.0;
  const Position start = state.position;
  const double side = start[0] >= end[0] ? 1.0 : -1.0;  // outside threads are cut towards smaller X
  const double roughed = std::max(whole - setup.last_cut, std::min(cut, whole));
  if (std::pow(roughed / cut, 2.0) > kMostGrooveSteps)
    return fail(context, block, "thread-words", "too many passes of a thread", "give a deeper first cut");
  const auto pass = [&](double depth) {
    // In along one flank: the deeper, the nearer to the end the cut begins.
    const double in = std::copysign((whole - depth) * std::tan(setup.flank_angle), start[2] - end[2]);
    const double x = end[0] + side * (whole - depth);
    if (!go_axis(context, block, MoveKind::rapid, 2, start[2] + in) ||
        !go_axis(context, block, MoveKind::rapid, 0, x + slope))
      return false;
    Position to = state.position;
    to[0] = x;
    to[2] = end[2];
    return cut_lathe_thread(context, block, to, start[0] - to[0]) &&
           go_axis(context, block, MoveKind::rapid, 0, start[0]);
  };
  double depth = 0.0;
  for (int n = 1; depth < roughed && !context.out.is_full(); ++n) {
    depth = std::min(roughed, std::max(cut * std::sqrt(n), depth + setup.least_cut));
    if (!pass(depth)) return false;
  }
  for (int n = depth < whole ? 0 : 1; n < std::max(setup.finishing_passes, 1); ++n) {
    if (!pass(whole)) return false;
  }
  return go_axis(context, block, MoveKind::rapid, 2, start[2]);
}

}  // namespace toolpace::nc
