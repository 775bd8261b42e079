#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <set>

#include "toolpace/machine/setup.h"
#include "toolpace/pipeline/follow.h"
#include "toolpace/pipeline/many.h"
#include "toolpace/tune/single_changes.h"
#include "toolpace/tune/sweep.h"

namespace toolpace {
namespace {

/// Straight blocks of 1 mm at 50 mm/s.
Job straight_blocks(std::size_t count) {
  auto reading = std::make_shared<Reading>();
  Moves& m = reading->moves;
  for (std::size_t i = 1; i <= count; ++i) {
    AxisVector end = AxisVector::Zero();
    end[0] = static_cast<double>(i);
    m.kind.push_back(MoveKind::feed);
    m.line.push_back(static_cast<std::uint32_t>(i));
    m.file.push_back(0);
    m.mode.push_back(0);
    m.detail.push_back(kNoDetail);
    m.end.push_back(end);
    m.feed.push_back(50);
  }
  Job job;
  job.program = reading;
  job.machine = default_setup().machine;
  return job;
}

TEST(SweepLookahead, TimeFallsToTheTimeAtFullDepthAndTheKneeIsMarked) {
  const auto sweep = sweep_lookahead(straight_blocks(40));
  ASSERT_TRUE(sweep) << sweep.error().message;
  EXPECT_EQ(sweep->points.front().lookahead, 1u);
  EXPECT_EQ(sweep->points.back().lookahead, std::nullopt);
  EXPECT_GT(sweep->points.front().cycle_time, 1.5 * sweep->points.back().cycle_time);
  const double best = sweep->points.back().cycle_time;
  EXPECT_LE(sweep->points[sweep->knee].cycle_time, 1.005 * best);
  EXPECT_GT(sweep->points[sweep->knee - 1].cycle_time, 1.005 * best);
}

double change_of(const Job& before, const Job& after, double PathLimits::*limit) {
  return after.machine.path.*limit / before.machine.path.*limit;
}

TEST(TrySingleChanges, TheFeedIsWhatHoldsALongStraightLineBack) {
  const auto job = std::make_shared<const Job>(straight_blocks(200));
  const auto found = try_single_changes(job);
  ASSERT_TRUE(found) << found.error().message;
  const SingleChange& best = found->changes.front();
  EXPECT_DOUBLE_EQ(best.job->options.feed_override, 1.1);
  EXPECT_NEAR(best.saved, 200.0 / 50 - 200.0 / 55, 0.01);
  const auto speed = std::find_if(found->changes.begin(), found->changes.end(), [&](const SingleChange& c) {
    return change_of(*job, *c.job, &PathLimits::speed) > 1.05;
  });
  ASSERT_NE(speed, found->changes.end());
  EXPECT_NEAR(speed->saved, 0, 1e-12) << "the path may go 100 mm/s already";
  EXPECT_NEAR(change_of(*job, *speed->job, &PathLimits::speed), 1.1, 1e-12);
}

TEST(TrySingleChanges, EachIsWhatItsJobTakesAndFallsOverTheList) {
  const auto job = std::make_shared<const Job>(straight_blocks(30));
  const auto found = try_single_changes(job);
  ASSERT_TRUE(found) << found.error().message;
  double before = kUnlimited;
  std::set<LawKind> laws;
  std::set<CornerRule> corners;
  for (const SingleChange& change : found->changes) {
    EXPECT_LE(change.saved, before);
    before = change.saved;
    laws.insert(change.job->options.law);
    corners.insert(change.job->options.corner.rule);
    const auto again = run(change.job);
    ASSERT_TRUE(again);
    EXPECT_EQ(found->present.cycle_time - again->summary.cycle_time, change.saved);
    const auto followed = follow(*again);
    ASSERT_TRUE(followed);
    EXPECT_EQ(followed->max_contour_error - found->present.contour, change.contour_added);
  }
  EXPECT_GT(laws.size(), 2u);
  EXPECT_GT(corners.size(), 2u);
}

TEST(ForMany, KeepsTheOrderAndReturnsTheFirstError) {
  const auto squares =
      for_many<std::size_t>(100, 2, {}, [](std::size_t i, const Monitor&) -> Result<std::size_t> { return i * i; });
  ASSERT_TRUE(squares);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ((*squares)[i], i * i);
  const auto failed = for_many<std::size_t>(10, 2, {}, [](std::size_t i, const Monitor&) -> Result<std::size_t> {
    if (i < 3) return i;
    return tl::unexpected(Error{ErrorKind::input, std::to_string(i), "", "", {}, {}});
  });
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, "3");
}

TEST(ForMany, CanBeCancelled) {
  std::stop_source source;
  source.request_stop();
  const auto none =
      for_many<int>(5, 2, {source.get_token(), {}}, [](std::size_t, const Monitor&) -> Result<int> { return 1; });
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().kind, ErrorKind::cancelled);
}

}  // namespace
}  // namespace toolpace
