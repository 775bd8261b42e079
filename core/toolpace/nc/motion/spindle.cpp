#include "toolpace/nc/motion/spindle.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace toolpace::nc {
namespace {

constexpr double kMmPerMetre = 1000.0, kMmPerFoot = 304.8;
constexpr double kNoWay = 1e-9;  // [mm]

}  // namespace

double spindle_turns(const State& state, double from, double to) {
  const Modal& modal = state.modal;
  const double speed = std::fabs(modal.spindle_speed);
  if (modal.spindle_mode != 960 || speed == 0.0) return speed;
  // Turns a minute times the radius in mm: S is in m/min, under G20 in ft/min.
  const double surface = speed * (modal.units == 200 ? kMmPerFoot : kMmPerMetre) / (2.0 * std::numbers::pi);
  const double least = 1.0 / modal.spindle_limit;      // of the time per turn [min]
  const double inner = surface / modal.spindle_limit;  // radius inside which the limit holds [mm]
  const auto time_per_turn = [&](double x) { return std::max(least, std::fabs(x) / surface); };
  const auto integral = [&](double x) {
    const double r = std::fabs(x);
    const double sum = r <= inner ? r * least : inner * least + (r * r - inner * inner) / (2.0 * surface);
    return std::copysign(sum, x);
  };
  const double mean =
      std::fabs(to - from) < kNoWay ? time_per_turn((from + to) / 2.0) : (integral(to) - integral(from)) / (to - from);
  return mean > 0.0 ? 1.0 / mean : std::numeric_limits<double>::infinity();
}

}  // namespace toolpace::nc
