/// One move under one law: from 10 to 20 mm/s over 40 mm, at 100 mm/s at most. Prints its phases.

#include <cstdio>

#include "toolpace/law/single_move.h"

int main() {
  const toolpace::MoveRequest move{.length = 40.0, .feed = 100.0, .start = 10.0, .end = 20.0};
  const toolpace::RampLimits ramp{.acceleration = 3000.0, .jerk = 1e6};
  const auto planned = toolpace::single_move(toolpace::LawKind::quintic, move, {ramp, ramp});
  if (!planned) {
    std::fprintf(stderr, "%s; %s\n", planned.error().message.c_str(), planned.error().remedy.c_str());
    return 1;
  }
  std::printf("peak %.3f mm/s, %.3f ms in all\n", planned->peak, 1000 * planned->total_time());
  for (const auto& phase : planned->phases) {
    const auto end = toolpace::evaluate(phase, phase.duration);
    std::printf("%8.3f ms  %7.3f ... %7.3f mm/s  to %7.3f mm\n", 1000 * phase.duration, phase.speed, end.speed,
                end.distance);
  }
}
