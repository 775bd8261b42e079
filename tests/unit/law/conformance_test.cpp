/// The suite that every row of the law table passes.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "every_law.h"
#include "law_cases.h"
#include "toolpace/law/law_table.h"

namespace toolpace {
namespace {

using testing::RampCase;

class LawConformance : public ::testing::TestWithParam<LawKind> {
 protected:
  const LawRow& law() const { return law_row(GetParam()); }

  std::vector<Phase> ramp(const RampCase& c) const {
    std::vector<Phase> phases;
    law().append_ramp(c.v0, c.v1, c.limits, phases);
    return phases;
  }
  double duration(const RampCase& c) const { return law().duration(std::abs(c.v1 - c.v0), c.limits); }
};

std::string text(const RampCase& c) {
  return "v0 " + std::to_string(c.v0) + " v1 " + std::to_string(c.v1) + " A " + std::to_string(c.limits.acceleration) +
         " J " + std::to_string(c.limits.jerk) + " T " + std::to_string(c.limits.time);
}

PhaseState end_state(const std::vector<Phase>& phases) { return evaluate(phases.back(), phases.back().duration); }

TEST_P(LawConformance, RampEndsAtTheSpeedAskedForWithoutAcceleration) {
  for (const RampCase& c : testing::ramp_cases()) {
    const auto phases = ramp(c);
    if (duration(c) == 0) {
      EXPECT_TRUE(phases.empty()) << text(c);
      continue;
    }
    ASSERT_FALSE(phases.empty()) << text(c);
    const double scale = std::max(c.v0, c.v1);
    EXPECT_EQ(phases.front().speed, c.v0) << text(c);
    EXPECT_NEAR(end_state(phases).speed, c.v1, 1e-14 * scale) << text(c);
    if (!law().bounds_jerk) continue;  // an unbounded jerk steps to zero acceleration after the ramp
    if (std::isinf(c.limits.jerk)) continue;
    EXPECT_EQ(phases.front().acceleration, 0.0) << text(c);
    EXPECT_NEAR(end_state(phases).acceleration, 0.0, 1e-12 * law().peak_acceleration(std::abs(c.v1 - c.v0), c.limits));
  }
}

TEST_P(LawConformance, RampIsMeanSpeedTimesDurationLong) {
  for (const RampCase& c : testing::ramp_cases()) {
    const auto phases = ramp(c);
    if (phases.empty()) continue;
    const double length = (c.v0 + c.v1) / 2 * duration(c);
    EXPECT_NEAR(end_state(phases).distance, length, 1e-12 * length) << text(c);
    EXPECT_NEAR(phases.back().begin + phases.back().duration, duration(c), 1e-14 * duration(c)) << text(c);
  }
}

TEST_P(LawConformance, RampKeepsItsLimitsAtTheExactExtrema) {
  for (const RampCase& c : testing::ramp_cases()) {
    const double dv = std::abs(c.v1 - c.v0);
    const double peak_acceleration = law().peak_acceleration(dv, c.limits);
    const double peak_jerk = law().peak_jerk(dv, c.limits);
    EXPECT_LE(peak_acceleration, c.limits.acceleration * (1 + 1e-14)) << text(c);
    EXPECT_TRUE(!law().bounds_jerk || peak_jerk <= c.limits.jerk * (1 + 1e-14)) << text(c);
    for (const Phase& phase : ramp(c)) {
      const PhaseExtrema e = extrema(phase);
      EXPECT_LE(std::max(e.max_acceleration, e.max_deceleration), peak_acceleration * (1 + 1e-12)) << text(c);
      EXPECT_LE(e.max_jerk, peak_jerk * (1 + 1e-12)) << text(c);
      // Monotone: nothing in the other direction beyond the rounding of a phase's end.
      EXPECT_LE(c.v1 > c.v0 ? e.max_deceleration : e.max_acceleration, 1e-15 * peak_acceleration) << text(c);
      EXPECT_GE(e.min_speed, std::min(c.v0, c.v1) - 1e-15 * std::max(c.v0, c.v1)) << text(c);
      EXPECT_LE(e.max_speed, std::max(c.v0, c.v1) * (1 + 1e-15)) << text(c);
    }
  }
}

TEST_P(LawConformance, PhasesMeetInTimeDistanceSpeedAndAcceleration) {
  for (const RampCase& c : testing::ramp_cases()) {
    const auto phases = ramp(c);
    for (std::size_t i = 1; i < phases.size(); ++i) {
      const PhaseState end = evaluate(phases[i - 1], phases[i - 1].duration);
      EXPECT_EQ(phases[i].begin, phases[i - 1].begin + phases[i - 1].duration) << text(c);
      EXPECT_EQ(phases[i].distance, end.distance) << text(c);
      EXPECT_NEAR(phases[i].speed, end.speed, 1e-14 * std::max(c.v0, c.v1)) << text(c);
      EXPECT_NEAR(phases[i].acceleration, end.acceleration, 1e-13 * c.limits.acceleration) << text(c);
    }
  }
}

TEST_P(LawConformance, RampIsSymmetricAboutItsMiddle) {
  for (const RampCase& c : testing::ramp_cases()) {
    const auto phases = ramp(c);
    const double time = duration(c);
    const auto speed_at = [&](double t) {
      std::size_t i = 0;
      while (i + 1 < phases.size() && t > phases[i + 1].begin) ++i;
      return evaluate(phases[i], t - phases[i].begin).speed;
    };
    if (phases.empty()) continue;
    for (const double u : {0.05, 0.2, 0.3, 0.45}) {
      EXPECT_NEAR(speed_at(u * time) + speed_at((1 - u) * time), c.v0 + c.v1, 1e-13 * std::max(c.v0, c.v1)) << text(c);
    }
  }
}

TEST_P(LawConformance, TheRampBackIsTheRampReversedInTime) {
  for (const RampCase& c : testing::ramp_cases()) {
    const auto forth = ramp(c), back = ramp({c.v1, c.v0, c.limits});
    ASSERT_EQ(forth.size(), back.size()) << text(c);
    const double steepest = law().peak_acceleration(std::abs(c.v1 - c.v0), c.limits);
    for (std::size_t i = 0; i < forth.size(); ++i) {
      const Phase &p = forth[i], &q = back[back.size() - 1 - i];
      EXPECT_NEAR(p.duration, q.duration, 1e-14 * p.duration) << text(c);
      for (const double u : {0.0, 0.3, 0.8}) {
        const PhaseState a = evaluate(p, u * p.duration), b = evaluate(q, (1 - u) * q.duration);
        EXPECT_NEAR(a.speed, b.speed, 1e-13 * std::max(c.v0, c.v1)) << text(c);
        EXPECT_NEAR(a.acceleration, -b.acceleration, 1e-13 * steepest) << text(c);
      }
    }
  }
}

/// Powers of two change no digit, so the scaled ramp is the same but for the rounding of roots.
TEST_P(LawConformance, UnitsOfLengthAndTimeDoNotMatter) {
  constexpr double kLength = 1024, kTime = 1.0 / 64;
  for (const RampCase& c : testing::ramp_cases()) {
    const double dv = std::abs(c.v1 - c.v0);
    const RampLimits scaled{c.limits.acceleration * kLength / kTime / kTime,
                            c.limits.jerk * kLength / kTime / kTime / kTime, c.limits.time * kTime};
    const double expected = law().duration(dv, c.limits) * kTime;
    EXPECT_NEAR(law().duration(dv * kLength / kTime, scaled), expected, 1e-15 * expected) << text(c);
    for (const double length : {1e-3, 7.0}) {
      const double reached = law().reach(c.v0, length, c.limits) * kLength / kTime;
      const double other = law().reach(c.v0 * kLength / kTime, length * kLength, scaled);
      EXPECT_TRUE(other == reached || std::abs(other - reached) <= 1e-14 * reached) << text(c);  // both may be infinite
    }
  }
}

TEST_P(LawConformance, ReachInvertsTheRampLength) {
  for (const RampCase& c : testing::ramp_cases()) {
    if (c.v1 < c.v0 || duration(c) == 0) continue;
    const double length = (c.v0 + c.v1) / 2 * duration(c);
    EXPECT_NEAR(law().reach(c.v0, length, c.limits), c.v1, 1e-13 * c.v1) << text(c);
  }
}

TEST_P(LawConformance, ReachIsNeverBelowTheSpeedItStartsFromAndNeverTooLong) {
  for (const RampCase& c : testing::ramp_cases()) {
    for (const double length : {0.0, 1e-6, 0.02, 3.0, 1e6}) {
      const double v = law().reach(c.v0, length, c.limits);
      EXPECT_GE(v, c.v0) << text(c) << " L " << length;
      if (std::isinf(v)) {
        EXPECT_EQ(law().duration(1.0, c.limits), 0.0) << text(c);
        continue;
      }
      // The speed is exact to a few ulp, and so a speed change to a few ulp of the speed.
      const double ulps = 4e-16 * v;
      const double change = std::max(v - c.v0 - ulps, 0.0);
      EXPECT_LE((c.v0 + v) / 2 * law().duration(change, c.limits), length * (1 + 1e-13)) << text(c) << " L " << length;
    }
  }
}

TEST_P(LawConformance, NothingTakesNoTimeAndUnboundedLimitsGiveSteps) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(law().duration(0.0, {3000, 1e6, 0.05}), 0.0);
  EXPECT_EQ(law().peak_acceleration(0.0, {3000, 1e6, 0.05}), 0.0);
  EXPECT_EQ(law().peak_jerk(0.0, {3000, 1e6, 0.05}), 0.0);
  EXPECT_EQ(law().duration(10.0, {kInf, kInf, 0.0}), 0.0);
  EXPECT_EQ(law().reach(10.0, 1.0, {kInf, kInf, 0.0}), kInf);
  std::vector<Phase> phases;
  law().append_ramp(10.0, 20.0, {kInf, kInf, 0.0}, phases);
  law().append_ramp(20.0, 20.0, {3000, 1e6, 0.05}, phases);
  EXPECT_TRUE(phases.empty());
}

TEST_P(LawConformance, RampsAppendWhereTheLastPhaseEnds) {
  std::vector<Phase> phases{{1.0, 2.0, 3.0, 10.0, 0.0, 0.0, PhaseShape::constant_jerk}};
  law().append_ramp(10.0, 20.0, {3000, 1e6, 0.05}, phases);
  ASSERT_GT(phases.size(), 1u);
  EXPECT_EQ(phases[1].begin, 3.0);
  EXPECT_EQ(phases[1].distance, 23.0);
}

INSTANTIATE_TEST_SUITE_P(All, LawConformance, ::testing::ValuesIn(test::every_law()), test::law_name);

}  // namespace
}  // namespace toolpace
