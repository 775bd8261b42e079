/// Traces as scopes write them.

#include "toolpace/trace/trace_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>

#include "toolpace/trace/trace.h"

namespace toolpace {
namespace {

class TraceFiles : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& text) {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::temp_directory_path() / (std::string("toolpace_trace_") + info->name());
    std::ofstream(path_, std::ios::binary) << text;
    return path_;
  }
  void TearDown() override { std::filesystem::remove(path_); }

  /// Rows of an open file, or its first error.
  Result<TraceRows> rows_of(const std::string& text, const TraceOptions& options = {}) {
    auto open = TraceFile::open(file(text), options);
    if (!open) return tl::unexpected(open.error());
    TraceRows rows;
    for (;;) {
      auto taken = open->read(rows, 2);
      if (!taken) return tl::unexpected(taken.error());
      if (*taken == 0) return rows;
    }
  }
  Error error_of(const std::string& text, const TraceOptions& options = {}) {
    auto rows = rows_of(text, options);
    EXPECT_FALSE(rows);
    return rows ? Error{} : rows.error();
  }

  std::filesystem::path path_;
};

using Values = std::vector<double>;

TraceOptions mapped(std::string_view text) {
  TraceOptions options;
  options.columns = parse_trace_mapping(text).value();
  return options;
}

TEST_F(TraceFiles, OfSimulateHaveBothPositionsOfAnAxis) {
  const auto rows = rows_of(
      "t_s,x_mm,a_deg,actual_x_mm,actual_a_deg,lag_mm,contour_error_mm,line\n0,1,180,0.5,90,9,8,1\n0.001,2,0,1.5,0,9,8,"
      "2\n");
  ASSERT_TRUE(rows) << rows.error().message;
  EXPECT_EQ(rows->time, (Values{0, 0.001}));
  EXPECT_EQ(rows->commanded[0], (Values{1, 2}));
  EXPECT_EQ(rows->actual[0], (Values{0.5, 1.5}));
  EXPECT_NEAR(rows->actual[3][0], std::numbers::pi / 2, 1e-15);
  EXPECT_TRUE(rows->actual[1].empty());
}

TEST_F(TraceFiles, MayHaveAnySeparatorAndDecimalMark) {
  for (const char* text :
       {"t_ms;x_mm\n1,5;2,25\n2,5;3\n", "t_ms\tx_mm\n1,5\t2,25\n2,5\t3\n", "t_ms,x_mm\n1.5,2.25\n2.5,3\n",
        "\xEF\xBB\xBFt_ms | x_mm\r\n1.5 | 2.25\r\n2.5 | 3\r\n", "# t_ms x_mm\n  1.5   2.25\n2.5\t3\n",
        "\"t_ms\";\"x_mm\"\n\"1,5\";\"2,25\"\n\"2,5\";\"3\"\n"}) {
    const auto rows = rows_of(text);
    ASSERT_TRUE(rows) << text << rows.error().message;
    EXPECT_EQ(rows->time, (Values{0.0015, 0.0025})) << text;
    EXPECT_EQ(rows->actual[0], (Values{2.25, 3})) << text;
  }
}

TEST_F(TraceFiles, OfTwinCatScopeHaveATimeBesideEachChannel) {
  const auto rows = rows_of(
      "Name\tYT Scope.tcscopex\nFile\tC:\\scope\nStarttime of export\t132\t02.05.2022\n\n"
      "Name\tAxis 1.ActPos\tName\tAxis 2.SetPos\tName\tAxis "
      "2.ActPos\nData-Type\tREAL64\tData-Type\tREAL64\tData-Type\tREAL64\n"
      "SampleTime[ms]\t2\tSampleTime[ms]\t2\tSampleTime[ms]\t2\nUnit\tmm\tUnit\tum\tUnit\tmm\n\n"
      "0\t1,5\t0\t7000\t0\t6,5\n2\t1,75\t2\t8000\t2\t7,5\nEOF\n");
  ASSERT_TRUE(rows) << rows.error().message;
  EXPECT_EQ(rows->time, (Values{0, 0.002}));
  EXPECT_EQ(rows->actual[0], (Values{1.5, 1.75}));
  EXPECT_EQ(rows->commanded[1], (Values{7, 8}));
  EXPECT_EQ(rows->actual[1], (Values{6.5, 7.5}));
}

TEST_F(TraceFiles, OfHalsamplerAreAxesInTheirOrder) {
  TraceOptions options;
  options.step = 0.002;
  const auto tagged = rows_of("10 1.5 2.5\n11 1.6 2.5\n12 1.8 2.5\n", options);
  ASSERT_TRUE(tagged) << tagged.error().message;
  EXPECT_EQ(tagged->time, (Values{0.02, 0.022, 0.024}));
  EXPECT_EQ(tagged->actual[1], (Values{2.5, 2.5, 2.5}));
  const auto plain = rows_of("1.5 2.5 \n1.6 2.5 \n1.8 2.5 \n", options);
  ASSERT_TRUE(plain) << plain.error().message;
  EXPECT_EQ(plain->time, (Values{0, 0.002, 0.004}));
  EXPECT_EQ(plain->actual[0], (Values{1.5, 1.6, 1.8}));
  EXPECT_EQ(error_of("1.5 2.5\n1.6 2.5\n1.8 2.5\n").code, "trace-time");
  const Error lost = error_of("10 1.5 2.5\n11 1.6 2.5\noverrun\n15 1.8 2.5\n", options);
  EXPECT_EQ(lost.code, "trace-gap");
  EXPECT_EQ(lost.where.line, 3u);
}

TEST_F(TraceFiles, HaveColumnsThatAreGuessedFromTheirNames) {
  struct Case {
    const char* name;
    TraceRole role;
    std::size_t axis;
  };
  for (const Case& c :
       {Case{"joint.1.motor-pos-fb", TraceRole::actual, 1}, Case{"axis.z.pos-cmd", TraceRole::commanded, 2},
        Case{"joint.0.f-error", TraceRole::ignored, 0}, Case{"Axis 2.ActPos", TraceRole::actual, 1},
        Case{"Istposition X [mm]", TraceRole::actual, 0}, Case{"v_x_mm_s", TraceRole::ignored, 0},
        Case{"a_mm_s2", TraceRole::ignored, 0}, Case{"posY", TraceRole::position, 1},
        Case{"Time (ms)", TraceRole::time, 0}, Case{"encoder_b_deg", TraceRole::actual, 4},
        Case{"torque X", TraceRole::ignored, 0}, Case{"line", TraceRole::ignored, 0}}) {
    const TraceColumn column = guess_column(c.name, "");
    EXPECT_EQ(column.role, c.role) << c.name;
    EXPECT_EQ(column.axis, c.axis) << c.name;
  }
  EXPECT_EQ(guess_column("x", "um").unit, 1e-3);
  EXPECT_EQ(guess_column("t", "us").unit, 1e-6);
}

TEST_F(TraceFiles, HaveColumnsThatAreTold) {
  const char* text = "a,b,c\n0,1,2\n1,3,5\n";
  const auto rows = rows_of(text, mapped("t=a[ms],y=3[um],commanded_y=b"));
  ASSERT_TRUE(rows) << rows.error().message;
  EXPECT_EQ(rows->time, (Values{0, 0.001}));
  EXPECT_EQ(rows->actual[1], (Values{0.002, 0.005}));
  EXPECT_EQ(rows->commanded[1], (Values{1, 3}));
  const Error none = error_of(text, mapped("t=a,x=d"));
  EXPECT_EQ(none.code, "trace-columns");
  EXPECT_NE(none.remedy.find("2 'b'"), std::string::npos) << none.remedy;
  EXPECT_EQ(error_of(text, mapped("t=a,x=b[kg]")).code, "trace-columns");
  for (const char* bad : {"t", "t=", "q=3", "x=1,,y=2"}) EXPECT_FALSE(parse_trace_mapping(bad)) << bad;
}

TEST_F(TraceFiles, ThatAreBrokenAreToldWithLineAndColumn) {
  const Error word = error_of("t_s,x_mm\n0,1\n0.1,2\n0.2,off\n");
  EXPECT_EQ(word.code, "trace-broken");
  EXPECT_EQ(word.where.line, 4u);
  EXPECT_EQ(word.where.column, 5u);
  EXPECT_EQ(error_of("t_s,x_mm\n0,1\n0.1,2\n0.2,3mm\n").code, "trace-broken");
  EXPECT_EQ(error_of("t_s,x_mm\n0,1\n0.1,2\n0.2\n").code, "trace-broken");
  EXPECT_EQ(error_of("t_s,x_mm\n0,1\n0.1,2\n0.2,inf\n").code, "trace-number");
  EXPECT_EQ(error_of("t_s,x_mm\n0,1\n0.1,2\n\n0.2,3\n").code, "trace-gap");
  EXPECT_EQ(error_of("").code, "trace-empty");
  EXPECT_EQ(error_of("buy milk\n").code, "trace-broken");
  EXPECT_EQ(error_of("t_s,load\n0,1\n0.1,2\n").code, "trace-columns");
}

TEST_F(TraceFiles, WhoseTimesMakeNoSenseAreRefused) {
  const auto with = [](std::size_t odd, double time) {
    std::string text = "t_s,x_mm\n";
    for (std::size_t i = 0; i < 50; ++i)
      text += std::to_string(i == odd ? time : static_cast<double>(i) * 0.001 + (i > odd && time > 1 ? 5 : 0)) + ",1\n";
    return text;
  };
  EXPECT_TRUE(read_trace(file(with(99, 0)), {}));
  EXPECT_NEAR(read_trace(file(with(99, 0)), {})->step, 0.001, 1e-12);
  const auto still = read_trace(file(with(20, 0.019)), {});
  ASSERT_FALSE(still);
  EXPECT_EQ(still.error().code, "trace-time");
  EXPECT_EQ(still.error().where.line, 22u);
  const auto gap = read_trace(file(with(20, 5.02)), {});
  ASSERT_FALSE(gap);
  EXPECT_EQ(gap.error().code, "trace-gap");
  EXPECT_EQ(gap.error().where.line, 22u);
  const auto few = read_trace(file("t_s,x_mm\n0,1\n0.1,2\n0.2,3\n"), {});
  ASSERT_FALSE(few);
  EXPECT_EQ(few.error().code, "trace-short");
}

}  // namespace
}  // namespace toolpace
