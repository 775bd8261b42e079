/// What is chosen by a machine's times.

#include "written_again.h"

namespace toolpace {
namespace {

/// A second a row, but for those of one kind.
ProgramTimer timer(MoveKind kind, double time) {
  return [kind, time](const Reading& reading, std::string_view) -> Result<ProgramTime> {
    ProgramTime result;
    for (const MoveKind k : reading.moves.kind) {
      result.row.push_back(k == kind ? time : 1.0);
      result.total += result.row.back();
    }
    return result;
  };
}

std::string arc_of_chords() { return "G21 G90 G94\nG0 X20 Y0\nG1 F600\n" + test::chords(20, 0, 2, 300) + "M2\n"; }

TEST(AMachineThatIsSlowOnArcs, GetsLines) {
  const auto rewritten = test::written_again(arc_of_chords(), {.timer = timer(MoveKind::arc, 1000)});
  EXPECT_EQ(rewritten.text.find("G3"), std::string::npos);
  EXPECT_GT(rewritten.replaced, 1u);
  EXPECT_LT(*rewritten.time_after, *rewritten.time_before);
  EXPECT_EQ(rewritten.slower, 0u);
}

TEST(AMachineThatIsNeverFaster, GetsTheProgramAsItWas) {
  const std::string text = arc_of_chords();
  // The fewer the rows, the longer it takes.
  const ProgramTimer odd = [](const Reading& reading, std::string_view) -> Result<ProgramTime> {
    const double each = 1e6 / static_cast<double>(reading.moves.size() * reading.moves.size());
    return ProgramTime{each * static_cast<double>(reading.moves.size()),
                       std::vector<double>(reading.moves.size(), each)};
  };
  const auto rewritten = test::written_again(text, {.timer = odd});
  EXPECT_EQ(rewritten.text, text);
  EXPECT_EQ(*rewritten.time_after, *rewritten.time_before);
  EXPECT_GE(rewritten.slower, 300u);
}

TEST(ATimerThatFails, FailsTheWork) {
  const std::string text = arc_of_chords();
  const auto reading = read_text(text, "a.ngc");
  const RewriteOptions options{.timer = [](const Reading&, std::string_view) -> Result<ProgramTime> {
    return tl::unexpected(cancelled_error());
  }};
  const auto rewritten = rewrite(text, "a.ngc", *reading, {}, options);
  ASSERT_FALSE(rewritten);
  EXPECT_EQ(rewritten.error().kind, ErrorKind::cancelled);
}

}  // namespace
}  // namespace toolpace
