#include "toolpace/sample/pulse_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "exact_stepper.h"

namespace toolpace {
namespace {

using test::Exact;
using test::ExactStepper;

std::vector<std::uint32_t> all_ticks(const PulseTable& table) {
  std::vector<std::uint32_t> ticks(table.move().steps);
  table.read(0, ticks);
  return ticks;
}

const StepperMove kMoves[] = {
    {2000, 5000, 0.2, 0.1, 1e6},       // cruise
    {500, 50000, 0.2, 0.07, 72e6},     // top speed not reached, Tacc ≠ Tdec
    {1, 1000, 0.01, 0.02, 1e6},        // one step
    {1, 1000, 0.0001, 0.0002, 1e6},    // one step, ramps shorter than it
    {2, 1000, 0.01, 0.02, 84e6},       // first and last pulse alone
    {3, 10, 5.0, 0.001, 1e4},          // very unequal ramps
    {700, 999, 0.001, 0.5, 1e3},       // hardly more than a tick a step
    {1000, 123.456, 1.7, 2.9, 32768},  // nothing is round
};

TEST(PulseTable, EveryPulseLiesWithinHalfATickOfItsExactTime) {
  for (const StepperMove& move : kMoves) {
    const auto table = PulseTable::create(move);
    ASSERT_TRUE(table) << table.error().message;
    const ExactStepper exact(move);
    const auto ticks = all_ticks(*table);
    std::uint64_t sum = 0;
    for (std::uint64_t k = 1; k <= move.steps; ++k) {
      sum += ticks[k - 1];
      const double off = static_cast<double>(Exact(sum) - exact.time(k) * Exact(move.timer_hz));
      EXPECT_LE(std::abs(off), 0.5 + 1e-6) << "pulse " << k << " of " << move.steps;
      EXPECT_GT(ticks[k - 1], 0u) << "pulse " << k;
    }
  }
}

TEST(PulseTable, TimesAreExactToFourteenDigitsOfTheMove) {
  for (const StepperMove& move : kMoves) {
    const auto table = PulseTable::create(move);
    ASSERT_TRUE(table);
    const ExactStepper exact(move);
    for (std::uint64_t k = 0; k <= move.steps; ++k) {
      EXPECT_NEAR(table->time(k), static_cast<double>(exact.time(k)), 1e-14 * table->total_time()) << k;
    }
  }
}

TEST(PulseTable, TheIntervalsAddUpToTheMove) {
  for (const StepperMove& move : kMoves) {
    const auto table = PulseTable::create(move);
    ASSERT_TRUE(table);
    const auto ticks = all_ticks(*table);
    const auto sum = std::accumulate(ticks.begin(), ticks.end(), std::uint64_t{0});
    EXPECT_EQ(sum, table->total_ticks());
    EXPECT_NEAR(static_cast<double>(sum), table->total_time() * move.timer_hz, 0.5 + 1e-6);
  }
}

TEST(PulseTable, AnyStretchIsTheSameAsInTheWhole) {
  const auto table = PulseTable::create(kMoves[7]);
  ASSERT_TRUE(table);
  const auto whole = all_ticks(*table);
  for (std::size_t first = 0; first < whole.size(); first += 61) {
    std::vector<std::uint32_t> part(std::min<std::size_t>(97, whole.size() - first));
    table->read(first, part);
    for (std::size_t i = 0; i < part.size(); ++i) EXPECT_EQ(part[i], whole[first + i]) << first + i;
  }
}

// Ten million steps with ramps of 2.5 and 1.5 million: the far ends as exact as the near ones.
TEST(PulseTable, TenMillionStepsStayExactToTheLast) {
  const StepperMove move{10'000'000, 1e6, 5.0, 3.0, 100e6};
  const auto table = PulseTable::create(move);
  ASSERT_TRUE(table);
  const ExactStepper exact(move);
  std::vector<std::uint32_t> ticks(100'000);
  std::uint64_t sum = 0;
  for (std::uint64_t first = 0; first < move.steps; first += ticks.size()) {
    table->read(first, ticks);
    sum = std::accumulate(ticks.begin(), ticks.end(), sum);
    const double off = static_cast<double>(Exact(sum) - exact.time(first + ticks.size()) * Exact(move.timer_hz));
    EXPECT_LE(std::abs(off), 0.5 + 1e-5) << first;
  }
  for (std::uint64_t k = move.steps - 20; k <= move.steps; ++k) {
    EXPECT_NEAR(table->time(k), static_cast<double>(exact.time(k)), 1e-14 * 15) << k;
  }
}

// N = 100, Tacc = 0.1, Tdec = 0.3: 2·100/0.4 = 500 step/s.
TEST(PulseTable, PeakIsWhatTheLengthAllows) {
  const auto table = PulseTable::create({100, 1000, 0.1, 0.3, 1e6});
  ASSERT_TRUE(table);
  EXPECT_NEAR(table->peak_speed(), 500, 1e-9);
  EXPECT_FALSE(table->reaches_speed());
  EXPECT_NEAR(table->total_time(), 0.4, 1e-15);
}

TEST(PulseTable, NumbersThatMakeNoSenseAreUsageErrors) {
  const double nan = std::nan("");
  for (const StepperMove& move :
       {StepperMove{0, 1, 1, 1, 1e6}, StepperMove{1, 0, 1, 1, 1e6}, StepperMove{1, nan, 1, 1, 1e6},
        StepperMove{1, 1, 0, 1, 1e6}, StepperMove{1, 1, 1, -1, 1e6}, StepperMove{1, 1, 1, 1, 0},
        StepperMove{1, 1, 1, 1, nan}}) {
    const auto table = PulseTable::create(move);
    ASSERT_FALSE(table);
    EXPECT_EQ(table.error().kind, ErrorKind::usage);
    EXPECT_EQ(table.error().code, "number-out-of-range");
  }
}

TEST(PulseTable, ATimerThatCannotKeepUpIsRefused) {
  EXPECT_EQ(PulseTable::create({1000, 1e6, 0.0001, 0.0001, 1e5}).error().code, "timer-too-slow");
  EXPECT_EQ(PulseTable::create({1000, 1e5, 0.0001, 0.0001, 1e5}).error().code, "timer-too-slow");
  EXPECT_EQ(PulseTable::create({10, 1, 100, 100, 84e6}).error().code, "timer-too-fast");        // 32 bits
  EXPECT_EQ(PulseTable::create({1'000'000'000, 1, 1, 1, 1e6}).error().code, "timer-too-fast");  // 2^45
}

}  // namespace
}  // namespace toolpace
