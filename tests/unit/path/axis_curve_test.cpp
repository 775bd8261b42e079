#include "toolpace/path/axis_curve.h"

#include <gtest/gtest.h>

#include "../kinematics/chains.h"
#include "toolpace/nc/reader.h"
#include "toolpace/path/build_path.h"
#include "toolpace/path/cut_for_axes.h"

namespace toolpace {
namespace {

using testing::head_and_table;
using testing::trunnion;

Path path_of(const std::string& text, const Chain& chain) {
  ReadOptions options;
  options.dialect = Dialect::fanuc;
  options.kinematics = {chain, true};
  const auto reading = read_text(text, "t.nc", options);
  EXPECT_TRUE(reading && !reading->refused);
  return build_path(reading->moves, 0.0).value();
}

constexpr const char* kMixed =
    "G90 G21 G94 G17\nG0 X10 Y5 B20 C30\nG43.4 H1\nG1 X5 Y6 Z7 F600\nX9 B40 C75\nG3 X19 Y16 R10 C20\nG1 B10\nG49\nG0 "
    "Z50\nM30\n";

TEST(AxisCurve, WhereThePathIsToldAnewTheAxesStandStill) {
  const Path path = path_of(kMixed, head_and_table());
  ASSERT_EQ(path.tellings.size(), 2u);
  const AxisCurve curve(path);
  for (const Path::Telling& telling : path.tellings) {
    EXPECT_LT((curve.end_of(telling.node - 1) - curve.begin_of(telling.node)).norm(), 1e-11);
    EXPECT_GT((path.end_of(telling.node - 1) - path.node[telling.node]).norm(), 1.0) << "but it is told otherwise";
  }
  for (std::size_t i = 0; i + 1 < path.size(); ++i) EXPECT_LT((curve.end_of(i) - curve.begin_of(i + 1)).norm(), 1e-11);
}

TEST(AxisCurve, DerivativesAreThoseOfItsPoints) {
  const Path path = path_of(kMixed, head_and_table());
  const AxisCurve curve(path);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double s = 0.4 * path.length[i], h = 1e-3 * path.length[i];
    const Frame f = curve.frame_at(i, s), before = curve.frame_at(i, s - h), behind = curve.frame_at(i, s + h);
    EXPECT_LT((f.point - curve.point_at(i, s)).norm(), 1e-12) << i;
    const auto close = [&](const AxisVector& derivative, const AxisVector& from, const AxisVector& to) {
      EXPECT_LT((derivative - (to - from) / (2 * h)).norm(), 1e-5 * (1 + derivative.norm())) << i;
    };
    close(f.first, before.point, behind.point);
    close(f.second, before.first, behind.first);
    close(f.third, before.second, behind.second);
  }
}

TEST(AxisCurve, WithoutATipIsThePathToTheBit) {
  const Path path = path_of("G90 G21 G94 G17\nG1 X5 B10 F600\nG3 X15 Y10 R10\nM30\n", trunnion());
  const AxisCurve curve(path);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Frame a = curve.frame_at(i, path.length[i] / 3), b = frame_at(path, i, path.length[i] / 3);
    EXPECT_EQ(a.point, b.point);
    EXPECT_EQ(a.third, b.third);
    EXPECT_EQ(curve.start_direction(i), start_direction(path, i));
    EXPECT_EQ(curve.is_straight(i), path.kind[i] == SegmentKind::line);
  }
  EXPECT_EQ(cut_for_axes(path).size(), path.size());
}

TEST(AxisCurve, OnALineWithoutTurnsTheAxesGoStraight) {
  const Path path = path_of("G90 G21 G94\nG0 A-40 C30\nG43.4 H1\nG1 X50 Y20 Z10 F600\nM30\n", trunnion());
  const AxisCurve curve(path);
  const std::size_t last = path.size() - 1;
  EXPECT_TRUE(curve.is_straight(last));
  EXPECT_NEAR(curve.start_direction(last).head<3>().norm(), 1, 1e-12);
  EXPECT_LT(curve.frame_at(last, 10).second.norm(), 1e-12);
}

TEST(CutForAxes, LeavesThePathWhereItIs) {
  const Path path = path_of(kMixed, head_and_table()), cut = cut_for_axes(path);
  // 20 to 40 and 30 to 75 degrees are 65 in all, so 8 pieces; C by 55, 7; B by 30, 4.
  ASSERT_EQ(cut.size(), path.size() + 7 + 6 + 3);
  std::size_t j = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    double s = 0;
    for (; j < cut.size() && cut.move[j] == path.move[i]; ++j) {
      for (const double share : {0.25, 0.75}) {
        const AxisVector was = point_at(path, i, s + share * cut.length[j]);
        EXPECT_LT((point_at(cut, j, share * cut.length[j]) - was).norm(), 1e-11) << j;
      }
      s += cut.length[j];
      if (s < path.length[i] * (1 - 1e-9)) {
        EXPECT_TRUE(AxisCurve(cut).is_cut(j + 1));
        EXPECT_LT((end_direction(cut, j) - start_direction(cut, j + 1)).norm(), 1e-12);
      }
    }
    EXPECT_NEAR(s, path.length[i], 1e-11);
  }
  ASSERT_EQ(cut.tellings.size(), 2u);
  EXPECT_EQ(cut.pauses.size(), path.pauses.size());
  EXPECT_NEAR(cut.position.back(), path.position.back(), 1e-10);
}

}  // namespace
}  // namespace toolpace
