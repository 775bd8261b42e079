/// What is seen at once: units of speed, heights that fit, keys of lines, tolerances of the program, settings that differ.

#include <QCheckBox>
#include <QLabel>
#include <QSettings>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QToolTip>
#include <numbers>

#include "models/setting_differences.h"
#include "opened.h"
#include "panels/nc_panel.h"
#include "panels/reading_page.h"
#include "panels/result_model.h"
#include "panels/tuning_panel.h"
#include "places.h"
#include "plots/profile_plot.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"
#include "support/events.h"
#include "support/files.h"
#include "support/ui_test.h"
#include "theme/line_key.h"
#include "toolpace/sample/motion.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

QStringList texts_of(const LineKey& key) {
  QStringList texts;
  for (const KeySample& sample : key.samples()) texts << sample.text;
  return texts;
}

double top_of(ProfilePlot& plot, int row) { return plot.axisRect(row)->axis(QCPAxis::atLeft)->range().upper; }

QString label_of(ProfilePlot& plot, int row) { return plot.axisRect(row)->axis(QCPAxis::atLeft)->label(); }

}  // namespace

class SeenTest : public QObject {
  Q_OBJECT

 private slots:
  // 20 mm/s = 1200 mm/min = 47.244 in/min.
  void speeds_a_minute_are_everywhere_at_once() {
    Opened window;
    window.open(kSquare);
    auto& button = window.the<QToolButton>("speedUnitButton");
    auto& field = window.the<NumberField>("vmaxEdit");
    auto& plot = window.the<ProfilePlot>("profilePlot");
    const auto peak = [&window] {
      auto& model = *window.the<QTableView>("resultTable").model();
      for (int row = 0; row < model.rowCount(); ++row) {
        if (model.index(row, 0).data().toString().startsWith("Peak speed")) {
          return model.index(row, 0).data().toString() + " = " + model.index(row, 1).data().toString();
        }
      }
      return QString();
    };
    QCOMPARE(button.text(), QString("mm/s"));
    QCOMPARE(field.text(), QString("100"));
    QCOMPARE(peak(), QString("Peak speed  mm/s = 20"));
    QTest::mouseClick(&button, Qt::LeftButton);
    studio::settle(window);
    QCOMPARE(button.text(), QString("mm/min"));
    QCOMPARE(field.text(), QString("6000"));
    QCOMPARE(field.unitText(), QString("mm/min"));
    QCOMPARE(peak(), QString("Peak speed  mm/min = 1200"));
    QVERIFY(label_of(plot, 0).endsWith("mm/min"));
    QVERIFY(label_of(plot, 1).endsWith("mm/s²"));
    QVERIFY(top_of(plot, 0) > 1200 && top_of(plot, 0) < 1500);
    QVERIFY(window.the<QLabel>("profileReadout").text().contains("mm/min"));
    QVERIFY(window.the<QLabel>("motionReadout").text().contains("mm/min"));
    window.actions().inch->trigger();
    studio::settle(window);
    QCOMPARE(peak(), QString("Peak speed  in/min = 47.244"));
    QCOMPARE(window.workspace().tuning().value().machine.path.speed, 100.0);
    // What is typed is in the unit that is shown.
    window.actions().inch->trigger();
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, "3000");
    QTest::keyClick(&field, Qt::Key_Return);
    QCOMPARE(window.workspace().tuning().value().machine.path.speed, 50.0);
    QTest::mouseClick(&button, Qt::LeftButton);
    QCOMPARE(field.text(), QString("50"));
  }

  // The rapid of the butterfly runs at 100 mm/s, what follows at 50: heights fit the half that is looked at.
  void heights_fit_the_visible_time_unless_they_are_held() {
    Opened window;
    window.openButterfly();
    auto& view = window.the<ProfileView>("profileView");
    auto& plot = view.plot();
    QAction& hold = *window.actions().hold_heights;
    QVERIFY(top_of(plot, 0) > 100);
    view.setVisibleRange(1.0, 2.0);
    studio::settle(window);
    QVERIFY2(top_of(plot, 0) > 50 && top_of(plot, 0) < 60, qPrintable(QString::number(top_of(plot, 0))));
    QVERIFY(plot.axisRect(0)->axis(QCPAxis::atLeft)->range().lower <= 0);
    hold.trigger();
    view.setVisibleRange(0.0, 1.0);
    studio::settle(window);
    QVERIFY(top_of(plot, 0) < 60);
    hold.trigger();
    studio::settle(window);
    QVERIFY(top_of(plot, 0) > 100);
    // The wheel over a scale changes it, and holds it.
    const double before = top_of(plot, 0);
    wheel(plot, {10, plot.axisRect(0)->center().y()}, 120);
    studio::settle(window);
    QVERIFY(hold.isChecked());
    QVERIFY(top_of(plot, 0) < before);
    QTest::mouseDClick(&plot, Qt::LeftButton, {}, plot.axisRect(0)->center());
    studio::settle(window);
    QVERIFY(!hold.isChecked());
    QVERIFY(top_of(plot, 0) > 100);
  }

  // A rapid of 100 mm/s beside a feed of 1 mm/s, which would be a line on the floor.
  void heights_fit_the_cutting_where_somebody_wants_that() {
    Opened window;
    window.open("G21 G90 G94\nG0 X100\nG1 X105 F60\nM2\n");
    auto& plot = window.the<ProfilePlot>("profilePlot");
    QVERIFY(top_of(plot, 0) > 100);
    window.actions().fit_cutting->trigger();
    studio::settle(window);
    QVERIFY2(top_of(plot, 0) > 1 && top_of(plot, 0) < 1.2, qPrintable(QString::number(top_of(plot, 0))));
    // Where nothing cuts, what is there fills the height.
    auto& view = window.the<ProfileView>("profileView");
    view.setVisibleRange(0.0, 0.5);
    studio::settle(window);
    QVERIFY(top_of(plot, 0) > 50);
    window.actions().fit_cutting->trigger();
    view.fit();
    studio::settle(window);
    QVERIFY(top_of(plot, 0) > 100);
  }

  // Trapezoids bound no jerk: a line at zero would say that there is none.
  void a_jerk_without_bound_is_no_zero() {
    Opened window;
    window.open(kSquare);
    auto& plot = window.the<ProfilePlot>("profilePlot");
    const auto words = [&plot] {
      QStringList found;
      for (int i = 0; i < plot.itemCount(); ++i) {
        const auto* text = qobject_cast<QCPItemText*>(plot.item(i));
        if (text && text->visible() && text->text().contains("jerk")) found << text->text();
      }
      return found;
    };
    const auto points = [&plot] {
      for (int i = 0; i < plot.graphCount(); ++i) {
        if (plot.graph(i)->name() == "j.curve") return plot.graph(i)->dataCount();
      }
      return -1;
    };
    QVERIFY(words().isEmpty());
    QVERIFY(points() > 0);
    window.workspace().tuning().edit("law", "law", [](Tuning& t) { t.options.law = LawKind::trapezoid; });
    studio::settle(window);
    QCOMPARE(words(), QStringList("jerk is not bounded: acceleration changes in steps"));
    QCOMPARE(points(), 0);
    auto& model = *window.the<QTableView>("resultTable").model();
    for (int row = 0; row < model.rowCount(); ++row) {
      if (!model.index(row, 0).data().toString().startsWith("Peak jerk  ")) continue;
      QCOMPARE(model.index(row, 1).data().toString(), QString("∞"));
    }
  }

  // What a line takes stands beside it: 10 mm at 20 mm/s are half a second and a little.
  void times_stand_beside_the_lines() {
    Opened window;
    window.open(kSquare);
    auto& nc = window.the<NcPanel>("ncPanel");
    const double time = nc.view().timeOf(3);
    QVERIFY2(time > 0.5 && time < 0.6, qPrintable(QString::number(time)));
    QCOMPARE(nc.view().timeOf(1), 0.0);
    auto& label = window.the<QLabel>("timesLabel");
    QVERIFY(label.isVisible());
    window.actions().line_times->trigger();
    QVERIFY(label.isHidden());
  }

  void lines_and_bars_have_keys() {
    Opened window;
    window.openButterfly();
    QCOMPARE(texts_of(window.the<LineKey>("profileKey")), QStringList({"A", "allowed", "feed"}));
    QCOMPARE(texts_of(window.the<LineKey>("contourKey")), QStringList({"rapids"}));
    QCOMPARE(texts_of(window.the<LineKey>("gutterKey")), QStringList({"mean speed", "time lost"}));
    window.actions().pin->trigger();
    studio::settle(window);
    QVERIFY(texts_of(window.the<LineKey>("profileKey")).contains("B"));
    QVERIFY(texts_of(window.the<LineKey>("contourKey")).contains("B"));
    for (const char* name : {"profileKey", "contourKey", "gutterKey"}) {
      const auto& key = window.the<LineKey>(name);
      QVERIFY2(key.isVisible() && key.width() >= key.sizeHint().width(), name);
    }
    window.open(kSquare);
    QVERIFY(!window.the<LineKey>("contourKey").isVisible() ||
            texts_of(window.the<LineKey>("contourKey")) == QStringList({"B"}));
  }

  void acceleration_and_jerk_have_a_map_of_their_own() {
    Opened window;
    window.openButterfly();
    auto& view = window.the<ContourView>("contourView");
    for (const auto by : {ColourBy::acceleration, ColourBy::jerk}) {
      view.setColourBy(by);
      QCOMPARE(view.canvas().colours(), diverging_table(Ground::light));
      QVERIFY(!window.the<QComboBox>("colourMap").isEnabled());
    }
    view.setColourBy(ColourBy::speed);
    QCOMPARE(view.canvas().colours(), colour_table(ColourMap::cividis, Ground::light));
    QVERIFY(window.the<QComboBox>("colourMap").isEnabled());
  }

  void the_tolerance_of_the_program_is_told_where_it_rules() {
    Opened window;
    window.workspace().tuning().edit("", "", [](Tuning& t) { t.options.corner.rule = CornerRule::blend; });
    auto& note = window.the<QLabel>("programTolerance");
    auto& field = window.the<NumberField>("toleranceEdit");
    window.open(kSquare);
    QVERIFY(!note.isVisible());
    QVERIFY(field.isEnabled());
    window.open("G21 G64 P0.05\nG1 F1200 X10\nY10\nX0\nM2\n");
    QVERIFY(note.isVisible());
    QCOMPARE(note.text(), QString("G64 P of the program rules: 0.05 mm"));
    QVERIFY(!field.isEnabled());
    window.open("G21\nG1 F1200 X10\nG64 P0.05\nY10\nG64 P0.02\nX0\nM2\n");
    QCOMPARE(note.text(), QString("G64 P of the program rules in 2 of 3 blocks: 0.02 mm … 0.05 mm"));
    QVERIFY(field.isEnabled());
    window.open(kSquare);
    QVERIFY(!note.isVisible());
  }

  void the_modal_strip_shows_the_tolerance_in_the_programs_unit() {
    Opened window;
    window.open("G20 G64 P0.002\nG1 F40 X1\nG64\nX2\nM2\n");
    auto& nc = window.the<NcPanel>("ncPanel");
    auto& strip = window.the<QLabel>("modalStrip");
    nc.view().setCurrentLine(2);
    QVERIFY2(strip.text().contains("G64&nbsp;P0.002"), qPrintable(strip.text()));
    nc.view().setCurrentLine(4);
    QVERIFY2(strip.text().contains("G64") && !strip.text().contains(";P0"), qPrintable(strip.text()));
  }

  void a_line_tells_when_it_begins() {
    Opened window;
    window.open(kSquare);
    auto& view = window.the<NcPanel>("ncPanel").view();
    const double begin = window.workspace().timeline()->lines()[3].begin;
    QVERIFY(begin > 0);
    int y = 0;
    while (y < view.viewport()->height() && view.lineAt(y) != 3) ++y;
    QHelpEvent help(QEvent::ToolTip, {60, y + 2}, view.viewport()->mapToGlobal(QPoint(60, y + 2)));
    QApplication::sendEvent(view.viewport(), &help);
    QVERIFY2(QToolTip::text().contains("from " + duration_text(begin) + " on"), qPrintable(QToolTip::text()));
  }

  void settings_in_which_a_and_b_differ_are_listed() {
    Opened window;
    window.openButterfly();
    auto& table = window.the<QTableView>("resultTable");
    const auto last = [&table] { return table.model()->index(table.model()->rowCount() - 1, 0).data().toString(); };
    window.actions().pin->trigger();
    studio::settle(window);
    QCOMPARE(last(), QString("Blocks"));
    window.workspace().tuning().edit("", "", [](Tuning& t) {
      t.machine.path.acceleration = 2000;
      t.options.lookahead = 8;
    });
    studio::settle(window);
    const int rows = table.model()->rowCount();
    QCOMPARE(table.model()->index(rows - 3, 0).data().toString(), QString("Settings that differ"));
    QCOMPARE(table.model()->index(rows - 2, 0).data().toString(), QString("Look-ahead  A 8 · B ∞"));
    QCOMPARE(last(), QString("Acceleration of the path  A 2000 mm/s² · B 3000 mm/s²"));
    QCOMPARE(table.columnSpan(rows - 1, 0), int(ResultModel::kColumns));
    window.actions().unpin->trigger();
    studio::settle(window);
    QCOMPARE(last(), QString("Blocks"));
  }

  // Every kind of setting that a job has: words, numbers of every section, the overrides, what is there only sometimes.
  void every_setting_that_differs_is_found() {
    const Job plain{"a.ngc", nullptr, default_setup().machine, default_setup().options};
    QVERIFY(setting_differences(plain, plain, {}).empty());
    Job other = plain;
    other.options.law = LawKind::trapezoid;
    other.options.ramps = Ramps::span;
    other.options.corner.rule = CornerRule::blend;
    other.options.hold_at = 1.5;
    other.options.feed_override = 0.5;
    other.machine.axes[0].jerk = 1e5;
    other.machine.servo[1].position_gain = 33;
    other.machine.period = 0.002;
    QStringList titles;
    for (const auto& d : setting_differences(plain, other, {})) titles << d.title;
    QCOMPARE(titles, QStringList({"Law", "Ramps", "Corners", "Feed hold", "Interpolation period", "Jerk of X",
                                  "Position gain of Y", "Feed override"}));
  }

  // The ridge turns B and C; the largest speed of B that the plot shows is the one that the motion has, in degrees.
  void rotary_axes_have_curves_and_readouts() {
    Opened window;
    window.openProgram(QString::fromStdString(toolpace::test::source_dir().string()) + "/examples/nc/ridge-xyzbc.ngc");
    studio::settle(window);
    QVERIFY(!window.the<QToolButton>("showAxisA").isVisible());
    QVERIFY(window.the<QToolButton>("showAxisC").isVisible());
    auto& plot = window.the<ProfilePlot>("profilePlot");
    QTest::mouseClick(&window.the<QToolButton>("showAxisB"), Qt::LeftButton);
    studio::settle(window);
    QVERIFY2(label_of(plot, 0).endsWith("mm/s, °/s"), qPrintable(label_of(plot, 0)));
    const auto& outcome = *window.workspace().timeline()->outcome();
    Motion motion(*outcome.path, outcome.plan);
    const PhaseBounds bounds = motion.bounds(0, motion.duration(), 4);
    const double most = std::max(bounds.speed.high, -bounds.speed.low) * 180 / std::numbers::pi;
    double drawn = 0;
    for (int i = 0; i < plot.graphCount(); ++i) {
      if (plot.graph(i)->name() != "v.axis") continue;
      for (const auto& point : *plot.graph(i)->data()) drawn = std::max(drawn, std::abs(point.value));
    }
    QVERIFY(most > 0);
    QVERIFY2(std::abs(drawn - most) < 0.05 * most, qPrintable(QString("%1 drawn, %2 is").arg(drawn).arg(most)));
    QVERIFY(top_of(plot, 0) >= drawn);
    const QString place = window.the<QLabel>("positionReadout").text();
    QVERIFY2(place.contains(" B ") && place.contains(" C ") && !place.contains(" A "), qPrintable(place));
    // A program of three axes on the same machine: where the machine says anything of an axis, it is there, too.
    window.open(kSquare);
    QVERIFY(!window.the<QToolButton>("showAxisB").isVisible());
    QVERIFY(!window.the<QToolButton>("showAxisB").isChecked());
    window.workspace().tuning().edit("", "", [](Tuning& t) { t.machine.axes[4].speed = 1; });
    studio::settle(window);
    QVERIFY(window.the<QToolButton>("showAxisB").isVisible());
    QVERIFY(window.the<QLabel>("positionReadout").text().contains(" B "));
  }

  void reading_options_and_units_are_kept_between_starts() {
    QTemporaryDir folder;
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
    {
      studio::MainWindow window(true);
      window.show();
      find<QCheckBox>(window, "readingBlockDelete").setChecked(true);
      auto& dialect = find<QComboBox>(window, "readingDialect");
      dialect.setCurrentIndex(2);
      emit dialect.activated(2);
      auto& arc = find<NumberField>(window, "readingArcTolerance");
      arc.setText("0.02");
      arc.setModified(true);
      QTest::keyClick(&arc, Qt::Key_Return);
      QCOMPARE(*find<ReadingPage>(window, "readingPage").options().arc_tolerance, 0.02);
      window.setPerMinute(true);
      window.actions().rapids->trigger();
      window.close();
    }
    studio::MainWindow again(true);
    const auto& options = find<ReadingPage>(again, "readingPage").options();
    QVERIFY(options.block_delete && find<QCheckBox>(again, "readingBlockDelete").isChecked());
    QCOMPARE(find<QComboBox>(again, "readingDialect").currentIndex(), 2);
    QCOMPARE(static_cast<int>(options.dialect), find<QComboBox>(again, "readingDialect").itemData(2).toInt());
    QCOMPARE(find<NumberField>(again, "readingArcTolerance").text(), QString("0.02"));
    QCOMPARE(*options.arc_tolerance, 0.02);
    QCOMPARE(find<QToolButton>(again, "speedUnitButton").text(), QString("mm/min"));
    QVERIFY(!again.actions().rapids->isChecked());
    // And programs are read by them.
    again.workspace().openText("G21 G90 F600\n/G1 X10\nG1 Y5\nM2\n", "block.ngc");
    studio::settle(again);
    QCOMPARE(again.workspace().timeline()->outcome()->summary.path_length, 5.0);
  }

  void labels_of_the_tuning_and_the_results_say_what_they_mean() {
    Opened window;
    window.openButterfly();
    auto& tuning = window.the<TuningPanel>("tuningPanel");
    int labels = 0;
    for (const auto* label : tuning.findChildren<QLabel*>()) {
      if (!label->buddy()) continue;
      ++labels;
      static const QRegularExpression formula("[=≤<→·≈Δα]");
      QVERIFY2(label->toolTip().contains(formula), qPrintable(label->text() + ": " + label->toolTip()));
    }
    QVERIFY(labels >= 15);
    const auto& model = *window.the<QTableView>("resultTable").model();
    for (int row = 0; row < model.rowCount(); ++row) {
      QVERIFY(!model.index(row, 0).data(Qt::ToolTipRole).toString().isEmpty());
    }
  }
};

TOOLPACE_UI_TEST(SeenTest)
#include "seen_test.moc"
