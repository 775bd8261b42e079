/// Random single moves under every law: what must hold for each of them.

#include <gtest/gtest.h>
// gtest first
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "case_count.h"
#include "every_law.h"
#include "toolpace/law/single_move.h"

namespace toolpace {
namespace {

/// The seed and the number of cases, before RapidCheck reads them: 10⁵ usually, more where soaking.
[[maybe_unused]] const bool kConfigured = [] {
  const std::string text = "seed=20140301 max_success=" + std::to_string(test::case_count(40'000));
  return ::setenv("RC_PARAMS", text.c_str(), 1) == 0;
}();

struct RandomMove {
  LawKind law;
  MoveRequest move;
  Dynamics dynamics;
};

std::ostream& operator<<(std::ostream& out, const RampLimits& l) {
  return out << "{" << l.acceleration << ", " << l.jerk << ", " << l.time << "}";
}

std::ostream& operator<<(std::ostream& out, const RandomMove& m) {
  out.precision(17);
  return out << law_row(m.law).id << " {" << m.move.length << ", " << m.move.feed << ", " << m.move.start << ", "
             << m.move.end << "}, {" << m.dynamics.up << ", " << m.dynamics.down << "}";
}

/// The number's place on a logarithmic scale, from 32 random bits.
double spread(std::uint32_t bits, double low, double high) {
  return low * std::pow(high / low, static_cast<double>(bits) / 4294967295.0);
}

/// Lengths 1e-6 … 1e6, speeds 1e-6 … 1e5, A 1e-3 … 1e6, J 1e-2 … 1e9; end speeds are 0, the feed, each other, or any part
/// of the feed, also parts that are hardly apart.
RandomMove make_random(LawKind law, const std::array<std::uint32_t, 10>& bits) {
  RandomMove m{law, {}, {}};
  m.move.length = spread(bits[0], 1e-6, 1e6);
  m.move.feed = spread(bits[1], 1e-6, 1e5);
  const auto end_speed = [&](std::uint32_t b) {
    const double part = static_cast<double>(b >> 3) / 536870911.0;
    switch (b & 7u) {
      case 0: return 0.0;
      case 1: return m.move.feed;
      case 2: return m.move.feed * part * 1e-6;
      default: return m.move.feed * part;
    }
  };
  m.move.start = end_speed(bits[2]);
  m.move.end = (bits[9] & 3u) == 0   ? m.move.start
               : (bits[9] & 3u) == 1 ? m.move.start * (1 - 1e-9 * static_cast<double>(bits[3] & 255u))
                                     : end_speed(bits[3]);
  m.dynamics.up = {spread(bits[4], 1e-3, 1e6), spread(bits[5], 1e-2, 1e9), 0.0};
  m.dynamics.down = {spread(bits[6], 1e-3, 1e6), spread(bits[7], 1e-2, 1e9), 0.0};
  if (law_row(law).uses_time) {
    m.dynamics.up.time = spread(bits[8], 1e-4, 1e2);
    m.dynamics.down.time = spread(bits[9], 1e-4, 1e2);
  }
  return m;
}

rc::Gen<RandomMove> random_move(LawKind law) {
  return rc::gen::map(rc::gen::container<std::array<std::uint32_t, 10>>(
                          rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint32_t>())),
                      [law](const auto& bits) { return make_random(law, bits); });
}

bool is_near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

double ramp_duration(const RandomMove& m, double dv, const RampLimits& limits) {
  return law_row(m.law).duration(dv, limits);
}

double length_with_peak(const RandomMove& m, double v) {
  return (m.move.start + v) / 2 * ramp_duration(m, v - m.move.start, m.dynamics.up) +
         (v + m.move.end) / 2 * ramp_duration(m, v - m.move.end, m.dynamics.down);
}

/// Ends, distance, limits, monotone ramps, continuity.
void check_phases(const RandomMove& m, const SingleMove& result) {
  const double top = m.move.feed;
  const LawRow& law = law_row(m.law);
  RC_ASSERT(is_near(result.phases.front().speed, m.move.start, 1e-14 * top) || result.up.time == 0);
  const double steepest = std::max(m.dynamics.up.acceleration, m.dynamics.down.acceleration);
  PhaseState before{0.0, m.move.start, 0.0, 0.0};
  double clock = 0.0;
  for (const Phase& p : result.phases) {
    const PhaseState first = evaluate(p, 0.0), last = evaluate(p, p.duration);
    RC_ASSERT(p.duration > 0 && p.begin == clock);
    RC_ASSERT(p.distance == before.distance);
    RC_ASSERT(is_near(first.speed, before.speed, 1e-13 * top));
    if (law.bounds_jerk) RC_ASSERT(is_near(first.acceleration, before.acceleration, 1e-11 * steepest));
    const PhaseExtrema e = extrema(p);
    RC_ASSERT(e.max_acceleration <= m.dynamics.up.acceleration * (1 + 1e-12));
    RC_ASSERT(e.max_deceleration <= m.dynamics.down.acceleration * (1 + 1e-12));
    if (law.bounds_jerk) RC_ASSERT(e.max_jerk <= std::max(m.dynamics.up.jerk, m.dynamics.down.jerk) * (1 + 1e-12));
    RC_ASSERT(std::min(e.max_acceleration, e.max_deceleration) <= 1e-14 * steepest);
    RC_ASSERT(e.max_speed <= top * (1 + 1e-14) && e.min_speed >= -1e-14 * top);
    before = last;
    clock = p.begin + p.duration;
  }
  RC_ASSERT(is_near(before.speed, m.move.end, 1e-13 * top));
  RC_ASSERT(is_near(before.distance, m.move.length, 1e-12 * m.move.length));
  if (law.bounds_jerk) RC_ASSERT(is_near(before.acceleration, 0.0, 1e-11 * steepest));
}

void check_numbers(const SingleMove& r) {
  for (const double value : {r.peak, r.cruise_time, r.up.length, r.up.time, r.down.length, r.down.time,
                             r.up.peak_acceleration, r.down.peak_acceleration}) {
    RC_ASSERT(std::isfinite(value) && value >= 0);
  }
}

class MoveProperties : public ::testing::TestWithParam<LawKind> {};

TEST_P(MoveProperties, AMoveIsExactAndInsideItsLimitsOrSaysWhatWouldBe) {
  const bool held = rc::check([law = GetParam()] {
    const RandomMove m = *random_move(law);
    const auto result = single_move(law, m.move, m.dynamics);
    if (result) {
      check_numbers(*result);
      check_phases(m, *result);
      return;
    }
    RC_ASSERT(result.error().kind == ErrorKind::infeasible);
    RC_ASSERT(length_with_peak(m, std::max(m.move.start, m.move.end)) > m.move.length);
    RandomMove advised = m;
    advised.move.end = result.error().attainable.value();
    RC_ASSERT(single_move(law, advised.move, m.dynamics).has_value());
  });
  EXPECT_TRUE(held);
}

TEST_P(MoveProperties, NoHigherPeakFits) {
  const bool held = rc::check([law = GetParam()] {
    const RandomMove m = *random_move(law);
    const auto result = single_move(law, m.move, m.dynamics);
    if (!result || result->reaches_feed) return;
    RC_ASSERT(length_with_peak(m, result->peak * (1 + 1e-11)) > m.move.length);
    const double least = std::max(m.move.start, m.move.end);
    RC_ASSERT(result->peak >= least);
  });
  EXPECT_TRUE(held);
}

TEST_P(MoveProperties, TimeReversalSwapsTheRamps) {
  const bool held = rc::check([law = GetParam()] {
    const RandomMove m = *random_move(law);
    const auto forward = single_move(law, m.move, m.dynamics);
    const auto backward =
        single_move(law, {m.move.length, m.move.feed, m.move.end, m.move.start}, {m.dynamics.down, m.dynamics.up});
    if (!forward || !backward) {
      // A downward ramp is feasible or not exactly as the upward one of the reversed move.
      RC_ASSERT(forward.has_value() == backward.has_value());
      return;
    }
    RC_ASSERT(is_near(forward->peak, backward->peak, 1e-14 * forward->peak));
    RC_ASSERT(is_near(forward->up.time + forward->down.time + forward->cruise_time, backward->total_time(),
                      1e-7 * forward->total_time()));
  });
  EXPECT_TRUE(held);
}

/// Far beyond any machine: every number anywhere in the range that is accepted at all.
TEST_P(MoveProperties, NumbersOfAnySizeGiveAMoveOrAnError) {
  const bool held = rc::check([law = GetParam()] {
    const auto bits = *rc::gen::container<std::array<std::uint32_t, 10>>(
        rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint32_t>()));
    const auto any = [&](std::size_t i) { return spread(bits[i], 1e-30, 1e30); };
    const MoveRequest move{any(0), any(1), std::min(any(2), any(1)), std::min(any(3), any(1))};
    const auto result = single_move(law, move, {{any(4), any(5), any(6)}, {any(7), any(8), any(9)}});
    if (!result) {
      RC_ASSERT(result.error().kind == ErrorKind::infeasible);
      RC_ASSERT(result.error().attainable.value() >= 0 && std::isfinite(*result.error().attainable));
      return;
    }
    check_numbers(*result);
    RC_ASSERT(result->peak <= move.feed && result->peak >= std::max(move.start, move.end));
    const double length = result->up.length + result->cruise_time * result->peak + result->down.length;
    RC_ASSERT(is_near(length, move.length, 1e-12 * move.length));
  });
  EXPECT_TRUE(held);
}

/// Lengths times s, times times t: speeds s/t, accelerations s/t², jerks s/t³.
TEST_P(MoveProperties, AChangeOfUnitsChangesNothing) {
  const bool held = rc::check([law = GetParam()] {
    const RandomMove m = *random_move(law);
    const double s = spread(*rc::gen::arbitrary<std::uint32_t>(), 1e-3, 1e3);
    const double t = spread(*rc::gen::arbitrary<std::uint32_t>(), 1e-3, 1e3);
    const auto scale = [&](const RampLimits& l) {
      return RampLimits{l.acceleration * s / t / t, l.jerk * s / t / t / t, l.time * t};
    };
    const MoveRequest scaled{m.move.length * s, m.move.feed * (s / t), m.move.start * (s / t), m.move.end * (s / t)};
    const auto one = single_move(law, m.move, m.dynamics);
    const auto other = single_move(law, scaled, {scale(m.dynamics.up), scale(m.dynamics.down)});
    if (!one || !other) {
      const double needed = length_with_peak(m, std::max(m.move.start, m.move.end));
      RC_ASSERT(one.has_value() == other.has_value() || is_near(needed, m.move.length, 1e-6 * needed));
      return;
    }
    // Only just feasible beside only just the feed: the peak may differ by the rounding of the speeds.
    RC_ASSERT(is_near(other->peak, one->peak * (s / t), 1e-12 * other->peak));
  });
  EXPECT_TRUE(held);
}

TEST_P(MoveProperties, ReachInvertsTheLengthOfARamp) {
  const bool held = rc::check([law = GetParam()] {
    const RandomMove m = *random_move(law);
    const double v0 = std::min(m.move.start, m.move.end), v1 = std::max(m.move.start, m.move.end);
    const double length = (v0 + v1) / 2 * ramp_duration(m, v1 - v0, m.dynamics.up);
    RC_ASSERT(is_near(law_row(law).reach(v0, length, m.dynamics.up), v1, 1e-12 * v1) || v0 == v1);
    const double reached = law_row(law).reach(v0, m.move.length, m.dynamics.up);
    RC_ASSERT(reached >= v0 && !std::isnan(reached));
  });
  EXPECT_TRUE(held);
}

INSTANTIATE_TEST_SUITE_P(Laws, MoveProperties, ::testing::ValuesIn(test::every_law()), test::law_name);

}  // namespace
}  // namespace toolpace
