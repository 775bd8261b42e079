/// Durations, reaches and peaks against the definitions in 50 digits, solved by bisection.

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "case_count.h"
#include "every_law.h"
#include "toolpace/law/single_move.h"

namespace toolpace {
namespace {

using Exact = boost::multiprecision::cpp_dec_float_50;

/// Duration and peaks of every law, written out once more.
Exact exact_duration(LawKind law, const Exact& dv, const RampLimits& limits) {
  const Exact a = limits.acceleration, j = limits.jerk, time = limits.time;
  if (dv <= 0) return 0;
  const auto larger = [](const Exact& x, const Exact& y) { return x > y ? x : y; };
  switch (law) {
    case LawKind::trapezoid: return dv / a;
    case LawKind::five_phase_time: return larger(time, larger(2 * dv / a, 2 * sqrt(Exact(dv / j))));
    case LawKind::five_phase_jerk: return larger(2 * dv / a, 2 * sqrt(Exact(dv / j)));
    case LawKind::seven_phase:
    case LawKind::time_optimal: return dv >= a * a / j ? Exact(dv / a + a / j) : Exact(2 * sqrt(Exact(dv / j)));
    case LawKind::quintic: break;
  }
  return larger(15 * dv / (8 * a), sqrt(Exact(10 * dv / (sqrt(Exact(3)) * j))));
}

/// Where an increasing function passes `wanted`; low ≤ root, high ≥ root.
Exact bisect(const std::function<Exact(const Exact&)>& f, const Exact& wanted, Exact low, Exact high) {
  for (int i = 0; i < 160; ++i) {
    const Exact middle = (low + high) / 2;
    (f(middle) <= wanted ? low : high) = middle;
  }
  return low;
}

class Numbers {
 public:
  double log(double low, double high) { return low * std::pow(high / low, part()); }
  double part() { return std::uniform_real_distribution<>(0, 1)(random_); }

 private:
  std::mt19937_64 random_{20141122};
};

double relative_error(double value, const Exact& exact) {
  return static_cast<double>(abs(Exact(value) - exact) / (exact > 0 ? exact : Exact(1)));
}

struct Sample {
  MoveRequest move;
  Dynamics dynamics;
};

/// All magnitudes that a machine may have, and ends that are at rest or hardly apart.
Sample draw(Numbers& numbers, LawKind law) {
  Sample s;
  s.move = {numbers.log(1e-6, 1e6), numbers.log(1e-6, 1e5), 0.0, 0.0};
  if (numbers.part() < 0.8) s.move.start = s.move.feed * numbers.part() * (numbers.part() < 0.2 ? 1e-6 : 1.0);
  if (numbers.part() < 0.8) s.move.end = s.move.feed * numbers.part();
  if (numbers.part() < 0.2) s.move.end = s.move.start;
  for (RampLimits* l : {&s.dynamics.up, &s.dynamics.down}) {
    *l = {numbers.log(1e-3, 1e6), numbers.log(1e-2, 1e9), law_row(law).uses_time ? numbers.log(1e-5, 10) : 0.0};
  }
  return s;
}

class Accuracy : public ::testing::TestWithParam<LawKind> {
 protected:
  static constexpr double kTolerance = 1e-12;
  Exact length(const Sample& s, const Exact& v) const {
    const Exact start = s.move.start, end = s.move.end;
    return (start + v) / 2 * exact_duration(GetParam(), v - start, s.dynamics.up) +
           (v + end) / 2 * exact_duration(GetParam(), v - end, s.dynamics.down);
  }
};

TEST_P(Accuracy, DurationIsExactToTwelveDigits) {
  Numbers numbers;
  const LawRow& law = law_row(GetParam());
  for (std::size_t i = 0; i < test::case_count(5000); ++i) {
    const Sample s = draw(numbers, GetParam());
    const double dv = numbers.log(1e-9, 1e5);
    const Exact exact = exact_duration(GetParam(), dv, s.dynamics.up);
    EXPECT_LT(relative_error(law.duration(dv, s.dynamics.up), exact), kTolerance) << dv;
    const DurationTerms terms = visit_law(GetParam(), [&](auto l) { return decltype(l)::terms(s.dynamics.up); });
    EXPECT_LT(relative_error(terms.duration(dv), exact), kTolerance) << dv;
  }
}

TEST_P(Accuracy, ReachIsExactToTwelveDigits) {
  Numbers numbers;
  const LawRow& law = law_row(GetParam());
  for (std::size_t i = 0; i < test::case_count(300); ++i) {
    const Sample s = draw(numbers, GetParam());
    const Exact v = s.move.start;
    const auto covered = [&](const Exact& end) -> Exact {
      return (v + end) / 2 * exact_duration(GetParam(), end - v, s.dynamics.up);
    };
    const Exact exact = bisect(covered, s.move.length, v, 1e20);
    EXPECT_LT(relative_error(law.reach(s.move.start, s.move.length, s.dynamics.up), exact), kTolerance)
        << law.id << " v " << s.move.start << " L " << s.move.length << " A " << s.dynamics.up.acceleration << " J "
        << s.dynamics.up.jerk << " T " << s.dynamics.up.time;
  }
}

TEST_P(Accuracy, PeakIsExactToTwelveDigits) {
  Numbers numbers;
  int below_feed = 0;
  const std::size_t count = test::case_count(300);
  for (std::size_t i = 0; i < count; ++i) {
    const Sample s = draw(numbers, GetParam());
    const auto move = single_move(GetParam(), s.move, s.dynamics);
    if (!move || move->reaches_feed) continue;
    ++below_feed;
    const Exact exact = bisect([&](const Exact& v) { return length(s, v); }, s.move.length,
                               std::max(s.move.start, s.move.end), s.move.feed);
    EXPECT_LT(relative_error(move->peak, exact), kTolerance)
        << "L " << s.move.length << " F " << s.move.feed << " " << s.move.start << " to " << s.move.end;
  }
  EXPECT_GT(below_feed, static_cast<int>(count / 20)) << "the draw is to try peaks below the feed";
}

INSTANTIATE_TEST_SUITE_P(Laws, Accuracy, ::testing::ValuesIn(test::every_law()), test::law_name);

}  // namespace
}  // namespace toolpace
