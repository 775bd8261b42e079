/// Alignment and comparison against motions whose answer is known.

#include "toolpace/trace/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace toolpace {
namespace {

/// Back and forth with changing speeds, so that no part is like another: x = Σ sines, from rest to rest within `length`.
double way(double t) {
  const double length = 4;
  if (t <= 0 || t >= length) return 0;
  const double s = std::sin(std::numbers::pi * t / length);
  return 20 * s * s * s * (std::sin(3 * t) + 0.4 * std::sin(7.3 * t + 1));
}

CommandedRows commanded_rows(double period = 0.001) {
  CommandedRows rows;
  rows.period = period;
  for (int k = 0; k * period <= 4 + 1e-9; ++k) {
    rows.position[0].push_back(way(k * period));
    rows.position[1].push_back(100 + way(k * period - 0.3));
    rows.line.push_back(k * period <= 2 ? 7 : 9);
  }
  return rows;
}

/// A trace of what stands at place(t) on the program, t by its own clock.
Trace trace_of(double begin, double end, double step, const std::function<double(double)>& place, double noise = 0.0) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0, 1);
  Trace trace;
  trace.step = step;
  trace.name = "t.csv";
  trace.first_line = 2;
  for (double t = begin; t < end; t += step) {
    trace.rows.time.push_back(t);
    trace.rows.actual[0].push_back(way(place(t)) + noise * normal(random));
    trace.rows.actual[1].push_back(100 + way(place(t) - 0.3) + noise * normal(random));
  }
  return trace;
}

TEST(Alignment, FindsTheOffsetToATenthOfASample) {
  for (const double step : {0.001, 0.00037, 0.004}) {
    const Trace trace = trace_of(
        -0.7, 5.1, step, [](double t) { return t - 0.123456; }, 0.002);
    const auto found = align(commanded_rows(), trace);
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_NEAR(found->clock_offset(), 0.123456, 0.1 * step);
    EXPECT_NEAR(found->clock_offset(), 0.123456, 5 * found->offset_error + 1e-6);
    EXPECT_GT(found->correlation, 0.98);
  }
}

TEST(Alignment, FindsAPieceOfTheProgram) {
  const Trace trace = trace_of(0, 1.2, 0.001, [](double t) { return t + 1.5; });
  const auto found = align(commanded_rows(), trace);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->clock_offset(), -1.5, 1e-4);
}

TEST(Alignment, TellsTheDriftOfClocks) {
  const Trace trace = trace_of(
      0, 4.2, 0.001, [](double t) { return t * (1 + 250e-6) - 0.05; }, 1e-4);
  const auto found = align(commanded_rows(), trace);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->drift, 250e-6, 5e-6);
  EXPECT_NEAR(found->at(2.0), 2.0 * (1 + 250e-6) - 0.05, 1e-6);
  const auto none = align(commanded_rows(), trace_of(
                                                0, 4.2, 0.001, [](double t) { return t - 0.05; }, 1e-4));
  ASSERT_TRUE(none);
  EXPECT_EQ(none->drift, 0);
}

TEST(Alignment, GoesByTheCommandWhereTheTraceRecordedIt) {
  Trace trace = trace_of(0, 4.2, 0.001, [](double t) { return t - 0.05 - 0.02; });  // a lag of 20 ms
  for (const double t : trace.rows.time) trace.rows.commanded[0].push_back(way(t - 0.05));
  const auto compared = compare(commanded_rows(), trace);
  ASSERT_TRUE(compared) << compared.error().message;
  EXPECT_TRUE(compared->alignment.by_commanded);
  EXPECT_NEAR(compared->alignment.clock_offset(), 0.05, 1e-6);
  EXPECT_NEAR(compared->axis[0].lag, 0.02, 1e-3);
  EXPECT_NEAR(compared->axis[1].lag, 0.02, 1e-3);
}

TEST(Alignment, RefusesATraceOfAnotherProgram) {
  const Trace other = trace_of(0, 4.2, 0.001, [](double t) { return 4 * std::sin(0.7 * t * t / 4); });
  const auto found = align(commanded_rows(), other);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, "trace-other-program");
  Trace swapped = trace_of(0, 4.2, 0.001, [](double t) { return t; });
  std::swap(swapped.rows.actual[0], swapped.rows.actual[1]);
  EXPECT_FALSE(align(commanded_rows(), swapped));
}

TEST(Alignment, SaysWhichUnitIsWrong) {
  Trace trace = trace_of(0, 4.2, 0.001, [](double t) { return t; });
  for (double& x : trace.rows.actual[0]) x /= 25.4;
  const auto found = align(commanded_rows(), trace);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, "trace-unit");
  EXPECT_NE(found.error().message.find("inches"), std::string::npos) << found.error().message;
  EXPECT_EQ(found.error().message.rfind("axis X", 0), 0u);
}

TEST(Comparison, TellsErrorsByAxisAndLine) {
  // X is 0.02 mm short between 2.5 s and 2.6 s, in line 9.
  Trace trace = trace_of(0, 4.0005, 0.001, [](double t) { return t; });
  for (std::size_t i = 2500; i < 2600; ++i) trace.rows.actual[0][i] -= 0.02;
  std::vector<ComparedRow> rows;
  const auto compared = compare(commanded_rows(), trace, &rows);
  ASSERT_TRUE(compared) << compared.error().message;
  EXPECT_EQ(rows.size(), compared->rows);
  EXPECT_NEAR(compared->axis[0].max_error, 0.02, 5e-4);  // which sets the clock by 1e-5 s, too
  EXPECT_EQ(compared->axis[0].worst_line, 9u);
  EXPECT_LT(compared->axis[1].max_error, 5e-4);
  ASSERT_EQ(compared->lines.size(), 2u);
  EXPECT_EQ(compared->lines[0].line, 7u);
  EXPECT_LT(compared->lines[0].max_following, 5e-4);
  EXPECT_NEAR(compared->lines[1].max_following, 0.02, 5e-4);
  EXPECT_NEAR(compared->lines[1].rms_following, 0.02 * std::sqrt(100.0 / 2000), 2e-4);
  EXPECT_LE(compared->max_contour, compared->max_following);
}

TEST(Comparison, LeavesOutAnotherZeroAndSaysSo) {
  Trace trace = trace_of(0, 4.0005, 0.001, [](double t) { return t; });
  for (double& y : trace.rows.actual[1]) y -= 340.5;
  const auto compared = compare(commanded_rows(), trace);
  ASSERT_TRUE(compared) << compared.error().message;
  EXPECT_NEAR(compared->axis[1].shift, -340.5, 1e-4);
  EXPECT_LT(compared->axis[1].max_error, 1e-3);
  EXPECT_EQ(compared->axis[0].shift, 0);
}

TEST(Comparison, RefusesAChannelAtItsEnd) {
  Trace trace = trace_of(0, 4.2, 0.001, [](double t) { return t; });
  for (double& x : trace.rows.actual[0]) x = std::min(x, 15.0);
  const auto compared = compare(commanded_rows(), trace);
  ASSERT_FALSE(compared);
  EXPECT_EQ(compared.error().code, "trace-saturated");
  EXPECT_GT(compared.error().where.line, 2u);
}

TEST(Comparison, OfASlowTraceMeasuresFromThePathBetweenItsRows) {
  // On a circle each sample lies on the path, however far apart samples are.
  CommandedRows circle;
  for (int k = 0; k <= 4000; ++k) {
    const double a = std::pow(std::sin(k * 0.001 * std::numbers::pi / 8), 2) * 6;
    circle.position[0].push_back(10 * std::cos(a));
    circle.position[1].push_back(10 * std::sin(a));
  }
  Trace trace;
  trace.step = 0.05;
  for (int k = 0; k <= 4000; k += 50) {
    trace.rows.time.push_back(k * 0.001);
    trace.rows.actual[0].push_back(circle.position[0][static_cast<std::size_t>(k)]);
    trace.rows.actual[1].push_back(circle.position[1][static_cast<std::size_t>(k)]);
  }
  const auto compared = compare(circle, trace);
  ASSERT_TRUE(compared) << compared.error().message;
  EXPECT_LT(compared->max_contour, 1e-5);
}

}  // namespace
}  // namespace toolpace
