/// Saving a program that was edited, and nothing lost without being asked when its window goes elsewhere.

#include <sys/stat.h>

#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "editing.h"
#include "support/dialogs.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

class SaveTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString square_, other_;

 private slots:
  void init() {
    square_ = folder_.filePath("square.ngc");
    other_ = folder_.filePath("other.ngc");
    write(square_, kSquare);
    write(other_, "G21 G90\nG1 F600 X3\nM2\n");
  }

  void saving_writes_the_edit_and_leaves_the_rest_and_the_rights_of_the_file_alone() {
    const QByteArray before = "G21 G90\r\n(\xe4)\r\nG1 F600 X3\r\nM2";
    write(square_, before);
    ::chmod(QFile::encodeName(square_).constData(), 0640);
    Editing window(square_);
    window.program().replaceLine(3, "G1 F600 X4");
    window.save();
    QCOMPARE(content(square_), QByteArray(before).replace("X3", "X4"));
    struct stat info {};
    QCOMPARE(::stat(QFile::encodeName(square_).constData(), &info), 0);
    QCOMPARE(static_cast<int>(info.st_mode & 07777), 0640);
    QVERIFY(!window.isWindowModified());
    QCOMPARE(QDir(folder_.path()).entryList(QDir::Files | QDir::Hidden).size(), 2);
  }

  void saving_that_fails_leaves_the_edits_and_says_why() {
    Editing window(square_);
    window.program().replaceLine(2, "G1 F1200 X20");
    studio::settle(window);
    QSignalSpy failed(&window.workspace(), &Workspace::saveFailed);
    window.storeProgramAs(folder_.filePath("no/such/folder.ngc"));
    TOOLPACE_EVENTUALLY_EQUAL(failed.count(), 1);
    QVERIFY(window.isWindowModified());
    QCOMPARE(window.program().path(), square_);
    QCOMPARE(content(square_), QByteArray(kSquare));
    const auto* problems = window.the<QTableView>("problemTable").model();
    QCOMPARE(problems->rowCount(), 1);
    emit window.workspace().problemsChanged();  // as by a plan that comes later: it tells of its own alone
    QCOMPARE(problems->rowCount(), 1);
    window.storeProgramAs(folder_.filePath("there.ngc"));
    TOOLPACE_EVENTUALLY_EQUAL(problems->rowCount(), 0);
  }

  void a_program_saved_under_another_name_stays_where_it_was_looked_at() {
    Editing window(square_);
    window.workspace().pin();
    window.workspace().setCursorTime(0.5);
    const QString copy = folder_.filePath("copy.ngc");
    window.storeProgramAs(copy);
    TOOLPACE_EVENTUALLY_EQUAL(window.program().path(), copy);
    studio::settle(window);
    QCOMPARE(content(copy), QByteArray(kSquare));
    QCOMPARE(window.workspace().document()->path, copy);
    QVERIFY(window.windowTitle().startsWith("copy.ngc"));
    QCOMPARE(window.workspace().cursorTime(), 0.5);
    QVERIFY(window.workspace().pinned());
    QVERIFY(QFile::remove(copy));
  }

  void the_example_asks_for_a_name() {
    Opened window;
    window.openButterfly();
    window.workspace().program().replaceLine(1, "G21 G90 G94 (mine)");
    const QString path = folder_.filePath("mine.ngc");
    const auto dialog = file_named(path);
    window.actions().save_program->trigger();
    TOOLPACE_EVENTUALLY_EQUAL(window.workspace().program().path(), path);
    QVERIFY(content(path).startsWith("G21 G90 G94 (mine)\n"));
    QVERIFY(!window.isWindowModified());
    QVERIFY(QFile::remove(path));
  }

  void closing_with_changes_asks_and_a_person_can_stay() {
    Editing window(square_);
    window.program().replaceLine(2, "G1 F1200 X20");
    NextDialog stay("cancelButton");
    QVERIFY(!window.close());
    QCOMPARE(stay.shown(), QString("changesBox"));
    QVERIFY(window.isVisible() && window.isWindowModified());
    NextDialog discard("discardChangesButton");
    QVERIFY(window.close());
    QCOMPARE(content(square_), QByteArray(kSquare));
  }

  void closing_with_what_is_still_being_typed_asks_too_and_saving_closes() {
    Editing window(square_);
    window.view().setCurrentLine(2);
    window.view().editCurrentLine();
    QTest::keyClicks(&window.field(), "5");
    NextDialog save("saveChangesButton");
    QVERIFY(!window.close());  // the file is written first
    TOOLPACE_EVENTUALLY(!window.isVisible());
    QCOMPARE(content(square_), QByteArray(kSquare).replace("X10", "X105"));
  }

  void closing_without_changes_does_not_ask() {
    Editing window(square_);
    window.program().replaceLine(2, "G1 F1200 X20");
    window.actions().undo->trigger();
    QVERIFY(window.close());
  }

  void opening_another_program_asks_first() {
    Editing window(square_);
    window.program().replaceLine(2, "G1 F1200 X20");
    {
      NextDialog stay("cancelButton");
      window.openFile(other_);
      QCOMPARE(window.program().path(), square_);
    }
    NextDialog save("saveChangesButton");
    window.openProgram(other_);
    TOOLPACE_EVENTUALLY_EQUAL(window.program().path(), other_);
    QCOMPARE(content(square_), QByteArray(kSquare).replace("X10", "X20"));
    QVERIFY(!window.isWindowModified());
    QVERIFY(!window.actions().undo->isEnabled());
    window.program().replaceLine(2, "G1 F600 X4");
    NextDialog discard("discardChangesButton");
    window.openExample();
    studio::settle(window);
    QCOMPARE(window.program().name(), QString("butterfly.ngc"));
    QCOMPARE(content(other_), QByteArray("G21 G90\nG1 F600 X3\nM2\n"));
  }

  void an_export_never_takes_the_place_of_the_open_program() {
    Editing window(square_);
    const QString link = folder_.filePath("link.csv");
    QVERIFY(QFile::link(square_, link));
    for (const QString& target : {square_, link}) {
      QSignalSpy failed(&window, &studio::MainWindow::failed);
      window.saveSetpoints(target);
      window.saveReport(target);
      QVERIFY(!window.savePicture(studio::MainWindow::Picture::window, target));
      QCOMPARE(failed.count(), 3);
      for (const auto& failure : failed) {
        QCOMPARE(failure[0].value<Error>().code, std::string("output-is-input"));
      }
      studio::settle(window);
      QCOMPARE(content(square_), QByteArray(kSquare));
    }
    QVERIFY(QFile::remove(link));
  }

  void a_polyline_is_edited_and_saved_like_any_program() {
    const QString path = folder_.filePath("line.csv");
    write(path, "x_mm,y_mm\n0,0\n10,0\n");
    Editing window(path);
    window.program().replaceLine(3, "20,0");
    studio::settle(window);
    QCOMPARE(window.length(), 20.0);
    window.save();
    QCOMPARE(content(path), QByteArray("x_mm,y_mm\n0,0\n20,0\n"));
    QVERIFY(QFile::remove(path));
  }
};

TOOLPACE_UI_TEST(SaveTest)
#include "save_test.moc"
