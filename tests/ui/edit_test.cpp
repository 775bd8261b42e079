/// Editing the program in the window, and undo.

#include <QLabel>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>

#include "editing.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

class EditTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString square_;

 private slots:
  void init() {
    square_ = folder_.filePath("square.ngc");
    write(square_, kSquare);
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
    TOOLPACE_EVENTUALLY(window.the<QLabel>("programDockBadge").text().contains("edited"));
    QVERIFY(window.actions().save_program->isEnabled());
    QVERIFY2(!window.view().findChild<QLineEdit*>(), "Enter ends the edit and begins no other");
    studio::settle(window);
    screenshot(window, "edited");
    window.actions().undo->trigger();
    QVERIFY(!window.isWindowModified());
    TOOLPACE_EVENTUALLY(!window.the<QLabel>("programDockBadge").text().contains("edited"));
  }

  void the_head_of_the_program_says_in_which_dialect_it_was_read_and_why() {
    const QString path = folder_.filePath("haas.nc");
    write(path, "%\nO1000 (HAAS VF-2)\nG21 G90 G94\nG154 P1 G0 X0 Y0\nG1 X10 F1200\nM30\n%\n");
    Editing window(path);
    const auto& badge = window.the<QLabel>("programDockBadge");
    TOOLPACE_EVENTUALLY(badge.text().contains("haas"));
    QVERIFY2(badge.toolTip().contains("Haas"), qPrintable(badge.toolTip()));
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
};

TOOLPACE_UI_TEST(EditTest)
#include "edit_test.moc"
