/// Setpoints against the programmed path.

#include <fmt/format.h>

#include <fstream>
#include <numbers>

#include "planned_program.h"
#include "toolpace/base/axis_unit.h"
#include "toolpace/io/setpoint_reader.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/verify/path_follower.h"

namespace toolpace {
namespace {

using namespace testing;

void write_points(const std::filesystem::path& file, const std::vector<Eigen::Vector2d>& points) {
  std::ofstream out(file);
  out.precision(17);
  out << "t_s,x_mm,y_mm,z_mm\n";
  for (std::size_t k = 0; k < points.size(); ++k)
    out << static_cast<double>(k) / 1000 << ',' << points[k].x() << ',' << points[k].y() << ",0\n";
}

/// Points every `step` along a polyline, its vertices included.
std::vector<Eigen::Vector2d> walk(const std::vector<Eigen::Vector2d>& corners, double step) {
  std::vector<Eigen::Vector2d> points = {corners.front()};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Eigen::Vector2d d = corners[i] - corners[i - 1];
    const int n = static_cast<int>(std::ceil(d.norm() / step));
    for (int k = 1; k <= n; ++k) points.push_back(corners[i - 1] + d * k / n);
  }
  return points;
}

Program polyline(const std::vector<Eigen::Vector2d>& corners) {
  Program program;
  program.start(corners[0].x(), corners[0].y());
  for (std::size_t i = 1; i < corners.size(); ++i) program.line(corners[i].x(), corners[i].y());
  return program;
}

TEST(PathCheck, MeasuresTheDistanceFromExactArcs) {
  const TemporaryDirectory dir;
  Program program;
  program.start(25, 0).arc(0, 0, 4.0).arc(0, 0, 7.0, 11.0).line(0, 0, 11);
  const toolpace::Setup setup = axis_limited_setup();
  write_setpoints(planned(program, setup), dir / "a.csv");
  const VerifyReport report = verified(dir / "a.csv", setup.machine, &program.moves(), 1e-6);
  EXPECT_TRUE(report.passes()) << broken(report);
  EXPECT_LT(check_of(report, CheckKind::deviation).value, 1e-10);
  // Sagitta of 0.1 mm on a radius of 25: 0.1²/200 = 5e-5 mm. The corner from the helix to the line may be passed with a
  // step of 2000 mm/s² · 1 ms = 2 mm/s, and is cut by at most 2 mm/s · 1 ms / 4 = 5e-4 mm then.
  EXPECT_LT(*report.chord_error, 5.01e-4);
  EXPECT_GT(*report.chord_error, 4e-5);
}

// The arc comes down where the line goes up again: just before the turn, a row on the arc is as near to the line as to the
// arc's chord.
TEST(PathCheck, TellsAnArcFromTheLineThatItTurnsRoundInto) {
  for (const double radius : {2.0, 20.0, 300.0}) {
    const TemporaryDirectory dir;
    Program program;
    program.start(-radius, 0).arc(0, 0, -std::numbers::pi).line(radius, 10).arc(0, 10, 1.0);
    const toolpace::Setup setup = axis_limited_setup();
    write_setpoints(planned(program, setup), dir / "a.csv");
    const VerifyReport report = verified(dir / "a.csv", setup.machine, &program.moves(), 1e-6);
    EXPECT_TRUE(report.passes()) << broken(report);
    EXPECT_LT(check_of(report, CheckKind::deviation).value, 2.5e-7) << radius;
  }
}

// Radii that differ by rounding of the words to 1e-4 mm, as posts write them: angle and length are not proportional then,
// which on a helix shows in its height.
TEST(PathCheck, MeasuresFromHelicesWhoseRadiiDifferByRounding) {
  const TemporaryDirectory dir;
  Program program;
  program.start(0.8002, -0.8078).arc(0.7862, -1.1026, -3.635604007745175, -30.0);
  Reading reading = *program.reading();
  reading.moves.end.back().head<2>() << 0.6341, -1.3555;
  auto job = std::make_shared<Job>();
  job->program = std::make_shared<const Reading>(reading);
  job->machine = axis_limited_setup().machine;
  const auto outcome = run(job);
  ASSERT_TRUE(outcome);
  write_setpoints(*outcome, dir / "a.csv");
  const VerifyReport report = verified(dir / "a.csv", job->machine, &reading.moves, 1e-6);
  EXPECT_TRUE(report.passes()) << broken(report);
  EXPECT_LT(check_of(report, CheckKind::deviation).value, 1e-7);
}

TEST(PathCheck, FindsARowOffTheArc) {
  const TemporaryDirectory dir;
  Program program;
  program.start(25, 0).arc(0, 0, 6.0);
  const toolpace::Setup setup = axis_limited_setup();
  write_setpoints(planned(program, setup), dir / "a.csv");
  std::ofstream out(dir / "b.csv");
  std::istringstream in(contents(dir / "a.csv"));
  std::size_t row = 0;
  for (std::string line; std::getline(in, line); ++row) {
    // Row 500 (line 501 of the file) moves 2e-5 mm outwards along x.
    if (row == 501) {
      std::vector<std::string> f;
      std::istringstream fields(line);
      for (std::string field; std::getline(fields, field, ',');) f.push_back(field);
      const double x = std::stod(f[1]), y = std::stod(f[2]);
      f[1] = std::to_string(x * (1 + 2e-5 / 25) * 1e0);
      std::ostringstream exact;
      exact.precision(17);
      exact << f[0] << ',' << x * (1 + 2e-5 / 25) << ',' << y * (1 + 2e-5 / 25);
      for (std::size_t i = 3; i < f.size(); ++i) exact << ',' << f[i];
      line = exact.str();
    }
    out << line << '\n';
  }
  out.close();
  const VerifyReport report = verified(dir / "b.csv", setup.machine, &program.moves(), 1e-5);
  EXPECT_NEAR(check_of(report, CheckKind::deviation).value, 2e-5, 1e-9);
  EXPECT_EQ(check_of(report, CheckKind::deviation).row, 500);
  EXPECT_TRUE(check_of(report, CheckKind::deviation).broken);
}

TEST(PathCheck, IsNotFooledByASelfCrossing) {
  const TemporaryDirectory dir;
  // A bow-tie. The motion leaves out the loop: it turns at the crossing (5, 5) onto the last leg.
  const std::vector<Eigen::Vector2d> corners = {{0, 0}, {10, 10}, {10, 0}, {0, 10}};
  const Program program = polyline(corners);
  write_points(dir / "whole.csv", walk(corners, 0.05));
  write_points(dir / "short.csv", walk({{0, 0}, {5, 5}, {0, 10}}, 0.05));
  const Machine machine;
  EXPECT_TRUE(verified(dir / "whole.csv", machine, &program.moves(), 0.01).passes());
  const VerifyReport report = verified(dir / "short.csv", machine, &program.moves(), 0.01);
  EXPECT_TRUE(check_of(report, CheckKind::follows_path).broken);
}

TEST(PathCheck, NoticesAStrokeThatWasLeftOut) {
  const TemporaryDirectory dir;
  // Drilling: down and up again in place. Every setpoint of the skipping motion is on the path.
  const Program program = polyline({{0, 0}, {5, 0}, {5, -3}, {5, 0}, {10, 0}});
  write_points(dir / "whole.csv", walk({{0, 0}, {5, 0}, {5, -3}, {5, 0}, {10, 0}}, 0.05));
  write_points(dir / "short.csv", walk({{0, 0}, {10, 0}}, 0.05));
  const Machine machine;
  EXPECT_TRUE(verified(dir / "whole.csv", machine, &program.moves(), 0.01).passes());
  EXPECT_TRUE(check_of(verified(dir / "short.csv", machine, &program.moves(), 0.01), CheckKind::follows_path).broken);
}

TEST(PathCheck, MeasuresACutCornerAndGivesItNoExemption) {
  const TemporaryDirectory dir;
  const Program program = polyline({{0, 0}, {10, 0}, {10, 10}});
  // The corner is cut from (9.99, 0) to (10, 0.01): 0.01/√2 mm from the vertex.
  write_points(dir / "a.csv", walk({{0, 0}, {9.99, 0}, {10, 0.01}, {10, 10}}, 0.004));
  const VerifyReport tight = verified(dir / "a.csv", Machine{}, &program.moves(), 0.002);
  EXPECT_TRUE(check_of(tight, CheckKind::follows_path).broken);
  const VerifyReport wide = verified(dir / "a.csv", Machine{}, &program.moves(), 0.0075);
  EXPECT_TRUE(wide.passes()) << broken(wide);
  EXPECT_EQ(wide.exempt_corners, 0);
  EXPECT_NEAR(*wide.chord_error, 0.01 / std::sqrt(2.0), 1e-5);
}

// Within the tolerance of a tip that the servo rule lets pass at 2000 mm/s² · 1 ms / 2 = 1 mm/s lie some twenty rows, on the
// way there and on the way back; the step of speed is where the tip is passed.
TEST(PathCheck, FindsTheTipOfAStrokeInsideAWideTolerance) {
  const TemporaryDirectory dir;
  Program program;
  program.line(10, 0).line(10, 10).control(PathControl::exact_path);
  for (int i = 0; i < 5; ++i) program.line(20 * i, 0, 2).line(20 * i, 0, -10.16 - 0.0001 * i).line(20 * i, 0, 2);
  toolpace::Setup setup = axis_limited_setup();
  setup.options.corner.rule = CornerRule::blend;
  write_setpoints(planned(program, setup), dir / "a.csv");
  const VerifyReport report = verified(dir / "a.csv", setup.machine, &program.moves(), 0.010001);
  EXPECT_TRUE(report.passes()) << broken(report);
}

/// Planned, and judged against its path.
VerifyReport proven(const std::string& text, const toolpace::Setup& setup) {
  auto job = std::make_shared<Job>();
  job->program = std::make_shared<const Reading>(read_text(text, "test.ngc").value());
  job->machine = setup.machine;
  job->options = setup.options;
  const auto outcome = run(job);
  EXPECT_TRUE(outcome) << outcome.error().message;
  return prove(*outcome).value();
}

// The blend ends so near the corner that the row before the corner is still on it.
TEST(PathCheck, ExemptsACornerOfG61BesideABlend) {
  toolpace::Setup setup = default_setup();
  setup.machine.period = 0.001;
  setup.machine.path = {191.5, 1355.8, 694.9, 291580, 226940};
  setup.machine.axes[0] = {203, 1533, 223036};
  setup.options.law = LawKind::time_optimal;
  setup.options.ramps = Ramps::span;
  setup.options.corner.rule = CornerRule::stop;
  setup.options.lookahead = 4;
  const VerifyReport report = proven(
      "G21 G90 G94 G17\nG64 P0.01\nG0 X-1.2745 Y0.6588\nG1 X-1.6526 Y-0.1538 F4234.5\nG1 X-1.6772 Y-0.2188 F416.5\n"
      "G1 X-1.7240 Y-0.2132 F340.8\nG61\nG0 X-1.8846 Y-0.2694\n"
      "G3 X-1.9673 Y-0.1736 I-0.1982 J-0.0875 F88.7\nG1 X-2.0196 Y-0.4995 F68.7\nM2\n",
      setup);
  EXPECT_TRUE(report.passes()) << broken(report);
}

// The corner at which G64 begins is passed as the job's rule says; the row behind it is on a blend already.
TEST(PathCheck, ExemptsACornerOfTheJobsRuleBesideABlend) {
  toolpace::Setup setup = default_setup();
  setup.machine.path = {294.6, 6108, 5136, 283829, 234932};
  setup.options.law = LawKind::trapezoid;
  setup.options.corner.rule = CornerRule::junction;
  setup.options.corner.junction_deviation = 0.01;
  const VerifyReport report = proven(
      "G21 G90 G94 G17\nG0 X-0.3399 Y0.1883 Z-0.5067\nG1 X-0.3672 Y0.2062 Z0.3929 F3121.9\nG64 P0.0027\n"
      "G1 X-0.3744 Y0.2117 Z0.3929 F594.3\nG5 X-0.6971 Y0.2403 I-0.0828 J0.0693 P0.0937 Q0.0536 F13217.8\n"
      "G2 X-0.4604 Y-0.2400 Z0.3652 I-0.0321 J-0.3143 F435.1\nM2\n",
      setup);
  EXPECT_TRUE(report.passes()) << broken(report);
}

// Two short blocks are merged within 0.1 mm, so that the motion comes to the corner of G61 in another direction than the block
// before it: what is exempt there is the step of the motion.
TEST(PathCheck, ExemptsTheCornerOfG61BehindMergedBlocks) {
  toolpace::Setup setup = default_setup();
  setup.machine.period = 0.00025;
  setup.machine.path = {284, 157.9, 157.9, 18526, 18526};
  setup.machine.axes[0] = {119.6, 233.8, 10018};
  setup.machine.axes[1] = {199.9, 221.3, 9728};
  setup.options.law = LawKind::seven_phase;
  setup.options.ramps = Ramps::span;
  const VerifyReport report =
      proven("G21 G90 F285\nG64 P0.1\nG1 X-0.193 Y0.3354\nG1 X-0.2075 Y0.4087\nG61\nG1 X-0.337 Y1.236\nM2\n", setup);
  EXPECT_TRUE(report.passes()) << broken(report);
  EXPECT_EQ(report.exempt_corners, 1);
}

// Two blocks as long as the way in one period, between long ones: three intervals between setpoints have a corner each, one behind
// the other, which take from each other's second differences.
TEST(PathCheck, FollowsCornersInPeriodsOneBehindTheOtherWhereRotaryAxesTurn) {
  toolpace::Setup setup = default_setup();
  setup.machine.path = {500, 5000, 5000, 2e5, 2e5};
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const double unit = axis_unit(k).size;
    setup.machine.axes[k] =
        is_rotary(k) ? AxisLimits{180 * unit, 1500 * unit, 4e4 * unit} : AxisLimits{500, 4000, 1.5e5};
  }
  setup.options.corner.rule = CornerRule::servo;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    const auto thousandths = [&](int low, int high) {
      return std::uniform_int_distribution(low, high)(random) * 0.001;
    };
    std::string text = "G21 G90 G94\nG1 X0 Y0 Z0 B0 C0 F560\n";
    double x = 0, y = 0, z = 0, b = 0, c = 0;
    for (int block = 0; block < 45; ++block) {
      const bool is_long = block % 3 == 0;
      x += is_long ? 2 : 0.007;
      y += is_long ? thousandths(-300, 300) : thousandths(-1, 2);
      z += is_long ? thousandths(-80, 80) : thousandths(-1, 1);
      b += is_long ? thousandths(-10, 10) : 0;
      c += is_long ? thousandths(0, 600) : thousandths(0, 2);
      text += fmt::format("G1 X{:.3f} Y{:.3f} Z{:.3f} B{:.3f} C{:.3f}\n", x, y, z, b, c);
    }
    for (const LawKind law : {LawKind::seven_phase, LawKind::five_phase_time}) {
      setup.options.law = law;
      const VerifyReport report = proven(text + "M2\n", setup);
      EXPECT_TRUE(report.passes()) << broken(report) << "seed " << seed;
    }
  }
}

// Strokes 0.03 mm apart: looked for in a wide reach, rows of one are as well on its neighbour.
TEST(PathCheck, MeasuresTheSameDeviationWhateverTheTolerance) {
  const TemporaryDirectory dir;
  std::vector<Eigen::Vector2d> corners = {{0, 0}};
  for (int i = 0; i < 6; ++i) {
    corners.push_back({i % 2 == 0 ? 4 : 0, 0.03 * i});
    corners.push_back({i % 2 == 0 ? 4 : 0, 0.03 * (i + 1)});
  }
  std::vector<Eigen::Vector2d> points = walk(corners, 0.01);
  for (std::size_t k = 0; k < points.size(); ++k) points[k].y() += 0.009 * std::sin(0.05 * static_cast<double>(k));
  write_points(dir / "a.csv", points);
  const auto deviation = [&](std::optional<double> tolerance) {
    return check_of(verified(dir / "a.csv", Machine{}, &polyline(corners).moves(), tolerance), CheckKind::deviation)
        .value;
  };
  const double measured = deviation({});
  EXPECT_NEAR(measured, 0.009, 2e-4);
  for (const double tolerance : {0.001, 0.0092, 0.01, 0.02, 0.1, 1.0})
    EXPECT_EQ(deviation(tolerance), measured) << tolerance;
}

TEST(PathCheck, NoticesAMissingEndAndAWrongLine) {
  const TemporaryDirectory dir;
  Program program;
  program.line(10, 0).line(20, 5);
  toolpace::Setup setup = axis_limited_setup();
  setup.options.corner.rule = CornerRule::stop;
  write_setpoints(planned(program, setup), dir / "a.csv");
  std::string text = contents(dir / "a.csv");
  std::string shorter = text.substr(0, text.rfind('\n', text.size() - 2) + 1);
  std::ofstream(dir / "short.csv")
      << shorter.substr(0, shorter.size() / 2).substr(0, shorter.rfind('\n', shorter.size() / 2) + 1);
  EXPECT_FALSE(verified(dir / "short.csv", setup.machine, &program.moves(), 1e-5).passes());
  const std::size_t row = text.find("\n0.05,");
  const std::size_t end = text.find('\n', row + 1);
  text.replace(end - 1, 1, "2");  // line 1 -> 2
  std::ofstream(dir / "line.csv") << text;
  const VerifyReport report = verified(dir / "line.csv", setup.machine, &program.moves());
  EXPECT_TRUE(check_of(report, CheckKind::line_column).broken);
  EXPECT_EQ(check_of(report, CheckKind::line_column).row, 50);
}

TEST(PathCheck, FollowsRotaryAxes) {
  const TemporaryDirectory dir;
  Program program;
  program.line(10, 0).rotate(2.0, 1.0).line(0, 0).rotate(0.5, 1.0);
  toolpace::Setup setup = default_setup();
  write_setpoints(planned(program, setup), dir / "a.csv");
  const VerifyReport report = verified(dir / "a.csv", setup.machine, &program.moves(), 1e-6);
  EXPECT_TRUE(report.passes()) << broken(report);
  std::ofstream(dir / "linear.csv") << "t_s,x_mm,y_mm,z_mm\n0,0,0,0\n0.001,0,0,0\n";
  auto file = open_setpoint_file(dir / "linear.csv");
  const Path path = build_path(program.moves(), 0).value();
  const ProgrammedPath programmed{path, program.moves(), {}};
  EXPECT_EQ(verify(**file, setup.machine, &programmed).error().code, "setpoints-axes");
}

// By hand: 3 mm back along the line. Nothing that goes forward alone is nearer than 1.5 mm to both rows, at 10 and at 7 mm.
TEST(PathCheck, MeasuresARowThatGoesBackFromWhereItIsMatched) {
  const TemporaryDirectory dir;
  write_points(dir / "a.csv", {{0, 0}, {5, 0}, {10, 0}, {7, 0}, {12, 0}, {20, 0}});
  const VerifyReport report = verified(dir / "a.csv", Machine{}, &polyline({{0, 0}, {20, 0}}).moves(), 2.0);
  EXPECT_TRUE(report.passes()) << broken(report);
  EXPECT_NEAR(check_of(report, CheckKind::deviation).value, 1.5, 0.03);
}

TEST(PathCheck, TellsOfAnotherProgram) {
  const TemporaryDirectory dir;
  const Program program = polyline({{0, 0}, {100, 0}});
  write_points(dir / "a.csv", walk({{0, 0}, {0, 100}}, 0.5));
  const VerifyReport report = verified(dir / "a.csv", Machine{}, &program.moves());
  EXPECT_TRUE(report.passes());  // without a tolerance the deviation is reported, not judged
  ASSERT_EQ(report.notes.size(), 1U);
  EXPECT_NE(report.notes[0].find("do not follow"), std::string::npos);
  EXPECT_FALSE(verified(dir / "a.csv", Machine{}, &program.moves(), 0.1).passes());
}

TEST(PathCheck, AProgramWithoutMotionHasOneRow) {
  const TemporaryDirectory dir;
  Program program;
  program.dwell(0.01);
  const toolpace::Setup setup = default_setup();
  write_setpoints(planned(program, setup), dir / "a.csv");
  EXPECT_TRUE(verified(dir / "a.csv", setup.machine, &program.moves(), 1e-6).passes());
}

}  // namespace
}  // namespace toolpace
