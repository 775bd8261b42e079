#include <gtest/gtest.h>

#include <string>

#include "toolpace/machine/setup.h"

namespace toolpace {
namespace {

using Machined = Setup;  // a test has a member of the other name

constexpr const char* kMill = R"(# The old mill, behind the window.
[machine]
name = 'Mill'   # as on its plate
period_ms = 2.0

  # Measured in spring.
  [axes.X]
  max_speed_mm_s = 1_00.0e0  # not more!
  max_jerk_mm_s3 = 3.0e4# gantry
  travel_mm = [ -300.0,  # left
                 300.0 ] # right

[path] # of all
max_speed_mm_s = 120
)";

Setup parsed(const std::string& text) {
  auto setup = parse_setup(text, "mill.toml", UnknownKeys::pass_over);
  EXPECT_TRUE(setup) << setup.error().message << "\n" << text;
  return setup.value_or(Setup{});
}

/// The text with one change to its setup, which it then reads back to.
template <class Change>
std::string edited(const std::string& text, const Change& change) {
  toolpace::Setup setup = parsed(text);
  change(setup);
  const auto result = edit_setup(text, "mill.toml", setup);
  if (!result) return "error: " + result.error().message;
  EXPECT_TRUE(is_same_file(parsed(*result), setup)) << *result;
  return *result;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(EditSetup, WithoutAChangeEveryByteStays) {
  EXPECT_EQ(edited(kMill, [](Machined&) {}), kMill);
  EXPECT_EQ(edited("", [](Machined&) {}), "");
  EXPECT_EQ(edited("\xEF\xBB\xBF# only a mark\r\n", [](Machined&) {}), "\xEF\xBB\xBF# only a mark\r\n");
}

TEST(EditSetup, AChangedValueIsWrittenInItsPlace) {
  const auto faster = [](Machined& s) { s.machine.axes[0].speed = 250.5; };
  EXPECT_EQ(edited(kMill, faster), replaced(kMill, "1_00.0e0", "250.5"));
  const auto renamed = [](Machined& s) { s.machine.name = "Mill \"2\""; };
  EXPECT_EQ(edited(kMill, renamed), replaced(kMill, "'Mill'", R"("Mill \"2\"")"));
}

TEST(EditSetup, OfATravelOnlyTheEndThatMovedIsWritten) {
  const auto longer = [](Machined& s) { s.machine.axes[0].travel_max = 310; };
  EXPECT_EQ(edited(kMill, longer), replaced(kMill, " 300.0 ]", " 310 ]"));
}

TEST(EditSetup, ANewKeyGoesToTheEndOfItsSectionAsItIsIndentedThere) {
  const auto bounded = [](Machined& s) { s.machine.axes[0].acceleration = 900; };
  EXPECT_EQ(edited(kMill, bounded),
            replaced(kMill, "300.0 ] # right\n", "300.0 ] # right\n  max_acceleration_mm_s2 = 900\n"));
  const auto at_the_end = [](Machined& s) { s.machine.path.acceleration = s.machine.path.deceleration = 900; };
  EXPECT_EQ(edited("[path]\nmax_speed_mm_s = 1", at_the_end),
            "[path]\nmax_speed_mm_s = 1\nmax_acceleration_mm_s2 = 900\n");
  EXPECT_EQ(edited("[path] # none yet\r\n", at_the_end), "[path] # none yet\r\nmax_acceleration_mm_s2 = 900\r\n");
}

TEST(EditSetup, ANewSectionGoesToTheEndOfTheFile) {
  const auto bounded = [](Machined& s) { s.machine.axes[2].jerk = 5e4; };
  EXPECT_EQ(edited(kMill, bounded), std::string(kMill) + "\n[axes.Z]\nmax_jerk_mm_s3 = 50000\n");
  EXPECT_EQ(edited("", bounded), "[axes.Z]\nmax_jerk_mm_s3 = 50000\n");
}

TEST(EditSetup, ALimitThatIsNoneAnyMoreLeavesButItsCommentStays) {
  const auto free = [](Machined& s) { s.machine.axes[0].jerk = kUnlimited; };
  EXPECT_EQ(edited(kMill, free), replaced(kMill, "  max_jerk_mm_s3 = 3.0e4# gantry\n", "  # gantry\n"));
  const auto endless = [](Machined& s) {
    s.machine.axes[0].travel_min = -kUnlimited;
    s.machine.axes[0].travel_max = kUnlimited;
  };
  EXPECT_EQ(
      edited(kMill, endless),
      replaced(kMill, "  travel_mm = [ -300.0,  # left\n                 300.0 ] # right\n", "  # left\n  # right\n"));
}

// Without its key slowing down follows speeding up, so that it has to be written when only the latter changes.
TEST(EditSetup, SlowingDownKeepsItsLimitWhenSpeedingUpChanges) {
  const std::string text = "[path]\nmax_acceleration_mm_s2 = 900\n";
  EXPECT_EQ(edited(text, [](Machined& s) { s.machine.path.acceleration = 1000; }),
            "[path]\nmax_acceleration_mm_s2 = 1000\nmax_deceleration_mm_s2 = 900\n");
  EXPECT_EQ(edited(text, [](Machined& s) { s.machine.path.acceleration = s.machine.path.deceleration = 1000; }),
            "[path]\nmax_acceleration_mm_s2 = 1000\n");
  EXPECT_EQ(edited(text, [](Machined& s) { s.machine.path.deceleration = kUnlimited; }),
            text + "max_deceleration_mm_s2 = inf\n");
}

TEST(EditSetup, DottedKeysAndTablesInBracesAreEditedWhereTheyStand) {
  const auto change = [](Machined& s) {
    s.machine.axes[0].speed = 7;
    s.machine.axes[0].jerk = 8;
    s.machine.axes[1].jerk = 9;
  };
  EXPECT_EQ(edited("axes.X.max_speed_mm_s = 5 # dotted\n[path]\n", change),
            "axes.X.max_speed_mm_s = 7 # dotted\naxes.X.max_jerk_mm_s3 = 8\naxes.Y.max_jerk_mm_s3 = 9\n[path]\n");
  EXPECT_EQ(edited("[axes]\nX.max_speed_mm_s = 5\n", change),
            "[axes]\nX.max_speed_mm_s = 7\nX.max_jerk_mm_s3 = 8\n\n[axes.Y]\nmax_jerk_mm_s3 = 9\n");
  EXPECT_EQ(edited("axes = { X = { max_speed_mm_s = 5 } } # braces", change),
            "axes = { X = { max_speed_mm_s = 7, max_jerk_mm_s3 = 8 }, Y.max_jerk_mm_s3 = 9 } # braces");
  EXPECT_EQ(edited("[axes]\nX = {}\n", change),
            "[axes]\nX = { max_speed_mm_s = 7, max_jerk_mm_s3 = 8}\n\n[axes.Y]\nmax_jerk_mm_s3 = 9\n");
  EXPECT_EQ(
      edited("axes = { X = { max_speed_mm_s = 5 } }\n", [](Machined& s) { s.machine.axes[0].speed = kUnlimited; }),
      "axes = { X = { max_speed_mm_s = inf } }\n")
      << "what follows in braces would lose its comma";
  EXPECT_EQ(edited("[ \"axes\" . 'X' ]\n\"max_speed_\\u006dm_s\" = 5\n", change),
            "[ \"axes\" . 'X' ]\n\"max_speed_\\u006dm_s\" = 7\nmax_jerk_mm_s3 = 8\n\n[axes.Y]\nmax_jerk_mm_s3 = 9\n");
}

TEST(EditSetup, DrivesThatShareAValueGoOnSharingIt) {
  const std::string text = "[servo]\nkv_1_s = 40 # all\n[servo.Y]\nkv_1_s = 30\n";
  const auto all_but_y = [](Machined& s) {
    for (std::size_t k = 0; k < kAxisCount; ++k) s.machine.servo[k].position_gain = k == 1 ? 30 : 60;
  };
  EXPECT_EQ(edited(text, all_but_y), replaced(text, "40", "60"));
  EXPECT_EQ(edited(text, [](Machined& s) { s.machine.servo[2].position_gain = 45; }),
            text + "\n[servo.Z]\nkv_1_s = 45\n");
  EXPECT_EQ(edited(text, [](Machined& s) { s.machine.servo[1].position_gain = 31; }), replaced(text, "30", "31"));
}

TEST(EditSetup, KeysOfALaterVersionStay) {
  const std::string text = "[turret]\nplaces = [ # first\n{tool = \"A\", side = \"head\"}]\n[path]\nmax_snap = 5\n";
  EXPECT_EQ(edited(text, [](Machined& s) { s.machine.path.speed = 9; }), text + "max_speed_mm_s = 9\n");
}

TEST(EditSetup, WhatNoFileCanHoldIsRefused) {
  EXPECT_NE(edited(kMill, [](Machined& s) { s.machine.axes[0].travel_min = 400; }).find("error: [axes.X] travel_mm is"),
            std::string::npos);
  EXPECT_EQ(edit_setup("[path\n", "mill.toml", default_setup()).error().code, "machine-syntax");
}

TEST(EditSetup, OverridesOfAJobAreNoMatterOfTheFile) {
  const auto change = [](Machined& s) {
    s.options.feed_override = 0.5;
    s.options.hold_at = 3;
    s.options.corner.step = 9;
  };
  EXPECT_EQ(edited(kMill, change), kMill);
}

TEST(EditSetup, ModesAreChangedWhereTheyStand) {
  const std::string text =
      "[servo.X]\nkv_1_s = 60\n\n[[servo.X.modes]]  # column\nfrequency_hz = 31.5  # measured\ndamping = 0.02\n\n"
      "[[servo.X.modes]]\n# head\nfrequency_hz = 80\nshare = 0.4\n\n[path]\nmax_speed_mm_s = 50\n";
  toolpace::Setup setup = parse_setup(text, "m.toml").value();
  auto& modes = setup.machine.servo[0].modes;
  ASSERT_EQ(modes, (std::vector<AxisMode>{{31.5, 0.02, 1}, {80, 0.05, 0.4}}));
  EXPECT_EQ(edit_setup(text, "m.toml", setup).value(), text);

  modes[0].frequency = 32;
  modes[1].damping = 0.1;
  const std::string changed = edit_setup(text, "m.toml", setup).value();
  EXPECT_NE(changed.find("frequency_hz = 32  # measured\n"), std::string::npos);
  EXPECT_NE(changed.find("share = 0.4\ndamping = 0.1\n\n[path]"), std::string::npos);

  modes.resize(1);
  const std::string fewer = edit_setup(text, "m.toml", setup).value();
  EXPECT_EQ(fewer.find("= 80"), std::string::npos);
  EXPECT_NE(fewer.find("# head\n"), std::string::npos);

  modes.push_back({120, 0.03, 0.2});
  setup.machine.servo[3].modes = {{9}};
  const std::string more = edit_setup(fewer, "m.toml", setup).value();
  EXPECT_NE(more.find("\n[[servo.X.modes]]\nfrequency_hz = 120\ndamping = 0.03\nshare = 0.2\n\n[[servo.A.modes]]"),
            std::string::npos);
}

TEST(EditSetup, ModesInAListStayOne) {
  for (const std::string text : {"servo.X.modes = [{frequency_hz = 30}]\n", "servo = { X = { kv_1_s = 60 } }\n"}) {
    toolpace::Setup setup = parse_setup(text, "m.toml").value();
    setup.machine.servo[0].modes = {{30, 0.01, 1}, {50}};
    const std::string edited = edit_setup(text, "m.toml", setup).value();
    EXPECT_NE(edited.find("modes = [{frequency_hz = 30, damping = 0.01}, {frequency_hz = 50}]"), std::string::npos);
  }
}

}  // namespace
}  // namespace toolpace
