#include "toolpace/path/build_path.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace toolpace {
namespace {

/// Builds a table of moves row by row.
struct MovesBuilder {
  Moves moves;
  MovesBuilder& add(MoveKind kind, const AxisVector& end, std::uint32_t detail = kNoDetail) {
    moves.kind.push_back(kind);
    moves.line.push_back(static_cast<std::uint32_t>(moves.size()));
    moves.file.push_back(0);
    moves.mode.push_back(0);
    moves.detail.push_back(detail);
    moves.end.push_back(end);
    moves.feed.push_back(10);
    return *this;
  }
};

AxisVector at(double x, double y, double a = 0) {
  AxisVector p = AxisVector::Zero();
  p[0] = x;
  p[1] = y;
  p[3] = a;
  return p;
}

TEST(BuildPath, MovesWithoutLengthVanish) {
  MovesBuilder b;
  b.add(MoveKind::feed, at(3, 4)).add(MoveKind::feed, at(3, 4)).add(MoveKind::feed, at(3, 5));
  const auto path = build_path(b.moves, 0);
  ASSERT_TRUE(path);
  ASSERT_EQ(path->size(), 2u);
  EXPECT_EQ(path->length[0], 5);
  EXPECT_EQ(path->length[1], 1);
  EXPECT_EQ(path->move[1], 2u);
}

TEST(BuildPath, RotaryMovesAreMeasuredInDegrees) {
  MovesBuilder b;
  b.add(MoveKind::feed, at(0, 0, std::numbers::pi / 2));
  const auto path = build_path(b.moves, 0);
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->length[0], 90, 1e-12);
  EXPECT_TRUE(is_rotary_only(*path, 0));
}

TEST(BuildPath, LinearAndRotaryTogetherAreMeasuredAlongXyz) {
  MovesBuilder b;
  b.add(MoveKind::feed, at(0, 2, 1));
  const auto path = build_path(b.moves, 0);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->length[0], 2);
  EXPECT_EQ(start_direction(*path, 0)[3], 0.5);
}

TEST(BuildPath, DwellsAndToolChangesStandAtTheirNode) {
  MovesBuilder b;
  b.moves.dwells = {0.25};
  b.add(MoveKind::feed, at(1, 0)).add(MoveKind::dwell, at(1, 0), 0).add(MoveKind::tool, at(1, 0));
  b.add(MoveKind::feed, at(2, 0)).add(MoveKind::end, at(2, 0));
  const auto path = build_path(b.moves, 4.0);
  ASSERT_TRUE(path);
  ASSERT_EQ(path->pauses.size(), 3u);
  EXPECT_EQ(path->pauses[0].node, 1u);
  EXPECT_EQ(path->pauses[0].duration, 0.25);
  EXPECT_EQ(path->pauses[1].node, 1u);
  EXPECT_EQ(path->pauses[1].duration, 4.0);
  EXPECT_EQ(path->pauses[2].node, 2u);
}

TEST(BuildPath, CoordinatesThatAreNotFiniteAreRefused) {
  MovesBuilder b;
  b.add(MoveKind::feed, at(std::numeric_limits<double>::infinity(), 0));
  const auto path = build_path(b.moves, 0);
  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().code, "path-not-finite");
}

TEST(BuildPath, CanBeCancelled) {
  MovesBuilder b;
  b.add(MoveKind::feed, at(1, 0));
  std::stop_source source;
  source.request_stop();
  const auto path = build_path(b.moves, 0, {source.get_token(), {}});
  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().kind, ErrorKind::cancelled);
}

}  // namespace
}  // namespace toolpace
