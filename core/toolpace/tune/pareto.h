#pragma once
/// What is better when several things count. Everything is the smaller the better.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "toolpace/limits/machine.h"

namespace toolpace {

struct Objectives {
  double cycle_time;                     ///< [s]
  double contour;                        ///< largest contour error through the drives [mm]
  std::optional<double> vibration = {};  ///< largest residual of an axis [mm, deg]; nothing where none has a resonance
};

/// What is weighed against the cycle time.
enum class Flaw : std::uint8_t { contour, vibration };

/// @pre known, if it is the vibration
inline double size_of(Flaw flaw, const Objectives& o) { return flaw == Flaw::contour ? o.contour : *o.vibration; }

/// The largest flaws that are still fine; infinite where any is.
struct FlawLimits {
  double contour = kUnlimited, vibration = kUnlimited;

  double of(Flaw flaw) const { return flaw == Flaw::contour ? contour : vibration; }
  /// A vibration that is not known breaks no limit.
  bool keeps(const Objectives& o) const { return o.contour <= contour && o.vibration.value_or(0.0) <= vibration; }
};

/// Whether one is nowhere worse and somewhere better. What is not known of both does not count.
bool dominates(const Objectives& one, const Objectives& other);

/// Indices of those that no other dominates, by rising cycle time; of equal ones the first.
std::vector<std::size_t> pareto_front(std::span<const Objectives> points);

/// The same where one flaw alone counts beside the time. @pre known of all, if it is the vibration
std::vector<std::size_t> pareto_front(std::span<const Objectives> points, Flaw flaw);

/// Index into `front` (points by rising cycle time) of the one that lies farthest below the straight line between both ends, time and
/// contour error each as a share of its range: before it a little time saves much error, behind it much time little. The first where
/// there are less than three. Those that others beat in both do not count. @pre not empty
std::size_t knee_of(std::span<const Objectives> front);

/// Area between a front and a reference point [s·mm]: how much of what is no worse than the reference it dominates.
double hypervolume(std::span<const Objectives> points, const Objectives& reference);

}  // namespace toolpace
