#pragma once
/// How round the drives make a commanded circle: the radial error of the actual path over the angle, as a ball bar shows it.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "drawing/contour_scene.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

/// A commanded circle or part of one: consecutive arc rows about one centre.
struct Circle {
  std::size_t first_row = 0, last_row = 0;  ///< of the program's moves
  std::uint32_t line = 0;                   ///< NC line of the first
  double begin = 0, end = 0;                ///< [s] commanded
  /// [s] The longest time at one speed, without that in which the drives settle at it: neither run-in nor run-out. Empty
  /// where the circle is too short for them.
  double steady_begin = 0, steady_end = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();    ///< [mm]
  Eigen::Vector3d radial = Eigen::Vector3d::UnitX();   ///< unit, from the centre to the start
  Eigen::Vector3d lateral = Eigen::Vector3d::UnitY();  ///< unit, the way it turns at the start
  Eigen::Vector3d first_point = Eigen::Vector3d::Zero(), last_point = Eigen::Vector3d::Zero();  ///< [mm]
  double start_radius = 0, end_radius = 0;  ///< [mm], going linearly with the angle
  double sweep = 0;                         ///< [rad] > 0
  std::array<int, 2> axes = {0, 1};         ///< that span the plane best: shown to the right and upwards
};

/// The circle that a block of the planned path belongs to; nothing where it is no arc.
std::optional<Circle> circle_at(const Outcome& outcome, std::size_t block);
/// A block of the longest circle, or part of one, of the program; nothing where there is no arc.
/// Consecutive arcs about one centre are one.
std::optional<std::size_t> longest_arc(const Outcome& outcome);
/// A block of the next circle (direction +1) or the one before (−1), seen from a time [s].
std::optional<std::size_t> next_circle(const Outcome& outcome, double time, int direction);

struct Roundness {
  struct Point {
    double time;   ///< [s]
    double angle;  ///< [rad] in the plane of Circle::axes
    double error;  ///< distance from the centre minus the commanded radius there [mm]
  };
  Circle circle;
  std::vector<Point> points;        ///< one a setpoint
  std::size_t first = 0, last = 0;  ///< those that are judged, [first, last): in the steady time, or all
  bool is_steady = false;           ///< whether run-in and run-out are left out
  std::size_t highest = 0, lowest = 0;
  double mean = 0;  ///< of the errors [mm]; below 0 where the drives cut the circle smaller

  bool is_empty() const { return points.empty(); }
  double most() const { return is_empty() ? 0.0 : points[highest].error; }
  double least() const { return is_empty() ? 0.0 : points[lowest].error; }
  /// Circular deviation: largest minus smallest radial error [mm]. @source ISO 230-4
  double deviation() const { return most() - least(); }
};

/// Measures the actual path from where it passes the circle's first point to where it passes the last one; being late by
/// the lag of the drives is no error.
Roundness measure_roundness(const ErrorTrace& trace, const Circle& circle);

}  // namespace toolpace::ui
