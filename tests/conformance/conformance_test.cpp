/// The programs of programs/, each against the table that the field's reference interpreter makes of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "motion_table.h"
#include "places.h"
#include "temporary_directory.h"
#include "toolpace/io/block_writer.h"
#include "toolpace/nc/reader.h"

namespace toolpace {
namespace {

using testing::TemporaryDirectory;

std::filesystem::path programs_dir() { return test::source_dir() / "tests/conformance/programs"; }

std::vector<std::string> program_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(programs_dir())) {
    if (entry.path().extension() == ".ngc") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class Conformance : public ::testing::TestWithParam<std::string> {};

// Programs whose names end in _error must be refused, at the same line and after the same motion.
TEST_P(Conformance, MotionAndRefusalsAreThoseOfTheReferenceInterpreter) {
  const std::filesystem::path program = programs_dir() / (GetParam() + ".ngc");
  ReadOptions options;
  options.tools = programs_dir() / "tools.tbl";
  options.block_delete = testing::contents(program).find("(ARGS: --block-delete)") != std::string::npos;
  const auto reading = read_file(program, options);
  ASSERT_TRUE(reading) << reading.error().message;
  EXPECT_EQ(reading->refused, GetParam().ends_with("_error"));
  const TemporaryDirectory folder;
  ASSERT_TRUE(write_blocks(folder / "found.csv", *reading));
  EXPECT_EQ(test::differences(test::read_motion_table(programs_dir() / (GetParam() + ".expected.csv")),
                              test::read_motion_table(folder / "found.csv")),
            "");
}

INSTANTIATE_TEST_SUITE_P(Programs, Conformance, ::testing::ValuesIn(program_names()),
                         [](const auto& row) { return row.param; });

TEST(ConformancePrograms, AreAllHere) { EXPECT_EQ(program_names().size(), 63u); }

// The comparison itself: each fact that is changed in a table is told.
TEST(MotionTable, TellsEveryFactThatDiffers) {
  const auto rows = test::read_motion_table(programs_dir() / "08_planes_g18_g19.expected.csv");
  EXPECT_EQ(test::differences(rows, rows), "");
  ASSERT_EQ(rows[1].at("kind"), "arc");
  const std::array changes = {std::pair{"kind", "feed"}, std::pair{"line", "99"},   std::pair{"path", "G61"},
                              std::pair{"plane", "G17"}, std::pair{"fmode", "G95"}, std::pair{"z", "0.000003"},
                              std::pair{"feed", ""},     std::pair{"cx", "9.9999"}, std::pair{"ny", "-1"},
                              std::pair{"sweep", "90"},  std::pair{"tol", "0.01"}};
  for (const auto& [column, value] : changes) {
    auto changed = rows;
    changed[1][column] = value;
    const std::string told = test::differences(rows, changed);
    EXPECT_EQ(told.find("row 2 (line 7): " + std::string(column) + " is \"" + value + "\", not "), 0u) << told;
  }
  EXPECT_EQ(test::differences(rows, {rows.begin(), rows.end() - 1}), "5 rows, not 6\n");
}

}  // namespace
}  // namespace toolpace
