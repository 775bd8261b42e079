/// Predictions against the clocks of real controllers: every row of times.tsv.

#include "measured_times.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace toolpace {
namespace {

using test::MeasuredTime;

constexpr double kShortProgram = 1.0;  // [s] below which what steps round counts more than what is modelled

struct Error {
  double relative, seconds;
  std::string name;
};

template <class Wanted>
std::vector<Error> errors_of(const Wanted& wanted) {
  std::vector<Error> errors;
  for (const MeasuredTime& time : test::measured_times()) {
    if (!wanted(time)) continue;
    const double off = std::abs(test::prediction_of(time).cycle_time - time.cycle_time);
    errors.push_back({off / time.cycle_time, off, time.settings + " " + time.control + " " + time.program});
  }
  std::sort(errors.begin(), errors.end(), [](const Error& a, const Error& b) { return a.relative < b.relative; });
  return errors;
}

void expect_close(const std::vector<Error>& errors, std::size_t rows, double median, double worst) {
  ASSERT_EQ(errors.size(), rows);
  EXPECT_LE(errors[rows / 2].relative, median);
  for (const Error& error : errors) {
    EXPECT_TRUE(error.relative <= worst || error.seconds <= 0.005)
        << error.name << ": " << error.relative * 100 << " %";
  }
}

auto rows_of(Controller controller, bool is_linked) {
  return [=](const MeasuredTime& time) { return time.controller == controller && time.baud.has_value() == is_linked; };
}

TEST(MeasuredTimes, GrblIsMetToAThousandth) {
  expect_close(errors_of(rows_of(Controller::grbl, false)), 58, 1e-3, 1e-2);
}

TEST(MeasuredTimes, GrblBehindASlowLinkIsMetToTwoHundredths) {
  expect_close(errors_of(rows_of(Controller::grbl, true)), 58, 1e-3, 2e-2);
}

TEST(MeasuredTimes, GrblhalIsMetToAThousandth) {
  expect_close(errors_of(rows_of(Controller::grblhal, false)), 58, 1e-3, 1e-2);
}

TEST(MeasuredTimes, KlipperIsMetToAThousandth) {
  expect_close(errors_of(rows_of(Controller::klipper, false)), 58, 1e-3, 1e-2);
}

auto rows_under(const std::string& control) {
  return [=](const MeasuredTime& time) { return time.controller == Controller::linuxcnc && time.control == control; };
}

TEST(MeasuredTimes, LinuxcncIsMetWithoutBlends) { expect_close(errors_of(rows_under("G61")), 16, 5e-3, 5e-2); }

TEST(MeasuredTimes, LinuxcncIsMetWithBlendsWithinATolerance) {
  expect_close(errors_of(rows_under("G64 P0.01")), 44, 2e-2, 15e-2);
  expect_close(errors_of(rows_under("G64 P0.05")), 12, 2e-2, 15e-2);
}

TEST(MeasuredTimes, LinuxcncIsMetWithFreeBlends) {
  // 1500 lines of 0.02 mm, which the interpreter of the measured machine could not read as fast as they were run.
  const auto fed = [](const MeasuredTime& time) { return rows_under("G64")(time) && time.program != "own_micro_002"; };
  expect_close(errors_of(fed), 12, 2e-2, 15e-2);
}

}  // namespace
}  // namespace toolpace
