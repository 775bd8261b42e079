/// The figures of the results say what an independent check of the setpoints says.

#include <QPushButton>
#include <QTableView>
#include <QTest>
#include <cmath>
#include <numbers>

#include "drawing/motion_figures.h"
#include "opened.h"
#include "support/planned.h"
#include "support/ui_test.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/tune/sweep.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

constexpr auto kZigzag = "G21 G90 G94\nF3000\nG1 X10\nY2\nX0\nY4\nX10\nM2\n";

/// A result of plan A by the beginning of its title; its tooltip with it.
std::pair<QString, QString> result(Opened& window, const QString& title) {
  const auto& model = *window.the<QTableView>("resultTable").model();
  for (int row = 0; row < model.rowCount(); ++row) {
    const QModelIndex value = model.index(row, 1);
    if (model.index(row, 0).data().toString().startsWith(title))
      return {value.data().toString(), value.data(Qt::ToolTipRole).toString()};
  }
  return {};
}

double deviation_of(const VerifyReport& report) {
  for (const Check& check : report.checks) {
    if (check.kind == CheckKind::deviation) return check.value;
  }
  return -1;
}

}  // namespace

class FiguresTest : public QObject {
  Q_OBJECT

 private slots:
  void off_the_path_is_what_verify_finds_also_where_the_program_sets_the_tolerance() {
    Opened window;
    window.open("G21 G90 G94\nG64 P0.2\nF3000\nG1 X10\nY10\nX0\nM2\n");
    window.waitForProof();
    const Proof& proof = *window.workspace().plan().proof;
    const double found = deviation_of(*prove(*proof.outcome));
    QVERIFY2(found > 0.01 && found <= 0.2 + 1e-6, qPrintable(QString::number(found)));
    QVERIFY(std::abs(result(window, "Off the path").first.toDouble() * 1e-3 - found) < 1e-4 * found);
    QVERIFY2(std::abs(proof.tube->largest_offset - found) < 2e-3 * 0.2, "the band shows the same");
    QCOMPARE(window.workspace().plan().scene->tolerance, std::optional(0.2));
    // Where blocks differ in their tolerance, no band of one width is drawn for all of them.
    window.open("G21 G90 G94\nG64 P0.2\nF3000\nG1 X10\nY10\nG61\nX0\nY0\nM2\n");
    QVERIFY(!window.workspace().plan().scene->tolerance);
  }

  void the_chord_error_of_rounded_corners_is_that_of_the_motion() {
    // On a steady arc: (50 mm/s · 1 ms)² / (8 · 5 mm).
    const auto arc = planned(Program().arc(10, 0, 0, 5, 0, -std::numbers::pi, 50));
    QVERIFY(std::abs(chord_error(*arc) - 0.05 * 0.05 / 40) < 1e-7);
    Opened window;
    window.open(kZigzag);
    window.workspace().tuning().edit("axes", "axes", [](Tuning& t) {
      for (auto& axis : t.machine.axes) axis = {100, 3000, 1e5};
      t.options.corner.rule = CornerRule::smooth;
      t.options.corner.tolerance = 0.05;
    });
    window.waitForProof();
    const Proof& proof = *window.workspace().plan().proof;
    QVERIFY(!proof.outcome->plan.splines.empty());
    QVERIFY2(proof.chord_error > 0 && proof.chord_error < 0.2 * deviation_of(proof.report),
             "setpoints a millisecond apart follow the curve much more closely than the curve follows the corner");
  }

  void contour_errors_of_rapids_stand_apart() {
    Opened window;
    // On a diagonal, drives of unequal gain are off it by a distance that grows with the speed: rapids run at 100 mm/s.
    window.workspace().tuning().edit("gain", "gain", [](Tuning& t) { t.machine.servo[1].position_gain = 20; });
    window.open("G21 G90 G94\nG0 X20 Y20\nG4 P1\nG1 X0 Y0 F600\nM2\n");
    window.waitForProof();
    const Proof& proof = *window.workspace().plan().proof;
    QVERIFY(proof.contour.cutting > 0);
    QVERIFY2(proof.contour.rapid > 3 * proof.contour.cutting, "ten times as fast");
    QVERIFY(result(window, "· in rapids").first.toDouble() > result(window, "Contour error").first.toDouble());
  }

  void a_figure_that_is_not_there_says_why_and_can_be_asked_for() {
    Opened window;
    window.open("G21 G90 G94\nG1 X1 F600\nG4 P2100\nX0\nM2\n");
    window.waitForProof();
    QVERIFY(!window.workspace().plan().proof);
    const auto [text, why] = result(window, "Violations");
    QCOMPARE(text, QString("–"));
    QVERIFY2(why.contains("setpoints"), qPrintable(why));
    auto& check = window.the<QPushButton>("checkNowButton");
    QVERIFY(check.isVisible());
    QTest::mouseClick(&check, Qt::LeftButton);
    QCOMPARE(result(window, "Violations").first, QString("…"));
    QVERIFY(eventually([&] { return window.workspace().plan().proof != nullptr; }));
    TOOLPACE_EVENTUALLY(!check.isVisible());
    QCOMPARE(result(window, "Violations").first, QString("0"));
  }

  void the_dwell_of_a_tool_change_stands_on_its_line() {
    Opened window;
    window.workspace().tuning().edit("tool", "tool", [](Tuning& t) { t.machine.tool_change = 4; });
    window.open("G21 G90 G94\nG0 X10\nT2 M6\nG1 X0 F600\nM2\n");
    const Timeline& timeline = *window.workspace().timeline();
    QCOMPARE(timeline.lines()[3].rest, 4.0);
    QCOMPARE(timeline.at(timeline.lines()[3].begin + 2).line, 3u);
    window.workspace().setCursorLine(3);
    QCOMPARE(window.workspace().cursorTime(), timeline.lines()[3].begin);
  }

  void depths_are_compared_by_one_way_of_planning() {
    Opened window;
    window.open("G21 G90 G94\nF3000\nG2 X10 I5\nG1 Y5\nG3 X0 I-5\nG1 Y0\nM2\n");
    window.workspace().tuning().edit("ramps", "ramps", [](Tuning& t) {
      t.options.ramps = Ramps::span;
      t.options.law = LawKind::seven_phase;
      for (auto& axis : t.machine.axes) axis = {100, 3000, 1e5};
    });
    studio::settle(window);
    const auto sweep = sweep_lookahead(*window.workspace().job());
    QVERIFY(sweep.has_value());
    Job unrefined = *window.workspace().job();
    unrefined.refined = false;
    const auto plain = run(std::make_shared<const Job>(unrefined));
    QCOMPARE(sweep->points.back().cycle_time, plain->summary.cycle_time);
  }
};

TOOLPACE_UI_TEST(FiguresTest)
#include "figures_test.moc"
