#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <cmath>
#include <numbers>

#include "drawing/circularity.h"
#include "opened.h"
#include "panels/circle_panel.h"
#include "panels/nc_view.h"
#include "panels/polar_plot.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

/// A full circle of 20 mm at 50 mm/s in four quarters, then one of 10 mm in the XZ plane.
constexpr auto kCircles =
    "G21 G90 G94 F3000\nG1 X20 Y0\nG3 X0 Y20 I-20\nX-20 Y0 J-20\nX0 Y-20 I20\nX20 Y0 J20\nG1 X40\n"
    "G18 G2 X40 Z0 I10 K0\nM2\n";

constexpr double kGain = 50;  // [1/s], of machine files

void open_circles(Opened& window, double backlash = 0) {
  window.open(kCircles);
  window.workspace().tuning().edit("machine", "machine", [backlash](Tuning& t) {
    t.options.ramps = Ramps::span;
    t.options.corner.rule = CornerRule::junction;
    t.machine.servo[0].backlash = backlash;
  });
  window.waitForProof();
  window.the<QDockWidget>("circleDock").raise();
  studio::settle(window);
}

}  // namespace

class CircleTest : public QObject {
  Q_OBJECT

 private slots:
  void four_quarters_are_one_circle_and_the_drives_make_it_smaller() {
    Opened window;
    open_circles(window);
    auto& panel = window.the<CirclePanel>("circlePanel");
    window.workspace().setCursorLine(3);
    const Roundness& roundness = panel.roundness();
    QVERIFY(!roundness.is_empty());
    QCOMPARE(roundness.circle.line, 3u);
    QVERIFY(std::abs(roundness.circle.sweep - 2 * std::numbers::pi) < 1e-9);
    QCOMPARE(roundness.circle.start_radius, 20.0);
    // By hand: loop and drive are y/r = Kv·ω²/(s³ + 2ζω·s² + ω²·s + Kv·ω²); on a circle run at s = j·v/R = 2.5j 1/s its
    // amplitude falls short of 1 by (s/Kv)²/2 = 1.25e-3 for the loop and gains 2ζ·s²/(ω·Kv) = 2.8e-4 from the drive.
    const double turn = 2.5, drive = 2 * std::numbers::pi * 100, damping = 0.7;
    const double real = 1 - 2 * damping * turn * turn / (drive * kGain);
    const double imaginary = turn / kGain - turn * turn * turn / (drive * drive * kGain);
    const double expected = 20.0 * (1 / std::hypot(real, imaginary) - 1);
    const auto middle = roundness.points[roundness.points.size() / 2];
    QVERIFY2(std::abs(middle.error - expected) < 0.01 * std::abs(expected),
             qPrintable(QString("%1 mm, by hand %2").arg(middle.error).arg(expected)));
    QVERIFY(roundness.is_steady);
    QVERIFY(std::abs(roundness.mean - expected) < 0.01 * std::abs(expected));
    QVERIFY2(roundness.deviation() < 0.02 * std::abs(expected), "run-in and run-out are no error of a circle");
    screenshot(window, "circle");
    window.setDark(true);
    window.setLanguage("zh_CN");
    screenshot(window, "circle-dark-zh");
  }

  void backlash_shows_at_the_reversals_of_its_axis() {
    Opened window;
    open_circles(window, 0.02);
    auto& panel = window.the<CirclePanel>("circlePanel");
    window.workspace().setCursorLine(3);
    const Roundness& with = panel.roundness();
    // X turns round at 0° and 180°: just after 180° the slide still stands where it was, farther out by part of the play.
    const auto error_at = [&](double degrees) {
      double best = 1e9, error = 0;
      for (const auto& p : with.points) {
        const double off = std::abs(std::remainder(p.angle - degrees * std::numbers::pi / 180, 2 * std::numbers::pi));
        if (off < best) (best = off, error = p.error);
      }
      return error;
    };
    QVERIFY2(error_at(184) - error_at(176) > 0.01, "the step of the play in X at its reversal");
    screenshot(window, "circle-backlash");
  }

  void the_cursor_chooses_the_circle_and_the_buttons_go_from_one_to_the_next() {
    Opened window;
    open_circles(window);
    auto& panel = window.the<CirclePanel>("circlePanel");
    QVERIFY(window.the<QLabel>("circleTitle").text().startsWith("line 3 "));  // the longest circle, before any choice
    window.workspace().setCursorLine(5);
    QCOMPARE(panel.roundness().circle.line, 3u);
    QTest::mouseClick(&window.the<QToolButton>("nextCircle"), Qt::LeftButton);
    QCOMPARE(panel.roundness().circle.line, 8u);
    const auto plane = std::array{0, 2};
    QCOMPARE(panel.roundness().circle.axes, plane);
    QCOMPARE(window.the<NcView>("ncView").currentLine(), 8);
    QTest::mouseClick(&window.the<QToolButton>("previousCircle"), Qt::LeftButton);
    QCOMPARE(panel.roundness().circle.line, 3u);
    // A click on the curve goes to that moment.
    auto& plot = window.the<PolarPlot>("polarPlot");
    const auto& aim = panel.roundness().points[panel.roundness().points.size() / 3];
    QTest::mouseClick(&plot, Qt::LeftButton, {}, plot.position(aim).toPoint());
    QVERIFY(std::abs(window.workspace().cursorTime() - aim.time) < 0.02);
  }

  void the_error_is_enlarged_as_asked_for() {
    Opened window;
    open_circles(window);
    auto& plot = window.the<PolarPlot>("polarPlot");
    QVERIFY(plot.enlargement() > 10);  // 25 µm of 20 mm would not be seen otherwise
    auto& box = window.the<QComboBox>("circleEnlargement");
    box.setCurrentIndex(box.findData(100));
    emit box.activated(box.currentIndex());
    QVERIFY(std::abs(plot.enlargement() - 100) < 1e-6);
    QVERIFY(window.the<QLabel>("circleFigures").text().contains("×100"));
  }

  void a_circle_too_short_for_the_drives_to_settle_is_measured_with_its_run_in() {
    Opened window;
    window.open("G21 G90 G94 F3000\nG1 X0.5 Y0\nG3 X-0.5 Y0 I-0.5\nG1 X-1\nM2\n");
    window.waitForProof();
    window.the<QDockWidget>("circleDock").raise();
    studio::settle(window);
    const Roundness& roundness = window.the<CirclePanel>("circlePanel").roundness();
    QVERIFY(!roundness.is_empty() && !roundness.is_steady);
    QVERIFY(roundness.deviation() > 0);
    QVERIFY(window.the<QLabel>("circleFigures").text().contains("with run-in and run-out"));
  }

  void a_program_without_arcs_says_so() {
    Opened window;
    window.open("G21 G90 G94 F600\nG1 X10\nY10\nM2\n");
    window.waitForProof();
    window.the<QDockWidget>("circleDock").raise();
    studio::settle(window);
    QVERIFY(window.the<CirclePanel>("circlePanel").roundness().is_empty());
    QVERIFY(window.the<QLabel>("circleFigures").text().isEmpty());
    screenshot(window, "circle-none");
  }
};

TOOLPACE_UI_TEST(CircleTest)
#include "circle_test.moc"
