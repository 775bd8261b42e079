/// The columns of each axis are judged by the positions.

#include <fstream>

#include "planned_program.h"

namespace toolpace {
namespace {

using namespace testing;

// By hand, at 1 s: 0, 1, 3 mm is 1 and 2 mm/s in the second and third row, and 1 mm/s² in both, as the machine rested before.
constexpr const char* kHeader = "t_s,x_mm,v_x_mm_s,a_x_mm_s2,j_x_mm_s3\n";
constexpr const char* kRows = "0,0,0,0,0\n1,1,1,1,1\n2,3,2,1,0\n3,3,0,-2,-3\n";

VerifyReport judged(const std::string& text) {
  const TemporaryDirectory dir;
  std::ofstream(dir / "a.csv") << text;
  return verified(dir / "a.csv", Machine{});
}

TEST(AxisColumns, AgreeWithTheDifferencesOfThePositions) {
  const VerifyReport report = judged(std::string(kHeader) + kRows);
  for (const CheckKind kind : {CheckKind::speed_column, CheckKind::acceleration_column, CheckKind::jerk_column}) {
    EXPECT_EQ(check_of(report, kind, 0).value, 0.0) << key_of(kind);
    EXPECT_FALSE(check_of(report, kind, 0).broken) << key_of(kind);
  }
  EXPECT_TRUE(report.notes.size() == 1 && report.notes[0].find("period") != std::string::npos);  // none is passed over
}

TEST(AxisColumns, AreBrokenWhereOneNumberIsAnother) {
  const std::string good = kRows;
  for (const auto& [was, is, kind] : {std::tuple{"2,3,2,1,0", "2,3,2.001,1,0", CheckKind::speed_column},
                                      {"2,3,2,1,0", "2,3,2,1.001,0", CheckKind::acceleration_column},
                                      {"3,3,0,-2,-3", "3,3,0,-2,3", CheckKind::jerk_column}}) {
    std::string rows = good;
    rows.replace(rows.find(was), std::string(was).size(), is);
    const VerifyReport report = judged(kHeader + rows);
    EXPECT_TRUE(check_of(report, kind, 0).broken) << is;
    EXPECT_EQ(check_of(report, kind, 0).row, was[0] - '0') << is;
    EXPECT_FALSE(report.passes());
  }
}

TEST(AxisColumns, WithoutThePositionsOfTheirAxisAreNotJudged) {
  const VerifyReport report = judged("x_mm,v_y_mm_s\n0,0\n0,5\n");
  ASSERT_EQ(report.notes.size(), 1U);
  EXPECT_NE(report.notes[0].find("v_y_mm_s"), std::string::npos);
}

TEST(AxisColumns, OfEveryFormatPassAsTheyAreWritten) {
  Program program;
  program.line(200, 0).rotate(2.0, 1.0).arc(100, 0, 3.0).line(-350, 10, 7);
  SetpointFileOptions options;
  options.axis_derivatives = true;
  for (const double period : {1e-3, 1.0 / 3000, 0.004}) {
    toolpace::Setup setup = axis_limited_setup();
    setup.machine.period = period;
    for (const char* name : {"a.csv", "a.npy", "a.npz", "a.semicolon.csv"}) {
      const TemporaryDirectory dir;
      write_setpoints(planned(program, setup), dir / name, options);
      const VerifyReport report = verified(dir / name, setup.machine, &program.moves(), 1e-6);
      EXPECT_TRUE(report.passes()) << name << ' ' << period << broken(report);
      EXPECT_NO_THROW(check_of(report, CheckKind::jerk_column, 3)) << name;
    }
  }
}

}  // namespace
}  // namespace toolpace
