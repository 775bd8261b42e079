/// Everything has a place: how programs are read, drives, presets, imports, menus of the right button.

#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QUndoStack>
#include <QUrl>

#include "import_dialog.h"
#include "models/presets.h"
#include "opened.h"
#include "panels/nc_view.h"
#include "panels/number_field.h"
#include "panels/reading_page.h"
#include "preview/contour_view.h"
#include "support/dialogs.h"
#include "support/files.h"
#include "support/screenshot.h"
#include "support/ui_test.h"
#include "toolpace/machine/read_machine.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

constexpr auto kDump = "$11=0.010\n$100=80\n$110=3000\n$120=200\n$130=300\n";

bool has_problem(Opened& window, const char* code) {
  const auto& all = window.workspace().problems();
  return std::any_of(all.begin(), all.end(), [code](const Diagnostic& d) { return d.code == code; });
}

/// Names of the actions of the menu that a right click at a place of a widget opens.
QStringList menu_at(QWidget& widget, const QPoint& at, bool as_event) {
  QStringList names;
  QTimer::singleShot(0, &widget, [&names] {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    if (!menu) return;
    for (const QAction* action : menu->actions()) names << action->text();
    menu->close();
  });
  if (as_event) {
    QContextMenuEvent asked(QContextMenuEvent::Mouse, at, widget.mapToGlobal(at));
    QApplication::sendEvent(&widget, &asked);
  } else {
    QTest::mouseClick(&widget, Qt::RightButton, {}, at);
  }
  return names;
}

}  // namespace

class PlacesTest : public QObject {
  Q_OBJECT

 private slots:
  void a_missing_sub_program_has_a_button_and_its_folder_mends_it() {
    QTemporaryDir folder;
    QDir(folder.path()).mkdir("subs");
    write(folder.filePath("part.nc"), "%\nO1\nG21 G90 G94 F600\nG1 X10.\nM98 P1234\nM30\n%\n");
    write(folder.filePath("subs/1234.nc"), "%\nO1234\nG1 Y10.\nM99\n%\n");
    Opened window;
    window.openProgram(folder.filePath("part.nc"));
    studio::settle(window);
    QVERIFY(has_problem(window, "sub-program-missing"));
    QPushButton* button = nullptr;
    for (auto* found : window.the<QTableView>("problemTable").findChildren<QPushButton*>()) button = found;
    QVERIFY(button);
    QCOMPARE(button->text(), QString("Folder…"));
    QVERIFY(button->isVisible());
    QVERIFY2(button->width() >= button->sizeHint().width(), "its text is cut off");
    const NextDialog chosen([&](QWidget& dialog) {
      auto& files = dynamic_cast<QFileDialog&>(dialog);
      files.setDirectory(folder.filePath("subs"));
      QMetaObject::invokeMethod(&files, "accept", Qt::QueuedConnection);
    });
    button->click();
    TOOLPACE_EVENTUALLY(window.the<QListWidget>("readingFolders").count() == 1);
    studio::settle(window);
    QVERIFY(!has_problem(window, "sub-program-missing"));
    QCOMPARE(window.workspace().timeline()->at(1e9).position.y(), 10.0);
    QVERIFY(!window.workspace().program().isModified());
  }

  void the_program_is_read_as_the_page_says() {
    Opened window;
    window.open("G21 G90 G94 F600\nG1 X10\n/X20\nM2\n");
    const auto length = [&] { return window.workspace().timeline()->outcome()->summary.path_length; };
    QCOMPARE(length(), 20.0);
    window.the<QDockWidget>("readingDock").show();
    QTest::mouseClick(&window.the<QCheckBox>("readingBlockDelete"), Qt::LeftButton, {}, {8, 8});
    studio::settle(window);
    QCOMPARE(length(), 10.0);
    auto& dialect = window.the<QComboBox>("readingDialect");
    dialect.setCurrentIndex(dialect.findData(static_cast<int>(Dialect::grbl)));
    emit dialect.activated(dialect.currentIndex());
    studio::settle(window);
    QCOMPARE(window.workspace().document()->reading->dialect, Dialect::grbl);
    screenshot(window.the<QDockWidget>("readingDock"), "reading-options");
  }

  void the_contour_error_follows_the_drives() {
    Opened window;
    window.open("G21 G90 G94 F3000\nG1 X10\nY10\nX0\nY0\nM2\n");
    window.waitForProof();
    const double before = window.workspace().plan().proof->contour.cutting;
    auto& dock = window.the<QDockWidget>("drivesDock");
    dock.show();
    auto& gain = window.the<NumberField>("driveXkv");
    gain.setFocus();
    gain.selectAll();
    QTest::keyClicks(&gain, "20");
    QTest::keyClick(&gain, Qt::Key_Return);
    QCOMPARE(window.workspace().tuning().value().machine.servo[0].position_gain, 20.0);
    window.waitForProof();
    QVERIFY2(window.workspace().plan().proof->contour.cutting > 1.2 * before, "axes of unequal gain cut corners off");
    QVERIFY(window.the<QLabel>("drivesErrors").text().contains("µm"));
    screenshot(dock, "drives");
    window.workspace().undoStack().undo();
    QCOMPARE(gain.text(), QString("50"));
  }

  void axes_of_the_machine_have_rows_though_the_program_leaves_them_alone() {
    Opened window;
    window.openButterfly();
    QVERIFY(!window.the<QWidget>("axisASpeed").isVisible());
    window.workspace().tuning().edit("a", "a", [](Tuning& t) { t.machine.axes[3].speed = 2; });
    QVERIFY(window.the<QWidget>("axisASpeed").isVisible() && !window.the<QWidget>("axisBSpeed").isVisible());
    window.open("G21 G90 G94 F600\nG1 X5 B90\nM2\n");
    QVERIFY(window.the<QWidget>("axisBSpeed").isVisible());
    window.workspace().setCursorTime(1e9);
    QVERIFY(window.the<QLabel>("positionReadout").text().contains("B"));
    QVERIFY(window.the<QLabel>("positionReadout").text().contains("90.000°"));
  }

  void a_preset_is_one_step_and_leaves_the_limits_alone() {
    Opened window;
    window.openButterfly();
    const Machine before = window.workspace().tuning().value().machine;
    for (std::size_t i = 0; i < plan_presets().size(); ++i) {
      PlanOptions wanted = window.workspace().tuning().value().options;
      plan_presets()[i].apply(wanted);
      window.actions().presets[i]->trigger();
      const auto& now = window.workspace().tuning().value();
      QCOMPARE(now.options.law, wanted.law);
      QCOMPARE(now.options.lookahead, wanted.lookahead);
      QCOMPARE(now.options.corner.rule, wanted.corner.rule);
      QCOMPARE(now.machine.path.jerk, before.path.jerk);
    }
    QCOMPARE(window.workspace().tuning().value().options.corner.rule, CornerRule::smooth);
    window.actions().undo->trigger();
    QCOMPARE(window.workspace().tuning().value().options.corner.rule, CornerRule::servo);
  }

  void settings_of_a_controller_are_shown_before_they_are_taken() {
    QTemporaryDir folder;
    const QString dump = folder.filePath("settings.txt");
    write(dump, kDump);
    const auto setup = read_machine(dump.toStdString());
    QVERIFY(setup.has_value());
    studio::ImportDialog dialog("settings.txt", *setup);
    const auto& table = find<QTableWidget>(dialog, "importTable");
    QStringList rows;
    for (int row = 0; row < table.rowCount(); ++row)
      rows << table.item(row, 0)->text() + ": " + table.item(row, 1)->text();
    QVERIFY2(rows.contains("Speed of X: 50 mm/s"), qPrintable(rows.join('\n')));
    QVERIFY2(rows.contains("Travel of X: -300 … 0 mm"), qPrintable(rows.join('\n')));
    QVERIFY2(rows.contains("Jerk of X: not there: no limit"), qPrintable(rows.join('\n')));
    dialog.show();
    screenshot(dialog, "import");
    // Dropped, it is known by what stands in it.
    Opened window;
    window.openButterfly();
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(dump)});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &drop);
    TOOLPACE_EVENTUALLY_EQUAL(window.workspace().tuning().value().machine.axes[0].speed, 50.0);
  }

  void the_example_says_that_it_is_one_and_what_to_try() {
    Opened window;
    window.openButterfly();
    auto& bar = window.the<QWidget>("welcomeBar");
    QVERIFY(bar.isVisible());
    QTest::mouseClick(&window.the<QPushButton>("tryJerk"), Qt::LeftButton);
    QVERIFY(window.the<NumberField>("jmEdit").hasFocus());
    QTest::mouseClick(&window.the<QPushButton>("tryTolerance"), Qt::LeftButton);
    studio::settle(window);
    QVERIFY(window.workspace().pinned());
    QCOMPARE(window.workspace().tuning().value().options.corner.rule, CornerRule::smooth);
    QTest::mouseClick(&window.the<QToolButton>("welcomeClose"), Qt::LeftButton);
    QVERIFY(!bar.isVisible());
  }

  void the_right_button_opens_a_menu_everywhere() {
    Opened window;
    window.openButterfly();
    auto& view = window.the<NcView>("ncView");
    QVERIFY(menu_at(*view.viewport(), {80, 60}, true).contains("Copy the lines"));
    QVERIFY(view.currentLine() > 1);
    auto& canvas = window.the<ContourCanvas>("contourCanvas");
    QVERIFY(menu_at(canvas, {20, 20}, false).contains("&Isometric view"));
    auto& table = window.the<QTableView>("resultTable");
    QVERIFY(menu_at(*table.viewport(), {20, 20}, true).contains("Copy the results"));
  }

  void programs_for_lathes_are_seen_as_at_a_lathe() {
    Opened window;
    window.open("G21 G90 G94 G18 F300\nG1 X20 Z-5\nZ-30\nX30\nM2\n");
    auto& contour = window.the<ContourView>("contourView");
    QCOMPARE(contour.view(), View::zx);
    const Projection seen = contour.canvas().projection();
    QVERIFY(seen.map({0, 0, 1}).x() > seen.map({0, 0, 0}).x() && seen.map({1, 0, 0}).y() < seen.map({0, 0, 0}).y());
    QTest::keyClick(&contour.canvas(), Qt::Key_I);
    window.workspace().reload();
    studio::settle(window);
    QCOMPARE(contour.view(), View::iso);
    window.open("G21 G90 G94 F300\nG1 X20 Y5\nX0 Y0\nM2\n", "other.ngc");
    QCOMPARE(contour.view(), View::xy);
  }

  void undo_in_a_field_is_the_windows_once_the_edit_is_done() {
    Opened window;
    window.openButterfly();
    window.activateWindow();
    auto& field = window.the<NumberField>("amEdit");
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, "2000");
    QTest::keyClick(&field, Qt::Key_Return);
    QCOMPARE(window.workspace().tuning().value().machine.path.acceleration, 2000.0);
    QTest::keyClick(&field, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(window.workspace().tuning().value().machine.path.acceleration, 3000.0);
  }
};

TOOLPACE_UI_TEST(PlacesTest)
#include "places_test.moc"
