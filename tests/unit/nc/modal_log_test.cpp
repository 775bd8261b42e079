#include "toolpace/nc/modal_log.h"

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

TEST(ModalLog, TellsWhatIsActiveAtEveryLine) {
  const auto reading = read_program("(title)\nG20 G91 F10\nT3 M6\nS500 M3\nG1 X1\nG55 X1\n\nM8\nM2\n");
  const ModalLog& log = reading.modal;
  const auto first = log.at(1);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->units, 210);
  EXPECT_EQ(first->motion, 800);
  const auto second = log.at(2);
  EXPECT_EQ(second->units, 200);
  EXPECT_EQ(second->feed, 10.0);
  EXPECT_EQ(second->tool, 0);
  EXPECT_EQ(log.at(3)->tool, 3);
  EXPECT_EQ(log.at(4)->spindle_direction, 1);
  EXPECT_EQ(log.at(5)->motion, 10);
  EXPECT_EQ(log.at(5)->work_offset(), "G54");
  EXPECT_EQ(log.at(7)->work_offset(), "G55");
  EXPECT_FALSE(log.at(7)->flood);
  EXPECT_TRUE(log.at(100)->flood);
  EXPECT_EQ(log.at(7)->codes(), "G1 G17 G20 G91 G91.1 G94 G55 G40 G49 G64 G97 G99");
}

TEST(ModalLog, KnowsLinesThatRunOutOfOrder) {
  const auto reading = read_program("o1 sub\nG1 X1\nG91\no1 endsub\nG21 F100\no1 call\nG90 G0 X0\nM2\n");
  EXPECT_EQ(reading.modal.at(2)->motion, 10);
  EXPECT_EQ(reading.modal.at(3)->distance, 910);
  EXPECT_EQ(reading.modal.at(7)->motion, 0);
  EXPECT_EQ(reading.modal.at(7)->distance, 900);
}

TEST(ModalLog, ListsALoopOnce) {
  const auto reading = read_program("G21\no1 repeat [1000]\nG1 X1 F#<_line>\nG0 X0\no1 endrepeat\nM2\n");
  EXPECT_LT(reading.modal.size(), 10u);
}

}  // namespace
}  // namespace toolpace::nc
