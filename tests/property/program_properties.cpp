/// Random NC programs of every kind of motion, under every corner rule, with overrides and feed holds: read, planned,
/// sampled and proven.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "case_count.h"
#include "planned_program.h"
#include "toolpace/law/law_table.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/prove.h"

namespace toolpace {
namespace {

using Random = std::mt19937_64;

double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
double spread(Random& random, double low, double high) {
  return std::exp(between(random, std::log(low), std::log(high)));
}
bool one_in(Random& random, unsigned n) { return random() % n == 0; }

/// Writes a program block by block; every number is written to 1e-4, and that is where the next block begins.
class ProgramText {
 public:
  ProgramText(Random& random, bool rotary) : random_(random), rotary_(rotary), size_(spread(random, 0.1, 30)) {
    text_ = "G21 G90 G94 G17\nF1200\n";
  }

  void add_block() {
    heading_ += between(random_, -1, 1) * (one_in(random_, 4) ? 3 : 0.3);
    switch (random_() % 24) {
      case 0: text_ += fmt::format("G4 P{:.3f}\n", between(random_, 0, 0.02)); return;
      case 1: text_ += one_in(random_, 2) ? "M0\n" : "T1 M6\n"; return;
      case 2: change_mode(); return;
      case 3: text_ += fmt::format("G0 {}\n", step(3)); return;
      case 4:
      case 5:
      case 6:
      case 7: arc(); return;
      case 8:
      case 9: spline(); return;
      case 10: inverse_time(); return;
      case 11:
        if (rotary_) turn();
        return;
      default: break;
    }
    const std::string target = step(1);
    text_ += fmt::format("G1 {}{} F{:.1f}\n", target, rotary_ && one_in(random_, 3) ? rotary_words() : "", feed());
  }

  std::string finish() const { return text_ + "M2\n"; }

 private:
  double feed() { return spread(random_, 60, 24000); }  // mm/min
  static double rounded(double v) { return std::round(v * 1e4) / 1e4; }

  std::string step(double scale) {
    const double length = scale * size_ * spread(random_, 0.05, 2);
    x_ = rounded(x_ + length * std::cos(heading_));
    y_ = rounded(y_ + length * std::sin(heading_));
    if (one_in(random_, 5)) z_ = rounded(between(random_, -2, 2));
    return fmt::format("X{:.4f} Y{:.4f} Z{:.4f}", x_, y_, z_);
  }
  std::string rotary_words() {
    a_ = rounded(a_ + between(random_, -60, 60));
    c_ = rounded(c_ + between(random_, -10, 10));
    return fmt::format(" A{:.4f} C{:.4f}", a_, c_);
  }
  void turn() { text_ += fmt::format("G1{} F{:.1f}\n", rotary_words(), feed()); }

  void change_mode() {
    constexpr const char* kModes[] = {"G61", "G61.1", "G64", "G64 P0.01", "G64 P0.05 Q0"};
    text_ += fmt::format("{}\n", kModes[random_() % std::size(kModes)]);
  }

  // By centre and end point, both rounded: the radii differ by 1e-4 at most.
  void arc() {
    const double radius = size_ * spread(random_, 0.1, 3), side = one_in(random_, 2) ? 1 : -1;
    const double along = one_in(random_, 2) ? heading_ : between(random_, -3, 3);
    const double sweep = side * spread(random_, 0.05, 6.2);
    const double i = rounded(-side * radius * std::sin(along)), j = rounded(side * radius * std::cos(along));
    if (std::hypot(i, j) < 0.01) return;
    const double cx = x_ + i, cy = y_ + j, c = std::cos(sweep), s = std::sin(sweep);
    x_ = rounded(cx - c * i + s * j);
    y_ = rounded(cy - s * i - c * j);
    if (one_in(random_, 3)) z_ = rounded(z_ + between(random_, -1, 1));
    heading_ = along + sweep;
    text_ += fmt::format("G{} X{:.4f} Y{:.4f} Z{:.4f} I{:.4f} J{:.4f} F{:.1f}\n", side > 0 ? 3 : 2, x_, y_, z_, i, j,
                         feed());
  }

  void spline() {
    const double length = size_ * spread(random_, 0.3, 2), reach = length / 3;
    const double leave = heading_, arrive = heading_ + between(random_, -1.5, 1.5);
    const double middle = (leave + arrive) / 2;
    x_ = rounded(x_ + length * std::cos(middle));
    y_ = rounded(y_ + length * std::sin(middle));
    heading_ = arrive;
    text_ +=
        fmt::format("G5 X{:.4f} Y{:.4f} I{:.4f} J{:.4f} P{:.4f} Q{:.4f} F{:.1f}\n", x_, y_, reach * std::cos(leave),
                    reach * std::sin(leave), -reach * std::cos(arrive), -reach * std::sin(arrive), feed());
  }

  void inverse_time() {
    text_ += fmt::format("G93 G1 {} F{:.2f}\nG94 F{:.1f}\n", step(1), spread(random_, 20, 2000), feed());
  }

  Random& random_;
  bool rotary_;
  double size_, heading_ = 0.0;
  double x_ = 0, y_ = 0, z_ = 0, a_ = 0, c_ = 0;
  std::string text_;
};

toolpace::Setup random_setup(Random& random, bool rotary) {
  toolpace::Setup setup = default_setup();
  const double speed = spread(random, 20, 500), acceleration = spread(random, 300, 10000);
  const double jerk = acceleration * spread(random, 10, 300);
  setup.machine.path = {speed, acceleration, acceleration * between(random, 0.5, 1), jerk,
                        jerk * between(random, 0.5, 1)};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (one_in(random, 4) && !is_rotary(axis)) continue;
    const double unit = is_rotary(axis) ? kRadiansPerDegree : 1.0;
    setup.machine.axes[axis].speed = speed * spread(random, 0.3, 2) * unit;
    setup.machine.axes[axis].acceleration = acceleration * spread(random, 0.3, 2) * unit;
    setup.machine.axes[axis].jerk = jerk * spread(random, 0.3, 2) * unit;
  }
  constexpr double kPeriods[] = {0.0005, 0.001, 0.001, 0.002, 0.004};
  setup.machine.period = kPeriods[random() % std::size(kPeriods)];
  setup.machine.tool_change = one_in(random, 2) ? 0.05 : 0.0;
  const auto laws = law_table();
  setup.options.law = laws[random() % laws.size()].kind;
  setup.options.ramps = one_in(random, 2) ? Ramps::block : Ramps::span;
  constexpr CornerRule kRules[] = {CornerRule::stop,  CornerRule::servo, CornerRule::junction,
                                   CornerRule::blend, CornerRule::blend, CornerRule::smooth};
  setup.options.corner.rule = kRules[random() % (rotary ? std::size(kRules) - 1 : std::size(kRules))];
  setup.options.corner.tolerance = spread(random, 0.002, 0.2);
  if (one_in(random, 3)) setup.options.lookahead = 1 + random() % 20;
  if (one_in(random, 4)) setup.options.feed_override = between(random, 0.2, 2);
  if (one_in(random, 4)) setup.options.rapid_override = between(random, 0.2, 1);
  const bool smooth = setup.options.corner.rule == CornerRule::smooth;
  if (one_in(random, 3) && !smooth) setup.options.hold_at = between(random, 0, 2);
  return setup;
}

std::string described(const toolpace::Setup& setup, const std::string& text) {
  const PlanOptions& o = setup.options;
  return fmt::format("law {}, corner {}, tolerance {}, ramps {}, lookahead {}, override {}, hold {}, period {}\n{}\n{}",
                     law_row(o.law).id, static_cast<int>(o.corner.rule), o.corner.tolerance, static_cast<int>(o.ramps),
                     o.lookahead.value_or(0), o.feed_override, o.hold_at.value_or(-1), setup.machine.period, text,
                     format_setup(setup));
}

/// Adds the rows of its setpoints.
void prove_program(std::uint64_t seed, std::int64_t& rows) {
  Random random(seed);
  const bool rotary = one_in(random, 4);
  const toolpace::Setup setup = random_setup(random, rotary);
  const bool smooth = setup.options.corner.rule == CornerRule::smooth;
  ProgramText program(random, rotary);
  for (std::size_t blocks = 2 + random() % (smooth ? 12 : 40); blocks > 0; --blocks) program.add_block();
  const std::string text = program.finish();
  auto reading = read_text(text, "random.ngc");
  ASSERT_TRUE(reading);
  ASSERT_FALSE(reading->refused) << reading->diagnostics.at(0).message << "\n" << text;
  auto job = std::make_shared<Job>();
  job->program = std::make_shared<const Reading>(std::move(*reading));
  job->machine = setup.machine;
  job->options = setup.options;
  const auto outcome = run(job);
  if (!outcome && outcome.error().code == std::string("hold-after-end")) return;
  ASSERT_TRUE(outcome) << outcome.error().message << ", seed " << seed << "\n" << described(setup, text);
  const auto report = prove(*outcome);
  ASSERT_TRUE(report) << report.error().message << ", seed " << seed << "\n" << described(setup, text);
  EXPECT_TRUE(report->passes()) << "seed " << seed << ", " << testing::broken(*report) << described(setup, text);
  rows += report->rows;
}

TEST(SetpointsOfRandomNcPrograms, KeepEveryLimit) {
  constexpr std::size_t kUsualPrograms = 60;
  std::int64_t rows = 0;
  for (std::uint64_t seed = 1; seed <= test::case_count(kUsualPrograms); ++seed) prove_program(seed, rows);
  RecordProperty("setpoints", std::to_string(rows));
}

// Two programs in which a blend reaches to a corner at which G61 begins: the row before the corner is off the path.
TEST(SetpointsOfRandomNcPrograms, AreExemptAtCornersOfG61BesideBlends) {
  std::int64_t rows = 0;
  for (const std::uint64_t seed : {1601u, 3553u}) prove_program(seed, rows);
  EXPECT_GT(rows, 0);
}

}  // namespace
}  // namespace toolpace
