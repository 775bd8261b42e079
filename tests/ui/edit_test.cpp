/// Editing the program in the window: undo, saving, and nothing lost without being asked.

#include <sys/stat.h>

#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "opened.h"
#include "panels/change_bar.h"
#include "panels/nc_view.h"
#include "support/dialogs.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

constexpr auto kSquare = "G21 G90 G94\nG1 F1200 X10\nY10\nX0\nY0\nM2\n";

void write(const QString& path, const QByteArray& text) {
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) qFatal("cannot write %s", qPrintable(path));
}

QByteArray content(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) qFatal("cannot read %s", qPrintable(path));
  return file.readAll();
}

class Editing : public Opened {
 public:
  explicit Editing(const QString& path) { openFile(path); }
  void openFile(const QString& path) {
    openProgram(path);
    studio::settle(*this);
  }
  ProgramModel& program() { return workspace().program(); }
  QString text() { return QString::fromUtf8(program().text().bytes()); }
  NcView& view() { return the<NcView>("ncView"); }
  /// Where a line is being written; one that was left lives on for a moment.
  QLineEdit& field() {
    for (auto* field : findChildren<QLineEdit*>("ncLineEditor")) {
      if (field->isVisible()) return *field;
    }
    qFatal("no line is being edited");
  }
  ChangeBar& bar() { return the<ChangeBar>("changeBar"); }
  double length() { return workspace().timeline()->outcome()->summary.path_length; }
  void save() {
    QSignalSpy saved(&workspace(), &Workspace::saved);
    actions().save_program->trigger();
    QTRY_COMPARE(saved.count(), 1);
    QTRY_VERIFY(!workspace().isSaving());
  }
};

}  // namespace

class EditTest : public QObject {
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

  void text_and_tuning_are_undone_in_the_order_in_which_they_were_done() {
    Editing window(square_);
    window.program().replaceLine(2, "G1 F1200 X20");
    window.workspace().tuning().edit("Look-ahead", "lookahead", [](Tuning& t) { t.options.lookahead = 7; });
    window.program().replaceLine(4, "X5");
    studio::settle(window);
    QCOMPARE(window.length(), 20.0 + 10.0 + 15.0 + 10.0);
    window.actions().undo->trigger();
    QCOMPARE(window.program().text().line(4), QString("X0"));
    QVERIFY(window.workspace().tuning().value().options.lookahead.has_value());
    window.actions().undo->trigger();
    QVERIFY(!window.workspace().tuning().value().options.lookahead.has_value());
    QCOMPARE(window.program().text().line(2), QString("G1 F1200 X20"));
    window.actions().undo->trigger();
    QCOMPARE(window.text(), QString(kSquare));
    QVERIFY(!window.actions().undo->isEnabled());
    studio::settle(window);
    QCOMPARE(window.length(), 40.0);
    QVERIFY(!window.workspace().isStale());
  }

  void a_line_is_edited_in_place_and_marks_the_title_until_it_is_undone() {
    Editing window(square_);
    QVERIFY(!window.isWindowModified());
    QVERIFY(!window.actions().save_program->isEnabled());
    window.view().setFocus();
    window.view().setCurrentLine(2);
    QTest::keyClick(&window.view(), Qt::Key_F2);
    auto& field = window.field();
    QTest::keyClicks(&field, "5");
    QTest::keyClick(&field, Qt::Key_Return);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QCOMPARE(window.program().text().line(2), QString("G1 F1200 X105"));
    QVERIFY(window.isWindowModified());
    QVERIFY(window.windowTitle().startsWith("square.ngc[*]"));
    QTRY_VERIFY(window.the<QLabel>("programDockBadge").isVisible());
    QVERIFY(window.actions().save_program->isEnabled());
    QVERIFY2(!window.view().findChild<QLineEdit*>(), "Enter ends the edit and begins no other");
    studio::settle(window);
    screenshot(window, "edited");
    window.actions().undo->trigger();
    QVERIFY(!window.isWindowModified());
    QTRY_VERIFY(!window.the<QLabel>("programDockBadge").isVisible());
  }

  void an_edit_is_seen_at_once_and_none_is_lost_while_the_one_before_is_read() {
    Editing window(square_);
    window.program().replaceLine(2, "G1 F1200 X20");
    QVERIFY(window.workspace().isStale());
    window.program().replaceLine(4, "X10");
    QCOMPARE(window.program().text().line(2), QString("G1 F1200 X20"));
    studio::settle(window);
    QCOMPARE(window.workspace().document()->line(2), QString("G1 F1200 X20"));
    QCOMPARE(window.workspace().document()->line(4), QString("X10"));
    QVERIFY(!window.workspace().isStale());
  }

  void escape_leaves_the_line_and_what_is_typed_stays_with_its_line_when_the_cursor_moves() {
    Editing window(square_);
    window.view().setFocus();
    window.view().setCurrentLine(2);
    window.view().editCurrentLine();
    QTest::keyClicks(&window.field(), "99");
    QTest::keyClick(&window.field(), Qt::Key_Escape);
    QCOMPARE(window.text(), QString(kSquare));
    window.view().editCurrentLine();
    QTest::keyClicks(&window.field(), "5");
    window.workspace().setCursorLine(4);
    QCOMPARE(window.view().currentLine(), 4);
    window.view().commitEdit();
    QCOMPARE(window.program().text().line(2), QString("G1 F1200 X105"));
    QCOMPARE(window.program().text().line(4), QString("X0"));
  }

  void a_long_line_is_edited_whole() {
    const QByteArray comment = "(" + QByteArray(50'000, 'x') + ")";
    write(square_, "G21 G90\nG1 F600 X3 " + comment + "\nM2\n");
    Editing window(square_);
    window.view().setCurrentLine(2);
    window.view().editCurrentLine();
    auto& field = window.field();
    QTest::keyClick(&field, Qt::Key_Home);
    QTest::keyClicks(&field, "N2 ");
    window.view().commitEdit();
    QCOMPARE(window.program().text().bytes(), "G21 G90\nN2 G1 F600 X3 " + comment + "\nM2\n");
  }

  void lines_are_added_and_taken_away_with_keys() {
    Editing window(square_);
    window.view().setFocus();
    window.view().setCurrentLine(2);
    QTest::keyClick(&window, Qt::Key_Return, Qt::ControlModifier);
    QTest::keyClicks(&window.field(), "X12");
    QTest::keyClick(&window.field(), Qt::Key_Return);
    QCOMPARE(window.text(), QString("G21 G90 G94\nG1 F1200 X10\nX12\nY10\nX0\nY0\nM2\n"));
    QCOMPARE(window.view().currentLine(), 3);
    QCOMPARE(window.workspace().undoStack().count(), 1);
    QTest::keyClick(&window.view(), Qt::Key_Down, Qt::ShiftModifier);
    QTest::keyClick(&window, Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(window.text(), QString("G21 G90 G94\nG1 F1200 X10\nX0\nY0\nM2\n"));
    window.actions().undo->trigger();
    window.actions().undo->trigger();
    QCOMPARE(window.text(), QString(kSquare));
  }

  void a_program_that_was_emptied_says_so_and_comes_back() {
    Editing window(square_);
    window.program().removeLines(1, 6);
    studio::settle(window);
    QVERIFY(!window.workspace().problems().empty());
    QCOMPARE(window.workspace().problems().front().code, std::string("empty-program"));
    window.actions().undo->trigger();
    studio::settle(window);
    QVERIFY(window.workspace().problems().empty());
    QCOMPARE(window.length(), 40.0);
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

  void what_was_saved_here_is_no_change_from_outside() {
    Editing window(square_);
    QSignalSpy read(&window.workspace(), &Workspace::documentChanged);
    QSignalSpy asked(&window.workspace(), &Workspace::conflictChanged);
    window.program().replaceLine(2, "G1 F1200 X20");
    studio::settle(window);
    QCOMPARE(read.count(), 1);
    window.save();
    // A change from outside is noticed, once, and nothing was noticed before it.
    write(square_, QByteArray(kSquare).replace("X10", "X300"));
    QTRY_COMPARE(read.count(), 2);
    QCOMPARE(window.program().text().line(2), QString("G1 F1200 X300"));
    QCOMPARE(asked.count(), 0);
  }

  void saving_that_fails_leaves_the_edits_and_says_why() {
    Editing window(square_);
    window.program().replaceLine(2, "G1 F1200 X20");
    studio::settle(window);
    QSignalSpy failed(&window.workspace(), &Workspace::saveFailed);
    window.storeProgramAs(folder_.filePath("no/such/folder.ngc"));
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(window.isWindowModified());
    QCOMPARE(window.program().path(), square_);
    QCOMPARE(content(square_), QByteArray(kSquare));
    const auto* problems = window.the<QTableView>("problemTable").model();
    QCOMPARE(problems->rowCount(), 1);
    emit window.workspace().problemsChanged();  // as by a plan that comes later: it tells of its own alone
    QCOMPARE(problems->rowCount(), 1);
    window.storeProgramAs(folder_.filePath("there.ngc"));
    QTRY_COMPARE(problems->rowCount(), 0);
  }

  void a_program_saved_under_another_name_stays_where_it_was_looked_at() {
    Editing window(square_);
    window.workspace().pin();
    window.workspace().setCursorTime(0.5);
    const QString copy = folder_.filePath("copy.ngc");
    window.storeProgramAs(copy);
    QTRY_COMPARE(window.program().path(), copy);
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
    NextDialog dialog([&path](QWidget& widget) {
      auto* files = qobject_cast<QFileDialog*>(&widget);
      if (!files) qFatal("no file dialog");
      files->findChild<QLineEdit*>("fileNameEdit")->setText(path);
      files->findChild<QLineEdit*>("fileNameEdit")->setFocus();
      QTest::keyClick(files->findChild<QLineEdit*>("fileNameEdit"), Qt::Key_Return);
    });
    window.actions().save_program->trigger();
    QTRY_COMPARE(window.workspace().program().path(), path);
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
    QTRY_VERIFY(!window.isVisible());
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
    QTRY_COMPARE(window.program().path(), other_);
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

  void reloading_with_changes_asks_in_a_bar_and_undo_brings_them_back() {
    Editing window(square_);
    window.program().replaceLine(2, "G1 F1200 X20");
    window.actions().reload->trigger();
    QTRY_VERIFY(window.bar().isVisible());
    QCOMPARE(window.program().text().line(2), QString("G1 F1200 X20"));
    studio::settle(window);
    screenshot(window, "reload-question");
    QTest::mouseClick(&window.the<QPushButton>("changeBarTakeFile"), Qt::LeftButton);
    studio::settle(window);
    QVERIFY(!window.bar().isVisible());
    QCOMPARE(window.text(), QString(kSquare));
    QVERIFY(!window.isWindowModified());
    window.actions().undo->trigger();
    QCOMPARE(window.program().text().line(2), QString("G1 F1200 X20"));
    QVERIFY(window.isWindowModified());
    window.actions().reload->trigger();
    QTRY_VERIFY(window.bar().isVisible());
    QTest::mouseClick(&window.the<QPushButton>("changeBarKeepMine"), Qt::LeftButton);
    QVERIFY(!window.bar().isVisible());
    QCOMPARE(window.program().text().line(2), QString("G1 F1200 X20"));
    studio::settle(window);
    QVERIFY(!window.workspace().isStale());
  }

  void a_change_from_outside_does_not_take_changes_away() {
    Editing window(square_);
    window.program().replaceLine(2, "G1 F1200 X20");
    write(square_, QByteArray(kSquare).replace("X10", "X300"));
    QTRY_VERIFY(window.bar().isVisible());
    QCOMPARE(window.program().text().line(2), QString("G1 F1200 X20"));
    QVERIFY(!QApplication::activeModalWidget());
    screenshot(window, "changed-outside");
    QTest::mouseClick(&window.the<QPushButton>("changeBarKeepMine"), Qt::LeftButton);
    // Going back to what the file was once is no way back to what it is.
    window.actions().undo->trigger();
    QCOMPARE(window.text(), QString(kSquare));
    QVERIFY(window.isWindowModified());
    window.save();  // asks no more
    QCOMPARE(content(square_), QByteArray(kSquare));
    QVERIFY(!window.isWindowModified());
  }

  void saving_over_a_change_that_was_not_seen_yet_asks() {
    Editing window(square_);
    window.program().replaceLine(2, "G1 F1200 X20");
    const QByteArray theirs = QByteArray(kSquare).replace("X10", "X300");
    write(square_, theirs);
    NextDialog stay("cancelButton");
    window.actions().save_program->trigger();
    QCOMPARE(stay.shown(), QString("replaceBox"));
    QCOMPARE(content(square_), theirs);
    NextDialog replace("replaceButton");
    window.save();
    QCOMPARE(content(square_), QByteArray(kSquare).replace("X10", "X20"));
    QTRY_VERIFY(!window.bar().isVisible());
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

TOOLPACE_UI_TEST(EditTest)
#include "edit_test.moc"
