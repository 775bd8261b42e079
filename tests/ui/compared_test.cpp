/// The controller that a program runs on: what it does is plan B, and its settings are edited in its own file.

#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include "opened.h"
#include "panels/change_bar.h"
#include "panels/controller_panel.h"
#include "panels/nc_view.h"
#include "panels/tune_settings_panel.h"
#include "support/dialogs.h"
#include "support/files.h"
#include "support/screenshot.h"
#include "support/ui_test.h"
#include "toolpace/controller/prediction.h"
#include "toolpace/nc/reader.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

const QByteArray kProgram = "G21 G90 G17\nG1 X30 F6000\nG3 X30 Y0 I0 J2\nG1 X40 Y5\nM2\n";
const QByteArray kGrbl =
    "<< $1=25\n$11=0.010 "
    "(junction)\n$12=0.002\n$100=80\n$101=80\n$102=400\n$110=6000\n$111=6000\n$112=600\n$120=500.000 "
    "(x accel)\n$121=500\n";

double predicted(const QByteArray& settings, Controller controller = Controller::grbl) {
  ReadOptions options;
  options.dialect = dialect_of(controller);
  const std::string_view text(kProgram.constData(), static_cast<std::size_t>(kProgram.size()));
  const auto reading = read_text(text, "p.nc", options);
  const auto parsed = parse_controller_settings(settings.toStdString(), "settings", controller);
  return predict(*reading, scan_program(text), *parsed)->cycle_time;
}

class OnController : public Opened {
 public:
  OnController() { open(kProgram, "p.nc"); }
  double seconds() { return workspace().pinned() ? workspace().pinned().timeline->duration() : 0; }
  bool takes(double expected) { return std::abs(seconds() - expected) < 1e-9; }
  QByteArray text() { return QByteArray::fromStdString(workspace().controller().text()->text); }
  QLineEdit& setting(const char* key) { return the<QLineEdit>((QByteArray("setting ") + key).constData()); }
  QString button() { return the<QToolButton>("runsButton").text(); }
  ChangeBar& bar() { return the<ChangeBar>("settingsBar"); }
  void save() { QTest::mouseClick(&the<QToolButton>("saveSettingsButton"), Qt::LeftButton); }
  /// As a person types it.
  void type(const char* key, const char* value) {
    QLineEdit& field = setting(key);
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, value);
    QTest::keyClick(&field, Qt::Key_Return);
  }
};

}  // namespace

class ComparedTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString in(const QString& name) const { return folder_.filePath(name); }

 private slots:
  void initTestCase() { QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path()); }

  void the_best_settings_of_the_controller_are_found_and_taken_in_one_step() {
    write(in("grbl.txt"), kGrbl);
    OnController window;
    QVERIFY(window.openController(in("grbl.txt")));
    TOOLPACE_EVENTUALLY(window.takes(predicted(kGrbl)));
    window.the<QDockWidget>("tuneDock").show();
    studio::settle(window);
    auto& panel = window.the<TuneSettingsPanel>("tuneSettingsPanel");
    QVERIFY(panel.isVisible() && !window.the<QAbstractButton>("tuneButton").isVisible());
    auto& table = window.the<QTableWidget>("tuneControllerSettings");
    QVERIFY(table.rowCount() > 5);
    const auto search = [&] {
      QTest::mouseClick(&window.the<QAbstractButton>("tuneSettingsButton"), Qt::LeftButton);
      QVERIFY(panel.isSearching());
      TOOLPACE_EVENTUALLY(!panel.isSearching());
      QVERIFY2(panel.tuned() && !panel.isStale(), qPrintable(window.the<QLabel>("tuneSettingsVerdict").text()));
      QVERIFY(!panel.tuned()->changes.empty());
      QVERIFY(panel.tuned()->after < panel.tuned()->before);
    };
    search();
    QVERIFY(panel.tuned()->changes.size() > 1);
    screenshot(window.the<QWidget>("tunePage"), "tuned-grbl");
    const int steps = window.workspace().undoStack().count();
    const double after = panel.tuned()->after;
    QTest::mouseClick(&window.the<QAbstractButton>("tuneSettingsTake"), Qt::LeftButton);
    QCOMPARE(window.workspace().undoStack().count(), steps + 1);
    TOOLPACE_EVENTUALLY(window.takes(after));
    QCOMPARE(predicted(window.text()), after);
    QVERIFY(!panel.isStale() && !window.the<QAbstractButton>("tuneSettingsTake").isEnabled());
    window.actions().undo->trigger();
    QCOMPARE(window.text(), kGrbl);
    TOOLPACE_EVENTUALLY(window.takes(predicted(kGrbl)));
    QVERIFY(window.the<QAbstractButton>("tuneSettingsTake").isEnabled());

    // Of those that are ticked alone.
    for (int row = 0; row < table.rowCount(); ++row)
      table.item(row, 0)->setCheckState(table.item(row, 0)->data(Qt::UserRole) == "$120" ? Qt::Checked : Qt::Unchecked);
    search();
    QCOMPARE(panel.tuned()->changes.size(), std::size_t{1});
    QCOMPARE(panel.tuned()->changes.front().setting, std::string("$120"));
    window.type("$121", "123");
    TOOLPACE_EVENTUALLY(panel.isStale());
    // Without a controller the page is that of the plan.
    window.workspace().unpin();
    QVERIFY(panel.isHidden() && window.the<QAbstractButton>("tuneButton").isVisible());
  }

  void what_a_controller_does_is_plan_b_and_its_settings_are_edited_as_any_other() {
    write(in("grbl.txt"), kGrbl);
    OnController window;
    Workspace& workspace = window.workspace();
    const auto own = workspace.plan().timeline->outcome();
    QVERIFY(window.openController(in("grbl.txt")));
    TOOLPACE_EVENTUALLY(window.takes(predicted(kGrbl)));
    QVERIFY(workspace.plan().timeline->outcome() == own);
    QCOMPARE(window.button(), QString("Runs on grbl"));
    // $122 is missing, which is told.
    QVERIFY(std::any_of(workspace.problems().begin(), workspace.problems().end(),
                        [](const Diagnostic& d) { return d.code == "settings-defaulted"; }));
    TOOLPACE_EVENTUALLY(workspace.controllerView().as_setpoints);
    const QString verdict = window.the<QLabel>("onControllerLabel").text();
    QVERIFY2(verdict.startsWith("On grbl ") && verdict.contains("; as setpoints "), qPrintable(verdict));
    const auto& limits = window.the<QTableWidget>("timeLimitTable");
    double sum = 0;
    for (int row = 0; row < limits.rowCount(); ++row) sum += limits.item(row, 1)->text().toDouble();
    QVERIFY(std::abs(sum - predicted(kGrbl)) < 0.001 * limits.rowCount());
    // The times of lines are the controller's.
    QVERIFY(window.the<NcView>("ncView").timeOf(3) > 0);
    QCOMPARE(window.the<NcView>("ncView").timeOf(3), workspace.controllerView().found->line_time[3]);

    const QByteArray quick = QByteArray(kGrbl).replace("$120=500.000", "$120=250.000");
    window.type("$120", "250");
    QCOMPARE(window.text(), quick);
    TOOLPACE_EVENTUALLY(window.takes(predicted(quick)));
    QCOMPARE(window.button(), QString("Runs on grbl*"));
    screenshot(window, "runs-on-grbl");
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(window.text(), kGrbl);
    QCOMPARE(window.button(), QString("Runs on grbl"));
    TOOLPACE_EVENTUALLY(window.takes(predicted(kGrbl)));
    window.actions().redo->trigger();
    // Only the line that was changed is another one in the file.
    QCOMPARE(content(in("grbl.txt")), kGrbl);
    window.save();
    QCOMPARE(content(in("grbl.txt")), quick);
    QCOMPARE(window.button(), QString("Runs on grbl"));

    // What another program writes is taken; where something is in its way, a person chooses.
    write(in("grbl.txt"), kGrbl);
    TOOLPACE_EVENTUALLY_EQUAL(window.text(), kGrbl);
    window.type("$121", "400");
    write(in("grbl.txt"), "; newer\n" + quick);
    TOOLPACE_EVENTUALLY(!window.bar().isHidden());
    QTest::mouseClick(window.bar().findChild<QPushButton*>("settingsBarKeepMine"), Qt::LeftButton);
    QCOMPARE(window.text(), "; newer\n" + QByteArray(quick).replace("$121=500", "$121=400"));
    QVERIFY(window.button().endsWith('*'));
    {
      NextDialog stay("cancelButton");
      window.close();
      QCOMPARE(stay.shown(), QString("changesBox"));
    }
    QVERIFY(window.isVisible());

    // Without the controller there is no B; undo brings both back.
    workspace.unpin();
    QVERIFY(!workspace.pinned());
    QVERIFY(window.the<QDockWidget>("controllerDock").isHidden());
    QCOMPARE(window.button(), QString("Runs on Toolpace"));
    window.actions().undo->trigger();
    TOOLPACE_EVENTUALLY(workspace.pinned());
  }

  void the_list_of_what_each_setting_gives_begins_with_the_most_and_its_rows_can_be_taken() {
    write(in("grbl.txt"), kGrbl);
    OnController window;
    window.openController(in("grbl.txt"));
    TOOLPACE_EVENTUALLY(window.workspace().pinned());
    auto& panel = window.the<ControllerPanel>("controllerPanel");
    QSignalSpy computed(&panel, &ControllerPanel::computed);
    QTest::mouseClick(&window.the<QPushButton>("trySettingsButton"), Qt::LeftButton);
    QVERIFY(eventually(computed));
    auto& rows = window.the<QTableWidget>("settingTable");
    QVERIFY(rows.rowCount() > 10);
    for (int row = 1; row < rows.rowCount(); ++row) {
      QVERIFY(rows.item(row, 2)->text().toDouble() <= rows.item(row - 1, 2)->text().toDouble());
    }
    screenshot(window, "what-each-setting-gives");
    const double before = window.seconds(), saves = rows.item(0, 2)->text().toDouble();
    QVERIFY(saves > 0);
    rows.setCurrentCell(0, 0);
    QTest::keyClick(&rows, Qt::Key_Return);
    TOOLPACE_EVENTUALLY(std::abs(before - window.seconds() - saves) < 0.001);
    QVERIFY(window.button().endsWith('*'));
    QCOMPARE(rows.rowCount(), 0);  // of other settings than these
    // Asked for and cancelled: nothing comes.
    computed.clear();
    QTest::mouseClick(&window.the<QPushButton>("trySettingsButton"), Qt::LeftButton);
    QTest::mouseClick(&window.the<QPushButton>("trySettingsButton"), Qt::LeftButton);
    QVERIFY(eventually(computed));
    QCOMPARE(rows.rowCount(), 0);
  }

  // 40 characters a second for blocks that take a tenth of a second each: the motion waits for them.
  void a_slow_link_and_slow_reading_cost_time_where_programs_come_by_one() {
    write(in("grbl.txt"), kGrbl);
    OnController window;
    window.openController(in("grbl.txt"));
    TOOLPACE_EVENTUALLY(window.workspace().pinned());
    const double before = window.seconds();
    QVERIFY(!window.the<QLabel>("controllerVerdict").text().contains("have not come"));
    const auto type = [&](const char* name, const char* text) {
      auto& field = window.the<NumberField>(name);
      field.setFocus();
      field.selectAll();
      QTest::keyClick(&field, Qt::Key_Delete);
      QTest::keyClicks(&field, text);
      QTest::keyClick(&field, Qt::Key_Return);
    };
    type("controllerBaud", "400");
    TOOLPACE_EVENTUALLY(window.seconds() > before && !window.workspace().isBusy());
    const double linked = window.seconds();
    QVERIFY(window.the<QLabel>("controllerVerdict").text().contains("have not come"));
    screenshot(window, "controller-with-a-slow-link");
    type("controllerBlockTime", "2000");
    TOOLPACE_EVENTUALLY(window.seconds() > linked);
    type("controllerBlockTime", "0");
    type("controllerBaud", "");
    TOOLPACE_EVENTUALLY(window.seconds() == before);
    // A program on the controller's own disk comes by no link.
    write(in("printer.cfg"), "[printer]\nkinematics: cartesian\nmax_velocity: 100\nmax_accel: 1000\n");
    window.openController(in("printer.cfg"));
    TOOLPACE_EVENTUALLY(!window.workspace().isBusy());
    QVERIFY(!window.the<NumberField>("controllerBaud").isEnabled());
    QVERIFY(window.the<NumberField>("controllerBlockTime").isEnabled());
  }

  void what_cannot_be_read_or_written_is_said_and_changes_nothing() {
    OnController window;
    QSignalSpy failed(&window, &studio::MainWindow::failed);
    const auto code = [&] { return QString::fromStdString(failed.last().first().value<Error>().code); };
    QVERIFY(!window.openController(in("none.txt")));
    write(in("note.txt"), "buy milk\n");
    QVERIFY(!window.openController(in("note.txt")));
    QCOMPARE(code(), QString("settings-unknown"));
    QVERIFY(!window.workspace().controller().text());

    write(in("limits.cfg"), "[printer]\nmax_velocity: 200\nmax_accel: 2000\n");
    write(in("printer.cfg"), "[include limits.cfg]\n[printer]\nkinematics: corexy\nsquare_corner_velocity: 5\n");
    QVERIFY(window.openController(in("printer.cfg")));
    window.type("[printer] max_accel", "3000");
    QCOMPARE(code(), QString("settings-included"));
    QCOMPARE(window.setting("[printer] max_accel").text(), QString("2000"));
    window.type("[printer] square_corner_velocity", "8");
    QVERIFY(window.text().endsWith("square_corner_velocity: 8\n"));
    // Arcs without [gcode_arcs] are refused by Klipper, which is told at the line.
    const auto is_told = [&] {
      const auto& list = window.workspace().problems();
      return std::any_of(list.begin(), list.end(),
                         [](const Diagnostic& d) { return d.code == "controller-refuses" && d.where.line == 3; });
    };
    TOOLPACE_EVENTUALLY(is_told());
    QVERIFY(!window.workspace().pinned());
  }

  void linuxcnc_has_times_but_no_motion_along_the_path_and_cancel_ends_it() {
    const QByteArray mill =
        "[TRAJ]\nLINEAR_UNITS = mm\nMAX_LINEAR_VELOCITY = 200\n[AXIS_X]\nMAX_VELOCITY = 100\nMAX_ACCELERATION = 1000\n"
        "[AXIS_Y]\nMAX_VELOCITY = 100\nMAX_ACCELERATION = 1000\n";
    write(in("mill.ini"), mill);
    OnController window;
    Workspace& workspace = window.workspace();
    window.openController(in("mill.ini"));
    workspace.cancel();
    TOOLPACE_EVENTUALLY(!workspace.isBusy());
    // Unless it was quicker, there is nothing, and that is said.
    QVERIFY(workspace.controllerView().found || workspace.controllerView().is_stale);
    window.type("[AXIS_X] MAX_ACCELERATION", "800");
    TOOLPACE_EVENTUALLY(workspace.controllerView().found && !workspace.controllerView().is_stale);
    const double seconds = predicted(QByteArray(mill).replace("1000\n[AXIS_Y]", "800\n[AXIS_Y]"), Controller::linuxcnc);
    QCOMPARE(workspace.controllerView().found->prediction.cycle_time, seconds);
    QVERIFY(!workspace.pinned());
    QVERIFY(window.the<NcView>("ncView").timeOf(3) > 0);
    screenshot(window, "runs-on-linuxcnc");
  }
};

TOOLPACE_UI_TEST(ComparedTest)
#include "compared_test.moc"
