/// The pages "Single move" and "Stepper", as a person uses them.

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "panels/move_plot.h"
#include "panels/pulse_plot.h"
#include "panels/single_move_page.h"
#include "panels/stepper_page.h"
#include "support/patience.h"
#include "support/screenshot.h"
#include "support/ui_test.h"
#include "theme/finish_drawing.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

void keep_picture(QWidget& widget, const QString& name) {
  finish_drawing();
  const QImage picture = screenshot(widget, name);
  QVERIFY(colours_in(picture) > 10);
}

template <class T>
T* child(QWidget& widget, const char* name) {
  T* found = widget.findChild<T*>(name);
  if (!found) qFatal("no %s", name);
  return found;
}

double shown(QWidget& widget, const char* name) {
  return child<QLabel>(widget, name)->text().remove(QChar(0x2009)).toDouble();
}

void enter(QWidget& widget, const char* name, const char* text) {
  auto* field = child<QLineEdit>(widget, name);
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, text);
  QTest::keyClick(field, Qt::Key_Return);
}

void choose(QWidget& widget, const char* name, int index) {
  auto* combo = child<QComboBox>(widget, name);
  combo->setCurrentIndex(index);
  emit combo->activated(index);
}

}  // namespace

class MotionPagesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { wear(light_theme()); }

  void presetsAreTheMovesOfTheLiterature() {
    SingleMovePage page;
    page.resize(1180, 720);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page, kPatience));
    QCOMPARE(shown(page, "moveResult_t_total"), 63.75);
    QCOMPARE(shown(page, "moveResult_sa"), 1925.0);
    keep_picture(page, "single-move-zheng-1");
    choose(page, "movePreset", 2);
    QVERIFY(std::abs(shown(page, "moveResult_fmax") - 92.666667) < 5e-7);
    QVERIFY(std::abs(shown(page, "moveResult_j_dec") - 0.322963) < 5e-7);
    keep_picture(page, "single-move-zheng-2");
  }

  void phasesAreLabelledWithTheirDurations() {
    SingleMovePage page;
    page.resize(1180, 720);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page, kPatience));
    const auto* plot = child<MovePlot>(page, "movePlot");
    QCOMPARE(plot->phaseLabels(), QStringList({"17.5", "17.5", "8.75", "10", "10"}));
    choose(page, "movePreset", 3);
    QCOMPARE(plot->phaseLabels().size(), 7);
    keep_picture(page, "single-move-s-curve");
  }

  void editingAFieldComputesAnew() {
    SingleMovePage page;
    page.show();
    enter(page, "moveFeed", "50");
    QCOMPARE(page.form().move.feed, 50.0);
    QCOMPARE(shown(page, "moveResult_fmax"), 50.0);
    QCOMPARE(child<QComboBox>(page, "movePreset")->currentIndex(), 0);
  }

  void theLawDecidesWhichLimitsAreShown() {
    SingleMovePage page;
    page.show();
    QVERIFY(child<QLineEdit>(page, "moveTacc")->isVisible());
    QVERIFY(!child<QLineEdit>(page, "moveAm")->isVisible());
    choose(page, "moveLaw", static_cast<int>(LawKind::quintic));
    QVERIFY(!child<QLineEdit>(page, "moveTacc")->isVisible());
    QVERIFY(child<QLineEdit>(page, "moveAm")->isVisible());
    QVERIFY(child<QLineEdit>(page, "moveJm")->isVisible());
    choose(page, "moveLaw", static_cast<int>(LawKind::trapezoid));
    QVERIFY(!child<QLineEdit>(page, "moveJm")->isVisible());
    QCOMPARE(child<QLabel>(page, "moveResult_j_acc")->text(), QString("∞"));
  }

  void anUnreachableEndSpeedSaysWhatWouldDo() {
    SingleMovePage page;
    page.resize(1180, 720);
    page.show();
    choose(page, "movePreset", 2);
    enter(page, "moveLength", "600");
    QVERIFY(!page.preview());
    const QString text = child<QLabel>(page, "moveVerdict")->text();
    QVERIFY2(text.contains("675"), qPrintable(text));
    QCOMPARE(child<QLabel>(page, "moveResult_fmax")->text(), QString("–"));
    keep_picture(page, "single-move-unreachable");
    enter(page, "moveLength", "675");
    QVERIFY(page.preview().has_value());
  }

  void everyLawDrawsEveryPreset() {
    SingleMovePage page;
    page.show();
    for (int preset = 1; preset <= 4; ++preset) {
      choose(page, "movePreset", preset);
      for (const LawRow& law : law_table()) {
        choose(page, "moveLaw", static_cast<int>(law.kind));
        QVERIFY2(page.preview().has_value(), law.id.data());
        for (const double v : page.preview()->speed) QVERIFY(v >= -1e-9 && v <= page.form().move.feed * (1 + 1e-9));
      }
    }
  }

  void theStepperPageShowsTheTable() {
    StepperPage page;
    page.resize(1180, 720);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page, kPatience));
    keep_picture(page, "stepper");
    enter(page, "stepperSteps", "1");
    QVERIFY(page.table().has_value());
    enter(page, "stepperSteps", "10000000");
    QVERIFY(page.table().has_value());
    enter(page, "stepperTimer", "100");
    QVERIFY(!page.table().has_value());
    QVERIFY(!child<QPushButton>(page, "stepperExport")->isEnabled());
    keep_picture(page, "stepper-timer-too-slow");
  }

  void exportWritesTheWholeTable() {
    QTemporaryDir folder;
    StepperPage page;
    page.setMove({1000, 5000, 0.05, 0.03, 1e6});
    QSignalSpy done(&page, &StepperPage::exported);
    page.exportTo(folder.filePath("pulses.csv"));
    QVERIFY(eventually(done));
    QVERIFY(done.last()[1].toBool());
    QFile file(folder.filePath("pulses.csv"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
    QCOMPARE(lines.size(), 1001);
    qint64 sum = 0;
    for (int i = 1; i < lines.size(); ++i) sum += lines[i].split(',')[1].toLongLong();
    QCOMPARE(sum, static_cast<qint64>(page.table()->total_ticks()));
    QVERIFY(eventually([&] { return child<QPushButton>(page, "stepperExport")->isEnabled(); }));
    done.clear();
    page.exportTo(folder.filePath("nowhere/pulses.h"));
    QVERIFY(eventually(done));
    QVERIFY(!done.last()[1].toBool());
  }

  void bothPagesWearTheDarkTheme() {
    wear(dark_theme());
    SingleMovePage move;
    StepperPage stepper;
    for (QWidget* page : {static_cast<QWidget*>(&move), static_cast<QWidget*>(&stepper)}) page->resize(1180, 720);
    move.setTheme(dark_theme());
    stepper.setTheme(dark_theme());
    move.show();
    stepper.show();
    QCOMPARE(move.grab().toImage().pixelColor(2, 2), dark_theme().surface);
    keep_picture(move, "single-move-dark");
    keep_picture(stepper, "stepper-dark");
    wear(light_theme());
  }
};

TOOLPACE_UI_TEST(MotionPagesTest)
#include "motion_pages_test.moc"
