#include "toolpace/verify/setpoint_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "sample_setpoints.h"
#include "temporary_directory.h"
#include "toolpace/io/setpoint_reader.h"
#include "toolpace/io/setpoint_writer.h"

namespace toolpace {
namespace {

using testing::sample_setpoints;
using testing::TemporaryDirectory;

SetpointRows read_back(const std::filesystem::path& file) {
  auto opened = open_setpoint_file(file);
  EXPECT_TRUE(opened) << opened.error().message;
  SetpointRows rows;
  while ((*opened)->read(rows, 700).value() > 0) {
  }
  return rows;
}

std::string code_of(const TemporaryDirectory& dir, const std::string& name, const std::string& text) {
  std::ofstream(dir / name, std::ios::binary) << text;
  auto opened = open_setpoint_file(dir / name);
  if (!opened) return opened.error().code;
  SetpointRows rows;
  const auto read = (*opened)->read(rows, 1000);
  return read ? "fine" : read.error().code;
}

class Formats : public ::testing::TestWithParam<const char*> {};

TEST_P(Formats, ReadBackToTheSameNumbers) {
  const TemporaryDirectory dir;
  const Setpoints s = sample_setpoints(0, 3000, true);
  auto writer = open_setpoint_writer(dir / GetParam(), {.decimal_comma = true});
  ASSERT_TRUE((*writer)->write(s));
  ASSERT_TRUE((*writer)->finish());
  const SetpointRows rows = read_back(dir / GetParam());
  const bool positions_only = rows.time.empty();
  EXPECT_EQ(positions_only, std::string(GetParam()) == "a.halstream");
  ASSERT_EQ(rows.count, s.size());
  EXPECT_EQ(rows.position[0], s.position[0]);
  EXPECT_EQ(rows.position[2], s.position[2]);
  for (std::size_t k = 0; k < s.size(); ++k) ASSERT_NEAR(rows.position[4][k], s.position[4][k], 1e-15);
  if (positions_only) return;
  EXPECT_EQ(rows.speed, s.speed);
  EXPECT_EQ(rows.jerk, s.jerk);
  if (std::string(GetParam()) == "a.npy") return;
  EXPECT_EQ(rows.line, s.line);
}

INSTANTIATE_TEST_SUITE_P(All, Formats, ::testing::Values("a.csv", "a.npy", "a.npz", "a.halstream", "a.semicolon.csv"));

TEST(SetpointFile, TakesColumnsInAnyOrderAndIgnoresOthers) {
  const TemporaryDirectory dir;
  std::ofstream(dir / "a.csv") << "y_mm,colour,x_mm\r\n1,7,2\r\n3,7,4\r\n";
  const SetpointRows rows = read_back(dir / "a.csv");
  EXPECT_EQ(rows.position[0], (std::vector<double>{2, 4}));
  EXPECT_EQ(rows.position[1], (std::vector<double>{1, 3}));
  EXPECT_TRUE(rows.position[2].empty());
}

TEST(SetpointFile, TakesWhatSpreadsheetsAndHandsLeaveInText) {
  const TemporaryDirectory dir;
  std::ofstream(dir / "a.csv") << "\xEF\xBB\xBF"
                               << "t_s, x_mm, note, line\r\n0, 1, 5, 7\r\n0.001, 2, 6, 8\r\n\r\n\r\n";
  auto opened = open_setpoint_file(dir / "a.csv");
  ASSERT_TRUE(opened);
  EXPECT_TRUE((*opened)->columns().time);
  EXPECT_EQ((*opened)->columns().ignored, std::vector<std::string>{"note"});
  SetpointRows rows;
  ASSERT_EQ((*opened)->read(rows, 10), 2U);
  EXPECT_EQ(rows.position[0], (std::vector<double>{1, 2}));
  EXPECT_EQ(rows.line, (std::vector<std::uint32_t>{7, 8}));
}

/// A header of version 1 and zeros.
std::string numpy_array(const std::string& type, const std::string& order, const std::string& shape,
                        std::size_t bytes) {
  const std::string header = "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }\n";
  std::string file = "\x93NUMPY\x01";
  file += '\0';
  file += static_cast<char>(header.size());
  file += '\0';
  return file + header + std::string(bytes, '\0');
}

TEST(SetpointFile, SaysWhatIsForeignInAnArray) {
  const TemporaryDirectory dir;
  const auto message = [&](const std::string& content) {
    std::ofstream(dir / "a.npy", std::ios::binary) << content;
    auto opened = open_setpoint_file(dir / "a.npy");
    return opened ? std::string("fine") : opened.error().message;
  };
  EXPECT_EQ(message(numpy_array("<f8", "False", "(3, 7)", 3 * 7 * 8)), "fine");
  EXPECT_NE(message(numpy_array(">f8", "False", "(3, 7)", 3 * 7 * 8)).find("\">f8\""), std::string::npos);
  EXPECT_NE(message(numpy_array("<f4", "False", "(3, 7)", 3 * 7 * 4)).find("\"<f4\""), std::string::npos);
  EXPECT_NE(message(numpy_array("<f8", "True", "(3, 7)", 3 * 7 * 8)).find("Fortran"), std::string::npos);
  EXPECT_NE(message(numpy_array("<f8", "False", "(21,)", 3 * 7 * 8)).find("1 dimensions"), std::string::npos);
  EXPECT_NE(message(numpy_array("<f8", "False", "(3, 7)", 2 * 7 * 8)).find("cut short"), std::string::npos);
  EXPECT_NE(message(numpy_array("<f8", "False", "(3, 5)", 3 * 5 * 8)).find("7 or 10 columns"), std::string::npos);
  EXPECT_NE(message(numpy_array("<f8", "False", "(3, 7)", 3 * 7 * 8 + 5)).find("5 bytes stand behind"),
            std::string::npos);
  EXPECT_NE(message(numpy_array("<f8", "False", "(3, 7)", 4 * 7 * 8)).find("56 bytes stand behind"), std::string::npos);
  std::string newer = numpy_array("<f8", "False", "(3, 7)", 3 * 7 * 8);
  newer[6] = 4;
  EXPECT_NE(message(newer).find("version 4.0"), std::string::npos);
  newer[6] = 1;
  newer[7] = 1;
  EXPECT_NE(message(newer).find("version 1.1"), std::string::npos);
}

TEST(SetpointFile, NamesThePlaceOfABrokenNumber) {
  const TemporaryDirectory dir;
  std::ofstream(dir / "a.csv") << "t_s,x_mm\n0,1\n0.001,1e400\n";
  auto opened = open_setpoint_file(dir / "a.csv");
  SetpointRows rows;
  const auto read = (*opened)->read(rows, 10);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, "setpoints-broken");
  EXPECT_EQ(read.error().where.line, 3U);
  EXPECT_EQ(read.error().where.column, 7U);
}

TEST(SetpointFile, RefusesWhatIsNoSetpointFile) {
  const TemporaryDirectory dir;
  EXPECT_EQ(open_setpoint_file(dir / "none.csv").error().code, "file-not-found");
  EXPECT_EQ(open_setpoint_file(dir.path()).error().code, "is-directory");
  EXPECT_EQ(code_of(dir, "a.csv", ""), "setpoints-empty");
  EXPECT_EQ(code_of(dir, "a.csv", "hello\n"), "setpoints-header");
  EXPECT_EQ(code_of(dir, "a.csv", "x_mm,x_mm\n1,2\n"), "setpoints-header");
  EXPECT_EQ(code_of(dir, "a.csv", "x_mm\nnan\n"), "setpoints-broken");
  EXPECT_EQ(code_of(dir, "a.csv", "x_mm,y_mm\n1\n"), "setpoints-broken");
  EXPECT_EQ(code_of(dir, "a.csv", "x_mm\n1,2\n"), "setpoints-broken");
  EXPECT_EQ(code_of(dir, "a.csv", "x_mm,line\n1,2.5\n"), "setpoints-broken");
  EXPECT_EQ(code_of(dir, "a.csv", "x_mm\n1\n\n2\n"), "setpoints-broken");
  EXPECT_EQ(code_of(dir, "a.npy", "\x93NUMPY"), "setpoints-shape");
  EXPECT_EQ(code_of(dir, "a.npz", "PK\x03\x04 and no more"), "setpoints-broken");
}

TEST(SetpointFile, RefusesArraysThatAreCutShort) {
  const TemporaryDirectory dir;
  for (const char* name : {"a.npy", "a.npz"}) {
    auto writer = open_setpoint_writer(dir / name);
    ASSERT_TRUE((*writer)->write(sample_setpoints(0, 100)));
    ASSERT_TRUE((*writer)->finish());
    const std::string whole = testing::contents(dir / name);
    for (std::size_t keep = 0; keep + 1 < whole.size(); keep += 61) {
      ASSERT_NE(code_of(dir, "cut", whole.substr(0, keep)), "fine") << name << " cut at " << keep;
    }
  }
}

TEST(SetpointFile, RefusesAnArchiveWhoseBytesAreNotThoseThatWereWritten) {
  const TemporaryDirectory dir;
  auto writer = open_setpoint_writer(dir / "a.npz");
  ASSERT_TRUE((*writer)->write(sample_setpoints(0, 40)));
  ASSERT_TRUE((*writer)->finish());
  const std::string whole = testing::contents(dir / "a.npz");
  ASSERT_EQ(code_of(dir, "same", whole), "fine");
  // Every entry is stored as it is: behind its header of 128 bytes stand its values.
  std::size_t tried = 0;
  for (std::size_t entry = whole.find("\x93NUMPY"); entry != std::string::npos;
       entry = whole.find("\x93NUMPY", entry + 1)) {
    for (std::size_t at = entry + 128; at < entry + 128 + 40 * 8; at += 37, ++tried) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ 1);
      ASSERT_EQ(code_of(dir, "damaged", damaged), "setpoints-broken") << at;
    }
  }
  EXPECT_EQ(tried, 3U * 9U);
}

TEST(SetpointFile, ReadsAgainFromTheFirstRow) {
  const TemporaryDirectory dir;
  for (const char* name : {"a.csv", "a.npy", "a.npz", "a.halstream"}) {
    auto writer = open_setpoint_writer(dir / name);
    ASSERT_TRUE((*writer)->write(sample_setpoints(0, 5000)));
    ASSERT_TRUE((*writer)->finish());
    auto file = open_setpoint_file(dir / name);
    ASSERT_TRUE(file);
    SetpointRows part, whole;
    ASSERT_EQ((*file)->read(part, 3001), 3001U);
    (*file)->rewind();
    EXPECT_EQ((*file)->read(whole, 10000), 5000U) << name;
    EXPECT_EQ((*file)->read(whole, 10000), 0U) << name;
    part.position[0].resize(3001);
    EXPECT_TRUE(std::equal(part.position[0].begin(), part.position[0].end(), whole.position[0].begin())) << name;
  }
}

TEST(SetpointFile, SaysThatAFileWasChangedWhileItWasRead) {
  const TemporaryDirectory dir;
  for (const char* name : {"a.csv", "a.npy", "a.npz", "a.halstream"}) {
    auto writer = open_setpoint_writer(dir / name);
    ASSERT_TRUE((*writer)->write(sample_setpoints(0, 50000)));
    ASSERT_TRUE((*writer)->finish());
    const auto read_on = [](SetpointFile& file) -> std::string {
      SetpointRows rows;
      for (;;) {
        const auto count = file.read(rows, 4096);
        if (!count) return count.error().code;
        if (*count == 0) return "fine";
      }
    };
    auto shrinking = open_setpoint_file(dir / name);
    SetpointRows first;
    ASSERT_EQ((*shrinking)->read(first, 10), 10U);
    std::filesystem::resize_file(dir / name, std::filesystem::file_size(dir / name) / 2);
    EXPECT_EQ(read_on(**shrinking), "file-changed") << name;
  }
  std::ofstream(dir / "b.csv") << "x_mm\n1\n2\n";
  auto growing = open_setpoint_file(dir / "b.csv");
  std::ofstream(dir / "b.csv", std::ios::app) << "3\n";
  SetpointRows rows;
  EXPECT_EQ((*growing)->read(rows, 10).error().code, "file-changed");
}

TEST(SetpointFile, TellsOfWhichPlanItIsInNpz) {
  const TemporaryDirectory dir;
  const auto told = [&](const SetpointOrigin& origin, const std::string& program) {
    SetpointFileOptions options;
    options.program_name = program;
    auto writer = open_setpoint_writer(dir / "a.npz", options);
    EXPECT_TRUE((*writer)->write(sample_setpoints(0, 10)));
    (*writer)->tell_origin(origin);
    EXPECT_TRUE((*writer)->finish());
    auto file = open_setpoint_file(dir / "a.npz");
    EXPECT_TRUE(file);
    return (*file)->origin();
  };
  CornerOptions corner;
  corner.rule = CornerRule::junction;
  corner.step = 12.5;
  corner.junction_deviation = 0.03;
  const SetpointOrigin origin = told({"trapezoid", corner, true, "zvd"}, "\", \"law\": \"x\", [{ \\ ä");
  EXPECT_EQ(origin.law, "trapezoid");
  ASSERT_TRUE(origin.corner);
  EXPECT_EQ(origin.corner->rule, CornerRule::junction);
  EXPECT_EQ(origin.corner->step, 12.5);
  EXPECT_EQ(origin.corner->junction_deviation, 0.03);
  EXPECT_TRUE(origin.has_path_control);
  EXPECT_EQ(origin.shaper, "zvd");
  corner.step = std::numeric_limits<double>::infinity();
  EXPECT_GT(*told({"quintic", corner, false, ""}, "").corner->step, 1e12);
  const SetpointOrigin nothing = told({}, "part.ngc");
  EXPECT_TRUE(nothing.law.empty() && !nothing.corner && nothing.shaper.empty());
}

TEST(SetpointFile, TakesEmptyLinesAtItsEndAloneAndNoLineWithoutEnd) {
  const TemporaryDirectory dir;
  EXPECT_EQ(code_of(dir, "a.csv", "x_mm\n1\n2"), "fine");
  EXPECT_EQ(code_of(dir, "a.csv", "x_mm\r\n1\r\n2\r\n\r\n\n"), "fine");
  EXPECT_EQ(code_of(dir, "a.csv", "x_mm\n1\n\n\n2\n"), "setpoints-broken");
  EXPECT_EQ(code_of(dir, "a.csv", "x_mm\n" + std::string(3 << 20, '1')), "setpoints-broken");
  // A line that lies across the pieces in which the file is read.
  std::string text = "x_mm,y_mm\n";
  for (int row = 0; row < 100000; ++row) text += std::to_string(row) + ",0.25\n";
  std::ofstream(dir / "long.csv") << text;
  const SetpointRows rows = read_back(dir / "long.csv");
  ASSERT_EQ(rows.count, 100000U);
  for (std::size_t row = 0; row < rows.count; ++row) ASSERT_EQ(rows.position[0][row], static_cast<double>(row));
}

}  // namespace
}  // namespace toolpace
