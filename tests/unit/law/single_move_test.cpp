#include "toolpace/law/single_move.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "every_law.h"

namespace toolpace {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

Dynamics by_time(double acc, double dec) { return {{kInf, kInf, acc}, {kInf, kInf, dec}}; }

const MoveRequest kZheng{4000, 100, 10, 20};

// Zheng, table 2, move 1: J1 = 4·90/35², J3 = 4·80/20², Sa = (10+100)/2·35, Sb = (100+20)/2·20,
// cruise (4000 − 1925 − 1200)/100.
TEST(ZhengTable2, FirstMoveReachesItsFeed) {
  const auto move = single_move(LawKind::five_phase_time, kZheng, by_time(35, 20));
  ASSERT_TRUE(move);
  EXPECT_TRUE(move->reaches_feed);
  EXPECT_EQ(move->peak, 100.0);
  EXPECT_NEAR(move->up.length, 1925, 1e-9);
  EXPECT_NEAR(move->down.length, 1200, 1e-9);
  EXPECT_NEAR(move->cruise_time, 8.75, 1e-12);
  EXPECT_NEAR(move->total_time(), 63.75, 1e-12);
  EXPECT_NEAR(move->up.peak_jerk, 0.293878, 5e-7);
  EXPECT_NEAR(move->down.peak_jerk, 0.800000, 5e-7);
  EXPECT_NEAR(move->up.peak_acceleration, 5.142857, 5e-7);
  EXPECT_NEAR(move->down.peak_acceleration, 8.000000, 5e-7);
}

// fmax = (2·4000 − 10·45 − 20·30)/75 = 92.6667, not the 91.1893 that the paper prints.
TEST(ZhengTable2, SecondMoveDoesNotReachItsFeed) {
  const auto move = single_move(LawKind::five_phase_time, kZheng, by_time(45, 30));
  ASSERT_TRUE(move);
  EXPECT_FALSE(move->reaches_feed);
  EXPECT_NEAR(move->peak, 92.666667, 5e-7);
  EXPECT_NEAR(move->up.length, 2310, 1e-9);
  EXPECT_NEAR(move->down.length, 1690, 1e-9);
  EXPECT_EQ(move->cruise_time, 0.0);
  EXPECT_NEAR(move->total_time(), 75, 1e-12);
  EXPECT_NEAR(move->up.peak_jerk, 0.163292, 5e-7);
  EXPECT_NEAR(move->down.peak_jerk, 0.322963, 5e-7);
  EXPECT_NEAR(move->up.peak_acceleration, 3.674074, 5e-7);
  EXPECT_NEAR(move->down.peak_acceleration, 4.844444, 5e-7);
}

// L = 700 between (10+20)/2·45 = 675, which the one ramp needs, and 675 + 20·30 = 1275, which a ramp down would add.
// A literal fmax is (1400 − 450 − 600)/75 = 4.67, below both ends.
TEST(FivePhaseTimeGap, OneRampThenCruiseAtTheHigherSpeed) {
  const auto move = single_move(LawKind::five_phase_time, {700, 100, 10, 20}, by_time(45, 30));
  ASSERT_TRUE(move);
  EXPECT_EQ(move->peak, 20.0);
  EXPECT_FALSE(move->reaches_feed);
  EXPECT_NEAR(move->up.length, 675, 1e-12);
  EXPECT_EQ(move->down.time, 0.0);
  EXPECT_NEAR(move->cruise_time, 25.0 / 20, 1e-12);
  for (const Phase& phase : move->phases) EXPECT_GE(evaluate(phase, phase.duration / 2).acceleration, 0.0);
}

TEST(FivePhaseTimeGap, SlowingDownCruisesFirst) {
  // (20+10)/2·30 = 450 fits into 500, going above 20 would need 20·45 more.
  const auto move = single_move(LawKind::five_phase_time, {500, 100, 20, 10}, by_time(45, 30));
  ASSERT_TRUE(move);
  EXPECT_EQ(move->peak, 20.0);
  EXPECT_EQ(move->up.time, 0.0);
  EXPECT_NEAR(move->cruise_time, 50.0 / 20, 1e-12);
  EXPECT_EQ(move->phases.front().rate, 0.0);
}

TEST(FivePhaseTimeGap, TooShortForTheOneRampIsAnErrorThatSaysWhatWouldDo) {
  const auto move = single_move(LawKind::five_phase_time, {600, 100, 10, 20}, by_time(45, 30));
  ASSERT_FALSE(move);
  EXPECT_EQ(move.error().kind, ErrorKind::infeasible);
  EXPECT_EQ(move.error().code, "exit-unreachable");
  EXPECT_NE(move.error().remedy.find("675"), std::string::npos) << move.error().remedy;
  // 2·600/45 − 10 = 16.67
  ASSERT_TRUE(move.error().attainable);
  EXPECT_NEAR(*move.error().attainable, 1200.0 / 45 - 10, 1e-9);
}

// A = 10, J = ∞ up; D = 40 down: v²/20 + v²/80 = 100 gives v = 40.
// Both ramps last √(κ·v/J), κ = 10/√3, and cover v·√(κ·v/J) together, so v = ∛(L²·J/κ) = 0.0565…
TEST(Quintic, AMoveTooShortForItsFeedIsMadeWhereJerkAloneIsLimited) {
  const RampLimits jerk_alone{kInf, 1e6, 0};
  const auto move = single_move(LawKind::quintic, {3.23e-5, 50, 0, 0}, {jerk_alone, jerk_alone});
  ASSERT_TRUE(move);
  EXPECT_NEAR(move->peak, std::cbrt(3.23e-5 * 3.23e-5 * 1e6 * std::sqrt(3.0) / 10), 1e-12);
  EXPECT_NEAR(evaluate(move->phases.back(), move->phases.back().duration).distance, 3.23e-5, 1e-18);
}

TEST(Trapezoid, PeakWithDifferentRamps) {
  const auto move = single_move(LawKind::trapezoid, {100, 1000, 0, 0}, {{10, kInf, 0}, {40, kInf, 0}});
  ASSERT_TRUE(move);
  EXPECT_NEAR(move->peak, 40, 1e-12);
  EXPECT_NEAR(move->up.length, 80, 1e-12);
  EXPECT_EQ(move->up.peak_jerk, kInf);
}

// Up: A = 10, J = 5 needs Δ ≥ 20 for constant acceleration; down: D = 100, J = 5 would need 2000. F = 50 is reached:
// up 50/10 + 2 = 7 s and 175 mm, three phases; down 2·√10 s, two phases.
TEST(SevenPhase, ConstantAccelerationMayVanishOnOneSideOnly) {
  const auto move = single_move(LawKind::seven_phase, {1000, 50, 0, 0}, {{10, 5, 0}, {100, 5, 0}});
  ASSERT_TRUE(move);
  EXPECT_TRUE(move->reaches_feed);
  EXPECT_EQ(move->phases.size(), 6u);
  EXPECT_NEAR(move->up.time, 7, 1e-12);
  EXPECT_NEAR(move->up.length, 175, 1e-9);
  EXPECT_NEAR(move->down.time, 2 * std::sqrt(10.0), 1e-12);
  EXPECT_NEAR(move->down.peak_acceleration, std::sqrt(250.0), 1e-12);
}

// The textbook move: a = 10, J = 5, v = 50, s = 1000 from rest to rest: t1 = 2, t2 = 3, t4 = (1000 − 350)/50 = 13.
TEST(SevenPhase, TextbookMoveHasSevenPhases) {
  const auto move = single_move(LawKind::seven_phase, {1000, 50, 0, 0}, {{10, 5, 0}, {10, 5, 0}});
  ASSERT_TRUE(move);
  const double expected[] = {2, 3, 2, 13, 2, 3, 2};
  ASSERT_EQ(move->phases.size(), 7u);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(move->phases[i].duration, expected[i], 1e-12) << i;
}

// J = 3e4: 3.61 → 0 takes 1.805·2·√(3.61/J) = 0.0396 mm, 3.61 → 0.5 takes 2.055·2·√(3.11/J) = 0.0418 mm. Within
// 0.04 mm the nearest reachable exit speed lies below the one asked for: (3.61+v)·√((3.61−v)/J) = 0.04 at v = 0.0748.
TEST(SevenPhase, ASlowerExitMayBeReachableWhereAFasterOneIsNot) {
  const Dynamics dynamics{{3000, 3e4, 0}, {3000, 3e4, 0}};
  EXPECT_TRUE(single_move(LawKind::seven_phase, {0.04, 100, 3.61, 0}, dynamics));
  const auto move = single_move(LawKind::seven_phase, {0.04, 100, 3.61, 0.5}, dynamics);
  ASSERT_FALSE(move);
  const double v = move.error().attainable.value();
  EXPECT_LT(v, 0.5);
  EXPECT_NEAR((3.61 + v) * std::sqrt((3.61 - v) / 3e4), 0.04, 1e-12);
}

struct Case {
  const char* name;
  MoveRequest move;
};

/// The cases that every law must get right.
const Case kCases[] = {
    {"cruise reached", {500, 100, 0, 0}},
    {"cruise not reached", {1, 100, 0, 0}},
    {"equal ends", {20, 100, 30, 30}},
    {"rising", {20, 100, 10, 60}},
    {"falling", {20, 100, 60, 10}},
    {"from rest", {20, 100, 0, 40}},
    {"to rest", {20, 100, 40, 0}},
    {"nearly equal ends", {0.5, 100, 1, 1.0000001}},
    {"start at feed", {60, 100, 100, 5}},
    {"end at feed", {60, 100, 5, 100}},
    {"both at feed", {3, 100, 100, 100}},
    {"no length", {0, 100, 40, 40}},
    {"no length at rest", {0, 100, 0, 0}},
    {"a hair of length", {1e-6, 100, 0, 0}},
    {"a hair at speed", {1e-9, 100, 50, 50}},
    {"very long", {1e9, 100, 0, 0}},
    {"high end speeds", {3, 1e4, 99, 99}},
};

class EveryLaw : public ::testing::TestWithParam<LawKind> {
 protected:
  const Dynamics dynamics_{{3000, 1e6, 0.05}, {2000, 4e5, 0.03}};

  Dynamics dynamics() const {  // each law as `move` runs it
    if (!law_row(GetParam()).uses_time) return dynamics_;
    return by_time(dynamics_.up.time, dynamics_.down.time);
  }
  double duration(double dv, const RampLimits& limits) const { return law_row(GetParam()).duration(dv, limits); }
  double length(const MoveRequest& m, double v) const {
    return (m.start + v) / 2 * duration(v - m.start, dynamics().up) +
           (v + m.end) / 2 * duration(v - m.end, dynamics().down);
  }
  /// The peak by bisection on the definition.
  double peak_by_bisection(const MoveRequest& m) const {
    if (length(m, m.feed) <= m.length) return m.feed;
    double low = std::max(m.start, m.end), high = m.feed;
    for (int i = 0; i < 200; ++i) {
      const double middle = (low + high) / 2;
      (length(m, middle) <= m.length ? low : high) = middle;
    }
    return low;
  }
};

TEST_P(EveryLaw, FindsTheHighestPeakAndTheExactDistanceInEveryCase) {
  for (const Case& c : kCases) {
    const auto move = single_move(GetParam(), c.move, dynamics());
    ASSERT_TRUE(move) << c.name << ": " << move.error().message;
    EXPECT_NEAR(move->peak, peak_by_bisection(c.move), 1e-12 * c.move.feed) << c.name;
    EXPECT_EQ(move->reaches_feed, move->peak == c.move.feed) << c.name;
    if (move->phases.empty()) {
      EXPECT_EQ(c.move.length, 0.0) << c.name;
      continue;
    }
    const Phase& last = move->phases.back();
    const PhaseState end = evaluate(last, last.duration);
    EXPECT_EQ(move->phases.front().speed, c.move.start) << c.name;
    EXPECT_NEAR(end.speed, c.move.end, 1e-14 * c.move.feed) << c.name;
    EXPECT_NEAR(end.distance, c.move.length, 1e-12 * c.move.length) << c.name;
    EXPECT_NEAR(last.begin + last.duration, move->total_time(), 1e-13 * move->total_time()) << c.name;
    EXPECT_GE(move->cruise_time, 0.0) << c.name;
  }
}

TEST_P(EveryLaw, ThePeakAloneIsThatOfTheMove) {
  for (const Case& c : kCases) {
    const auto move = single_move(GetParam(), c.move, dynamics());
    const double peak = visit_law(GetParam(), [&](auto law) {
      return peak_speed<decltype(law)>(c.move.start, c.move.end, c.move.feed, c.move.length, dynamics());
    });
    EXPECT_NEAR(peak, move->peak, 1e-14 * c.move.feed) << c.name;
  }
}

TEST_P(EveryLaw, ExactlyOneRampWhereTheLengthIsItsOwn) {
  for (const auto& [start, end] : {std::pair{10.0, 60.0}, std::pair{60.0, 10.0}, std::pair{0.0, 35.0}}) {
    MoveRequest move{0, 100, start, end};
    move.length = length(move, std::max(start, end));
    const auto result = single_move(GetParam(), move, dynamics());
    ASSERT_TRUE(result);
    EXPECT_NEAR(result->peak, std::max(start, end), 1e-12 * 60);
    EXPECT_EQ(result->cruise_time, 0.0);
  }
}

TEST_P(EveryLaw, TimeReversalSwapsTheRamps) {
  const Dynamics forward = dynamics(), backward{forward.down, forward.up};
  for (const Case& c : kCases) {
    const MoveRequest reversed{c.move.length, c.move.feed, c.move.end, c.move.start};
    const auto one = single_move(GetParam(), c.move, forward), other = single_move(GetParam(), reversed, backward);
    ASSERT_TRUE(one && other) << c.name;
    EXPECT_NEAR(one->peak, other->peak, 1e-14 * one->peak) << c.name;
    EXPECT_NEAR(one->up.time, other->down.time, 1e-9 * one->up.time) << c.name;
    EXPECT_NEAR(one->total_time(), other->total_time(), 1e-13 * one->total_time()) << c.name;
  }
}

TEST_P(EveryLaw, SpeedsAboveTheFeedAreAUsageError) {
  for (const MoveRequest& move : {MoveRequest{10, 50, 60, 0}, MoveRequest{10, 50, 0, 60}}) {
    const auto result = single_move(GetParam(), move, dynamics());
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::usage);
    EXPECT_EQ(result.error().code, "speed-above-feed");
  }
}

TEST_P(EveryLaw, AnUnreachableExitSpeedIsAnErrorWhoseAdviceWorks) {
  for (const MoveRequest& move :
       {MoveRequest{0.2, 100, 50, 100}, MoveRequest{0.3, 100, 80, 10}, MoveRequest{0, 100, 5, 6},
        MoveRequest{0.002, 100, 3.61, 0.5}, MoveRequest{1e-5, 100, 50, 50.001}}) {
    const auto result = single_move(GetParam(), move, dynamics());
    ASSERT_FALSE(result) << move.start << " to " << move.end;
    EXPECT_EQ(result.error().kind, ErrorKind::infeasible);
    ASSERT_TRUE(result.error().attainable);
    MoveRequest advised = move;
    advised.end = *result.error().attainable;
    EXPECT_GE(advised.end, 0.0);
    EXPECT_TRUE(single_move(GetParam(), advised, dynamics())) << move.start << " to " << advised.end;
    advised = move;
    const MoveRequest bounds{0, 100, move.start, move.end};
    advised.length = length(bounds, std::max(move.start, move.end));
    EXPECT_TRUE(single_move(GetParam(), advised, dynamics())) << move.start << " over " << advised.length;
  }
}

TEST_P(EveryLaw, NumbersThatMakeNoSenseAreUsageErrors) {
  const double nan = std::nan("");
  const MoveRequest good{100, 50, 0, 0};
  for (const double bad : {nan, -1.0, kInf, 1e200, 1e-200}) {
    for (int field = 0; field < 4; ++field) {
      MoveRequest move = good;
      (field == 0 ? move.length : field == 1 ? move.feed : field == 2 ? move.start : move.end) = bad;
      const auto result = single_move(GetParam(), move, dynamics());
      ASSERT_FALSE(result) << bad << " in field " << field;
      EXPECT_EQ(result.error().kind, ErrorKind::usage);
    }
  }
  for (const double bad : {nan, -1.0, 0.0, 1e-200}) {
    for (const Dynamics& d : {Dynamics{{bad, 1e6, 1}, {1, 1, 1}}, Dynamics{{1, bad, 1}, {1, 1, 1}},
                              Dynamics{{1, 1, 1}, {bad, 1, 1}}, Dynamics{{1, 1, 1}, {1, bad, 1}}}) {
      EXPECT_FALSE(single_move(GetParam(), good, d)) << bad;
    }
  }
  EXPECT_FALSE(single_move(GetParam(), {100, 0, 0, 0}, dynamics())) << "a feed of zero";
}

TEST_P(EveryLaw, UnboundedLimitsOnEitherSideWork) {
  const RampLimits bounded = dynamics().up, unbounded{kInf, kInf, 0.0};
  for (const Dynamics& d :
       {Dynamics{bounded, unbounded}, Dynamics{unbounded, bounded}, Dynamics{unbounded, unbounded}}) {
    for (const MoveRequest& move :
         {MoveRequest{5, 100, 0, 0}, MoveRequest{500, 100, 20, 30}, MoveRequest{50, 100, 30, 20}}) {
      const auto result = single_move(GetParam(), move, d);
      ASSERT_TRUE(result);
      EXPECT_TRUE(std::isfinite(result->total_time()));
      EXPECT_GT(result->total_time(), 0.0);
      const Phase& last = result->phases.back();
      EXPECT_NEAR(evaluate(last, last.duration).distance, move.length, 1e-12 * move.length);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Moves, EveryLaw, ::testing::ValuesIn(test::every_law()), test::law_name);

}  // namespace
}  // namespace toolpace
