/// Random stepper moves: pulse times against 50 digits, tables in pieces, intervals of at least a tick.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "case_count.h"
#include "exact_stepper.h"
#include "toolpace/sample/pulse_table.h"

namespace toolpace {
namespace {

class Numbers {
 public:
  double log(double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<>(0, 1)(random_));
  }
  std::uint64_t below(std::uint64_t end) { return std::uniform_int_distribution<std::uint64_t>(0, end - 1)(random_); }

 private:
  std::mt19937_64 random_{18930101};
};

std::string text(const StepperMove& m) {
  std::ostringstream out;
  out.precision(17);
  out << m.steps << " steps, " << m.speed << " step/s, " << m.t_acc << " s, " << m.t_dec << " s, " << m.timer_hz
      << " Hz";
  return out.str();
}

StepperMove draw(Numbers& numbers) {
  return {static_cast<std::uint64_t>(numbers.log(1, 2e6)), numbers.log(1, 1e6), numbers.log(1e-5, 20),
          numbers.log(1e-5, 20), numbers.log(1e3, 1e8)};
}

TEST(PulseProperties, EveryPulseLiesWithinHalfATickAndItsTimeIsExact) {
  Numbers numbers;
  std::size_t made = 0;
  for (std::size_t i = 0; i < test::case_count(1500); ++i) {
    const StepperMove move = draw(numbers);
    const auto table = PulseTable::create(move);
    if (!table) continue;
    ++made;
    const test::ExactStepper exact(move);
    const auto steps = move.steps;
    for (const std::uint64_t pulse : {std::uint64_t{1}, std::min<std::uint64_t>(2, steps), numbers.below(steps) + 1,
                                      steps - (steps > 1 ? 1 : 0), steps}) {
      const test::Exact time = exact.time(pulse);
      EXPECT_NEAR(table->time(pulse), static_cast<double>(time), 2e-14 * table->total_time())
          << pulse << " of " << text(move);
      const double off = static_cast<double>(test::Exact(table->ticks_at(pulse)) - time * test::Exact(move.timer_hz));
      EXPECT_LE(std::abs(off), 0.5 + 1e-14 * static_cast<double>(table->total_ticks()))
          << pulse << " of " << text(move);
    }
  }
  EXPECT_GT(made, test::case_count(1500) / 4);
}

TEST(PulseProperties, PiecesOfATableMakeUpTheTable) {
  Numbers numbers;
  for (std::size_t i = 0; i < test::case_count(60); ++i) {
    const StepperMove move = draw(numbers);
    const auto table = PulseTable::create(move);
    if (!table) continue;
    std::uint64_t sum = 0;
    std::vector<std::uint32_t> ticks;
    for (std::uint64_t first = 0; first < move.steps; first += ticks.size()) {
      ticks.resize(static_cast<std::size_t>(std::min(move.steps - first, 1 + numbers.below(300'000))));
      table->read(first, ticks);
      EXPECT_GT(*std::min_element(ticks.begin(), ticks.end()), 0u) << text(move);
      sum = std::accumulate(ticks.begin(), ticks.end(), sum);
      EXPECT_EQ(sum, table->ticks_at(first + ticks.size())) << first << " of " << text(move);
    }
    EXPECT_EQ(sum, table->total_ticks()) << text(move);
  }
}

}  // namespace
}  // namespace toolpace
