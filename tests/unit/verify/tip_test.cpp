#include <gtest/gtest.h>

#include <random>

#include "../kinematics/chains.h"
#include "toolpace/path/axis_curve.h"
#include "toolpace/verify/own_kinematics.h"

namespace toolpace {
namespace {

using namespace testing;

TEST(OwnKinematics, AgreeWithThoseThatPlan) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 500; ++k) {
    const Chain chain = k % 3 == 0 ? trunnion() : k % 3 == 1 ? head_and_table() : nutating_head();
    AxisVector q;
    for (Eigen::Index i = 0; i < 6; ++i) q[i] = unit(random) * (i < 3 ? 300 : 3);
    const ToolPose pose = forward(chain, q);
    const SeenTool seen = seen_tool(chain, q);
    ASSERT_LT((pose.tip - seen.tip).norm(), 1e-11);
    ASSERT_LT((pose.tool - seen.tool).norm(), 1e-13);
    AxisVector place = q;
    place.head<3>() = seen.tip;
    ASSERT_LT((axes_for(chain, place) - q).norm(), 1e-11);
    Frame f;
    f.point = place;
    for (AxisVector* d : {&f.first, &f.second, &f.third}) {
      for (Eigen::Index i = 0; i < 6; ++i) (*d)[i] = unit(random) * (i < 3 ? 1 : 0.05);
    }
    const Frame exact = through(chain, f), own = axes_frame(chain, f);
    const double all = exact.first.norm() + exact.second.norm() + exact.third.norm();
    ASSERT_LT((exact.first - own.first).norm(), 5e-4 * all);
    ASSERT_LT((exact.second - own.second).norm(), 1e-4 * all);
  }
}

// The tip on a circle of 1.5 mm, while nothing turns: a difference over a millimetre would see a tenth of its speed less.
TEST(OwnKinematics, SeeHowASmallArcBegins) {
  Frame f;
  f.point << 10, 20, 30, 0.3, -0.2, 0.1;
  f.first << 0, 1, 0, 0, 0, 0;
  f.second << 1 / 1.5, 0, 0, 0, 0, 0;
  f.third << 0, -1 / (1.5 * 1.5), 0, 0, 0, 0;
  const Frame exact = through(trunnion(), f), own = axes_frame(trunnion(), f);
  EXPECT_LT((exact.first - own.first).norm(), 1e-6);
  EXPECT_LT((exact.second - own.second).norm(), 1e-6);
}

}  // namespace
}  // namespace toolpace
