/// The machine and its file: saved in place, and nothing lost without being asked.

#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "machine_file.h"
#include "opened.h"
#include "panels/change_bar.h"
#include "support/dialogs.h"
#include "support/files.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

constexpr auto kMill =
    "# The old mill.\n[machine]\nname = 'Mill' # as on its plate\n\n[path]\nmax_speed_mm_s = 120.0 # carefully\n"
    "max_acceleration_mm_s2 = 900\nmax_jerk_mm_s3 = 3e4\n";

QByteArray with_speed(const char* speed) { return QByteArray(kMill).replace("120.0", speed); }

class TunedWindow : public Opened {
 public:
  double speed() { return workspace().tuning().value().machine.path.speed; }
  void setSpeed(double speed) {
    workspace().tuning().edit("speed", "speed", [speed](Tuning& t) { t.machine.path.speed = speed; });
  }
  bool hasStar() { return the<QToolButton>("machineButton").text().endsWith('*'); }
  ChangeBar& bar() { return the<ChangeBar>("machineBar"); }
  void save() { actions().save_machine->trigger(); }
};

}  // namespace

class MachineTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString in(const QString& name) const { return folder_.filePath(name); }

 private slots:
  void initTestCase() { QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path()); }

  void saving_changes_the_value_and_keeps_everything_else() {
    write(in("mill.toml"), kMill);
    TunedWindow window;
    QVERIFY(window.openMachine(in("mill.toml")));
    QVERIFY(!window.hasStar());
    window.setSpeed(99);
    QVERIFY(window.hasStar());
    window.save();
    QVERIFY(!window.hasStar());
    QCOMPARE(content(in("mill.toml")), with_speed("99"));
  }

  void programs_about_the_tip_are_read_by_the_machine_that_is_chosen() {
    const QByteArray chain =
        "[kinematics]\nrotary = [{axis = \"A\", side = \"table\", direction = [1, 0, 0], point_mm = [0, 0, -50]}]\n";
    write(in("mill.toml"), kMill);
    write(in("tilting.toml"), kMill + chain);
    TunedWindow window;
    QVERIFY(window.openMachine(in("mill.toml")));
    window.open("%\nO1\nG21 G90 G94\nG43.4 H1\nG1 X10 A20 F600\nG49\nM30\n%\n", "tip.nc");
    const auto reading = [&] { return window.workspace().document()->reading; };
    QVERIFY(reading()->refused);
    QVERIFY(window.openMachine(in("tilting.toml")));
    TOOLPACE_EVENTUALLY(!reading()->refused && reading()->moves.has_tip());
    TOOLPACE_EVENTUALLY(window.workspace().timeline() && !window.workspace().isBusy());
    QVERIFY(window.workspace().timeline()->outcome()->path->chain_of(0) != nullptr);
    QVERIFY(window.openMachine(in("mill.toml")));
    TOOLPACE_EVENTUALLY(reading()->refused);
  }

  void a_change_that_is_taken_back_leaves_no_star_and_a_feed_hold_is_no_change_of_the_machine() {
    write(in("mill.toml"), kMill);
    TunedWindow window;
    window.openMachine(in("mill.toml"));
    window.setSpeed(99);
    window.setSpeed(120);
    QVERIFY(!window.hasStar());
    window.workspace().tuning().edit("hold", "hold", [](Tuning& t) { t.options.hold_at = 1; });
    QVERIFY(!window.hasStar());
  }

  void what_another_program_writes_is_taken_where_nothing_is_in_its_way() {
    write(in("mill.toml"), kMill);
    TunedWindow window;
    window.openMachine(in("mill.toml"));
    write(in("mill.toml"), with_speed("77"));
    TOOLPACE_EVENTUALLY_EQUAL(window.speed(), 77.0);
    QVERIFY(!window.hasStar());
    QVERIFY(window.bar().isHidden());
  }

  void a_person_chooses_between_own_changes_and_those_of_another_program() {
    write(in("mill.toml"), kMill);
    TunedWindow window;
    window.openMachine(in("mill.toml"));
    window.setSpeed(99);
    write(in("mill.toml"), with_speed("77"));
    TOOLPACE_EVENTUALLY(!window.bar().isHidden());
    QCOMPARE(window.speed(), 99.0);
    screenshot(window, "machine-changed-outside");
    QTest::mouseClick(window.bar().findChild<QPushButton*>("machineBarTakeFile"), Qt::LeftButton);
    QCOMPARE(window.speed(), 77.0);
    QVERIFY(!window.hasStar());
    QVERIFY(window.bar().isHidden());
    window.actions().undo->trigger();
    QCOMPARE(window.speed(), 99.0);
    QVERIFY(window.hasStar());

    write(in("mill.toml"), "# newer\n" + with_speed("66"));
    TOOLPACE_EVENTUALLY(!window.bar().isHidden());
    QTest::mouseClick(window.bar().findChild<QPushButton*>("machineBarKeepMine"), Qt::LeftButton);
    QCOMPARE(window.speed(), 99.0);
    QVERIFY(window.hasStar());
    window.save();
    QCOMPARE(content(in("mill.toml")), "# newer\n" + with_speed("99"));
  }

  void saving_over_a_file_that_changed_outside_asks() {
    write(in("mill.toml"), kMill);
    TunedWindow window;
    window.openMachine(in("mill.toml"));
    window.setSpeed(99);
    const QByteArray theirs = "# newer\n" + with_speed("55");
    write(in("mill.toml"), theirs);
    {
      NextDialog stay("cancelButton");
      window.save();
      QCOMPARE(stay.shown(), QString("replaceBox"));
    }
    QCOMPARE(content(in("mill.toml")), theirs);
    QVERIFY(window.hasStar());
    NextDialog replace("replaceButton");
    window.save();
    QCOMPARE(content(in("mill.toml")), "# newer\n" + with_speed("99"));
    QVERIFY(!window.hasStar());
  }

  void a_file_that_another_program_has_broken_is_told_and_mine_stays() {
    write(in("mill.toml"), kMill);
    TunedWindow window;
    window.openMachine(in("mill.toml"));
    write(in("mill.toml"), "[path\n");
    auto& problems = window.the<QTableView>("problemTable");
    TOOLPACE_EVENTUALLY(problems.model()->rowCount() > 0);
    QCOMPARE(window.speed(), 120.0);
    window.setSpeed(99);
    NextDialog replace("replaceButton");
    window.save();
    QCOMPARE(content(in("mill.toml")), with_speed("99"));
  }

  void leaving_with_changes_asks_and_saves_or_stays_or_leaves_them() {
    write(in("mill.toml"), kMill);
    TunedWindow window;
    window.openMachine(in("mill.toml"));
    window.setSpeed(99);
    {
      NextDialog stay("cancelButton");
      QVERIFY(!window.close());
      QCOMPARE(stay.shown(), QString("changesBox"));
    }
    QVERIFY(window.isVisible());
    {
      NextDialog ask([&](QWidget& dialog) {
        screenshot(dialog, "machine-changes");
        QTest::mouseClick(dialog.findChild<QPushButton*>("saveChangesButton"), Qt::LeftButton);
      });
      QVERIFY(window.close());
    }
    QCOMPARE(content(in("mill.toml")), with_speed("99"));
    window.show();
    window.setSpeed(98);
    NextDialog leave("discardChangesButton");
    QVERIFY(window.close());
    QCOMPARE(content(in("mill.toml")), with_speed("99"));
  }

  void another_machine_is_opened_after_asking() {
    write(in("mill.toml"), kMill);
    TunedWindow window;
    window.openMachine(in("mill.toml"));
    window.setSpeed(99);
    {
      NextDialog stay("cancelButton");
      window.actions().default_machine->trigger();
    }
    QCOMPARE(window.speed(), 99.0);
    NextDialog leave("discardChangesButton");
    window.actions().default_machine->trigger();
    QCOMPARE(window.speed(), 100.0);
    QVERIFY(!window.hasStar());
  }

  void changes_of_the_default_limits_are_asked_about_too() {
    TunedWindow window;
    QVERIFY(!window.hasStar());
    window.setSpeed(99);
    QVERIFY(window.hasStar());
    NextDialog stay("cancelButton");
    QVERIFY(!window.close());
    QCOMPARE(stay.shown(), QString("changesBox"));
    window.actions().undo->trigger();
  }

  void a_save_that_fails_says_why_and_keeps_the_star() {
    QVERIFY(QDir(folder_.path()).mkpath("gone"));
    write(in("gone/mill.toml"), kMill);
    TunedWindow window;
    window.openMachine(in("gone/mill.toml"));
    window.setSpeed(99);
    QVERIFY(QDir(in("gone")).removeRecursively());
    window.save();
    QVERIFY(window.hasStar());
    QVERIFY(window.the<QTableView>("problemTable").model()->rowCount() > 0);
    NextDialog leave("discardChangesButton");
    QVERIFY(window.close());
  }

  void an_imported_machine_is_saved_under_a_name_of_its_own() {
    const QByteArray ini = "[TRAJ]\nMAX_LINEAR_VELOCITY = 50\nMAX_LINEAR_ACCELERATION = 500\n";
    write(in("lathe.ini"), ini);
    TunedWindow window;
    QVERIFY(window.openMachine(in("lathe.ini")));
    QVERIFY(window.hasStar());
    auto name = file_named(in("turning.ini"));
    window.save();
    QVERIFY(!window.hasStar());
    QCOMPARE(content(in("lathe.ini")), ini);
    TunedWindow again;
    QVERIFY(again.openMachine(in("turning.ini.toml")));
    QCOMPARE(again.speed(), 50.0);
    QVERIFY(!again.hasStar());
  }

  void what_an_imported_machine_leaves_open_is_told_until_it_is_saved() {
    write(in("joints.ini"), "[JOINT_0]\nMAX_VELOCITY = 50\n");
    TunedWindow window;
    QVERIFY(window.openMachine(in("joints.ini")));
    const auto& problems = *window.the<QTableView>("problemTable").model();
    QCOMPARE(problems.rowCount(), 1);
    const auto name = file_named(in("joints.toml"));
    window.save();
    QVERIFY(!window.hasStar());
    QCOMPARE(problems.rowCount(), 0);
  }

  void travel_out_of_order_is_refused_at_import() {
    write(in("odd.ini"), "[AXIS_X]\nMIN_LIMIT = 100\nMAX_LIMIT = -100\n");
    TunedWindow window;
    QVERIFY(!window.openMachine(in("odd.ini")));
    QVERIFY(window.the<QTableView>("problemTable").model()->rowCount() > 0);
    QVERIFY(!window.hasStar());
  }

  void a_built_in_machine_is_there_again_at_the_next_start() {
    const QString path = studio::built_in_machines().front().path;
    QString title;
    double speed = 0;
    {
      studio::MainWindow window(true);
      window.show();
      QVERIFY(window.openMachine(path));
      speed = window.workspace().tuning().value().machine.path.speed;
      title = window.findChild<QToolButton*>("machineButton")->text();
      QVERIFY(window.close());
    }
    studio::MainWindow window(true);
    window.show();
    window.openLast();
    studio::settle(window);
    QCOMPARE(window.findChild<QToolButton*>("machineButton")->text(), title);
    QCOMPARE(window.workspace().tuning().value().machine.path.speed, speed);
    QVERIFY(window.close());
  }

  void a_built_in_machine_that_was_changed_is_saved_as_a_file_with_its_comments() {
    TunedWindow window;
    QVERIFY(window.openMachine(studio::built_in_machines().front().path));
    window.setSpeed(99);
    auto name = file_named(in("own.toml"));
    window.save();
    QVERIFY(content(in("own.toml")).startsWith("# "));
    QVERIFY(content(in("own.toml")).contains("max_speed_mm_s = 99\n"));
    QVERIFY(!window.hasStar());
  }
};

TOOLPACE_UI_TEST(MachineTest)
#include "machine_test.moc"
