#include "toolpace/machine/setup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "toolpace/base/numbers.h"
#include "toolpace/machine/setup_keys.h"

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
  const auto text = format_setup(*first);
  ASSERT_TRUE(text) << text.error().message;
  const auto second = parse_setup(*text, "again.toml");
  ASSERT_TRUE(second) << second.error().message << "\n" << *text;
  EXPECT_TRUE(is_same_file(*second, *first)) << *text;
  EXPECT_EQ(*format_setup(*second), *text);
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
  EXPECT_EQ(parse_setup(*format_setup(*setup), "m.toml")->machine.servo, setup->machine.servo);
  EXPECT_EQ(parse_setup("[servo]\nkw_1_s = 40\n", "m.toml").error().code, "machine-key");
  EXPECT_EQ(parse_setup("[servo.Q]\nkv_1_s = 40\n", "m.toml").error().code, "machine-key");
}

TEST(Setup, TravelMayBeOpenToOneSide) {
  const auto setup = parse_setup("[axes.Z]\ntravel_mm = [-inf, 10]\n", "m.toml");
  ASSERT_TRUE(setup) << setup.error().message;
  EXPECT_EQ(setup->machine.axes[2].travel_max, 10.0);
  const auto again = parse_setup(*format_setup(*setup), "m.toml");
  ASSERT_TRUE(again) << *format_setup(*setup);
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

// The parser took the comment's backslash for one in a text.
TEST(Setup, ACommentMayEndWithABackslashBesideOtherLetters) {
  const auto setup = parse_setup("# C:\\machines\\\n[machine]\nname = \"Fr\u00e4se\"\n", "m.toml");
  ASSERT_TRUE(setup) << setup.error().message;
}

TEST(Setup, KeysOfALaterVersionAreRefusedUnlessTheyArePassedOver) {
  const char* text =
      "future = 1\n[kinematics]\na = [1, 2]\n[axes.U]\nb = 2\n[path]\nmax_snap = 3\nmax_speed_mm_s = 5\n";
  EXPECT_EQ(parse_setup(text, "m.toml").error().code, "machine-key");
  const auto setup = parse_setup(text, "m.toml", UnknownKeys::pass_over);
  ASSERT_TRUE(setup) << setup.error().message;
  EXPECT_EQ(setup->machine.path.speed, 5);
}

struct BadValue {
  const char *text, *said;  ///< what is wrong with it, and the bounds with their unit
};
void PrintTo(const BadValue& value, std::ostream* out) { *out << value.text; }

class BadValues : public testing::TestWithParam<BadValue> {};

TEST_P(BadValues, AreRefusedWithTheirBounds) {
  const auto setup = parse_setup(GetParam().text, "m.toml");
  ASSERT_FALSE(setup);
  EXPECT_EQ(setup.error().code, "machine-value");
  EXPECT_EQ(setup.error().kind, ErrorKind::usage);
  EXPECT_GT(setup.error().where.line, 0u);
  EXPECT_EQ(setup.error().message, GetParam().said);
}

INSTANTIATE_TEST_SUITE_P(
    MachineFile, BadValues,
    testing::Values(
        BadValue{"[path]\nmax_speed_mm_s = 0\n",
                 "max_speed_mm_s is 0, but must be 1e-6 to 1e9 mm/s, or inf for no limit"},
        BadValue{"[path]\nmax_speed_mm_s = -1\n",
                 "max_speed_mm_s is -1, but must be 1e-6 to 1e9 mm/s, or inf for no limit"},
        BadValue{"[path]\nmax_speed_mm_s = nan\n",
                 "max_speed_mm_s is nan, but must be 1e-6 to 1e9 mm/s, or inf for no limit"},
        BadValue{"[path]\nmax_speed_mm_s = 1e-310\n",
                 "max_speed_mm_s is 1e-310, but must be 1e-6 to 1e9 mm/s, or inf for no limit"},
        BadValue{"[path]\nmax_speed_mm_s = true\n",
                 "max_speed_mm_s is true, but must be 1e-6 to 1e9 mm/s, or inf for no limit"},
        BadValue{"[path]\nmax_speed_mm_s = \"fast\"\n",
                 "max_speed_mm_s is a text, but must be 1e-6 to 1e9 mm/s, or inf for no limit"},
        BadValue{"[path]\nmax_acceleration_mm_s2 = 1e13\n",
                 "max_acceleration_mm_s2 is 1e+13, but must be 1e-6 to 1e12 mm/s\u00b2, or inf for no limit"},
        BadValue{"[axes.A]\nmax_jerk_deg_s3 = [1]\n",
                 "max_jerk_deg_s3 is a list, but must be 1e-6 to 1e15 deg/s\u00b3, or inf for no limit"},
        BadValue{"[axes.X]\ntravel_mm = [5, 1]\n",
                 "travel_mm is [5, 1], but must be [min, max] with min < max, each -1e9 to 1e9 mm, or -inf and inf for "
                 "open ends"},
        BadValue{
            "[axes.X]\ntravel_mm = [-2e9, 1]\n",
            "travel_mm is [-2e+09, 1], but must be [min, max] with min < max, each -1e9 to 1e9 mm, or -inf and inf "
            "for open ends"},
        BadValue{
            "[axes.A]\ntravel_deg = 5\n",
            "travel_deg is 5, but must be [min, max] with min < max, each -1e9 to 1e9 deg, or -inf and inf for open "
            "ends"},
        BadValue{"[axes.X]\ntravel_mm = [false, true]\n",
                 "travel_mm is a list, but must be [min, max] with min < max, each -1e9 to 1e9 mm, or -inf and inf for "
                 "open ends"},
        BadValue{"[axes.X]\nsteps_per_mm = -1\n",
                 "steps_per_mm is -1, but must be 1e-6 to 1e9 steps/mm, or 0 for none"},
        BadValue{"[servo]\nbandwidth_hz = 1e18\n", "bandwidth_hz is 1e+18, but must be 0.01 to 1e5 Hz"},
        BadValue{"[servo]\ndamping = {}\n", "damping is a section, but must be 0.001 to 100"},
        BadValue{"[servo.X]\nvelocity_feed_forward = inf\n", "velocity_feed_forward is inf, but must be 0 to 1"},
        BadValue{"[lookahead]\nblocks = true\n",
                 "blocks is true, but must be a whole number from 1 to 1000000000, or \"all\""},
        BadValue{"[lookahead]\nblocks = 0\n",
                 "blocks is 0, but must be a whole number from 1 to 1000000000, or \"all\""},
        BadValue{"[lookahead]\nblocks = 1.5\n",
                 "blocks is 1.5, but must be a whole number from 1 to 1000000000, or \"all\""},
        BadValue{"[machine]\nperiod_ms = 0\n", "period_ms is 0, but must be 0.001 to 10000 ms"},
        BadValue{"[machine]\ntool_change_s = inf\n", "tool_change_s is inf, but must be 0 to 86400 s"},
        BadValue{"[machine]\nname = 3\n", "name is 3, but must be a text"},
        BadValue{"[law]\nkind = 1979-05-27\n", "kind is a date or a time, but must be a text"}));

TEST(Setup, WordsThatAreNotKnownAreRefused) {
  for (const char* text : {"[law]\nkind = \"cubic\"\n", "[lookahead]\nramps = \"both\"\n", "machine = 3\n"})
    EXPECT_EQ(parse_setup(text, "m.toml").error().code, "machine-value") << text;
}

// A deceleration without limit beside a bounded acceleration was left out, and read back as the acceleration.
TEST(Setup, SlowingDownWithoutLimitIsWritten) {
  toolpace::Setup setup = default_setup();
  setup.machine.path.deceleration = kUnlimited;
  const auto text = format_setup(setup);
  ASSERT_TRUE(text);
  EXPECT_EQ(parse_setup(*text, "m.toml")->machine.path.deceleration, kUnlimited) << *text;
}

TEST(Setup, WhatCannotBeReadBackIsNotWritten) {
  toolpace::Setup setup = default_setup();
  setup.machine.axes[0].travel_min = 100;
  setup.machine.axes[0].travel_max = -100;
  EXPECT_EQ(
      format_setup(setup).error().message,
      "[axes.X] travel_mm is [100, -100], but must be [min, max] with min < max, each -1e9 to 1e9 mm, or -inf and "
      "inf for open ends");
  setup = default_setup();
  setup.machine.name = "Fr\xe4se";  // Latin-1
  EXPECT_EQ(format_setup(setup).error().code, "machine-unwritable");
}

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
  bad = good;
  bad.machine.axes[2].travel_max = -kUnlimited;
  EXPECT_FALSE(check_setup(bad.machine, bad.options));
  bad = good;
  bad.options.hold_at = -1;
  EXPECT_EQ(check_setup(bad.machine, bad.options).error().message, "hold_at_s is -1, but must be 0 to 1e9 s");
}

// One table says what a key may be: its ends are fine everywhere, and what lies beyond nowhere.
TEST(Setup, EndsOfEveryRangeAreFineInFilesAndInChecks) {
  toolpace::Setup known;
  for (const SetupSection& section : setup_sections(known)) {
    for (std::size_t k = 0; k < section.numbers.size(); ++k) {
      const NumberKey& key = section.numbers[k];
      const auto file = [&](double value) { return "[" + section.name + "]\n" + key.name + " = " + to_text(value); };
      for (const double end : {key.range.least, key.range.most}) {
        const auto setup = parse_setup(file(end), "m.toml");
        ASSERT_TRUE(setup) << file(end) << setup.error().message;
        EXPECT_TRUE(check_setup(setup->machine, setup->options)) << file(end);
        EXPECT_TRUE(format_setup(*setup)) << file(end);
      }
      EXPECT_FALSE(parse_setup(file(key.range.most * 1.001), "m.toml")) << file(key.range.most);
      EXPECT_FALSE(parse_setup(file(key.range.least - 1e-3 * (key.range.least + 1)), "m.toml")) << key.name;
    }
  }
}

TEST(Setup, SaysWhatIsWrongWithAMode) {
  const auto message = [](const std::string& body) {
    const auto setup = parse_setup("[[servo.X.modes]]\n" + body, "m.toml");
    return setup ? std::string("fine") : setup.error().message;
  };
  EXPECT_EQ(message("frequency_hz = 30"), "fine");
  EXPECT_EQ(message("damping = 0.1"), "a mode has no frequency_hz");
  EXPECT_EQ(message("frequency_hz = 0"), "frequency_hz is 0, but must be 0.01 to 1e5 Hz");
  EXPECT_EQ(message("frequency_hz = 30\nshare = 2"), "share is 2, but must be 0.001 to 1");
  EXPECT_EQ(message("frequenz_hz = 30"), "there is no key 'frequenz_hz'");
  EXPECT_EQ(parse_setup("[servo.X]\nmodes = 3", "m.toml").error().message, "modes is 3, but must be a list");
  toolpace::Setup bad = default_setup();
  bad.machine.servo[1].modes = {{30, 0, 1}};
  EXPECT_EQ(check_setup(bad.machine, bad.options).error().message,
            "[servo.Y.modes] damping is 0, but must be 0.001 to 100");
}

}  // namespace
}  // namespace toolpace
