/// Programs and machines opened in the window, and what it remembers.

#include <QDropEvent>
#include <QMimeData>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>

#include "main_window.h"
#include "panels/nc_panel.h"
#include "preferences.h"
#include "screenshot.h"
#include "support/files.h"
#include "support/patience.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::studio;
using ui::kSquare;
using ui::write;

class FilesTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString in(const QString& name) const { return folder_.filePath(name); }

 private slots:
  void initTestCase() { QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path()); }

  void a_dropped_file_is_opened_and_planned() {
    write(in("square.ngc"), kSquare);
    MainWindow window(false);
    window.show();
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(in("square.ngc"))});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &drop);
    settle(window);
    QCOMPARE(window.workspace().document()->name, QString("square.ngc"));
    QCOMPARE(window.workspace().timeline()->outcome()->summary.path_length, 40.0);
  }

  void a_file_replaced_on_disk_is_read_again_and_the_cursor_stays() {
    write(in("again.ngc"), kSquare);
    MainWindow window(false);
    window.show();
    window.openProgram(in("again.ngc"));
    settle(window);
    window.workspace().setCursorTime(0.5);
    QSignalSpy changed(&window.workspace(), &ui::Workspace::documentChanged);
    write(in("new.ngc"), QByteArray(kSquare).replace("X10", "X20"));
    QVERIFY(QFile::remove(in("again.ngc")));
    QVERIFY(QFile::rename(in("new.ngc"), in("again.ngc")));
    QVERIFY(ui::eventually(changed));
    settle(window);
    QCOMPARE(window.workspace().timeline()->outcome()->summary.path_length, 60.0);
    QCOMPARE(window.workspace().cursorTime(), 0.5);
  }

  void a_line_edited_in_place_changes_the_plan() {
    MainWindow window(false);
    window.show();
    window.workspace().openText(kSquare, "square.ngc");
    settle(window);
    window.workspace().program().replaceLine(2, "G1 F1200 X15");
    settle(window);
    QCOMPARE(window.workspace().document()->line(2), QString("G1 F1200 X15"));
    QVERIFY(window.workspace().timeline()->outcome()->summary.path_length > 40.0);
  }

  void errors_of_a_program_are_listed_with_their_line_and_the_rest_is_planned() {
    MainWindow window(false);
    window.setLanguage("en");
    window.resize(1280, 800);
    window.show();
    window.workspace().openText("G21 G90 G94 F600\nG1 X10\nG1 Y10\nG2 X0 Y0 R1\nG1 X5\nM2\n", "bad-arc.ngc");
    settle(window);
    QVERIFY(!window.workspace().problems().empty());
    QCOMPARE(window.workspace().problems().front().where.line, std::size_t{4});
    QCOMPARE(window.workspace().timeline()->outcome()->summary.path_length, 20.0);
    window.actions().next_problem->trigger();
    QCOMPARE(window.findChild<ui::NcView*>("ncView")->currentLine(), 4);
    ui::screenshot(window, "window-errors");
  }

  void a_missing_file_is_told_and_what_was_open_stays() {
    MainWindow window(false);
    window.show();
    window.openExample();
    settle(window);
    QSignalSpy failed(&window.workspace(), &ui::Workspace::openFailed);
    window.openProgram(in("nothing-here.ngc"));
    settle(window);
    QCOMPARE(failed.count(), 1);
    QCOMPARE(window.workspace().document()->name, QString("butterfly.ngc"));
    QVERIFY(QApplication::activeModalWidget() == nullptr);
  }

  void degenerate_programs_open_without_trouble() {
    MainWindow window(false);
    window.show();
    for (const char* text : {"", "%\n", "M2\n", "G21 G90 F100\nG1 X0 Y0\nM2\n", "G21 F60\nG1 X1e-6\nM2\n",
                             "G21 F60000\nG0 X1e7 Y1e7\nM2\n", "G21 F60\nG1 Z-5\nZ5\nM2\n", "\xff\xfe binary \x01"}) {
      window.workspace().openText(text, "odd.ngc");
      settle(window);
      window.workspace().setCursorTime(1);
      window.actions().fit->trigger();
      QVERIFY(!window.grab().isNull());
    }
  }

  void a_machine_is_saved_and_opened_again_with_the_same_values() {
    MainWindow window(false);
    window.show();
    window.workspace().tuning().edit("a", "am", [](ui::Tuning& t) {
      t.machine.path.acceleration = 1234.5;
      t.machine.axes[1].jerk = 4e5;
      t.options.lookahead = 17;
    });
    window.storeMachineAs(in("mine.toml"));
    QVERIFY(window.workspace().tuning().isClean());
    window.workspace().tuning().reset(default_setup());
    QVERIFY(window.openMachine(in("mine.toml")));
    const auto& tuning = window.workspace().tuning().value();
    QCOMPARE(tuning.machine.path.acceleration, 1234.5);
    QCOMPARE(tuning.machine.axes[1].jerk, 4e5);
    QCOMPARE(tuning.options.lookahead, std::optional<std::size_t>(17));
    write(in("broken.toml"), "[path]\nmax_sped_mm_s = 3\n");
    QVERIFY(!window.openMachine(in("broken.toml")));
  }

  void an_opening_wins_over_a_change_of_the_program_that_goes() {
    write(in("goes.ngc"), kSquare);
    write(in("comes.ngc"), kSquare);
    MainWindow window(false);
    window.show();
    window.openProgram(in("goes.ngc"));
    settle(window);
    auto* watcher = &window.workspace().watcher();
    window.openProgram(in("comes.ngc"));
    emit watcher->changed(in("goes.ngc"));
    window.workspace().program().replaceLine(1, "G1 F1200 X30");
    settle(window);
    QCOMPARE(window.workspace().document()->name, QString("comes.ngc"));
  }

  void a_change_is_read_where_the_opening_fails() {
    write(in("stays.ngc"), kSquare);
    MainWindow window(false);
    window.show();
    window.openProgram(in("stays.ngc"));
    settle(window);
    write(in("stays.ngc"), QByteArray(kSquare).replace("X10", "X20"));
    window.openProgram(in("missing.ngc"));
    emit window.workspace().watcher().changed(in("stays.ngc"));
    settle(window);
    QCOMPARE(window.workspace().timeline()->outcome()->summary.path_length, 60.0);
  }

  void preferences_are_remembered() {
    Preferences saved;
    saved.dark = true;
    saved.language = "zh_CN";
    for (int i = 0; i < 12; ++i) remember(saved.recent_programs, QString("/tmp/%1.ngc").arg(i));
    save_preferences(saved);
    const Preferences loaded = load_preferences();
    QVERIFY(loaded.dark);
    QCOMPARE(loaded.language, QString("zh_CN"));
    QCOMPARE(loaded.recent_programs.size(), 10);
    QCOMPARE(loaded.recent_programs.front(), QString("/tmp/11.ngc"));
  }
};

TOOLPACE_UI_TEST(FilesTest)
#include "files_test.moc"
