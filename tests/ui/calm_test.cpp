/// A machine that shakes: what the page "Drives" tells of it, the vibration below the plots, the limit on the page "Tune".

#include <QDockWidget>
#include <QTest>

#include "opened.h"
#include "panels/calm_panel.h"
#include "panels/tune_page.h"
#include "plots/profile_view.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

const QByteArray kStops = "G21 G90\nG1 X30 F6000\nG4 P0.2\nG1 X5\nM2\n";

/// The page beside a program that shakes X.
class CalmDesk : public Opened {
 public:
  CalmDesk() {
    open(kStops);
    the<QDockWidget>("drivesDock").show();
    shake();
  }
  void shake() {
    workspace().tuning().edit("drive", "drive", [](ui::Tuning& t) {
      t.machine.servo[0].resonance = 23;
      t.machine.servo[0].resonance_damping = 0.02;
      t.machine.servo[0].modes = {{61, 0.03, 0.4}};
    });
    settle();
  }
  void settle() {
    studio::settle(*this);
    waitForProof();
  }
  CalmPanel& panel() { return the<CalmPanel>("calmPanel"); }
  QTableWidget& table() { return the<QTableWidget>("calmTable"); }
  void advise() {
    QTest::mouseClick(&the<QAbstractButton>("calmButton"), Qt::LeftButton);
    QVERIFY(panel().isAdvising());
    TOOLPACE_EVENTUALLY(!panel().isAdvising());
    QVERIFY2(panel().advice(), qPrintable(the<QLabel>("calmHint").text()));
    settle();
  }
};

}  // namespace

class CalmTest : public QObject {
  Q_OBJECT

 private slots:
  void one_click_takes_what_keeps_the_machine_calm() {
    CalmDesk desk;
    QVERIFY(desk.the<QLabel>("calmModes").text().contains("X: 23 Hz"));
    QVERIFY(desk.the<QLabel>("calmModes").text().contains("61 Hz"));
    desk.advise();
    QCOMPARE(desk.table().rowCount(), 8);
    const auto best = desk.panel().advice()->best;
    QVERIFY(best.has_value());
    const CalmChoice choice = desk.panel().advice()->choices[*best];
    const int steps = desk.workspace().undoStack().count();
    desk.table().setFocus();
    desk.table().setCurrentCell(static_cast<int>(*best), 0);
    QTest::keyClick(&desk.table(), Qt::Key_Return);
    QCOMPARE(desk.workspace().undoStack().count(), steps + 1);
    desk.settle();
    QCOMPARE(desk.workspace().tuning().value().options.shaper, choice.job->options.shaper);
    QCOMPARE(desk.workspace().tuning().value().machine.path.jerk, choice.job->machine.path.jerk);
  }

  void the_shaper_is_a_setting_like_others() {
    CalmDesk desk;
    auto& box = desk.the<QComboBox>("shaperBox");
    QCOMPARE(box.currentIndex(), 0);
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_Down);
    desk.settle();
    QCOMPARE(desk.workspace().tuning().value().options.shaper, ShaperKind::zv);
    desk.workspace().undoStack().undo();
    QCOMPARE(box.currentIndex(), 0);
  }

  void without_a_mode_there_is_nothing_to_ask() {
    Opened window;
    window.open(kStops);
    QVERIFY(!window.the<QAbstractButton>("calmButton").isEnabled());
    QVERIFY(!window.the<QComboBox>("shaperBox").isEnabled());
    QVERIFY(window.the<QWidget>("tuneVibration").parentWidget()->isHidden());
    QVERIFY(window.the<QWidget>("showVibration").isHidden());
  }

  void the_vibration_is_a_plot_and_a_limit_of_the_search() {
    CalmDesk desk;
    QVERIFY(!desk.the<QWidget>("showVibration").isHidden());
    desk.the<QAbstractButton>("showVibration").click();
    desk.settle();
    auto& view = desk.the<ProfileView>("profileView");
    QVERIFY(colours_in(screenshot(view, "vibration-plot")) > 10);
    desk.the<QDockWidget>("tuneDock").show();
    desk.settle();
    auto& limit = desk.the<NumberField>("tuneVibration");
    QVERIFY(!limit.parentWidget()->isHidden());
    limit.setValue(0.002);
    desk.the<NumberField>("tunePlans").setValue(16);
    auto& page = desk.the<TunePage>("tunePage");
    page.search();
    TOOLPACE_EVENTUALLY(!page.isSearching());
    QVERIFY(page.tuning());
    QCOMPARE(page.tuning()->limits.vibration, 0.002);
  }

  void pictures_of_the_page() {
    for (const char* language : {"en", "zh_CN"}) {
      CalmDesk desk;
      desk.setLanguage(language);
      desk.setDark(QString(language) != "en");
      desk.advise();
      QVERIFY(colours_in(screenshot(desk.the<QWidget>("drivesPage"), QString("calm-%1").arg(language))) > 10);
    }
  }
};

TOOLPACE_UI_TEST(CalmTest)
#include "calm_test.moc"
