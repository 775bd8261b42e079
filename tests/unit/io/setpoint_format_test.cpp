#include "toolpace/io/setpoint_format.h"

#include <set>

#include "planned_program.h"

namespace toolpace {
namespace {

using namespace testing;

TEST(SetpointFormat, IsFoundByItsIdAndBySuffixesInLettersOfAnyCase) {
  std::set<std::string_view> ids, suffixes;
  for (const SetpointFormat& format : setpoint_formats()) {
    EXPECT_EQ(format_named(format.id), &format);
    EXPECT_EQ(format_of("part" + std::string(format.suffix)), &format);
    std::string capital(format.suffix);
    for (char& c : capital) c = static_cast<char>(std::toupper(c));
    EXPECT_EQ(format_of("PART" + capital), &format);
    EXPECT_TRUE(ids.insert(format.id).second && suffixes.insert(format.suffix).second) << format.id;
    EXPECT_NE(setpoint_suffixes().find(format.suffix), std::string::npos);
  }
  EXPECT_EQ(format_of("part"), &setpoint_formats().front());
  EXPECT_EQ(format_of("part.txt"), nullptr);
  EXPECT_EQ(format_named("txt"), nullptr);
}

TEST(SetpointFormat, WhatAnyOfThemWritesIsReadBackAsTheSameMotion) {
  const TemporaryDirectory dir;
  const Outcome outcome = planned(Program().line(10, 0).arc(10, 5, 1.5).line(3, 9, 2), axis_limited_setup());
  Setpoints wanted;
  Sampler(*outcome.path, outcome.plan, outcome.job->program->moves, 0.001).next(wanted, 1 << 20);
  for (const SetpointFormat& format : setpoint_formats()) {
    const auto name = dir / ("part" + std::string(format.suffix));
    write_setpoints(outcome, name);
    auto file = open_setpoint_file(name);
    ASSERT_TRUE(file) << format.id << ": " << file.error().message;
    SetpointRows rows;
    while (true) {
      const auto read = (*file)->read(rows, 1000);
      ASSERT_TRUE(read) << format.id << ": " << read.error().message;
      if (*read == 0) break;
    }
    ASSERT_EQ(rows.count, wanted.size()) << format.id;
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(rows.position[axis], wanted.position[axis]) << format.id;
  }
}

// What is inside decides: a name that promises text may hold an array.
TEST(SetpointFormat, ContentDecidesBeforeTheName) {
  const TemporaryDirectory dir;
  const Outcome outcome = planned(Program().line(10, 0), axis_limited_setup());
  write_setpoints(outcome, dir / "a.npy");
  std::filesystem::rename(dir / "a.npy", dir / "a.halstream");
  const auto file = open_setpoint_file(dir / "a.halstream");
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_TRUE((*file)->columns().profile);
}

}  // namespace
}  // namespace toolpace
