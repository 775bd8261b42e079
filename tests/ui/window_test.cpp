#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <random>

#include "main_window.h"
#include "panels/dock_title.h"
#include "panels/nc_panel.h"
#include "panels/number_field.h"
#include "panels/result_model.h"
#include "panels/sweep_panel.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"
#include "screenshot.h"
#include "support/events.h"
#include "support/find.h"
#include "support/patience.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::studio;

/// The window with the example, planned.
class Opened : public MainWindow {
 public:
  explicit Opened(const QSize& size = {1280, 800}) : MainWindow(false) {
    setLanguage("en");
    resize(size);
    show();
    openExample();
    settle(*this);
  }
  template <class T>
  T& the(const char* name) {
    return ui::find<T>(*this, name);
  }
};

class WindowTest : public QObject {
  Q_OBJECT

 private slots:
  void the_first_start_shows_the_planned_butterfly_and_where_to_drop_a_program() {
    Opened window;
    QVERIFY(window.workspace().timeline());
    QVERIFY(window.workspace().timeline()->duration() > 1);
    QVERIFY(window.the<QLabel>("dropHint").isVisible());
    QCOMPARE(window.the<QLabel>("dropHint").text(), QString("drop an NC program here"));
    QVERIFY(!window.workspace().isStale());
    QVERIFY(window.the<QLabel>("cycleTimeLabel").text().endsWith(" s"));
  }

  // Qt's restoreState() read a list of tab bars that showing one of them had freed, after a panel was dragged somewhere.
  void the_panels_come_back_whatever_became_of_them() {
    Opened window;
    std::mt19937 chance(1);
    const auto pick = [&](int count) { return static_cast<int>(chance() % static_cast<unsigned>(count)); };
    const auto docks = window.findChildren<QDockWidget*>();
    const auto titles = window.findChildren<ui::DockTitle*>();
    for (int round = 0; round < 40; ++round) {
      for (int change = 0; change < 3; ++change) {
        QDockWidget& dock = *docks[pick(static_cast<int>(docks.size()))];
        dock.setVisible(pick(4) > 0);
        dock.raise();
        if (pick(4) == 0) window.resize(640 + pick(1400), 400 + pick(800));
        if (pick(2) == 0) QApplication::processEvents();
      }
      if (ui::DockTitle& title = *titles[pick(static_cast<int>(titles.size()))]; title.isVisible()) {
        ui::drag(title, title.rect().center(), {pick(1200) - 600, pick(800) - 400});
      }
      window.the<QAction>("resetLayoutAction").trigger();
      for (const char* name : {"programDock", "plotsDock", "tuningDock", "resultsDock"}) {
        QVERIFY2(window.the<QDockWidget>(name).isVisible(), name);
      }
      QVERIFY(!window.the<QDockWidget>("singleMoveDock").isVisible());
    }
  }

  void pictures_of_both_themes_both_languages_and_two_sizes() {
    for (const bool dark : {false, true}) {
      for (const char* language : {"en", "zh_CN"}) {
        for (const QSize size : {QSize(1280, 800), QSize(2560, 1440)}) {
          Opened window(size);
          window.setLanguage(language);
          window.setDark(dark);
          window.workspace().setCursorTime(2.0);
          const QString name = QString("window-%1-%2-%3").arg(dark ? "dark" : "light", language).arg(size.width());
          QVERIFY(ui::colours_in(ui::screenshot(window, name)) > 100);
          // Nothing scrolls sideways and nothing is pushed out of the window at the least size.
          QCOMPARE(window.size(), size);
        }
      }
    }
  }

  void one_cursor_moves_program_path_plots_and_read_out() {
    Opened window;
    auto& view = window.the<ui::NcView>("ncView");
    window.workspace().setCursorLine(200);
    QCOMPARE(view.currentLine(), 200);
    QVERIFY(window.the<QLabel>("timeReadout").text().contains("line 200"));
    const double before = window.workspace().cursorTime();
    QTest::keyClick(&window, Qt::Key_Right);
    QVERIFY(window.workspace().cursorTime() > before);
    QCOMPARE(view.currentLine(), 201);
    QTest::keyClick(&window, Qt::Key_Left);
    QCOMPARE(view.currentLine(), 200);
    // A click on a line of the program goes there too.
    view.setFocus();
    QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, QPoint(150, view.viewport()->height() - 10));
    QVERIFY(view.currentLine() != 200);
    QVERIFY(window.the<QLabel>("timeReadout").text().contains(QString("line %1").arg(view.currentLine())));
  }

  void go_to_leads_to_lines_block_numbers_and_times() {
    Opened window;
    window.workspace().openText("N10 G21 G90 F600\nN20 G1 X10\nN30 Y10\nX0\nM2\n", "corner.ngc");
    settle(window);
    const auto go = [&](const QString& where) {
      window.actions().go_to->trigger();
      auto& field = window.the<QLineEdit>("findEdit");
      QTest::keyClicks(&field, where);  // over what was asked for before
      QTest::keyClick(&field, Qt::Key_Return);
    };
    auto& view = window.the<ui::NcView>("ncView");
    go("N30");
    QCOMPARE(view.currentLine(), 3);
    QVERIFY(window.the<QLabel>("timeReadout").text().contains("N30"));
    go("4");
    QCOMPARE(view.currentLine(), 4);
    QVERIFY(window.the<QLabel>("timeReadout").text().contains("line 4"));
    go("0.5 s");
    QCOMPARE(window.workspace().cursorTime(), 0.5);
    QCOMPARE(view.currentLine(), 2);
    go("99");
    QCOMPARE(view.currentLine(), 2);
    // The text that was looked for comes back with its own bar.
    window.actions().find->trigger();
    QVERIFY(window.the<QLineEdit>("findEdit").text().isEmpty());
    QTest::keyClicks(&window.the<QLineEdit>("findEdit"), "Y10");
    QTest::keyClick(&window.the<QLineEdit>("findEdit"), Qt::Key_Return);
    QCOMPARE(view.currentLine(), 3);
  }

  void playing_moves_the_cursor_and_pauses_at_the_end() {
    Opened window;
    QTest::keyClick(&window, Qt::Key_Home);
    QCOMPARE(window.workspace().cursorTime(), 0.0);
    window.workspace().playback().setRate(100);
    QTest::keyClick(&window, Qt::Key_Space);
    QVERIFY(window.workspace().playback().isPlaying());
    QVERIFY(ui::eventually([&] { return !window.workspace().playback().isPlaying(); }));
    QCOMPARE(window.workspace().cursorTime(), window.workspace().timeline()->duration());
  }

  void pinning_makes_b_and_swapping_exchanges_the_parameters() {
    Opened window;
    const double at_all = window.workspace().timeline()->duration();
    QTest::mouseClick(&window.the<QToolButton>("pinButton"), Qt::LeftButton);
    QVERIFY(window.workspace().pinned());
    window.workspace().tuning().edit("N", "lookahead", [](ui::Tuning& t) { t.options.lookahead = 1; });
    settle(window);
    const double at_one = window.workspace().timeline()->duration();
    QVERIFY(at_one > at_all);
    QVERIFY(window.the<QLabel>("cycleDeltaLabel").text().startsWith("+"));
    ui::screenshot(window, "window-a-and-b");
    QTest::mouseClick(&window.the<QToolButton>("swapButton"), Qt::LeftButton);
    settle(window);
    QCOMPARE(window.workspace().timeline()->duration(), at_all);
    QCOMPARE(window.workspace().pinned().timeline->duration(), at_one);
    QVERIFY(!window.workspace().tuning().value().options.lookahead);
    QTest::mouseClick(&window.the<QToolButton>("unpinButton"), Qt::LeftButton);
    QVERIFY(!window.workspace().pinned());
  }

  void the_sweep_marks_the_knee() {
    Opened window;
    auto& panel = window.the<ui::SweepPanel>("sweepPanel");
    QSignalSpy computed(&panel, &ui::SweepPanel::computed);
    window.actions().sweep->trigger();
    QVERIFY(ui::eventually(computed));
    const auto& sweep = panel.lastSweep();
    QVERIFY(sweep.points.size() > 5);
    QVERIFY(!sweep.points.back().lookahead);
    QVERIFY(sweep.points[sweep.knee].cycle_time <= sweep.points.back().cycle_time * 1.01);
    ui::screenshot(window, "window-sweep");
  }

  void every_control_has_a_name_for_people_and_for_tests() {
    Opened window;
    for (const auto* control : window.findChildren<QWidget*>()) {
      const bool is_control = qobject_cast<const QAbstractButton*>(control) ||
                              qobject_cast<const ui::NumberField*>(control) ||
                              qobject_cast<const QAbstractSlider*>(control) || control->inherits("QComboBox") ||
                              control->inherits("QTableView");
      if (!is_control || control->objectName().startsWith("qt_") || control->inherits("QScrollBar")) continue;
      if (control->parentWidget() && control->parentWidget()->inherits("QAbstractItemView")) continue;
      if (control->parentWidget() && control->parentWidget()->inherits("QDockWidget")) continue;
      if (control->inherits("QToolBarExtension") || control->parentWidget()->inherits("QTabBar")) continue;
      const auto* button = qobject_cast<const QToolButton*>(control);
      if (button && button->defaultAction()) continue;  // named by its action
      const QString what = control->metaObject()->className() + QString(" ") + control->objectName();
      QVERIFY2(!control->objectName().isEmpty(), qPrintable(what));
      const bool has_text = qobject_cast<const QAbstractButton*>(control) &&
                            !static_cast<const QAbstractButton*>(control)->text().isEmpty();
      QVERIFY2(!control->accessibleName().isEmpty() || has_text, qPrintable(what));
    }
  }

  void touch_mode_makes_every_field_and_button_high_enough_for_a_finger() {
    Opened window({1600, 1200});
    window.setTouch(true);
    settle(window);
    for (const char* name : {"amEdit", "lawBox", "playButton", "lookaheadSlider"}) {
      QVERIFY2(window.the<QWidget>(name).height() >= 48, name);
    }
    ui::screenshot(window, "window-touch");
    window.setTouch(false);
  }

  void inches_change_every_unit_that_is_shown() {
    Opened window;
    window.setInch(true);
    settle(window);
    QVERIFY(window.the<QLabel>("positionReadout").text().endsWith(" in"));
    QCOMPARE(window.the<ui::NumberField>("vmaxEdit").unitText(), QString("in/s"));
    ui::screenshot(window, "window-inch");
  }

  void two_plans_with_dwells_and_rotary_axes_need_no_scrolling_in_a_small_window() {
    Opened window;
    window.workspace().openText("G21 G90 G94 F1200\nG1 X30 A90\nG4 P1.5\nG0 Y20 B10 C5\nG4 P0.5\nG1 Y0\nM2\n",
                                "dwells.ngc");
    settle(window);
    window.workspace().pin();
    window.workspace().tuning().edit("A", "a", [](ui::Tuning& t) { t.machine.path.acceleration = 1500; });
    settle_with_proof(window);
    for (const char* language : {"en", "zh_CN"}) {
      window.setLanguage(language);
      settle(window);
      auto& table = window.the<QTableView>("resultTable");
      // Every figure; the settings that differ follow below.
      const auto& model = dynamic_cast<ui::ResultModel&>(*table.model());
      int last = model.rowCount() - 1;
      while (model.isSetting(last) || table.isRowHidden(last)) --last;
      QVERIFY(table.visualRect(model.index(last, 0)).bottom() <= table.viewport()->height());
      QCOMPARE(table.horizontalScrollBar()->maximum(), 0);
      ui::screenshot(window, QString("two-plans-dwells-rotary-") + language);
    }
  }

  void rows_of_results_are_as_high_as_each_other_for_fingers_too() {
    Opened window;
    auto& table = window.the<QTableView>("resultTable");
    for (const bool touch : {true, false}) {
      window.setTouch(touch);
      // A dwell and a rapid bring rows that were hidden while the height changed.
      window.workspace().openText(touch ? "G21 G90 G94 F600\nG1 X10\nG4 P1\nG0 X0\nM2\n" : "G1 X10 F600\nM2\n",
                                  "a.ngc");
      settle(window);
      for (int row = 0; row < table.model()->rowCount(); ++row) {
        if (!table.isRowHidden(row)) QCOMPARE(table.rowHeight(row), table.verticalHeader()->defaultSectionSize());
      }
      QCOMPARE(table.verticalHeader()->defaultSectionSize() > 40, touch);
    }
  }
};

TOOLPACE_UI_TEST(WindowTest)
#include "window_test.moc"
