#include "toolpace/kinematics/great_circle.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "chains.h"

namespace toolpace {
namespace {

using Eigen::Vector3d;
using namespace testing;

double angle_between(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// Largest angle [rad] between the tool on the polynomials and the great circle, at 40 places of each.
double off_circle(const Chain& chain, const std::vector<SharePlace>& places, const AxisVector& from,
                  const AxisVector& to) {
  const Vector3d a = forward(chain, from).tool, b = forward(chain, to).tool;
  const double whole = angle_between(a, b);
  const Vector3d side = (b - a * a.dot(b)).normalized();
  double most = 0;
  for (std::size_t k = 1; k < places.size(); ++k) {
    const double length = places[k].share - places[k - 1].share;
    const RotaryTurn turn = turn_between(places[k - 1].place, places[k].place, length);
    for (int i = 0; i <= 40; ++i) {
      AxisVector axes = from;
      axes.tail<3>() = turn.at(length * i / 40)[0];
      const double angle = whole * (places[k - 1].share + length * i / 40);
      most = std::max(most, angle_between(forward(chain, axes).tool, std::cos(angle) * a + std::sin(angle) * side));
    }
  }
  return most;
}

TEST(GreatCircle, ThePolynomialHasWhatItsEndsTell) {
  const RotaryPlace from{{1, 2, 3}, {0.1, -0.2, 0.3}, {1, 2, -3}}, to{{1.5, 1.0, 3.2}, {0.4, 0.2, 0}, {-1, 0, 2}};
  const RotaryTurn turn = turn_between(from, to, 2.5);
  for (const auto& [s, place] : {std::pair(0.0, from), std::pair(2.5, to)}) {
    EXPECT_LT((turn.at(s)[0] - place.angle).norm(), 1e-13);
    EXPECT_LT((turn.at(s)[1] - place.first).norm(), 1e-13);
    EXPECT_LT((turn.at(s)[2] - place.second).norm(), 1e-13);
  }
  // The third derivative against a difference of the second.
  const Vector3d slope = (turn.at(1.001)[2] - turn.at(0.999)[2]) / 0.002;
  EXPECT_LT((turn.at(1.0)[3] - slope).norm(), 1e-5);
  RotaryTurn later = turn;
  later.begin = 0.7;
  EXPECT_LT((later.at(0.5)[0] - turn.at(1.2)[0]).norm(), 1e-14);
}

// From A 45 C 0 to A 45 C 90 both directions are 60 degrees apart (cos = 1/2); their middle is tilted by
// acos(cos 45 / cos 30) = 35.2644 degrees, at C 45.
TEST(GreatCircle, TheMiddleOfTwoTiltedDirectionsIsTiltedLess) {
  const AxisVector from = axes(0, 0, 0, 45), to = axes(0, 0, 0, 45, 0, 90);
  const auto places = turn_in_plane(trunnion(), from, to);
  ASSERT_TRUE(places);
  double a = 0, c = 0;
  for (std::size_t k = 1; k < places->size(); ++k) {
    const SharePlace &before = (*places)[k - 1], &behind = (*places)[k];
    if (!(before.share <= 0.5 && behind.share > 0.5)) continue;
    const auto at = turn_between(before.place, behind.place, behind.share - before.share).at(0.5 - before.share)[0];
    a = at[0] / kRadiansPerDegree;
    c = at[2] / kRadiansPerDegree;
  }
  EXPECT_NEAR(a, 35.26438968, 1e-4);
  EXPECT_NEAR(c, 45, 1e-4);
}

TEST(GreatCircle, IsKeptByRandomTurnsOfEachBuild) {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> tilt(-85, 85), round(-170, 170);
  int led = 0, tried = 0;
  for (const Chain& chain : {trunnion(), head_and_table(), nutating_head()}) {
    for (int k = 0; k < 60; ++k) {
      AxisVector from = axes(0, 0, 0), to = from;
      for (AxisVector* end : {&from, &to}) {
        for (const RotaryJoint& joint : chain.joints)
          (*end)[static_cast<Eigen::Index>(joint.axis)] =
              (joint.axis == kC ? round(random) : tilt(random)) * kRadiansPerDegree;
      }
      const auto places = turn_in_plane(chain, from, to);
      ++tried;
      if (!places) continue;
      ++led;
      ASSERT_LT(off_circle(chain, *places, from, to), 2 * kInPlane) << from.transpose() << " to " << to.transpose();
      ASSERT_EQ(places->front().place.angle, from.tail<3>().eval());
      ASSERT_EQ(places->back().place.angle, to.tail<3>().eval());
    }
  }
  EXPECT_GT(led, tried / 4);
}

TEST(GreatCircle, PassesNearAPoleAsNearAsItIs) {
  // At 30 degrees on both sides, C away from a half turn by ever less: past the pole at sin 30·sin(δ/2), about.
  for (const double off : {10.0, 1.0, 0.1, 1e-3}) {
    const AxisVector from = axes(0, 0, 0, 30), to = axes(0, 0, 0, 30, 0, 180 - off);
    const auto places = turn_in_plane(trunnion(), from, to);
    ASSERT_TRUE(places) << off;
    EXPECT_LT(off_circle(trunnion(), *places, from, to), 2 * kInPlane);
    EXPECT_LT(places->size(), 400u);
  }
}

TEST(GreatCircle, ThroughAPoleTheTiltChangesItsSign) {
  EXPECT_TRUE(turn_in_plane(trunnion(), axes(0, 0, 0, 30), axes(0, 0, 0, -40)).value().empty()) << "evenly";
}

TEST(GreatCircle, SaysWhereNoWayLeadsToTheAngles) {
  const Chain chain = trunnion();
  EXPECT_FALSE(turn_in_plane(chain, axes(0, 0, 0), axes(0, 0, 0, 30, 0, 90))) << "C would have to turn in the pole";
  EXPECT_FALSE(turn_in_plane(chain, axes(0, 0, 0, 30, 0, 90), axes(0, 0, 0)));
  EXPECT_FALSE(turn_in_plane(chain, axes(0, 0, 0, 30), axes(0, 0, 0, 30, 0, 200))) << "the way round is the other one";
  EXPECT_FALSE(turn_in_plane(chain, axes(0, 0, 0, 30), axes(0, 0, 0, 30, 0, 360))) << "round a cone";
  EXPECT_FALSE(turn_in_plane(chain, axes(0, 0, 0, 90), axes(0, 0, 0, -90))) << "opposite directions";
  const Chain one{{chain.joints[1]}, 0};
  EXPECT_TRUE(turn_in_plane(one, axes(0, 0, 0), axes(0, 0, 0, 0, 0, 90)).value().empty()) << "the tool stays upright";
  EXPECT_TRUE(turn_in_plane(chain, axes(0, 0, 0), axes(0, 0, 0, 0, 0, 90)).value().empty()) << "C alone, in the pole";
}

}  // namespace
}  // namespace toolpace
