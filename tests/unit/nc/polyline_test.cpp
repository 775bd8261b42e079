#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

Reading read_rows(const std::string& text) { return read_program(text, {}, "path.csv"); }

TEST(Polyline, TheFirstRowIsTheStartAndFeedsBelongToTheMoveThatEndsThere) {
  const auto reading = read_rows("x_mm,y_mm,z_mm,feed_mm_min\n1,2,3,\n4,5,6,600\n7,8,9,1200\n");
  const Moves& m = reading.moves;
  EXPECT_FALSE(reading.refused);
  EXPECT_EQ(m.start[0], 1.0);
  ASSERT_EQ(m.size(), 2u);
  EXPECT_EQ(xyz(m, 1), (Values{7.0, 8.0, 9.0}));
  EXPECT_EQ(m.feed, (Values{10.0, 20.0}));  // mm/s
  EXPECT_EQ(m.line[0], 3u);
}

TEST(Polyline, ColumnsMayBeFewerAndInAnyOrder) {
  const auto reading = read_rows("c, x_mm\n0,0\n90,1\n");
  ASSERT_EQ(reading.moves.size(), 1u);
  EXPECT_NEAR(reading.moves.end[0][5], std::acos(0.0), 1e-15);
  EXPECT_EQ(reading.moves.end[0][0], 1.0);
  EXPECT_TRUE(std::isinf(reading.moves.feed[0])) << "no feed column: as fast as the machine allows";
}

TEST(Polyline, OnStandardInputIsKnownByItsHeader) {
  EXPECT_EQ(read_program("y_mm,x_mm\n0,0\n3,4\n", {}, "-").moves.end[0][0], 4.0);
  EXPECT_EQ(read_program("\n feed_mm_min;x_mm\n;0\n60;4\n", {}, "-").moves.end[0][0], 4.0);
  EXPECT_TRUE(has_code(read_program("x5\ny3\n", {}, "-"), "axes-without-motion")) << "an NC program";
  EXPECT_EQ(read_program("x_mm,y_mm\n0,0\n3,4\n", {}, "path.ngc").refused, true);
}

TEST(Polyline, PlacesThatNoMachineReachesAreRefused) {
  EXPECT_EQ(codes(read_rows("x_mm,y_mm\n0,0\n1e249,1\n")), (Codes{"coordinate-too-large@3:1"}));
  EXPECT_EQ(codes(read_rows("x_mm,y_mm\n0,-2e9\n1,1\n")), (Codes{"coordinate-too-large@2:1"}));
  EXPECT_EQ(codes(read_rows("x_mm,y_mm\n0,0\n1e9,1\n")), Codes{});
}

TEST(Polyline, FaultsHaveLineAndColumn) {
  EXPECT_EQ(codes(read_rows("x_mm,y_mm\n0,0\n1,nan\n2,1e400\n3\n4,5,6\n7,x\n")),
            (Codes{"number-not-finite@3:3", "number-not-finite@4:3", "value-missing@5:2", "too-many-values@6:5",
                   "number-expected@7:3"}));
  EXPECT_EQ(codes(read_rows("1,2\n3,4\n")), (Codes{"header-missing@1:1"}));
  EXPECT_EQ(codes(read_rows("x_mm,x_mm\n3,4\n")), (Codes{"column-twice@1:6"}));
  EXPECT_EQ(codes(read_rows("x_mm,feed_mm_min\n0,0\n1,0\n")), (Codes{"no-feed@3:1"}));
  EXPECT_EQ(codes(read_rows("x_mm\n")), (Codes{"no-points@1:0"}));
}

TEST(Polyline, NumbersTooSmallToHoldAreZero) {
  const auto reading = read_rows("x_mm\n0\n1e-400\n");
  ASSERT_EQ(reading.moves.size(), 1u);
  EXPECT_EQ(reading.moves.end[0][0], 0.0);
}

}  // namespace
}  // namespace toolpace::nc
