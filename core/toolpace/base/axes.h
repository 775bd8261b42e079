#pragma once
/// The axes of a machine and vectors over them.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace toolpace {

enum class Axis : std::uint8_t { x, y, z, a, b, c };

inline constexpr std::size_t kAxisCount = 6;
inline constexpr std::array<char, kAxisCount> kAxisNames = {'X', 'Y', 'Z', 'A', 'B', 'C'};
inline constexpr double kTwoPi = 2.0 * std::numbers::pi;
inline constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
inline constexpr double kPerMinute = 1.0 / 60.0;  ///< of a rate a minute to one a second

/// One value an axis: X Y Z in mm (mm/s, …), A B C in rad (rad/s, …). Not initialised: write AxisVector::Zero().
using AxisVector = Eigen::Matrix<double, static_cast<int>(kAxisCount), 1>;

/// Where the axes are and how they move: the first three derivatives by time.
struct AxisMotion {
  AxisVector position;      ///< [mm, rad]
  AxisVector speed;         ///< [mm/s, rad/s]
  AxisVector acceleration;  ///< [mm/s², rad/s²]
  AxisVector jerk;          ///< [mm/s³, rad/s³]
};

constexpr bool is_rotary(std::size_t axis) { return axis >= 3; }

}  // namespace toolpace
