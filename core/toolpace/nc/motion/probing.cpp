#include "toolpace/nc/motion/probing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "toolpace/nc/motion/end_point.h"
#include "toolpace/nc/motion/feedrate.h"

namespace toolpace::nc {

bool run_probe(Context& context, const Block& block, Code code) {
  State& state = context.state;
  const std::size_t column = block.column_of(GGroup::motion);
  if (state.compensation.radius > 0.0) {
    return context.faults.fail("probe-with-compensation", "probing while cutter radius compensation is on",
                               "end it with G40 first", column);
  }
  if (state.modal.feed_mode == 930) {
    return context.faults.fail("probe-inverse-time", "probing in inverse-time mode", "use G94", column);
  }
  if (state.modal.feed == 0.0)
    return context.faults.fail("no-feed", "probing without a feedrate", "give F before", column);
  Position end;
  Feedrate feed;
  if (!find_end(context, block, end)) return false;
  const bool moves = !std::equal(end.begin(), end.end(), state.position.begin(),
                                 [](double a, double b) { return std::fabs(a - b) < 1e-6; });
  if (!moves && (code == 382 || code == 384)) {
    return context.faults.fail("probe-goes-nowhere", fmt::format("{} ends where it begins", code_text('G', code)),
                               "give an end point away from here", column);
  }
  if (!find_straight_feedrate(context, block, state.position, end, feed)) return false;
  context.out.line(MoveKind::probe, state.offsets, end, feed);
  state.position = end;
  // In the units of the program at this moment, as LinuxCNC keeps them.
  Position result = end;
  for (std::size_t i = 0; i < kAxisCount; ++i) result[i] /= is_rotary(i) ? 1.0 : state.modal.unit();
  store_position(context.parameters, kProbedPosition, result);
  // The tool goes to the end: where a contact must come, it came there; where it may come, it did not.
  context.parameters.set_numbered(kProbeSucceeded, code == 382 || code == 384 ? 1.0 : 0.0);
  return true;
}

}  // namespace toolpace::nc
