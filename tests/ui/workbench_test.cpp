#include <QContextMenuEvent>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QTimer>

#include "opened.h"
#include "panels/modal_strip.h"
#include "panels/nc_view.h"
#include "panels/number_field.h"
#include "plots/profile_plot.h"
#include "plots/profile_view.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

QString result(Opened& window, const QString& title) {
  const auto& model = *window.the<QTableView>("resultTable").model();
  for (int row = 0; row < model.rowCount(); ++row) {
    if (model.index(row, 0).data().toString().startsWith(title)) return model.index(row, 1).data().toString();
  }
  return {};
}

}  // namespace

class WorkbenchTest : public QObject {
  Q_OBJECT

 private slots:
  void at_the_least_size_the_plots_are_high_and_every_result_is_seen() {
    Opened window({1280, 800});
    window.openButterfly();
    window.waitForProof();
    const auto& plot = window.the<ProfilePlot>("profilePlot");
    for (const auto* rect : plot.axisRects()) {
      QVERIFY2(rect->height() >= 72, qPrintable(QString("%1 px").arg(rect->height())));
    }
    auto& table = window.the<QTableView>("resultTable");
    const int hidden_rows = table.verticalHeader()->length() - table.viewport()->height();
    QVERIFY2(hidden_rows <= 20, "at most the last row is scrolled out of sight");
    // Taller windows give more to the plots, too.
    window.resize(1920, 1200);
    studio::settle(window);
    for (const auto* rect : plot.axisRects()) QVERIFY(rect->height() >= 130);
  }

  void a_spoilt_layout_is_put_right_again() {
    Opened window({1600, 1000});
    window.openButterfly();
    const int plots = window.the<QDockWidget>("plotsDock").height();
    QVERIFY(plots > 400);
    window.the<QDockWidget>("tuningDock").hide();
    window.the<QDockWidget>("programDock").setFloating(true);
    window.resizeDocks({&window.the<QDockWidget>("plotsDock")}, {200}, Qt::Vertical);
    window.actions().reset_layout->trigger();
    studio::settle(window);
    QVERIFY(window.the<QDockWidget>("tuningDock").isVisible());
    QVERIFY(!window.the<QDockWidget>("programDock").isFloating());
    QVERIFY(std::abs(window.the<QDockWidget>("plotsDock").height() - plots) <= 4);
  }

  void modal_state_follows_the_cursor_line() {
    Opened window;
    window.open(
        "G21 G90 G94\nT3 M6\nG55 S8000 M3\nG1 X10 F1200\nG91 G20\nG2 X1 I0.5 F20\nM8\nG90 G21 G1 X0 Y0 F600\nM2\n");
    auto& strip = window.the<ModalStrip>("modalStrip");
    auto& view = window.the<NcView>("ncView");
    QVERIFY(strip.isVisible());
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_Home);
    QVERIFY(strip.text().contains("G54") && strip.text().contains("T0"));
    for (int i = 0; i < 3; ++i) QTest::keyClick(&view, Qt::Key_Down);
    QCOMPARE(view.currentLine(), 4);
    QVERIFY(strip.text().contains("G55") && strip.text().contains("T3") && strip.text().contains("F1200 mm/min"));
    QVERIFY(strip.text().contains("M3"));
    for (int i = 0; i < 2; ++i) QTest::keyClick(&view, Qt::Key_Down);
    QVERIFY(strip.text().contains("G20") && strip.text().contains("G91") && strip.text().contains("F20 in/min"));
    QVERIFY(strip.text().contains(">G2<"));
    QVERIFY(strip.toolTip().contains("incremental"));
    window.setLanguage("zh_CN");
    QVERIFY(eventually([&] { return !strip.toolTip().contains("incremental"); }));
    // A polyline has none.
    window.open("x_mm,y_mm\n0,0\n10,0\n", "line.csv");
    QVERIFY(!strip.isVisible());
  }

  void a_feed_hold_at_the_cursor_stops_and_resumes_in_the_plots() {
    Opened window;
    window.open("G21 G90 G94\nG1 X100 F3000\nM2\n");
    const double before = window.workspace().timeline()->duration();
    window.workspace().setCursorTime(1.0);
    window.actions().hold->trigger();
    studio::settle(window);
    const auto timeline = window.workspace().timeline();
    QVERIFY2(timeline->duration() > before + 1.0, "a second of rest, and the way to it and from it");
    // It rests somewhere after the hold and runs at the feed again later.
    QVERIFY(timeline->at(1.5).state.speed < 1e-9);
    QVERIFY(std::abs(timeline->at(timeline->duration() - 0.5).state.speed - 50) < 1e-6);
    QCOMPARE(window.the<NumberField>("holdEdit").text(), QString("1"));
    screenshot(window, "feed-hold");
    window.actions().undo->trigger();
    studio::settle(window);
    QCOMPARE(window.workspace().timeline()->duration(), before);
    QCOMPARE(window.the<NumberField>("holdEdit").text(), QString("–"));
    // The same by typing, and away with it by an empty field.
    auto& field = window.the<NumberField>("holdEdit");
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, "0.5");
    QTest::keyClick(&field, Qt::Key_Return);
    studio::settle(window);
    QVERIFY(window.workspace().timeline()->duration() > before + 1.0);
    field.selectAll();
    QTest::keyClick(&field, Qt::Key_Delete);
    QTest::keyClick(&field, Qt::Key_Return);
    studio::settle(window);
    QCOMPARE(window.workspace().timeline()->duration(), before);
  }

  void the_menu_of_the_plots_holds_where_it_was_opened() {
    Opened window;
    window.open("G21 G90 G94\nG1 X100 F3000\nM2\n");
    auto& profile = window.the<ProfileView>("profileView");
    auto& plot = profile.plot();
    const auto [left, right] = plot.edges();
    const QPoint at = plot.mapTo(&profile, QPoint(static_cast<int>((left + right) / 2), 40));
    const double time = *profile.timeAt(at);
    QTimer look;  // the menu keeps this thread until it closes
    connect(&look, &QTimer::timeout, &window, [&] {
      auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      if (!menu) return;
      look.stop();
      auto* action = menu->findChild<QAction*>("holdHereAction");
      QVERIFY(action);
      action->trigger();
      menu->close();
    });
    look.start(5);
    QContextMenuEvent ask(QContextMenuEvent::Mouse, at, profile.mapToGlobal(at));
    QApplication::sendEvent(&profile, &ask);
    studio::settle(window);
    QVERIFY(window.workspace().tuning().value().options.hold_at.has_value());
    QVERIFY(std::abs(*window.workspace().tuning().value().options.hold_at - time) < 1e-9);
  }

  void another_program_takes_no_hold_over() {
    Opened window;
    window.open("G21 G90 G94\nG1 X100 F3000\nM2\n");
    window.workspace().setCursorTime(1.5);
    window.actions().hold->trigger();
    studio::settle(window);
    window.open("G21 G90 G94\nG1 X10 F3000\nM2\n", "other.ngc");
    QVERIFY(!window.workspace().tuning().value().options.hold_at);
    QVERIFY(window.workspace().problems().empty());
  }

  void the_lower_bound_stands_in_the_results() {
    Opened window;
    window.open("G21 G90 G94\nG1 X100 F3000\nM2\n");
    window.waitForProof();
    const double bound = result(window, "Lower bound").toDouble();
    const double cycle = window.workspace().timeline()->duration();
    // By hand: without a jerk limit 100 mm at 50 mm/s and 3000 mm/s² take 100/50 + 50/3000 = 2.0167 s.
    QVERIFY(bound >= 2.0166 && bound <= cycle);
    QCOMPARE(result(window, "· plan above it"), QString::number((cycle / bound - 1) * 100, 'f', 1));
  }
};

TOOLPACE_UI_TEST(WorkbenchTest)
#include "workbench_test.moc"
