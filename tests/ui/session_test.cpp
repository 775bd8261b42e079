/// An hour at the window as one person spends it, by mouse and keys: first start, open, tune, find why, compare, sweep, export, a bad
/// file, an edit outside, cancel. ctest runs it in an X display (Xvfb) where there is one. After each step the window is looked at:
/// nothing lies over anything else, and every text stands out against its ground.

#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "opened.h"
#include "panels/nc_view.h"
#include "panels/number_field.h"
#include "panels/sweep_panel.h"
#include "plots/profile_plot.h"
#include "support/dialogs.h"
#include "support/files.h"
#include "support/legible.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

void click(QWidget& widget) { QTest::mouseClick(&widget, Qt::LeftButton, {}, widget.rect().center()); }

/// A key of the window, which has to be the one that keys go to.
void press(Opened& window, Qt::Key key) {
  window.activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&window, kPatience));
  QTest::keyClick(&window, key, Qt::ControlModifier);
}

void type(QWidget& field, const QString& text) {
  click(field);
  QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(&field, text);
  QTest::keyClick(&field, Qt::Key_Return);
}

}  // namespace

class SessionTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString in(const QString& name) const { return folder_.filePath(name); }
  void look(Opened& window, const QString& name) {
    studio::settle(window);
    screenshot(window, "session-" + name);
    for (const QString& trouble : illegible_in(window)) troubles_ << name + ": " + trouble;
  }
  QStringList troubles_;

 private slots:
  void an_hour_at_the_window() {
    write(in("part.ngc"),
          "G21 G90 G94\nT1 M6\nG0 X5 Y5\nG1 Z-1 F300\nX45 F1500\nG2 X55 Y15 J10\nG1 Y35\nX5\nY5\nG0 Z5\nM2\n");
    Opened window;
    window.openExample();  // first start
    look(window, "first-start");
    QVERIFY(window.the<QWidget>("welcomeBar").isVisible());

    window.openProgram(in("part.ngc"));
    look(window, "opened");
    QVERIFY(!window.the<QWidget>("welcomeBar").isVisible());
    const double at_first = window.workspace().timeline()->duration();

    type(window.the<NumberField>("amEdit"), "1000");  // tune
    studio::settle(window);
    const double slower = window.workspace().timeline()->duration();
    QVERIFY(slower > at_first);
    look(window, "tuned");

    // Why is it slow there? A click on the plots moves the line of the program, and the bar below names what holds it.
    auto& plot = window.the<ProfilePlot>("profilePlot");
    const double corner = window.workspace().timeline()->lines()[5].begin;
    QTest::mouseClick(&plot, Qt::LeftButton, {}, {static_cast<int>(plot.xOf(corner + 0.02)), plot.height() / 4});
    QCOMPARE(window.the<NcView>("ncView").currentLine(), 5);
    QVERIFY(!window.the<QLabel>("messageReadout").text().isEmpty());

    click(window.the<QToolButton>("pinButton"));  // A beside B
    type(window.the<NumberField>("amEdit"), "4000");
    look(window, "compared");
    QVERIFY(window.workspace().timeline()->duration() < window.workspace().pinned().timeline->duration());
    QVERIFY(window.the<QLabel>("cycleDeltaLabel").text().startsWith("−"));

    window.the<QDockWidget>("sweepDock").raise();
    press(window, Qt::Key_L);  // sweep
    TOOLPACE_EVENTUALLY(!window.the<SweepPanel>("sweepPanel").lastSweep().points.empty());
    look(window, "swept");

    {
      std::unique_ptr<NextDialog> name;  // export: what will be written, then where to
      const NextDialog answer([&](QWidget& dialog) {
        QVERIFY(dialog.findChild<QLabel*>("exportContents")->text().contains("setpoints"));
        QTest::mouseClick(dialog.findChild<QAbstractButton*>("exportSave"), Qt::LeftButton);
        name.reset(new NextDialog(file_named(in("out.csv"))));
      });
      press(window, Qt::Key_E);
      TOOLPACE_EVENTUALLY(QFile::exists(in("out.csv")));
    }

    write(in("bad.ngc"), "G21 G90\nG1 X10\nG1 X[1/0] F100\nM2\n");  // a bad file
    window.openProgram(in("bad.ngc"));
    look(window, "bad-file");
    QVERIFY(window.the<QTableView>("problemTable").model()->rowCount() > 0);

    window.openProgram(in("part.ngc"));  // again
    studio::settle(window);
    write(in("part.ngc"), "G21 G90 G94\nG1 X20 F600\nM2\n");  // another program writes to it
    TOOLPACE_EVENTUALLY(window.workspace().document()->line_count() == 3);
    look(window, "changed-outside");

    QByteArray long_program = "G21 G90 G94 F6000\n";
    for (int i = 0; i < 4000; ++i) long_program += QString("G1 X%1 Y%2\n").arg(i % 2 ? 40 : 0).arg(i).toLatin1();
    window.open(long_program, "long.ngc");
    window.actions().presets.back()->trigger();  // and what takes long is cancelled
    TOOLPACE_EVENTUALLY(window.workspace().isRefining());
    press(window, Qt::Key_Period);
    TOOLPACE_EVENTUALLY(!window.workspace().isBusy());
    QVERIFY(window.workspace().timeline());
    look(window, "cancelled");

    window.setDark(true);
    window.setLanguage("zh_CN");
    look(window, "dark-chinese");
    QVERIFY2(troubles_.isEmpty(), qPrintable(troubles_.join('\n')));
  }
};

TOOLPACE_UI_TEST(SessionTest)
#include "session_test.moc"
