/// What a scope recorded, opened, mapped and laid beside the plan, as a person does it.

#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "opened.h"
#include "panels/trace_page.h"
#include "plots/profile_plot.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"
#include "support/dialogs.h"
#include "support/files.h"
#include "support/screenshot.h"
#include "support/ui_test.h"
#include "theme/finish_drawing.h"
#include "toolpace/pipeline/follow.h"
#include "trace_dialog.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

constexpr double kBegin = 0.25;  // [s] when the program starts, by the scope's clock

/// What the machine's drives do under the plan, as a scope with a decimal comma writes it, in ms and µm.
QByteArray recorded(const Outcome& outcome, const char* head = "Time [ms];ActPos X [um];ActPos Y [um]\n") {
  QByteArray text = head;
  double time = kBegin;
  const auto done = follow(outcome, [&](const Setpoints&, const ServoTrace& trace, std::size_t rows) -> Result<void> {
    for (std::size_t k = 0; k < rows; ++k, time += outcome.job->machine.period) {
      text += QString("%1;%2;%3\n")
                  .arg(time * 1e3, 0, 'f', 3)
                  .arg(trace.actual[0][k] * 1e3, 0, 'f', 4)
                  .arg(trace.actual[1][k] * 1e3, 0, 'f', 4)
                  .replace('.', ',')
                  .toUtf8();
    }
    return {};
  });
  return done ? text : QByteArray();
}

void drop_file(QWidget& window, const QString& path) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path)});
  QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &enter);
  QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &drop);
}

bool has_points(Opened& window, const QString& graph) {
  auto& plot = window.the<ProfileView>("profileView").plot();
  for (int i = 0; i < plot.plottableCount(); ++i) {
    auto* curve = qobject_cast<QCPGraph*>(plot.plottable(i));
    if (curve && curve->name() == graph) return curve->visible() && curve->dataCount() > 0;
  }
  return false;
}

}  // namespace

class TraceViewTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString in(const QString& name) const { return folder_.filePath(name); }
  QString verdict(Opened& window) { return window.the<QLabel>("traceVerdict").text(); }

  /// The butterfly with its trace, opened by a drop.
  void openBoth(Opened& window) {
    window.openButterfly();
    write(in("scope.csv"), recorded(*window.workspace().timeline()->outcome()));
    const NextDialog use("traceUse");
    drop_file(window, in("scope.csv"));
    TOOLPACE_EVENTUALLY(window.isSettled() && use.shown() == "traceDialog");
  }

 private slots:
  void a_trace_is_dropped_and_its_errors_are_those_of_the_drives() {
    Opened window;
    openBoth(window);
    const auto followed = follow(*window.workspace().timeline()->outcome());
    QVERIFY(followed);
    QVERIFY2(verdict(window).contains("starts at 0.2"), qPrintable(verdict(window)));
    auto& axes = window.the<QTableWidget>("traceAxes");
    QCOMPARE(axes.rowCount(), 2);
    QCOMPARE(axes.item(1, 0)->text(), QString("Y"));
    auto& lines = window.the<QTableWidget>("traceLines");
    QVERIFY(lines.rowCount() > 500);
    const double worst = lines.item(0, 1)->text().toDouble() * 1e-3;
    // The scope knows when its rows were taken to a part of a period, and Z is not among them.
    QVERIFY2(std::abs(worst - followed->max_contour_error) < 0.05 * followed->max_contour_error,
             qPrintable(QString("%1 and %2").arg(worst).arg(followed->max_contour_error)));
  }

  void plots_and_preview_show_it_until_it_is_closed() {
    Opened window;
    openBoth(window);
    auto& error = window.the<QToolButton>("showError");
    if (!error.isChecked()) QTest::mouseClick(&error, Qt::LeftButton);  // it shows itself where there is room
    studio::settle(window);
    finish_drawing();
    for (const char* graph : {"f.X", "f.Y", "e.measured"}) QVERIFY2(has_points(window, graph), graph);
    QVERIFY(!has_points(window, "f.Z"));
    auto& toggle = window.the<QToolButton>("showFollow");
    QVERIFY(toggle.isVisible() && toggle.isChecked());
    auto& canvas = window.the<ContourView>("contourView").canvas();
    QVERIFY(canvas.showsMeasured());
    QVERIFY(window.the<QComboBox>("errorEnlargement").isVisible());
    window.the<ContourView>("contourView").setEnlargement(100);
    studio::settle(window);
    finish_drawing();
    QVERIFY(colours_in(screenshot(window, "trace-window")) > 10);
    QVERIFY(colours_in(screenshot(window.the<QDockWidget>("traceDock"), "trace-page")) > 10);
    QTest::mouseClick(&toggle, Qt::LeftButton);
    studio::settle(window);
    QVERIFY(!has_points(window, "f.X"));
    QTest::mouseClick(&window.the<QPushButton>("traceClose"), Qt::LeftButton);
    studio::settle(window);
    QVERIFY(!toggle.isVisible() && !canvas.showsMeasured() && !has_points(window, "e.measured"));
    QVERIFY(!window.actions().close_trace->isEnabled());
    QCOMPARE(window.the<QTableWidget>("traceLines").rowCount(), 0);
  }

  void a_click_on_a_line_goes_there() {
    Opened window;
    openBoth(window);
    auto& lines = window.the<QTableWidget>("traceLines");
    const int line = lines.item(3, 0)->text().toInt();
    QTest::mouseClick(lines.viewport(), Qt::LeftButton, {}, lines.visualItemRect(lines.item(3, 1)).center());
    QCOMPARE(static_cast<int>(window.workspace().timeline()->at(window.workspace().cursorTime()).line), line);
  }

  void it_is_compared_anew_with_each_plan() {
    Opened window;
    openBoth(window);
    const QString before = window.the<QTableWidget>("traceAxes").item(0, 2)->text();
    window.workspace().tuning().edit("feed", "feed", [](ui::Tuning& t) { t.options.feed_override = 0.98; });
    TOOLPACE_EVENTUALLY(window.isSettled());
    const auto& axes = window.the<QTableWidget>("traceAxes");
    QVERIFY(axes.rowCount() == 0 || axes.item(0, 2)->text() != before);
  }

  void what_the_columns_mean_can_be_told() {
    Opened window;
    window.openButterfly();
    write(in("plain.csv"), recorded(*window.workspace().timeline()->outcome(), "a;b;c\n"));
    const auto tell = [&](QWidget& dialog) {
      auto& use = find<QPushButton>(dialog, "traceUse");
      const auto choose = [&](const char* list, const QString& text) {
        auto& box = find<QComboBox>(dialog, list);
        const int index = box.findText(text);
        QVERIFY2(index >= 0, qPrintable(text));
        box.setCurrentIndex(index);
        emit box.activated(index);
      };
      for (const char* list : {"traceMeaning1", "traceMeaning2", "traceMeaning3"}) choose(list, "nothing");
      QVERIFY(!use.isEnabled());
      QCOMPARE(find<QLabel>(dialog, "traceState").text(), QString("No column tells where an axis was."));
      choose("traceMeaning1", "time");
      choose("traceUnit1", "ms");
      choose("traceMeaning2", "X, actual");
      choose("traceUnit2", "um");
      choose("traceMeaning3", "X, actual");
      QCOMPARE(find<QLabel>(dialog, "traceState").text(), QString("Two columns mean the same."));
      choose("traceMeaning3", "Y, actual");
      choose("traceUnit3", "um");
      QVERIFY(use.isEnabled());
      QVERIFY(colours_in(screenshot(dialog, "trace-dialog")) > 3);
      QTest::mouseClick(&use, Qt::LeftButton);
    };
    std::unique_ptr<NextDialog> told;
    const NextDialog named([&](QWidget& dialog) {
      auto* field = dialog.findChild<QLineEdit*>("fileNameEdit");
      field->setText(in("plain.csv"));
      QTest::keyClick(field, Qt::Key_Return);
      told = std::make_unique<NextDialog>(tell);
    });
    window.actions().open_trace->trigger();
    TOOLPACE_EVENTUALLY(window.isSettled());
    QVERIFY2(verdict(window).contains("correlation"), qPrintable(verdict(window)));
  }

  void a_trace_of_another_program_is_refused_in_words() {
    Opened window;
    openBoth(window);
    window.open("G21 G90\nG1 X50 F600\nY20\nX0\nY0\nM2\n", "other.ngc");
    TOOLPACE_EVENTUALLY(window.isSettled());
    QCOMPARE(window.the<QTableWidget>("traceLines").rowCount(), 0);
    QVERIFY(!verdict(window).isEmpty() && !verdict(window).contains("correlation 0.99"));
    QVERIFY(!window.the<ContourView>("contourView").canvas().showsMeasured());
  }

  void a_polyline_and_a_machine_are_none() {
    Opened window;
    window.openButterfly();
    write(in("line.csv"), "x,y\n0,0\n10,0\n10,10\n");
    drop_file(window, in("line.csv"));
    studio::settle(window);
    QCOMPARE(window.workspace().document()->name, QString("line.csv"));
  }

  void pictures_in_chinese() {
    Opened window({1024, 700});
    window.setLanguage("zh_CN");
    window.setDark(true);
    openBoth(window);
    studio::settle(window);
    finish_drawing();
    QVERIFY(colours_in(screenshot(window, "trace-window-zh_CN")) > 10);
    QVERIFY(colours_in(screenshot(window.the<QDockWidget>("traceDock"), "trace-page-zh_CN")) > 10);
  }
};

TOOLPACE_UI_TEST(TraceViewTest)
#include "trace_view_test.moc"
