/// One digit altered anywhere is caught, or is smaller than the bounds that the report of the unaltered file states.

#include <algorithm>
#include <fstream>
#include <sstream>

#include "planned_program.h"

namespace toolpace {
namespace {

using namespace testing;

struct Mutant {
  std::string text;
  std::size_t row = 0, column = 0;
  double change = 0.0;
};

/// Replaces one random digit of one random number by another one.
Mutant mutate(const std::vector<std::string>& lines, std::mt19937& random) {
  Mutant m;
  m.row = 1 + random() % (lines.size() - 1);
  const std::string& line = lines[m.row];
  std::vector<std::size_t> digits;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (std::isdigit(static_cast<unsigned char>(line[i]))) digits.push_back(i);
  }
  const std::size_t at = digits[random() % digits.size()];
  std::string changed = line;
  changed[at] = static_cast<char>('0' + (line[at] - '0' + 1 + static_cast<int>(random() % 9)) % 10);
  m.column = static_cast<std::size_t>(std::count(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(at), ','));
  const auto number = [&](const std::string& text) {
    std::istringstream in(text);
    std::string field;
    for (std::size_t c = 0; c <= m.column; ++c) std::getline(in, field, ',');
    return std::strtod(field.c_str(), nullptr);
  };
  m.change = std::abs(number(changed) - number(line));
  for (std::size_t k = 0; k < lines.size(); ++k) m.text += (k == m.row ? changed : lines[k]) + '\n';
  return m;
}

/// The bound on a change of this column, from the report of the file as it was.
double stated_bound(const VerifyReport& report, std::size_t column) {
  switch (column) {
    case 0: return check_of(report, CheckKind::time_step).bound + 1e-15;
    case 1:
    case 2:
    case 3: return report.position_resolution;
    case 4:
      return 4 * std::max(check_of(report, CheckKind::speed_column).bound,
                          check_of(report, CheckKind::acceleration_column).bound * report.period);
    case 5: return 4 * check_of(report, CheckKind::acceleration_column).bound;
    case 6: return 4 * check_of(report, CheckKind::jerk_column).bound;
    default: return 0.0;  // the line of any row
  }
}

void expect_caught(const Program& program, const Setup& setup, int mutants, unsigned seed) {
  const TemporaryDirectory dir;
  write_setpoints(planned(program, setup), dir / "a.csv");
  const VerifyReport report = verified(dir / "a.csv", setup.machine, &program.moves(), 1e-6);
  ASSERT_TRUE(report.passes()) << broken(report);
  std::vector<std::string> lines;
  std::istringstream in(contents(dir / "a.csv"));
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::mt19937 random(seed);
  int caught = 0;
  for (int i = 0; i < mutants; ++i) {
    const Mutant m = mutate(lines, random);
    std::ofstream(dir / "b.csv") << m.text;
    auto file = open_setpoint_file(dir / "b.csv");
    bool passes = false;
    if (file) {
      const Path path = build_path(program.moves(), 0).value();
      const ProgrammedPath programmed{path, program.moves(), 1e-6};
      const auto result = verify(**file, setup.machine, &programmed);
      passes = result && result->passes();
    }
    caught += !passes;
    if (!passes) continue;
    ASSERT_LE(m.change, stated_bound(report, m.column))
        << "seed " << seed << " mutant " << i << " row " << m.row << ": " << lines[m.row] << " column " << m.column;
  }
  EXPECT_GT(caught, mutants / 4);  // the rest are digits so far behind the point that no machine would see them
}

TEST(Mutation, OnLinesIsCaughtOrWithinTheStatedBound) {
  Program program;
  program.line(20, 0).line(20, 15).line(3, 5, 2);
  toolpace::Setup setup = axis_limited_setup();
  setup.options.corner.rule = CornerRule::stop;
  expect_caught(program, setup, 200, 1);
}

TEST(Mutation, OnArcsIsCaughtOrWithinTheStatedBound) {
  Program program;
  program.start(10, 0).arc(0, 0, 5.0, 3.0).arc(0, 0, -2.0);
  toolpace::Setup setup = axis_limited_setup();
  setup.options.law = LawKind::seven_phase;
  setup.options.corner.rule = CornerRule::stop;
  expect_caught(program, setup, 200, 2);
}

TEST(Mutation, AtCornersIsCaughtOrWithinTheStatedBound) {
  Program program;
  std::mt19937 random(7);
  for (int i = 0; i < 40; ++i) program.line(0.5 * i + 0.5, 0.3 * static_cast<double>(random() % 10) / 10);
  expect_caught(program, axis_limited_setup(), 200, 3);
}

}  // namespace
}  // namespace toolpace
