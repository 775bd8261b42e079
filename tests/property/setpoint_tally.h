#pragma once
/// Setpoints of random programs, judged and counted.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>

#include "case_count.h"
#include "planned_program.h"
#include "toolpace/pipeline/prove.h"

namespace toolpace::testing {

/// Judges as many programs as a test wants, or as many as have TOOLPACE_SETPOINTS setpoints where scripts/soak sets it, and
/// prints at its end how many setpoints it judged and how many violations it found: a line that scripts/soak adds up.
class SetpointTally {
 public:
  /// @param usual  programs
  explicit SetpointTally(std::size_t usual) : programs_wanted_(test::case_count(usual)) {
    if (const char* setpoints = std::getenv("TOOLPACE_SETPOINTS")) {
      setpoints_wanted_ = static_cast<std::int64_t>(std::atof(setpoints));
    }
  }
  ~SetpointTally() {
    fmt::print("judged: {} setpoints of {} programs, {} violations\n", setpoints_, programs_, violations_);
    std::fflush(stdout);
  }
  SetpointTally(const SetpointTally&) = delete;
  SetpointTally& operator=(const SetpointTally&) = delete;

  bool wants_more() {
    if (::testing::Test::HasFatalFailure()) return false;
    return setpoints_wanted_ > 0 ? setpoints_ < setpoints_wanted_ : asked_++ < programs_wanted_;
  }

  /// @param describe  () -> what to print of a program that breaks something
  template <class Describe>
  void judge(const Outcome& outcome, Describe&& describe) {
    const auto report = prove(outcome);
    if (!report) {
      ++violations_;
      ADD_FAILURE() << report.error().message << "\n" << describe();
      return;
    }
    ++programs_;
    setpoints_ += report->rows;
    for (const Check& check : report->checks) violations_ += check.broken;
    EXPECT_TRUE(report->passes()) << broken(*report) << describe();
  }

 private:
  std::size_t programs_wanted_, asked_ = 0;
  std::int64_t setpoints_wanted_ = 0;
  std::int64_t setpoints_ = 0, programs_ = 0, violations_ = 0;
};

}  // namespace toolpace::testing
