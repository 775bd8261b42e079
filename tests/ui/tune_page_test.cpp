/// The page "Tune", as a person uses it: search, look, take, turn the dial, go back.

#include "panels/tune_page.h"

#include <QDockWidget>
#include <QMenu>
#include <QSlider>
#include <QTest>

#include "opened.h"
#include "support/screenshot.h"
#include "support/ui_test.h"
#include "theme/finish_drawing.h"
#include "toolpace/pipeline/follow.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

/// A square with rounded-off numbers of its own, quickly planned.
const QByteArray kSquare = "G21 G90\nG1 X20 F3000\nY20\nX0\nY0\nX10 Y10\nM2\n";

/// The window with the page beside it, and few plans to make.
class TuneDesk : public Opened {
 public:
  explicit TuneDesk(const QByteArray& program = kSquare, const char* plans = "24") {
    open(program);
    the<QDockWidget>("tuneDock").show();
    settle();
    enter("tunePlans", plans);
  }
  TunePage& page() { return the<TunePage>("tunePage"); }
  FrontPlot& plot() { return the<FrontPlot>("frontPlot"); }
  QTableWidget& settings() { return the<QTableWidget>("tuneSettings"); }
  QString verdict() { return the<QLabel>("tuneVerdict").text(); }
  QUndoStack& undo() { return workspace().undoStack(); }
  void settle() { studio::settle(*this); }

  void enter(const char* name, const QString& text) {
    auto& field = the<NumberField>(name);
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
  }
  void press(const char* name) { QTest::mouseClick(&the<QAbstractButton>(name), Qt::LeftButton); }
  void search() {
    press("tuneButton");
    QVERIFY(page().isSearching());
    TOOLPACE_EVENTUALLY(!page().isSearching());
    QVERIFY2(page().tuning(), qPrintable(verdict()));
    settle();
  }
  QPoint at(std::size_t index) { return plot().placeOf(index).toPoint(); }
  void moveTo(const QPoint& to) {
    QMouseEvent move(QEvent::MouseMove, to, plot().mapToGlobal(to), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&plot(), &move);
  }
};

std::size_t last_of(const toolpace::TuneResult& tuning) { return tuning.front.size() - 1; }

}  // namespace

class TunePageTest : public QObject {
  Q_OBJECT

 private slots:
  void a_click_takes_the_settings_in_one_step_and_undo_gives_them_back() {
    TuneDesk desk;
    const double before = desk.workspace().timeline()->duration();
    const Machine machine = desk.workspace().tuning().value().machine;
    desk.search();
    const auto tuning = desk.page().tuning();
    QVERIFY(tuning->front.size() >= 3);
    QVERIFY(desk.the<QSlider>("frontSlider").isEnabled());
    const int steps = desk.undo().count();
    const std::size_t last = last_of(*tuning);
    QTest::mouseClick(&desk.plot(), Qt::LeftButton, {}, desk.at(last));
    QCOMPARE(desk.undo().count(), steps + 1);
    desk.settle();
    // What the page said of it is what the window plans.
    QCOMPARE(desk.workspace().timeline()->duration(), tuning->front[last].objectives.cycle_time);
    QCOMPARE(desk.the<QSlider>("frontSlider").value(), static_cast<int>(last));
    QVERIFY(!desk.page().isStale());
    const auto followed = follow(*desk.workspace().timeline()->outcome());
    QVERIFY(followed && followed->max_contour_error == tuning->front[last].objectives.contour);
    desk.actions().undo->trigger();
    desk.settle();
    QCOMPARE(desk.workspace().timeline()->duration(), before);
    QCOMPARE(desk.workspace().tuning().value().machine.path.acceleration, machine.path.acceleration);
    QVERIFY(!desk.page().isStale());
  }

  void the_mouse_over_a_point_tells_what_would_change() {
    TuneDesk desk;
    desk.search();
    const std::size_t last = last_of(*desk.page().tuning());
    QCOMPARE(desk.settings().rowCount(), 0);
    desk.moveTo(desk.at(last));
    QVERIFY(desk.settings().rowCount() > 0);
    QVERIFY(desk.the<QLabel>("tuneChangesTitle").text().startsWith("There: "));
    QVERIFY(desk.settings().item(0, 1)->text() != desk.settings().item(0, 2)->text());
    desk.moveTo({2, 2});
    QCOMPARE(desk.settings().rowCount(), 0);
  }

  void a_turn_of_the_dial_is_one_step_and_a_key_is_one_too() {
    TuneDesk desk;
    desk.search();
    auto& slider = desk.the<QSlider>("frontSlider");
    const int steps = desk.undo().count();
    slider.setFocus();
    QTest::keyClick(&slider, Qt::Key_End);
    QCOMPARE(slider.value(), slider.maximum());
    QCOMPARE(desk.undo().count(), steps + 1);
    desk.settle();
    QCOMPARE(desk.workspace().timeline()->duration(), desk.page().tuning()->front.back().objectives.cycle_time);
    QVERIFY(desk.the<QLabel>("frontNumbers").text().contains("µm"));
    slider.setSliderDown(true);
    for (const int to : {2, 1, 0}) slider.setSliderPosition(to);
    slider.setSliderDown(false);
    QCOMPARE(desk.undo().count(), steps + 2);
    desk.settle();
    QCOMPARE(desk.workspace().timeline()->duration(), desk.page().tuning()->front.front().objectives.cycle_time);
    desk.press("frontKnee");
    desk.settle();
    const auto& tuning = *desk.page().tuning();
    QCOMPARE(desk.workspace().timeline()->duration(), tuning.front[tuning.knee].objectives.cycle_time);
  }

  void a_limit_on_the_contour_error_is_kept_by_the_best() {
    TuneDesk desk;
    desk.search();
    const double present = desk.page().tuning()->present.objectives.contour;
    desk.enter("tuneContour", QString::number(present * 0.5 * 1e3, 'f', 4));
    desk.search();
    const auto& tuning = *desk.page().tuning();
    QVERIFY(tuning.best);
    QVERIFY(tuning.front[*tuning.best].objectives.contour <= present * 0.5 * 1.0001);
    desk.press("frontBest");
    desk.settle();
    QCOMPARE(desk.workspace().timeline()->duration(), tuning.front[*tuning.best].objectives.cycle_time);
    desk.enter("tuneContour", "0.01");
    desk.search();
    QVERIFY(desk.verdict().contains("none keeps the limit"));
    QVERIFY(!desk.the<QPushButton>("frontBest").isEnabled());
  }

  void what_was_found_for_other_settings_or_another_program_says_so() {
    TuneDesk desk;
    desk.search();
    desk.workspace().tuning().edit("speed", "speed", [](ui::Tuning& t) { t.machine.path.speed = 20; });
    QVERIFY(desk.page().isStale());
    QVERIFY(desk.verdict().startsWith("Of another program"));
    QVERIFY(!desk.the<QSlider>("frontSlider").isEnabled());
    const int steps = desk.undo().count();
    QTest::mouseClick(&desk.plot(), Qt::LeftButton, {}, desk.at(last_of(*desk.page().tuning())));
    QCOMPARE(desk.undo().count(), steps);
    desk.actions().undo->trigger();
    QVERIFY(!desk.page().isStale());
    desk.open("G1 X5 F600\nY5\nM2\n", "other.ngc");
    QVERIFY(desk.page().isStale());
  }

  void what_may_be_changed_is_chosen_and_one_thing_at_least() {
    TuneDesk desk;
    auto& menu = desk.the<QMenu>("tuneVaryMenu");
    QCOMPARE(menu.actions().size(), static_cast<qsizetype>(kKnobCount));
    for (auto* action : menu.actions()) {
      if (action->objectName() != "vary_am") action->trigger();
    }
    QCOMPARE(desk.the<QToolButton>("tuneVary").text(), QString("Vary: 1 of 8"));
    desk.search();
    const auto law = desk.workspace().tuning().value().options.law;
    for (const Tuned& t : desk.page().tuning()->front) QCOMPARE(t.job->options.law, law);
    desk.the<QAction>("vary_am").trigger();
    QVERIFY(desk.the<QAction>("vary_am").isChecked());
  }

  void a_search_is_stopped_with_what_there_is_and_cancelled_without() {
    TuneDesk desk(kSquare, "2000");
    desk.press("tuneButton");
    QCOMPARE(desk.the<QPushButton>("tuneButton").text(), QString("Stop"));
    TOOLPACE_EVENTUALLY(desk.the<QLabel>("tuneVerdict").text().contains('%'));
    desk.press("tuneButton");
    TOOLPACE_EVENTUALLY(!desk.page().isSearching());
    QVERIFY(desk.page().tuning() && desk.page().tuning()->plans < 2000);
    const auto before = desk.page().tuning();
    desk.press("tuneButton");
    desk.press("tuneButton");
    if (desk.page().isSearching()) desk.press("tuneButton");
    TOOLPACE_EVENTUALLY(!desk.page().isSearching());
    QCOMPARE(desk.the<QPushButton>("tuneButton").text(), QString("Search"));
  }

  void what_helps_most_is_ranked_and_one_is_taken_by_a_key() {
    TuneDesk desk;
    desk.actions().what_if->trigger();
    TOOLPACE_EVENTUALLY(!desk.page().changes().isComputing());
    auto& table = desk.the<QTableWidget>("changesTable");
    QVERIFY(table.rowCount() >= 5);
    const auto saved = [&](int row) { return table.item(row, 1)->text().replace("−", "-").toDouble(); };
    QVERIFY(saved(0) > 0);
    for (int row = 1; row < table.rowCount(); ++row) QVERIFY(saved(row) <= saved(row - 1));
    const double before = desk.workspace().timeline()->duration(), promised = saved(0);
    const int steps = desk.undo().count();
    table.setFocus();
    table.setCurrentCell(0, 0);
    QTest::keyClick(&table, Qt::Key_Return);
    QCOMPARE(desk.undo().count(), steps + 1);
    desk.settle();
    QVERIFY(std::abs(before - desk.workspace().timeline()->duration() - promised) < 1e-3);
    QVERIFY(desk.the<QLabel>("changesHint").text().startsWith("Of other settings"));
    QTest::keyClick(&table, Qt::Key_Return);  // it is not of these settings any more
    QCOMPARE(desk.undo().count(), steps + 1);
  }

  void vibration_is_coloured_where_a_drive_resonates() {
    TuneDesk desk;
    desk.workspace().tuning().edit("drive", "drive", [](ui::Tuning& t) { t.machine.servo[0].resonance = 40; });
    desk.settle();
    desk.search();
    for (const Tuned& t : desk.page().tuning()->front) QVERIFY(t.objectives.vibration.has_value());
    QVERIFY(desk.verdict().contains("vibration"));
    QCOMPARE(desk.plot().plotLayout()->columnCount(), 2);
  }

  void pictures_of_the_page() {
    for (const char* language : {"en", "zh_CN"}) {
      const bool english = QString(language) == "en";
      Opened window({1280, 800});
      window.setLanguage(language);
      window.setDark(!english);
      window.open(kSquare);
      if (!english) window.workspace().tuning().edit("", "", [](ui::Tuning& t) { t.machine.servo[0].resonance = 45; });
      auto& dock = window.the<QDockWidget>("tuneDock");
      dock.show();
      studio::settle(window);
      window.the<NumberField>("tunePlans").setValue(40);
      auto& page = window.the<TunePage>("tunePage");
      page.search();
      page.changes().compute();
      TOOLPACE_EVENTUALLY(!page.isSearching() && !page.changes().isComputing());
      emit window.the<FrontPlot>("frontPlot").hovered(page.tuning()->knee);
      studio::settle(window);
      finish_drawing();
      QVERIFY(colours_in(screenshot(dock, QString("tune-%1").arg(language))) > 10);
      dock.resize(360, 700);
      studio::settle(window);
      QVERIFY(colours_in(screenshot(dock, QString("tune-narrow-%1").arg(language))) > 10);
    }
  }
};

TOOLPACE_UI_TEST(TunePageTest)
#include "tune_page_test.moc"
