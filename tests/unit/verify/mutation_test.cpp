/// One digit (or byte) altered anywhere is caught, or is smaller than the bounds that the report of the unaltered file
/// states.

#include <algorithm>
#include <fstream>

#include "planned_program.h"
#include "toolpace/io/setpoint_reader.h"

namespace toolpace {
namespace {

using namespace testing;

/// All of a file, or nothing where it cannot be read.
std::optional<SetpointRows> read_all(const std::filesystem::path& file) {
  auto setpoints = open_setpoint_file(file);
  if (!setpoints) return {};
  SetpointRows rows;
  for (std::size_t taken = 1; taken > 0;) {
    const auto more = (*setpoints)->read(rows, 1 << 20);
    if (!more) return {};
    taken = *more;
  }
  return rows;
}

template <class T>
double largest_change(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
  return largest;
}

/// Whether every column of the altered file is within the bound that the report states for it.
::testing::AssertionResult within_bounds(const SetpointRows& was, const SetpointRows& is, const VerifyReport& report) {
  const auto judge = [](const char* column, double change, double bound) {
    if (change <= bound) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << column << " changed by " << change << ", bound " << bound;
  };
  if (!was.time.empty() || !is.time.empty()) {
    const auto time =
        judge("time", largest_change(was.time, is.time), check_of(report, CheckKind::time_step).bound + 1e-15);
    if (!time) return time;
  }
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto position =
        judge("position", largest_change(was.position[axis], is.position[axis]), report.position_resolution);
    if (!position) return position;
  }
  for (std::size_t order = 0; order < kDerivatives; ++order) {
    constexpr std::array kKinds = {CheckKind::speed_column, CheckKind::acceleration_column, CheckKind::jerk_column};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (was.derivative[order][axis].empty()) continue;
      const Check& check = check_of(report, kKinds[order], axis);
      const double noise = 1e-12 * std::pow(report.period, -1.0 - static_cast<double>(order));  // positions below 1 m
      const auto column =
          judge("column of an axis", largest_change(was.derivative[order][axis], is.derivative[order][axis]),
                check.value + noise);
      if (!column) return column;
    }
  }
  if (const auto line = judge("line", largest_change(was.line, is.line), 0.0); !line) return line;
  if (was.speed.empty() && is.speed.empty()) return ::testing::AssertionSuccess();
  const double acceleration = check_of(report, CheckKind::acceleration_column).bound;
  const double speed = std::max(check_of(report, CheckKind::speed_column).bound, acceleration * report.period);
  for (const auto& verdict :
       {judge("speed", largest_change(was.speed, is.speed), 4 * speed),
        judge("acceleration", largest_change(was.acceleration, is.acceleration), 4 * acceleration),
        judge("jerk", largest_change(was.jerk, is.jerk), 4 * check_of(report, CheckKind::jerk_column).bound)}) {
    if (!verdict) return verdict;
  }
  return ::testing::AssertionSuccess();
}

struct Format {
  const char* ending;
  bool is_text;
  SetpointFileOptions options = {};
};

/// Another digit in place of a random one behind the header, or another byte in place of any.
std::string altered(std::string content, const Format& format, std::mt19937& random) {
  if (!format.is_text) {
    char& byte = content[random() % content.size()];
    byte = static_cast<char>(byte ^ static_cast<char>(1 + random() % 255));
    return content;
  }
  const std::size_t header =
      std::isdigit(static_cast<unsigned char>(content[0])) || content[0] == '-' ? 0 : content.find('\n') + 1;
  std::size_t at = header + random() % (content.size() - header);
  while (!std::isdigit(static_cast<unsigned char>(content[at]))) at = header + random() % (content.size() - header);
  content[at] = static_cast<char>('0' + (content[at] - '0' + 1 + static_cast<int>(random() % 9)) % 10);
  return content;
}

void expect_caught(const Program& program, const Setup& setup, const Format& format, unsigned seed, int mutants = 200) {
  const TemporaryDirectory dir;
  const auto good = dir / (std::string("a") + format.ending), bad = dir / (std::string("b") + format.ending);
  write_setpoints(planned(program, setup), good, format.options);
  const VerifyReport report = verified(good, setup.machine, &program.moves(), 1e-6);
  ASSERT_TRUE(report.passes()) << broken(report);
  const auto was = read_all(good);
  ASSERT_TRUE(was);
  const std::string content = contents(good);
  std::mt19937 random(seed);
  int caught = 0;
  for (int i = 0; i < mutants; ++i) {
    std::ofstream(bad, std::ios::binary) << altered(content, format, random);
    const auto is = read_all(bad);
    const bool passes = is && [&] {
      auto file = open_setpoint_file(bad);
      const Path path = build_path(program.moves(), 0).value();
      const ProgrammedPath programmed{path, program.moves(), 1e-6};
      const auto result = verify(**file, setup.machine, &programmed);
      return result && result->passes();
    }();
    caught += !passes;
    if (!passes) continue;
    ASSERT_TRUE(within_bounds(*was, *is, report)) << format.ending << " seed " << seed << " mutant " << i;
  }
  EXPECT_GT(caught, mutants / 5);  // the rest are digits so far behind the point that no machine would see them
}

toolpace::Setup stopping_setup(LawKind law = LawKind::quintic) {
  toolpace::Setup setup = axis_limited_setup();
  setup.options.law = law;
  setup.options.corner.rule = CornerRule::stop;
  return setup;
}

Program lines() {
  Program program;
  program.line(20, 0).line(20, 15).line(3, 5, 2);
  return program;
}

Program arcs() {
  Program program;
  program.start(10, 0).arc(0, 0, 5.0, 3.0).arc(0, 0, -2.0);
  return program;
}

TEST(Mutation, OnLinesIsCaughtOrWithinTheStatedBound) {
  expect_caught(lines(), stopping_setup(), {".csv", true}, 1);
}

TEST(Mutation, OnArcsIsCaughtOrWithinTheStatedBound) {
  expect_caught(arcs(), stopping_setup(LawKind::seven_phase), {".csv", true}, 2);
}

TEST(Mutation, AtCornersIsCaughtOrWithinTheStatedBound) {
  Program program;
  std::mt19937 random(7);
  for (int i = 0; i < 40; ++i) program.line(0.5 * i + 0.5, 0.3 * static_cast<double>(random() % 10) / 10);
  expect_caught(program, axis_limited_setup(), {".csv", true}, 3, 400);
}

TEST(Mutation, OfSemicolonsAndDecimalCommasIsCaughtOrWithinTheStatedBound) {
  SetpointFileOptions commas;
  commas.decimal_comma = true;
  expect_caught(lines(), stopping_setup(), {".semicolon.csv", true, commas}, 4);
  expect_caught(arcs(), stopping_setup(), {".semicolon.csv", true}, 5);
}

TEST(Mutation, OfTheColumnsOfEachAxisIsCaughtOrWithinTheStatedBound) {
  SetpointFileOptions options;
  options.axis_derivatives = true;
  Program turning;
  turning.line(10, 0).rotate(2.0, 1.0).line(0, 5);
  expect_caught(lines(), stopping_setup(), {".csv", true, options}, 11);
  expect_caught(turning, stopping_setup(), {".csv", true, options}, 12);
  expect_caught(turning, stopping_setup(), {".npy", false, options}, 13);
}

TEST(Mutation, OfHalstreamsIsCaughtOrWithinTheStatedBound) {
  expect_caught(lines(), stopping_setup(), {".halstream", true}, 6);
  expect_caught(arcs(), stopping_setup(), {".halstream", true}, 7);
}

TEST(Mutation, OfAnyByteOfNumpyFilesIsCaughtOrWithinTheStatedBound) {
  expect_caught(lines(), stopping_setup(), {".npy", false}, 8);
  expect_caught(arcs(), stopping_setup(), {".npy", false}, 9);
  expect_caught(lines(), stopping_setup(), {".npz", false}, 10);
}

}  // namespace
}  // namespace toolpace
