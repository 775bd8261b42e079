#include "toolpace/nc/motion/turning_cycles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "toolpace/nc/motion/arcs.h"
#include "toolpace/nc/motion/cycle_fault.h"
#include "toolpace/nc/motion/increments.h"
#include "toolpace/nc/motion/lathe_roughing.h"
#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/text/whole_number.h"

namespace toolpace::nc {
namespace {

constexpr int kMostContourRepeats = 1000;
constexpr double kSmallestDepth = 20.0;  // no pass is as deep: without a point it counts least increments

// X is a radius in contours.
Position at(const Context& context, Point p) {
  Position position = programmed_position(context.state);
  position[2] = p.x;
  position[0] = p.y;
  return position;
}

bool go(Context& context, const Block& block, Code code, Point to) {
  context.state.modal.motion = code;
  return go_straight(context, block, code, at(context, to));
}

bool go_around(Context& context, const Block& block, Point end, Point centre, int turn) {
  const Position& from = programmed_position(context.state);
  const PlaneArc arc{{from[2], from[0]}, {end.x, end.y}, {centre.x, centre.y}, turn};
  return toolpace::nc::go_around(context, block, arc, at(context, end));
}

Point here(const Context& context) {
  const Position& p = programmed_position(context.state);
  return {p[2], p[0]};
}

// U and W of a second block: what is left for finishing, across the radius.
Point allowance(const Context& context, const Block& block) {
  const State& state = context.state;
  return {block.has('w') ? increments_of(state, block, 'w', kSmallestDepth) : 0.0,
          block.has('u') ? increments_of(state, block, 'u', kSmallestDepth) / 2.0 : 0.0};
}

// Feeds that the contour gives hold while it is finished.
bool follow(Context& context, const Block& block, const std::vector<ContourElement>& contour, Point shift,
            bool own_feeds) {
  Modal& modal = context.state.modal;
  const double feed = modal.feed, feed_linear = modal.feed_linear;
  bool good = true;
  for (const ContourElement& e : contour) {
    if (own_feeds && e.feed > 0.0) {
      modal.feed = e.feed;
      modal.feed_linear = e.feed * modal.unit();
    }
    good = e.turn == 0 ? go(context, block, e.rapid ? 0 : 10, e.end + shift)
                       : go_around(context, block, e.end + shift, e.centre + shift, e.turn);
    if (!good || context.out.is_full()) break;
  }
  modal.feed = feed;
  modal.feed_linear = feed_linear;
  return good;
}

// Off the work first, then back to where the cycle began.
bool come_back(Context& context, const Block& block, Point start, bool facing) {
  const Point now = here(context);
  return go(context, block, 0, facing ? Point{start.x, now.y} : Point{now.x, start.y}) && go(context, block, 0, start);
}

bool rough_lines(Context& context, const Block& block, Code code, std::vector<ContourElement> contour,
                 WorkBudget& budget) {
  const bool facing = code == kLatheFaceRough;
  const Point start = here(context);
  while (contour.size() > 2 && contour.back().rapid) contour.pop_back();  // the way out is no part of the contour
  if (contour.size() < 2) {
    return fail(context, block, "lathe-contour-empty", "the lines of the cycle describe no contour",
                "a contour has a move to its start, and one along it");
  }
  Roughing roughing;
  roughing.step = block.has('d') ? increments_of(context.state, block, 'd') : context.state.turning_setup.step;
  roughing.first_pass_is_deep = true;
  roughing.retract = context.state.turning_setup.retract;
  if (!(roughing.step > 0.0))
    return fail(context, block, "lathe-words", "a roughing cycle without a depth of its passes",
                "give it with D, or with U of a block before (G72: W)", 'd');
  LatheProfile profile(std::move(contour), facing, context.state.modal.unit());
  profile.start_above();
  if (const ContourElement* const back = profile.find_turning_back()) {
    return fail(context, block, "lathe-contour-turns-back",
                fmt::format("the contour in line {} turns back on its way, or an arc of it does", back->line),
                facing ? "the contour of G72 goes one way in X, its arcs no further than a quarter either side"
                       : "the contour of G71 goes one way in Z, its arcs no further than a quarter either side");
  }
  profile.shift(profile.from_machine(allowance(context, block)));
  profile.close();
  std::vector<LatheMove> moves;
  if (!rough(profile, roughing, moves, budget, context.faults)) return false;
  if (!go(context, block, 0, profile.in_machine(profile.elements().front().start))) return false;
  for (const LatheMove& move : moves) {
    if (context.out.is_full()) return true;
    const Point end = profile.in_machine(move.end);
    const bool good = move.kind == MoveKind::arc ? go_around(context, block, end, profile.in_machine(move.centre),
                                                             profile.turn_in_machine(move.turn))
                                                 : go(context, block, move.kind == MoveKind::rapid ? 0 : 10, end);
    if (!good) return false;
  }
  return come_back(context, block, start, facing);
}

bool repeat_lines(Context& context, const Block& block, const std::vector<ContourElement>& contour) {
  const TurningSetup& setup = context.state.turning_setup;
  const Point start = here(context), left = allowance(context, block);
  for (int pass = setup.repeats - 1; pass >= 0; --pass) {
    const double share = setup.repeats > 1 ? static_cast<double>(pass) / (setup.repeats - 1) : 0.0;
    const Point shift = left + Point{setup.relief_z, setup.relief_x} * share;
    if (!follow(context, block, contour, shift, false) || !come_back(context, block, start, false)) return false;
  }
  return true;
}

}  // namespace

bool set_up_turning(Context& context, const Block& block, Code code) {
  TurningSetup& setup = context.state.turning_setup;
  const double unit = context.state.modal.unit();
  if (code == kLatheFinish)
    return fail(context, block, "lathe-words", "G70 without the lines of a contour", "give their numbers with P and Q");
  if (code == kLatheRepeat) {
    if (block.has('u')) setup.relief_x = block.of('u') * unit;
    if (block.has('w')) setup.relief_z = block.of('w') * unit;
    double repeats = block.of('r', 1.0);
    if (repeats > 0.0 && repeats < 1.0) repeats *= 1000.0;  // R0.005 is five, where counts may have a point
    const auto count = whole_number(repeats, 1, kMostContourRepeats);
    if (!count)
      return fail(context, block, "lathe-words", "R of G73 is no number of passes",
                  "R is a whole number from 1 to 1000", 'r');
    setup.repeats = *count;
    return true;
  }
  const char depth = code == kLatheFaceRough ? 'w' : 'u';
  if (block.has(depth)) setup.step = std::fabs(increments_of(context.state, block, depth, kSmallestDepth));
  if (block.has('r')) setup.retract = std::fabs(increments_of(context.state, block, 'r', kSmallestDepth));
  return true;
}

bool run_turning_cycle(Context& context, const Block& block, Code code, std::vector<ContourElement> contour,
                       WorkBudget& budget) {
  const Code motion = context.state.modal.motion;
  const Point start = here(context);
  bool good = false;
  if (code == kLatheFinish) {
    good = follow(context, block, contour, {}, true) && come_back(context, block, start, false);
  } else if (code == kLatheRepeat) {
    good = repeat_lines(context, block, contour);
  } else {
    good = rough_lines(context, block, code, std::move(contour), budget);
  }
  context.state.modal.motion = motion;
  return good;
}

}  // namespace toolpace::nc
