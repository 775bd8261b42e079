#pragma once
/// What is better when several things count. Everything is the smaller the better.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace toolpace {

struct Objectives {
  double cycle_time;                     ///< [s]
  double contour;                        ///< largest contour error through the drives [mm]
  std::optional<double> vibration = {};  ///< [mm]; nothing where it is not known
};

/// Whether one is nowhere worse and somewhere better. What is not known of both does not count.
bool dominates(const Objectives& one, const Objectives& other);

/// Indices of those that no other dominates, by rising cycle time; of equal ones the first.
std::vector<std::size_t> pareto_front(std::span<const Objectives> points);

/// Index into `front` (points by rising cycle time) of the one that lies farthest below the straight line between both ends, time and
/// contour error each as a share of its range: before it a little time saves much error, behind it much time little. The first where
/// there are less than three. @pre not empty
std::size_t knee_of(std::span<const Objectives> front);

/// Area between a front and a reference point [s·mm]: how much of what is no worse than the reference it dominates.
double hypervolume(std::span<const Objectives> points, const Objectives& reference);

}  // namespace toolpace
