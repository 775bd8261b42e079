#include "toolpace/machine/setup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace toolpace {
namespace {

constexpr const char* kMill = R"([machine]
name = "Mill \"3\""
period_ms = 2
tool_change_s = 4.5
[path]
max_speed_mm_s = 120
max_acceleration_mm_s2 = 900
max_jerk_mm_s3 = 30000
[axes.X]
max_speed_mm_s = 100
travel_mm = [-10, 300.5]
steps_per_mm = 80
[axes.A]
max_speed_deg_s = 90
travel_deg = [-180, 180]
[law]
kind = "seven-phase"
tacc_ms = 40
[lookahead]
blocks = 64
ramps = "span"
corner = "junction"
tolerance_mm = 0.02
)";

TEST(Setup, ReadsEveryKindOfKeyInCoreUnits) {
  const auto setup = parse_setup(kMill, "mill.toml");
  ASSERT_TRUE(setup) << setup.error().message;
  EXPECT_EQ(setup->machine.name, "Mill \"3\"");
  EXPECT_DOUBLE_EQ(setup->machine.period, 0.002);
  EXPECT_EQ(setup->machine.path.acceleration, 900);
  EXPECT_EQ(setup->machine.path.deceleration, 900) << "follows the acceleration where it is not given";
  EXPECT_EQ(setup->machine.path.jerk_deceleration, 30000);
  EXPECT_EQ(setup->machine.axes[0].travel_max, 300.5);
  EXPECT_NEAR(setup->machine.axes[3].speed, std::numbers::pi / 2, 1e-15);
  EXPECT_EQ(setup->machine.axes[1].speed, kUnlimited) << "a missing key means no limit";
  EXPECT_EQ(setup->options.law, LawKind::seven_phase);
  EXPECT_DOUBLE_EQ(setup->options.t_acc, 0.04);
  EXPECT_EQ(setup->options.lookahead, 64u);
  EXPECT_EQ(setup->options.ramps, Ramps::span);
  EXPECT_EQ(setup->options.corner.rule, CornerRule::junction);
}

TEST(Setup, WhatIsWrittenReadsBackTheSame) {
  const auto first = parse_setup(kMill, "mill.toml");
  ASSERT_TRUE(first);
  const std::string text = format_setup(*first);
  const auto second = parse_setup(text, "again.toml");
  ASSERT_TRUE(second) << second.error().message << "\n" << text;
  EXPECT_EQ(format_setup(*second), text);
  EXPECT_EQ(second->machine.name, first->machine.name);
  EXPECT_EQ(second->machine.axes[3].travel_min, first->machine.axes[3].travel_min);
  EXPECT_EQ(second->machine.axes[3].speed, first->machine.axes[3].speed);
  EXPECT_EQ(second->machine.period, first->machine.period);
}

TEST(Setup, ServoHoldsForAllAxesAndServoXForOne) {
  const auto setup = parse_setup(
      "[servo.Y]\nkv_1_s = 30\n[servo]\nkv_1_s = 40\nbacklash_mm = 0.01\n[servo.A]\nbacklash_deg = 90\n", "m.toml");
  ASSERT_TRUE(setup) << setup.error().message;
  EXPECT_EQ(setup->machine.servo[0].position_gain, 40);
  EXPECT_EQ(setup->machine.servo[1].position_gain, 30);
  EXPECT_EQ(setup->machine.servo[2].backlash, 0.01);
  EXPECT_EQ(setup->machine.servo[3].backlash, 90 * kRadiansPerDegree);
  EXPECT_EQ(setup->machine.servo[4].backlash, 0.0);
  EXPECT_EQ(parse_setup(format_setup(*setup), "m.toml")->machine.servo, setup->machine.servo);
  EXPECT_EQ(parse_setup("[servo]\nkw_1_s = 40\n", "m.toml").error().code, "machine-key");
  EXPECT_EQ(parse_setup("[servo.Q]\nkv_1_s = 40\n", "m.toml").error().code, "machine-key");
}

TEST(Setup, TravelMayBeOpenToOneSide) {
  const auto setup = parse_setup("[axes.Z]\ntravel_mm = [-inf, 10]\n", "m.toml");
  ASSERT_TRUE(setup) << setup.error().message;
  EXPECT_EQ(setup->machine.axes[2].travel_max, 10.0);
  const auto again = parse_setup(format_setup(*setup), "m.toml");
  ASSERT_TRUE(again) << format_setup(*setup);
  EXPECT_EQ(again->machine.axes[2].travel_min, -kUnlimited);
  EXPECT_EQ(again->machine.axes[2].travel_max, 10.0);
}

// Such characters led the TOML parser into code that it declares unreachable.
TEST(Setup, OtherLettersThanAsciiStandInTextsAndCommentsOnly) {
  const auto key = parse_setup("[path]\n# \u00fcber\n\u03cd = 1\n", "m.toml");
  ASSERT_FALSE(key);
  EXPECT_EQ(key.error().code, "machine-syntax");
  EXPECT_EQ(key.error().where.line, 3u);
  EXPECT_EQ(key.error().where.column, 1u);
  const auto text = parse_setup("[machine]\nname = \"\u5371\\\"\u03cd\" # \u03cd\n[machine2]\n", "m.toml");
  EXPECT_EQ(text.error().code, "machine-key");
  const auto good = parse_setup("\xEF\xBB\xBF[machine]\nname = '''\u03cd'\n\u0449''' # \u03cd\n", "m.toml");
  ASSERT_TRUE(good) << good.error().message;
  EXPECT_EQ(good->machine.name, "\u03cd'\n\u0449");
}

TEST(Setup, AnUnknownKeyNamesTheNearestOneAndItsPlace) {
  const auto setup = parse_setup("[path]\nmax_speed_mms = 3\n", "m.toml");
  ASSERT_FALSE(setup);
  EXPECT_EQ(setup.error().code, "machine-key");
  EXPECT_EQ(setup.error().where.line, 2u);
  EXPECT_NE(setup.error().remedy.find("max_speed_mm_s"), std::string::npos) << setup.error().remedy;
}

TEST(Setup, AnUnknownSectionOrAxisIsAnError) {
  EXPECT_EQ(parse_setup("[pathh]\n", "m.toml").error().code, "machine-key");
  EXPECT_EQ(parse_setup("[axes.U]\nmax_speed_mm_s = 1\n", "m.toml").error().code, "machine-key");
}

TEST(Setup, BadSyntaxTellsTheLine) {
  const auto setup = parse_setup("[path]\nmax_speed_mm_s = = 3\n", "m.toml");
  ASSERT_FALSE(setup);
  EXPECT_EQ(setup.error().code, "machine-syntax");
  EXPECT_EQ(setup.error().where.line, 2u);
}

class BadValue : public testing::TestWithParam<const char*> {};

TEST_P(BadValue, IsRefused) {
  const auto setup = parse_setup(GetParam(), "m.toml");
  ASSERT_FALSE(setup);
  EXPECT_EQ(setup.error().code, "machine-value");
  EXPECT_EQ(setup.error().kind, ErrorKind::usage);
}

INSTANTIATE_TEST_SUITE_P(MachineFile, BadValue,
                         testing::Values("[path]\nmax_speed_mm_s = 0\n", "[path]\nmax_speed_mm_s = -1\n",
                                         "[path]\nmax_speed_mm_s = nan\n", "[path]\nmax_speed_mm_s = \"fast\"\n",
                                         "[axes.X]\ntravel_mm = [5, 1]\n", "[axes.X]\ntravel_mm = 5\n",
                                         "[law]\nkind = \"cubic\"\n", "[lookahead]\nblocks = 0\n",
                                         "[lookahead]\nramps = \"both\"\n", "[machine]\nperiod_ms = 0\n",
                                         "[machine]\ntool_change_s = -1\n", "machine = 3\n"));

TEST(Setup, CheckRefusesLimitsThatMakeNoSense) {
  const toolpace::Setup good = default_setup();
  EXPECT_TRUE(check_setup(good.machine, good.options));
  toolpace::Setup bad = good;
  bad.machine.path.jerk = -1;
  EXPECT_FALSE(check_setup(bad.machine, bad.options));
  bad = good;
  bad.machine.period = 0;
  EXPECT_FALSE(check_setup(bad.machine, bad.options));
  bad = good;
  bad.options.feed_override = 0;
  EXPECT_FALSE(check_setup(bad.machine, bad.options));
  bad = good;
  bad.machine.path.speed = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(check_setup(bad.machine, bad.options));
  bad = good;
  bad.options.lookahead = 0;
  EXPECT_FALSE(check_setup(bad.machine, bad.options));
}

TEST(Setup, AMissingFileIsAnIoError) {
  EXPECT_EQ(read_setup("no/such/machine.toml").error().kind, ErrorKind::io);
  EXPECT_EQ(read_setup(".").error().kind, ErrorKind::io);
}

}  // namespace
}  // namespace toolpace
