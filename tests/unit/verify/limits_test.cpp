/// Limits by differences: what keeps them passes, what breaks them fails, with the right place.

#include <fstream>

#include "planned_program.h"
#include "toolpace/law/law_table.h"

namespace toolpace {
namespace {

using namespace testing;

Program bracket() {
  Program p;
  p.line(60, 0)
      .line(60, 40)
      .arc(40, 40, std::numbers::pi / 2)
      .line(20, 60)
      .dwell(0.0503)
      .line(0, 0, 5)
      .line(0.01, 0, 5)
      .line(3, 1, 5);
  return p;
}

void write_csv(const std::filesystem::path& file, const std::vector<double>& x, double period) {
  std::ofstream out(file);
  out.precision(17);
  out << "t_s,x_mm\n";
  for (std::size_t k = 0; k < x.size(); ++k) out << static_cast<double>(k) * period << ',' << x[k] << '\n';
}

class EveryLawVerified : public ::testing::TestWithParam<LawKind> {};

TEST_P(EveryLawVerified, PassesItsOwnPlans) {
  const TemporaryDirectory dir;
  const Program program = bracket();
  for (const CornerRule rule : {CornerRule::stop, CornerRule::servo, CornerRule::junction}) {
    for (const double period : {0.001, 0.004, 0.00025}) {
      toolpace::Setup setup = axis_limited_setup();
      setup.options.law = GetParam();
      setup.options.corner.rule = rule;
      setup.machine.period = period;
      if (!law_row(GetParam()).bounds_jerk) {
        for (auto& axis : setup.machine.axes) axis.jerk = kUnlimited;
        setup.machine.path.jerk = setup.machine.path.jerk_deceleration = kUnlimited;
      }
      write_setpoints(planned(program, setup), dir / "a.npz");
      const VerifyReport report = verified(dir / "a.npz", setup.machine, &program.moves(), 1e-6);
      EXPECT_TRUE(report.passes()) << static_cast<int>(rule) << ", " << period << " s:\n" << broken(report);
      // Six corners, two of them tangent joints of the arc; a stop needs no exemption.
      EXPECT_LE(report.exempt_corners, rule == CornerRule::stop ? 2 : 6);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, EveryLawVerified,
                         ::testing::Values(LawKind::trapezoid, LawKind::five_phase_time, LawKind::five_phase_jerk,
                                           LawKind::seven_phase, LawKind::quintic));

TEST(Limits, FailWhereTheMachineIsWeakerThanThePlan) {
  const TemporaryDirectory dir;
  const Program program = bracket();
  toolpace::Setup setup = axis_limited_setup();
  setup.options.corner.rule = CornerRule::stop;
  write_setpoints(planned(program, setup), dir / "a.csv");
  Machine weak = setup.machine;
  weak.axes[0].speed = 90;
  weak.axes[1].acceleration = 1500;
  weak.axes[2].jerk = 100;
  weak.axes[0].travel_max = 59.5;
  const VerifyReport report = verified(dir / "a.csv", weak, &program.moves());
  EXPECT_TRUE(check_of(report, CheckKind::axis_speed, 0).broken);
  EXPECT_TRUE(check_of(report, CheckKind::axis_acceleration, 1).broken);
  EXPECT_TRUE(check_of(report, CheckKind::axis_jerk, 2).broken);
  EXPECT_TRUE(check_of(report, CheckKind::travel_max, 0).broken);
  EXPECT_FALSE(check_of(report, CheckKind::axis_speed, 1).broken);
  EXPECT_FALSE(check_of(report, CheckKind::travel_min, 0).broken);
  EXPECT_EQ(check_of(report, CheckKind::travel_max, 0).value, 60.0);
  for (const Check& check : report.checks) {
    EXPECT_TRUE(check.row >= 0 && check.row < report.rows) << key_of(check.kind) << ": row " << check.row;
  }
}

TEST(Limits, AreMeasuredByDifferences) {
  const TemporaryDirectory dir;
  // By hand: steps 0, 0.05, 0.15, 0.15 mm in 1 ms: 150 mm/s; second differences 0.05, 0.1, 0, −0.15 -> 1.5e5 mm/s²;
  // third ones 0.05, 0.05, −0.1, −0.15, 0.15 -> 1.5e8 mm/s³.
  write_csv(dir / "a.csv", {0, 0.05, 0.2, 0.35}, 0.001);
  const VerifyReport report = verified(dir / "a.csv", default_setup().machine);
  EXPECT_NEAR(check_of(report, CheckKind::axis_speed, 0).value, 150, 1e-9);
  EXPECT_EQ(check_of(report, CheckKind::axis_speed, 0).row, 2);
  EXPECT_NEAR(check_of(report, CheckKind::axis_acceleration, 0).value, 1.5e5, 1e-6);
  EXPECT_NEAR(check_of(report, CheckKind::axis_jerk, 0).value, 1.5e8, 1e-3);
  EXPECT_EQ(report.rows, 4);
  EXPECT_DOUBLE_EQ(report.duration, 0.003);
}

TEST(Limits, HoldAtTheLimitItself) {
  const TemporaryDirectory dir;
  // 100 mm/s exactly, in steps of 0.1 that doubles cannot hold: rounding must not make it a failure.
  std::vector<double> x;
  for (int k = 0; k < 20000; ++k) x.push_back(0.1 * k);
  write_csv(dir / "a.csv", x, 0.001);
  Machine machine;
  machine.axes[0].speed = 100;
  EXPECT_TRUE(verified(dir / "a.csv", machine).passes());
  machine.axes[0].speed = 99.9998;  // two parts in a million too slow
  EXPECT_FALSE(verified(dir / "a.csv", machine).passes());
}

TEST(Limits, ExemptACornerWithoutTheProgramToo) {
  const TemporaryDirectory dir;
  Program program;
  program.line(30, 0).line(60, 10);
  toolpace::Setup setup = axis_limited_setup();
  setup.options.corner.step = 20;  // far more than 2000 mm/s² · 1 ms
  write_setpoints(planned(program, setup), dir / "a.csv");
  const VerifyReport report = verified(dir / "a.csv", setup.machine);
  EXPECT_TRUE(report.passes()) << broken(report);
  EXPECT_EQ(report.exempt_corners, 1);
  EXPECT_NEAR(report.largest_corner_step, 20, 2);
}

TEST(Limits, ExemptReversalsWhereverTheRowsFall) {
  const TemporaryDirectory dir;
  // Back over itself at 1 mm/s, as the servo rule lets it: a row near the turn may belong to either leg.
  for (int i = 0; i < 40; ++i) {
    Program program;
    program.line(2 + 0.00037 * i, 0).line(1, 0).start(0, 0).arc(1, 20, -1.0).arc(1, 20, 1.0);
    const toolpace::Setup setup = axis_limited_setup();
    write_setpoints(planned(program, setup), dir / "a.npz");
    const VerifyReport report = verified(dir / "a.npz", setup.machine, &program.moves(), 1e-6);
    ASSERT_TRUE(report.passes()) << i << "\n" << broken(report);
  }
}

/// X there and back at ±speed, from rest and to rest under the limits of axis_limited_setup() or below.
std::vector<double> there_and_back(double speed, double slow_down_to) {
  const double period = 0.001, step = 2000 * period * 0.5;  // half of what the acceleration allows in a period
  std::vector<double> v;
  const auto change = [&](double to) {
    while (v.empty() || std::abs(v.back() - to) > 1e-9) {
      const double from = v.empty() ? 0.0 : v.back();
      v.push_back(from + std::clamp(to - from, -step, step));
    }
    v.insert(v.end(), 20, to);
  };
  change(speed);
  change(slow_down_to);
  v.push_back(-slow_down_to);
  v.push_back(-slow_down_to);
  change(-speed);
  change(0.0);
  std::vector<double> x = {0.0};
  for (const double speed_here : v) x.push_back(x.back() + speed_here * period);
  return x;
}

/// Which of the checks of acceleration are broken.
struct Broken {
  bool axis, path;
  bool operator==(const Broken&) const = default;
};
Broken broken_accelerations(const VerifyReport& report) {
  return {
      check_of(report, CheckKind::axis_acceleration, 0).broken,
      check_of(report, CheckKind::path_acceleration).broken || check_of(report, CheckKind::path_deceleration).broken};
}

Machine without_jerk(Machine machine) {
  machine.path.jerk = machine.path.jerk_deceleration = kUnlimited;
  for (auto& axis : machine.axes) axis.jerk = kUnlimited;
  return machine;
}

// A reversal is run through by no corner rule but in the step that a servo follows in a period: 2000 mm/s² · 1 ms = 2 mm/s.
TEST(Limits, DoNotExemptAReversalAtSpeed) {
  const TemporaryDirectory dir;
  const Machine axes = without_jerk(axis_limited_setup().machine);
  Machine path_alone = axes;
  path_alone.axes = {};
  write_csv(dir / "fast.csv", there_and_back(60, 60), 0.001);
  write_csv(dir / "slow.csv", there_and_back(60, 1), 0.001);
  EXPECT_EQ(broken_accelerations(verified(dir / "fast.csv", axes)), (Broken{true, true}));
  EXPECT_EQ(broken_accelerations(verified(dir / "fast.csv", path_alone)), (Broken{false, true}));
  const VerifyReport slow = verified(dir / "slow.csv", axes);
  EXPECT_TRUE(slow.passes()) << broken(slow);
  const VerifyReport on_path = verified(dir / "slow.csv", path_alone);
  EXPECT_TRUE(on_path.passes()) << broken(on_path);
}

TEST(Limits, ExemptAReversalByTheStepThatTheJobAllows) {
  const TemporaryDirectory dir;
  const Machine machine = without_jerk(axis_limited_setup().machine);
  write_csv(dir / "a.csv", there_and_back(60, 20), 0.001);
  const auto judged = [&](const CornerOptions& corner) {
    auto file = open_setpoint_file(dir / "a.csv");
    VerifyOptions options;
    options.corner = corner;
    return verify(**file, machine, nullptr, options).value();
  };
  EXPECT_TRUE(judged({.step = 40.0}).passes());
  EXPECT_FALSE(judged({.step = 30.0}).passes());
  EXPECT_FALSE(judged({.rule = CornerRule::servo}).passes());
  EXPECT_FALSE(judged({.rule = CornerRule::junction}).passes());
  EXPECT_FALSE(judged({.rule = CornerRule::stop}).passes());
}

// From a line onto an arc, from that onto another, which turns the other way, and back onto a line, each at an angle, at a speed
// step of 20 mm/s: a rule that lets that pass explains it, ones that let 2 mm/s pass, or none, do not.
TEST(Limits, ExemptCornersOfCurvesByTheStepThatTheJobAllows) {
  Program program;
  program.line(30, 0).arc(25, 20, 1.5).arc(70, 5, -0.8, 2.0).line(75, 40, 4);
  for (const LawKind law : {LawKind::trapezoid, LawKind::quintic}) {
    const TemporaryDirectory dir;
    toolpace::Setup setup = axis_limited_setup();
    setup.options.law = law;
    setup.options.corner.step = 20;
    if (law == LawKind::trapezoid) setup.machine = without_jerk(setup.machine);
    write_setpoints(planned(program, setup), dir / "a.csv");
    const auto judged = [&](const CornerOptions& corner) {
      auto file = open_setpoint_file(dir / "a.csv");
      VerifyOptions options;
      options.corner = corner;
      return verify(**file, setup.machine, nullptr, options).value();
    };
    const VerifyReport as_planned = judged({.step = 20.0});
    EXPECT_TRUE(as_planned.passes()) << broken(as_planned);
    EXPECT_GE(as_planned.exempt_corners, 3);
    for (const CornerOptions& stricter : {CornerOptions{.step = 10.0}, CornerOptions{.rule = CornerRule::servo},
                                          CornerOptions{.rule = CornerRule::stop}}) {
      const VerifyReport report = judged(stricter);
      const auto is_broken = [&](std::size_t axis) {
        return check_of(report, CheckKind::axis_acceleration, axis).broken;
      };
      EXPECT_TRUE(is_broken(0) && is_broken(1)) << static_cast<int>(stricter.rule);
    }
  }
}

// Around a corner at 60 mm/s, 10 mm/s behind it: the turn explains a step across, not one of the speed along the path.
TEST(Limits, DoNotExemptAStepOfSpeedAtACorner) {
  const Machine axes = without_jerk(axis_limited_setup().machine);
  Machine path_alone = axes;
  path_alone.axes = {};
  for (const double angle : {0.3, 1.2, std::numbers::pi / 2}) {
    for (const double inside : {0.0, 0.4}) {  // share of the period at which the corner is passed
      const TemporaryDirectory dir;
      std::ofstream out(dir / "a.csv");
      out.precision(17);
      out << "t_s,x_mm,y_mm\n";
      double way = 0, v = 0;
      int row = 0;
      const auto put = [&](double speed, double beyond) {
        const double before = way - beyond;
        out << 0.001 * row++ << ',' << before + beyond * std::cos(angle) << ',' << beyond * std::sin(angle) << '\n';
        way += speed * 0.001;
      };
      while (v < 60) put(v += 1, 0);
      const double corner = way + 0.6 - 0.06 * inside;
      for (int k = 0; k < 60; ++k) put(way < corner ? 60 : 10, std::max(0.0, way - corner));
      out.close();
      const VerifyReport with_axes = verified(dir / "a.csv", axes);
      EXPECT_TRUE(check_of(with_axes, CheckKind::path_deceleration).broken) << angle << ", " << inside;
      EXPECT_TRUE(check_of(verified(dir / "a.csv", path_alone), CheckKind::path_deceleration).broken);
    }
  }
}

// The columns say nothing here: a ramp at twice the acceleration, straight and round an arc of 20 mm.
TEST(Limits, OfThePathAreJudgedFromThePositions) {
  for (const double radius : {1e9, 20.0}) {
    const TemporaryDirectory dir;
    std::ofstream out(dir / "a.csv");
    out.precision(17);
    out << "t_s,x_mm,y_mm\n";
    double way = 0, v = 0;
    for (int k = 0; k < 20; ++k) {
      out << 0.001 * k << ',' << radius * std::sin(way / radius) << ','
          << 2 * radius * std::pow(std::sin(way / radius / 2), 2) << '\n';
      way += (v += 4) * 0.001;
    }
    for (; v > 0; v -= 1) {
      out << 0.001 * (80 + 20 - v) << ',' << radius * std::sin(way / radius) << ','
          << 2 * radius * std::pow(std::sin(way / radius / 2), 2) << '\n';
      way += v * 0.001;
    }
    out.close();
    Machine machine;
    machine.path.acceleration = machine.path.deceleration = 2000;
    const VerifyReport report = verified(dir / "a.csv", machine);
    EXPECT_TRUE(check_of(report, CheckKind::path_acceleration).broken) << radius;
    EXPECT_NEAR(check_of(report, CheckKind::path_acceleration).value, 4000, 40) << radius;
    EXPECT_FALSE(check_of(report, CheckKind::path_deceleration).broken) << radius;
  }
}

TEST(Limits, DoNotExemptARowOutOfLine) {
  const TemporaryDirectory dir;
  Program program;
  program.line(60, 0);
  const toolpace::Setup setup = axis_limited_setup();
  write_setpoints(planned(program, setup), dir / "a.csv");
  auto text = contents(dir / "a.csv");
  const std::size_t row = text.find("\n0.3,");
  ASSERT_NE(row, std::string::npos);
  const std::size_t y = text.find(",0,", row);
  text.replace(y, 3, ",0.004,");
  std::ofstream(dir / "a.csv") << text;
  const VerifyReport report = verified(dir / "a.csv", setup.machine);
  EXPECT_TRUE(check_of(report, CheckKind::axis_acceleration, 1).broken);
  EXPECT_EQ(check_of(report, CheckKind::axis_acceleration, 1).row, 300);
}

TEST(Limits, NoticeAnUnevenClock) {
  const TemporaryDirectory dir;
  std::ofstream(dir / "a.csv") << "t_s,x_mm\n0,0\n0.001,0\n0.002,0\n0.0030001,0\n0.004,0\n";
  const VerifyReport report = verified(dir / "a.csv", default_setup().machine);
  EXPECT_TRUE(check_of(report, CheckKind::time_step).broken);
  EXPECT_EQ(check_of(report, CheckKind::time_step).row, 3);
}

TEST(Limits, ComeInRadiansForRotaryAxes) {
  const TemporaryDirectory dir;
  std::ofstream(dir / "a.csv") << "t_s,a_deg\n0,0\n0.001,0.09\n0.002,0.18\n";
  Machine machine;
  machine.axes[3].speed = 90 * kRadiansPerDegree;
  EXPECT_TRUE(verified(dir / "a.csv", machine).passes());
  machine.axes[3].speed = 89.9 * kRadiansPerDegree;
  EXPECT_FALSE(verified(dir / "a.csv", machine).passes());
}

}  // namespace
}  // namespace toolpace
