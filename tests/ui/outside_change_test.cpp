/// A file that another program changes while it is edited here: neither side is lost without being asked.

#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "editing.h"
#include "panels/change_bar.h"
#include "support/dialogs.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

class OutsideChangeTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString square_;

 private slots:
  void init() {
    square_ = folder_.filePath("square.ngc");
    write(square_, kSquare);
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
    TOOLPACE_EVENTUALLY_EQUAL(read.count(), 2);
    QCOMPARE(window.program().text().line(2), QString("G1 F1200 X300"));
    QCOMPARE(asked.count(), 0);
  }

  void reloading_with_changes_asks_in_a_bar_and_undo_brings_them_back() {
    Editing window(square_);
    window.program().replaceLine(2, "G1 F1200 X20");
    window.actions().reload->trigger();
    TOOLPACE_EVENTUALLY(window.bar().isVisible());
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
    TOOLPACE_EVENTUALLY(window.bar().isVisible());
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
    TOOLPACE_EVENTUALLY(window.bar().isVisible());
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
    TOOLPACE_EVENTUALLY(!window.bar().isVisible());
  }
};

TOOLPACE_UI_TEST(OutsideChangeTest)
#include "outside_change_test.moc"
