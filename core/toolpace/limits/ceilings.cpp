#include "toolpace/limits/ceilings.h"

#include <algorithm>
#include <optional>

namespace toolpace {
namespace {

using Combine = MotionCeiling (*)(const MotionCeiling&, const MotionCeiling&);

MotionCeiling combined(const Commands& commands, std::size_t begin, std::size_t end, Combine combine) {
  if (commands.ceilings.size() == 1 || begin == end) return commands.ceilings.front();
  MotionCeiling all = commands.ceiling_of(begin);
  for (std::size_t i = begin + 1; i < end; ++i) {
    if (commands[i].ceiling != commands[i - 1].ceiling) all = combine(all, commands.ceiling_of(i));
  }
  return all;
}

}  // namespace

namespace {

/// In between, controllers go from one to the other in proportion (Fanuc: AI contour control, levels 1 to 10).
double finer(double own, double fine, double accuracy) {
  if (!(accuracy > 0) || !(fine < own)) return own;
  if (!(own < kUnlimited)) return accuracy < 1 ? own : fine;
  return own + accuracy * (fine - own);
}

}  // namespace

Machine under(const Machine& machine, const MotionCeiling& ceiling) {
  Machine lowered = machine;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    lowered.axes[k].speed = std::min(machine.axes[k].speed, ceiling.speed[i]);
    lowered.axes[k].acceleration = std::min(machine.axes[k].acceleration, ceiling.acceleration[i]);
  }
  lowered.path.speed = std::min(machine.path.speed, ceiling.path_speed);
  PathLimits& path = lowered.path;
  path.acceleration = finer(path.acceleration, path.fine_acceleration, ceiling.accuracy);
  path.deceleration = finer(path.deceleration, path.fine_acceleration, ceiling.accuracy);
  path.acceleration = std::min(path.acceleration, ceiling.path_acceleration);
  path.deceleration = std::min(path.deceleration, ceiling.path_acceleration);
  return lowered;
}

std::vector<Machine> machines_under(const Machine& machine, const Commands& commands) {
  std::vector<Machine> machines;
  machines.reserve(commands.ceilings.size());
  for (const MotionCeiling& ceiling : commands.ceilings) machines.push_back(under(machine, ceiling));
  return machines;
}

MotionCeiling lowest_ceiling(const Commands& commands, std::size_t begin, std::size_t end) {
  return combined(commands, begin, end, lower_of);
}

MotionCeiling highest_ceiling(const Commands& commands, std::size_t begin, std::size_t end) {
  return combined(commands, begin, end, higher_of);
}

MotionCeiling highest_ceiling(const Moves& moves) {
  if (moves.ceilings.size() == 1) return moves.ceilings.front();
  std::vector<bool> runs(moves.ceilings.size());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (is_motion(moves.kind[i])) runs[moves.modes[moves.mode[i]].ceiling] = true;
  }
  std::optional<MotionCeiling> all;
  for (std::size_t c = 0; c < runs.size(); ++c) {
    if (runs[c]) all = all ? higher_of(*all, moves.ceilings[c]) : moves.ceilings[c];
  }
  return all.value_or(MotionCeiling{});
}

bool has_mixed_ceilings(const Commands& commands, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin + 1; i < end; ++i) {
    if (commands[i].ceiling != commands[begin].ceiling) return true;
  }
  return false;
}

}  // namespace toolpace
