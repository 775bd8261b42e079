#include "toolpace/nc/motion/feedrate.h"

#include <cmath>

#include "toolpace/nc/motion/spindle.h"
#include "toolpace/nc/scaling.h"

namespace toolpace::nc {
namespace {

constexpr double kNoLength = 1e-12;

}  // namespace

bool find_feedrate(Context& context, const Block& block, const Way& way, Feedrate& feed) {
  const double linear_length = way.linear, angular_length = way.angular;
  const Modal& modal = context.state.modal;
  if (modal.feed_mode == 930) {
    if (!block.has('f')) {
      return context.faults.fail("inverse-time-without-feed",
                                 "a feed move in inverse-time mode (G93) without an F word",
                                 "give F in every block with a feed move, or use G94");
    }
    feed.linear = linear_length * block.of('f');
    feed.angular = angular_length * block.of('f');
    if (block.of('f') > 0.0) return true;
    return context.faults.fail("no-feed", "a feed of zero", "give a positive F", block.column_of('f'));
  }
  if (modal.feed == 0.0)
    return context.faults.fail("no-feed", "a feed move without a feedrate", "give F before or in this block");
  double turns = 1.0;
  if (modal.feed_mode == 950) {
    turns = spindle_turns(context.state, way.from, way.to);
    if (turns == 0.0) {
      return context.faults.fail("spindle-stopped", "feed per turn (G95) without a spindle speed", "give S before");
    }
    if (std::isinf(turns)) {
      return context.faults.fail("spindle-unbounded",
                                 "at X0 constant surface speed (G96) turns the spindle without bound",
                                 "give the highest speed with D beside G96");
    }
  }
  feed.linear = modal.feed_linear * turns;
  feed.angular = modal.feed * turns;
  return true;
}

bool find_straight_feedrate(Context& context, const Block& block, const Position& from, const Position& to,
                            Feedrate& feed) {
  double linear = 0.0, angular = 0.0;
  if (context.state.modal.feed_mode == 930) {  // lengths matter in inverse-time mode alone
    for (std::size_t i = 0; i < kAxisCount; ++i) {
      const double step = (to[i] - from[i]) * scale_of(context.state.offsets, i);
      (is_rotary(i) ? angular : linear) += step * step;
    }
    linear = std::sqrt(linear);
    angular = std::sqrt(angular);
    if (linear < kNoLength) linear = 0.0;
  }
  return find_feedrate(context, block, {linear, angular, from[0], to[0]}, feed);
}

}  // namespace toolpace::nc
