/// The line column where corners are smoothed: each setpoint names the block that it is on.

#include <random>

#include "planned_program.h"
#include "toolpace/pipeline/prove.h"

namespace toolpace {
namespace {

using namespace testing;

Outcome smoothed(const Program& program, CornerRule rule) {
  Setup setup = axis_limited_setup();
  setup.options.law = LawKind::seven_phase;
  setup.options.ramps = Ramps::span;
  setup.options.corner.rule = rule;
  return planned(program, setup);
}

/// x of each setpoint with its line.
std::vector<std::pair<double, std::uint32_t>> sampled(const Outcome& outcome) {
  std::vector<std::pair<double, std::uint32_t>> rows;
  Sampler sampler(*outcome.path, outcome.plan, outcome.job->program->moves, outcome.job->machine.period);
  for (Setpoints chunk; sampler.next(chunk);) {
    for (std::size_t k = 0; k < chunk.size(); ++k) rows.emplace_back(chunk.position[0][k], chunk.line[k]);
  }
  return rows;
}

/// Blocks whose x rises tell by x alone on which one a setpoint is, but for the tolerance, near a corner.
void expect_lines_by_x(const Program& program, CornerRule rule, double most_off) {
  const Outcome outcome = smoothed(program, rule);
  const Moves& moves = program.moves();
  for (const auto& [x, line] : sampled(outcome)) {
    const double begin = line > 1 ? moves.end[line - 2][0] : moves.start[0], end = moves.end[line - 1][0];
    ASSERT_GE(x, begin - most_off) << "line " << line;
    ASSERT_LE(x, end + most_off) << "line " << line;
  }
}

// A corner of the tolerance t is missed by t; along the bisector that is t·cos of half the turn in x at most.
TEST(SmoothedLines, ACornerBelongsToBothOfItsBlocks) {
  Program program;
  program.line(10, 0).line(20, 10).line(30, 0).line(40, 0.1);
  for (const CornerRule rule : {CornerRule::blend, CornerRule::smooth}) {
    SCOPED_TRACE(static_cast<int>(rule));
    expect_lines_by_x(program, rule, 0.01);
  }
}

// Collinear blocks merge into one segment; each setpoint still names its own block, to rounding.
TEST(SmoothedLines, MergedBlocksKeepTheirLines) {
  Program program;
  for (int i = 1; i <= 200; ++i) program.line(0.05 * i, 0.1 * i);
  expect_lines_by_x(program, CornerRule::blend, 1e-9);
  expect_lines_by_x(program, CornerRule::smooth, 0.01);
}

TEST(SmoothedLines, ChainsOfShortBlocksKeepTheirLines) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    std::mt19937_64 engine(seed);
    const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
    Program program;
    double x = 0, y = 0;
    for (int i = 0; i < 400; ++i) {
      const double step = 0.02 + 0.4 * uniform() * uniform();
      x += step;
      y += step * 0.3 * std::sin(x) + 0.01 * (uniform() - 0.5);
      program.line(x, y);
    }
    for (const CornerRule rule : {CornerRule::blend, CornerRule::smooth}) {
      SCOPED_TRACE(::testing::Message() << "seed " << seed << " rule " << static_cast<int>(rule));
      expect_lines_by_x(program, rule, 0.011);
    }
  }
}

// The stroke at the end goes there and back: its two lines have one chord, of no length.
TEST(SmoothedLines, TheVerifierFindsNoneThatIsNotUnderTheTool) {
  Program program;
  program.line(10, 0).arc(10, 5, 1.5).line(20, 3).arc(20, 8, -2.5, 1).line(0, 0, 3).line(0, 0, 0).line(0, 0, 3);
  for (const CornerRule rule : {CornerRule::blend, CornerRule::smooth}) {
    SCOPED_TRACE(static_cast<int>(rule));
    const auto report = prove(smoothed(program, rule));
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->passes()) << broken(*report);
    EXPECT_EQ(check_of(*report, CheckKind::line_column).value, 0.0);
  }
}

}  // namespace
}  // namespace toolpace
