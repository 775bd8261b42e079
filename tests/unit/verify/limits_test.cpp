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
