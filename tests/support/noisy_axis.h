#pragma once
/// An axis that is driven hither and thither, and what a noisy scope shows of it: for round trips of identification.

#include <algorithm>
#include <cmath>
#include <random>

#include "toolpace/servo/axis_servo.h"
#include "toolpace/servo/identify_axis.h"

namespace toolpace::test {

/// Moves of seven-phase ramps with 10 ms of jerk between random places, some with a rest behind, at 1 kHz.
inline std::vector<double> random_moves(std::mt19937_64& random, std::size_t rows) {
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<double> way = {0.0};
  double speed = 0, acceleration = 0, wanted = 0;
  std::size_t change = 0;
  while (way.size() < rows) {
    if (way.size() >= change) {
      wanted = share(random) < 0.25 ? 0.0 : (share(random) < 0.5 ? -1 : 1) * (20 + 80 * share(random));
      change = way.size() + 60 + static_cast<std::size_t>(300 * share(random));
    }
    // To the wanted speed with at most 4000 mm/s² and 4e5 mm/s³.
    const double reach = acceleration * std::abs(acceleration) / (2 * 4e5);
    const double ahead = wanted - speed - reach;
    const double aim = std::abs(ahead) < 0.4 ? -acceleration * 0.5 : (ahead > 0 ? 4000.0 : -4000.0) - acceleration;
    acceleration += std::clamp(aim, -400.0, 400.0);
    speed += acceleration * 1e-3;
    way.push_back(way.back() + speed * 1e-3);
  }
  return way;
}

/// Values other than the defaults.
inline ServoAxis random_drive(std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0, 1);
  ServoAxis axis;
  axis.position_gain = 25 + 60 * share(random);
  axis.velocity_feed_forward = 0.2 + 0.6 * share(random);
  axis.acceleration_feed_forward = 0.1 + 0.6 * share(random);
  axis.bandwidth = 50 + 60 * share(random);
  axis.damping = 0.6 + 0.4 * share(random);
  axis.backlash = 0.004 + 0.02 * share(random);
  axis.resonance = 18 + 40 * share(random);
  axis.resonance_damping = 0.02 + 0.06 * share(random);
  return axis;
}

inline IdentificationData noisy_axis(const ServoAxis& axis, std::mt19937_64& random, std::size_t rows, double noise) {
  std::normal_distribution<double> normal(0, noise);
  IdentificationData data;
  data.commanded = random_moves(random, rows);
  auto servo = AxisServo::create(axis, data.period).value();
  servo.reset(0);
  double before = 0, from = 0;
  for (std::size_t k = 0; k < rows; ++k) {
    data.time.push_back(static_cast<double>(k) * data.period);
    data.actual.push_back(servo.step(before, from, data.commanded[k]) + normal(random));
    before = from;
    from = data.commanded[k];
  }
  return data;
}

}  // namespace toolpace::test
