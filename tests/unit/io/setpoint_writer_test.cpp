#include "toolpace/io/setpoint_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "sample_setpoints.h"
#include "temporary_directory.h"
#include "toolpace/io/setpoint_table.h"

namespace toolpace {
namespace {

using testing::contents;
using testing::sample_setpoints;
using testing::TemporaryDirectory;

std::string written(const Setpoints& setpoints, const std::string& name, SetpointFileOptions options = {}) {
  const TemporaryDirectory dir;
  auto writer = open_setpoint_writer(dir / name, options);
  EXPECT_TRUE(writer) << writer.error().message;
  EXPECT_TRUE((*writer)->write(setpoints));
  EXPECT_TRUE((*writer)->finish());
  return contents(dir / name);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> fields_of(const std::string& line, char separator) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, separator);) fields.push_back(field);
  return fields;
}

TEST(RowClock, ShowsTheNearestDoubleToTheDecimalTime) {
  // 1001 · 0.001 is 1.0009999999999999 in doubles.
  EXPECT_EQ(RowClock(0.001).time(1001), 1.001);
  EXPECT_EQ(RowClock(0.00025).time(3), 0.00075);
  EXPECT_EQ(RowClock(1.0 / 3000).time(2), 2 * (1.0 / 3000));
}

TEST(Csv, HasTheHeaderOfTheContract) {
  EXPECT_EQ(lines_of(written(sample_setpoints(0, 2), "a.csv"))[0], "t_s,x_mm,y_mm,z_mm,v_mm_s,a_mm_s2,j_mm_s3,line");
  EXPECT_EQ(lines_of(written(sample_setpoints(0, 2, true), "a.csv"))[0],
            "t_s,x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,v_mm_s,a_mm_s2,j_mm_s3,line");
}

TEST(Csv, NumbersReadBackToTheSameDoubles) {
  const Setpoints s = sample_setpoints(0, 3000);
  const auto lines = lines_of(written(s, "a.csv"));
  ASSERT_EQ(lines.size(), 3001U);
  for (std::size_t k = 0; k < s.size(); ++k) {
    const auto fields = fields_of(lines[k + 1], ',');
    ASSERT_EQ(fields.size(), 8U);
    const auto number = [&](std::size_t i) { return std::strtod(fields[i].c_str(), nullptr); };
    ASSERT_EQ(number(0), static_cast<double>(k) / 1000);
    for (std::size_t axis = 0; axis < 3; ++axis) ASSERT_EQ(number(1 + axis), s.position[axis][k]);
    ASSERT_EQ(number(4), s.speed[k]);
    ASSERT_EQ(number(5), s.acceleration[k]);
    ASSERT_EQ(number(6), s.jerk[k]);
    ASSERT_EQ(fields[7], std::to_string(s.line[k]));
  }
}

TEST(Csv, IsTheSameWhateverTheChunks) {
  const TemporaryDirectory dir;
  auto writer = open_setpoint_writer(dir / "a.csv");
  ASSERT_TRUE(writer);
  for (std::size_t first = 0; first < 3000; first += 100) ASSERT_TRUE((*writer)->write(sample_setpoints(first, 100)));
  ASSERT_TRUE((*writer)->finish());
  EXPECT_EQ(contents(dir / "a.csv"), written(sample_setpoints(0, 3000), "a.csv"));
}

TEST(Csv, ShowsNoNegativeZero) {
  Setpoints s = sample_setpoints(0, 1);
  s.acceleration[0] = -0.0;
  EXPECT_EQ(fields_of(lines_of(written(s, "a.csv"))[1], ',')[5], "0");
}

TEST(Csv, GivesDerivativesOfEachAxisAsDifferences) {
  Setpoints s = sample_setpoints(0, 3);
  s.position[0] = {0.0, 0.25, 1.0};
  const auto lines = lines_of(written(s, "a.csv", {.axis_derivatives = true}));
  EXPECT_EQ(lines[0],
            "t_s,x_mm,y_mm,z_mm,v_mm_s,a_mm_s2,j_mm_s3,v_x_mm_s,v_y_mm_s,v_z_mm_s,a_x_mm_s2,a_y_mm_s2,a_z_mm_s2,"
            "j_x_mm_s3,j_y_mm_s3,j_z_mm_s3,line");
  const auto fields = fields_of(lines[3], ',');
  // By hand: steps of 0.25 and 0.75 in 1 ms are 250 and 750 mm/s; 250 -> 750 mm/s in 1 ms is 5e5 mm/s2, after 2.5e5.
  EXPECT_DOUBLE_EQ(std::strtod(fields[7].c_str(), nullptr), 750.0);
  EXPECT_DOUBLE_EQ(std::strtod(fields[10].c_str(), nullptr), 5e5);
  EXPECT_NEAR(std::strtod(fields[13].c_str(), nullptr), 2.5e8, 1e-6);
}

// B = 90° in the head lays a tool of 100 mm down: the tip is 100 mm towards −X, and as much above where it hung.
TEST(Csv, ShowsWhereTheTipIs) {
  Setpoints s = sample_setpoints(0, 1);
  for (auto& axis : s.position) axis = {0.0};
  s.position[4] = {90 * kRadiansPerDegree};
  const Chain head{{{4, ChainSide::head, Eigen::Vector3d::UnitY(), Eigen::Vector3d::Zero()}}, 100};
  const auto lines = lines_of(written(s, "a.csv", {.tip_of = head}));
  EXPECT_EQ(lines[0], "t_s,x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,v_mm_s,a_mm_s2,j_mm_s3,tip_x_mm,tip_y_mm,tip_z_mm,line");
  const auto fields = fields_of(lines[1], ',');
  EXPECT_NEAR(std::strtod(fields[10].c_str(), nullptr), -100, 1e-12);
  EXPECT_NEAR(std::strtod(fields[12].c_str(), nullptr), 100, 1e-12);
  const TemporaryDirectory dir;
  for (const char* name : {"a.npy", "a.npz", "a.halstream"}) {
    const auto writer = open_setpoint_writer(dir / name, {.tip_of = head});
    ASSERT_FALSE(writer) << name;
    EXPECT_EQ(writer.error().code, "setpoint-columns-unnamed");
  }
}

TEST(Semicolon, WritesDecimalCommasByChoice) {
  Setpoints s = sample_setpoints(0, 1);
  s.position[2][0] = -5.5;
  EXPECT_EQ(fields_of(lines_of(written(s, "a.semicolon.csv"))[1], ';')[3], "-5.5");
  const auto text = written(s, "a.csv", {.format = format_named("semicolon"), .decimal_comma = true});
  EXPECT_EQ(fields_of(lines_of(text)[1], ';')[3], "-5,5");
}

TEST(Halstream, HasOnePositionARowAndNoHeader) {
  Setpoints s = sample_setpoints(0, 2, true);
  s.position[0] = {1.5, 2.0};
  s.position[1] = {0.25, -1.0};
  s.position[4] = {0.0, std::numbers::pi / 2};
  EXPECT_EQ(written(s, "a.halstream"), "1.5 0.25 -5 0 0 0\n2 -1 -5 0 90 0\n");
}

TEST(SetpointWriter, RefusesWhatNoMachineCanRun) {
  const TemporaryDirectory dir;
  auto writer = open_setpoint_writer(dir / "a.csv");
  Setpoints bad = sample_setpoints(0, 5);
  bad.position[1][3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ((*writer)->write(bad).error().code, "setpoint-not-finite");
  Setpoints gap = sample_setpoints(3, 5);
  ASSERT_TRUE((*writer)->write(sample_setpoints(0, 2)));
  EXPECT_EQ((*writer)->write(gap).error().code, "setpoint-rows");
  Setpoints ragged = sample_setpoints(2, 5);
  ragged.jerk.pop_back();
  EXPECT_EQ((*writer)->write(ragged).error().code, "setpoint-columns");
}

// 1e307 rad are 5.7e308°, which no double holds; nor does one hold 1e300 mm a millisecond three times over.
TEST(SetpointWriter, RefusesWhatIsFiniteHereAndNotInTheFile) {
  const TemporaryDirectory dir;
  Setpoints turned = sample_setpoints(0, 2, true);
  turned.position[5] = {0.0, 1e307};
  EXPECT_EQ((*open_setpoint_writer(dir / "a.npy"))->write(turned).error().code, "setpoint-not-finite");
  Setpoints far = sample_setpoints(0, 2);
  far.position[0] = {0.0, 1e300};
  EXPECT_TRUE((*open_setpoint_writer(dir / "a.csv"))->write(far));
  const auto differences = open_setpoint_writer(dir / "d.csv", {.axis_derivatives = true});
  EXPECT_EQ((*differences)->write(far).error().code, "setpoint-not-finite");
}

TEST(SetpointWriter, RefusesAnUnknownExtension) {
  const auto writer = open_setpoint_writer("out.xlsx");
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().kind, ErrorKind::usage);
  EXPECT_EQ(writer.error().code, "setpoint-format-unknown");
}

TEST(SetpointWriter, LeavesNothingBehindWhenAbandoned) {
  const TemporaryDirectory dir;
  for (const char* name : {"a.csv", "a.npy", "a.npz", "a.halstream"}) {
    auto writer = open_setpoint_writer(dir / name);
    ASSERT_TRUE(writer);
    ASSERT_TRUE((*writer)->write(sample_setpoints(0, 50000)));
  }
  EXPECT_EQ(dir.entries(), 0U);
}

}  // namespace
}  // namespace toolpace
