#include "toolpace/limits/dynamics_table.h"

#include <gtest/gtest.h>

#include <set>

namespace toolpace {
namespace {

Dynamics slower(int step) { return {{1000.0 - step, 1e5, 0}, {800, 1e5, 0}}; }

TEST(DynamicsTable, KeepsEachOfAFewOnceHoweverOftenTheyChange) {
  DynamicsTable table;
  std::vector<std::uint32_t> ramp;
  for (int i = 0; i < 5000; ++i) ramp.push_back(table.add(slower(i * i % 100), Cause::acceleration));
  SpeedLimits limits;
  std::move(table).give_to(limits);
  std::set<double> different;
  for (const Dynamics& d : limits.dynamics) different.insert(d.up.acceleration);
  EXPECT_EQ(different.size(), limits.dynamics.size());
  for (int i = 0; i < 5000; ++i) {
    EXPECT_EQ(limits.dynamics[ramp[static_cast<std::size_t>(i)]], slower(i * i % 100)) << i;
  }
}

TEST(DynamicsTable, FindsTheFirstAgainAfterManyOthers) {
  DynamicsTable table;
  for (int i = 0; i < 900; ++i) EXPECT_EQ(table.add(slower(i), Cause::acceleration), static_cast<std::uint32_t>(i));
  EXPECT_EQ(table.add(slower(3), Cause::acceleration), 3u);
  EXPECT_EQ(table.add(slower(899), Cause::acceleration), 900u);  // not kept in mind
  EXPECT_EQ(table.add(slower(899), Cause::acceleration), 900u);  // but for the last
}

TEST(DynamicsTable, TellsTheSameLimitsOfDifferentCausesApart) {
  DynamicsTable table;
  EXPECT_EQ(table.add(slower(1), Cause::acceleration), 0u);
  EXPECT_EQ(table.add(slower(1), Cause::axis_acceleration), 1u);
  EXPECT_EQ(table.add(slower(1), Cause::acceleration), 0u);
  SpeedLimits limits;
  std::move(table).give_to(limits);
  EXPECT_EQ(limits.dynamics_cause, (std::vector{Cause::acceleration, Cause::axis_acceleration}));
}

}  // namespace
}  // namespace toolpace
