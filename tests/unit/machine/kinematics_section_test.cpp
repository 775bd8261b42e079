#include <gtest/gtest.h>

#include "toolpace/machine/setup.h"

namespace toolpace {
namespace {

TEST(KinematicsSection, IsReadFromTheBaseOutwards) {
  const auto setup = parse_setup(
      "[kinematics]\nrotary = [{axis = \"B\", side = \"head\", direction = [0, 2, 0], point_mm = [1, 2, 3]},\n"
      " {axis = \"C\", side = \"table\", direction = [0, 0, -1]}]\ntool_mm = 120\n",
      "m.toml");
  ASSERT_TRUE(setup) << setup.error().message;
  const Chain& chain = setup->kinematics.chain;
  ASSERT_EQ(chain.joints.size(), 2u);
  EXPECT_EQ(chain.joints[0].axis, 4u);
  EXPECT_EQ(chain.joints[0].side, ChainSide::head);
  EXPECT_EQ(chain.joints[0].direction, Eigen::Vector3d::UnitY()) << "of unit length";
  EXPECT_EQ(chain.joints[0].point, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(chain.joints[1].axis, 5u);
  EXPECT_EQ(chain.joints[1].point, Eigen::Vector3d::Zero());
  EXPECT_EQ(chain.tool_length, 120);
  EXPECT_TRUE(setup->kinematics.tells_tool_length);
}

TEST(KinematicsSection, IsWrittenAsItWasRead) {
  const auto setup = parse_setup(
      "[kinematics]\nrotary = [{axis = \"A\", side = \"table\", direction = [1, 0, 0], point_mm = [0, 0.5, -50]}]\n",
      "m");
  ASSERT_TRUE(setup);
  const auto text = format_setup(*setup);
  ASSERT_TRUE(text);
  const auto again = parse_setup(*text, "m");
  ASSERT_TRUE(again) << *text;
  EXPECT_EQ(again->kinematics.chain.joints.at(0).point, Eigen::Vector3d(0, 0.5, -50));
  EXPECT_FALSE(again->kinematics.tells_tool_length);
  EXPECT_EQ(edit_setup(*text, "m", *setup).value(), *text) << "an edit of other values leaves it alone";
}

TEST(KinematicsSection, WhatMakesNoSenseIsToldWithItsPlace) {
  const auto error = [](const std::string& body) {
    const auto setup = parse_setup("[kinematics]\n" + body + "\n", "m.toml");
    return setup ? std::string("none")
                 : setup.error().code + "@" + std::to_string(setup.error().where.line) + " " + setup.error().message;
  };
  const std::string good = "{axis = \"A\", side = \"table\", direction = [1, 0, 0]}";
  EXPECT_EQ(error("rotary = [" + good + "]"), "none");
  EXPECT_EQ(error("rotary = 3"), "machine-value@2 rotary is 3, but must be a list");
  EXPECT_EQ(error("rotary = [" + good + ", " + good + "]"), "machine-value@2 A stands twice in the chain");
  EXPECT_EQ(error("rotary = [1]"), "machine-value@2 1 stands where a rotary axis is due");
  EXPECT_EQ(error("rotary = [{axis = \"A\", side = \"table\"}]"),
            "machine-value@2 a rotary axis needs axis, side and a direction other than 0");
  EXPECT_EQ(error("rotary = [{axis = \"X\", side = \"table\", direction = [1, 0, 0]}]"),
            "machine-value@2 axis must be \"A\", \"B\" or \"C\"");
  EXPECT_EQ(error("rotary = [{axis = \"A\", side = \"left\", direction = [1, 0, 0]}]"),
            "machine-value@2 side must be \"table\" or \"head\"");
  EXPECT_EQ(error("rotary = [{axis = \"A\", side = \"head\", direction = [1, 0]}]"),
            "machine-value@2 direction must be three numbers [x, y, z] up to 1e+06");
  EXPECT_EQ(error("rotary = [{axis = \"A\", side = \"head\", direction = [1, 0, nan]}]"),
            "machine-value@2 direction must be three numbers [x, y, z] up to 1e+06");
  EXPECT_EQ(error("\ntool_mm = -1"), "machine-value@3 tool_mm is -1, but must be 0 to 10000 mm");
  EXPECT_EQ(error("rotray = []"), "machine-key@2 there is no key 'rotray'");
  EXPECT_EQ(error("rotary = [{axes = \"A\"}]"), "machine-key@2 there is no key 'axes'");
}

}  // namespace
}  // namespace toolpace
