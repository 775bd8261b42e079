#include "toolpace/limits/tip_bounds.h"

#include <gtest/gtest.h>

#include <random>

#include "../kinematics/chains.h"
#include "toolpace/path/axis_curve.h"

namespace toolpace {
namespace {

using namespace testing;

Path line_about(const Chain& chain, const AxisVector& from, const AxisVector& to) {
  Path path;
  path.kind = {SegmentKind::line};
  path.node = {from, to};
  const double length = (to - from).head<3>().norm();
  path.length = {length > 0 ? length : (to - from).tail<3>().norm() / kRadiansPerDegree};
  path.move = {0};
  path.detail = {kNoDetail};
  path.tellings = {{0, chain, from}};
  path.position = NodePositions(path.length);
  return path;
}

TEST(TipBounds, CoverWhatTheAxesDoAndAreNearIt) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 300; ++k) {
    const Chain chain = k % 3 == 0 ? trunnion() : k % 3 == 1 ? head_and_table() : nutating_head();
    AxisVector from, step;
    for (Eigen::Index i = 0; i < 6; ++i)
      from[i] = unit(random) * (i < 3 ? 100 : 2), step[i] = unit(random) * (i < 3 ? 2 : 0);
    if (k % 5 == 0) step.setZero();
    for (const RotaryJoint& joint : chain.joints) step[static_cast<Eigen::Index>(joint.axis)] = 0.07 * unit(random);
    const Path path = line_about(chain, from, from + step);
    const CurveBounds bounds = curve_bounds(path, 0);
    AxisVector most[3] = {AxisVector::Zero(), AxisVector::Zero(), AxisVector::Zero()};
    for (int i = 0; i <= 40; ++i) {
      const Frame f = AxisCurve(path).frame_at(0, path.length[0] * i / 40);
      most[0] = most[0].cwiseMax(f.first.cwiseAbs());
      most[1] = most[1].cwiseMax(f.second.cwiseAbs());
      most[2] = most[2].cwiseMax(f.third.cwiseAbs());
    }
    const AxisVector* const bound[3] = {&bounds.first, &bounds.second, &bounds.third};
    for (int order = 0; order < 3; ++order) {
      const double slack = 1e-9 * (1 + most[order].norm());
      EXPECT_TRUE((most[order].array() <= bound[order]->array() + slack).all()) << "line " << k << ", order " << order;
      // Beside what is lost by half the angle there is what another order brings in where this one all but vanishes.
      const double rate = step.tail<3>().cwiseAbs().sum() / path.length[0];
      const double beside = order > 0 ? rate * most[order - 1].norm() : 0.0;
      EXPECT_LT((*bound[order] - most[order]).norm(), (order < 2 ? 0.3 : 0.8) * (most[order].norm() + beside) + slack)
          << "line " << k << ", order " << order;
    }
    EXPECT_EQ(bounds.together, AxisVector::Zero());
  }
}

TEST(TipBounds, APointAtRestOnATurningTableIsACircle) {
  // C alone, 30 mm from its axis: by degree of the path the axes run 30·π/180 mm, and bend by as much again.
  const Chain chain{{{kC, ChainSide::table, Eigen::Vector3d::UnitZ(), {0, 0, 0}}}};
  const Path path = line_about(chain, axes(30, 0, 0), axes(30, 0, 0, 0, 0, 2));
  const CurveBounds bounds = curve_bounds(path, 0);
  EXPECT_NEAR(bounds.first[1], 30 * kRadiansPerDegree, 2e-4);
  EXPECT_NEAR(bounds.second[0], 30 * kRadiansPerDegree * kRadiansPerDegree, 2e-5);
  EXPECT_NEAR(bounds.first[5], kRadiansPerDegree, 1e-12);
}

TEST(TipBounds, ThePoleIsWhereTheToolLiesAlongTheFartherJoint) {
  const auto near = [](double b) {
    return is_near_pole(line_about(head_and_table(), axes(0, 0, 0, 0, b, 0), axes(1, 0, 0, 0, b, 5)), 0);
  };
  EXPECT_TRUE(near(2));
  EXPECT_FALSE(near(30));
  EXPECT_FALSE(is_near_pole(line_about(head_and_table(), axes(0, 0, 0, 0, 0), axes(1, 0, 0, 0, 5)), 0))
      << "the farther joint rests";
}

}  // namespace
}  // namespace toolpace
