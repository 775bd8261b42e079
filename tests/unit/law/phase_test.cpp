#include "toolpace/law/phase.h"

#include <gtest/gtest.h>

#include <cmath>

namespace toolpace {
namespace {

// v = 4 − 6t + 3t²/2·2: speed 4, acceleration −6, jerk 6 turns at t = 1 with v = 4 − 6 + 3 = 1.
TEST(PhaseExtrema, SpeedThatTurnsInsideThePhaseIsFound) {
  const PhaseExtrema e = extrema({0, 3, 0, 4, -6, 6, PhaseShape::constant_jerk});
  EXPECT_DOUBLE_EQ(e.min_speed, 1.0);
  EXPECT_DOUBLE_EQ(e.max_speed, 13.0);  // at t = 3: 4 − 18 + 27
  EXPECT_DOUBLE_EQ(e.max_acceleration, 12.0);
  EXPECT_DOUBLE_EQ(e.max_deceleration, 6.0);
  EXPECT_DOUBLE_EQ(e.max_jerk, 6.0);
}

TEST(PhaseExtrema, CruiseHasNeitherAccelerationNorJerk) {
  const PhaseExtrema e = extrema({0, 3, 0, 4, 0, 0, PhaseShape::constant_jerk});
  EXPECT_EQ(e.min_speed, 4.0);
  EXPECT_EQ(e.max_speed, 4.0);
  EXPECT_EQ(e.max_acceleration + e.max_deceleration + e.max_jerk, 0.0);
}

// 15/8·Δ/T and 10/√3·Δ/T² with Δ = −8, T = 2, compared with the densely evaluated polynomial.
TEST(PhaseExtrema, QuinticPeaksAreThoseOfThePolynomial) {
  const Phase p{0, 2, 0, 10, 0, -8, PhaseShape::quintic};
  const PhaseExtrema e = extrema(p);
  double deceleration = 0, jerk = 0;
  for (int i = 0; i <= 200000; ++i) {
    const PhaseState s = evaluate(p, 2.0 * i / 200000);
    deceleration = std::max(deceleration, -s.acceleration);
    jerk = std::max(jerk, std::abs(s.jerk));
  }
  EXPECT_NEAR(e.max_deceleration, deceleration, 1e-9);
  EXPECT_NEAR(e.max_jerk, jerk, 1e-8);
  EXPECT_EQ(e.max_acceleration, 0.0);
  EXPECT_EQ(e.min_speed, 2.0);
  EXPECT_EQ(e.max_speed, 10.0);
}

TEST(Evaluate, StateIsTheDerivativeOfDistance) {
  for (const Phase& p :
       {Phase{0, 2, 1, 10, 0, -8, PhaseShape::quintic}, Phase{0, 2, 1, 10, 3, -2, PhaseShape::constant_jerk}}) {
    const double h = 1e-5;
    for (const double t : {0.3, 1.0, 1.7}) {
      const PhaseState s = evaluate(p, t), before = evaluate(p, t - h), after = evaluate(p, t + h);
      EXPECT_NEAR(s.speed, (after.distance - before.distance) / (2 * h), 1e-8);
      EXPECT_NEAR(s.acceleration, (after.speed - before.speed) / (2 * h), 1e-8);
      EXPECT_NEAR(s.jerk, (after.acceleration - before.acceleration) / (2 * h), 1e-8);
    }
  }
}

}  // namespace
}  // namespace toolpace
