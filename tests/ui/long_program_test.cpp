/// Long programs: the window stays alive while one is read, planned and let go, says how far it is, can be cancelled, and
/// pays for what it shows rather than for what the program holds. Times and memory are measured by scripts/bench.

#include <QAbstractEventDispatcher>
#include <QFile>
#include <QProgressBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>
#include <cmath>
#include <set>

#include "opened.h"
#include "panels/nc_view.h"
#include "plots/profile_plot.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"
#include "support/events.h"
#include "support/planned.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

constexpr int kBlocks = 300'000;

/// So many blocks of about 0.2 mm that wind over a plate, as text.
QByteArray winding_text(int blocks) {
  QByteArray text = "G21 G90 G94 G17 F6000\n";
  text.reserve(blocks * 28LL);
  for (int i = 0; i < blocks; ++i) {
    const double turn = std::sqrt(static_cast<double>(i)) * 0.06, radius = 1.5 * turn;
    text += "G1 X" + QByteArray::number(radius * std::cos(turn) + 0.02 * std::sin(0.7 * i), 'f', 4) + " Y" +
            QByteArray::number(radius * std::sin(turn), 'f', 4) + "\n";
  }
  return text + "M2\n";
}

/// What is read for many seconds: in the middle of it lines run 24 million times, just within the bounds of reading.
QByteArray endless_text() {
  QByteArray text = "G21 G90 G94 F600\nG1 X1\n";
  const QByteArray comments = QByteArray("(nothing happens here)\n").repeated(20'000);
  text += comments + "#1=0\no1 while [#1 LT 1990000]\n#1=[#1+1]\n";
  text += QByteArray("#2=[#1*2]\n").repeated(9) + "o1 endwhile\n" + comments;
  return text + "G1 X2\nM2\n";
}

/// Counts how often the event loop found nothing to do and was ready for the next thing that a person does.
class Turns {
 public:
  Turns() {
    QObject::connect(QAbstractEventDispatcher::instance(), &QAbstractEventDispatcher::aboutToBlock, &context_,
                     [this] { ++count_; });
  }
  int count() const { return count_; }

 private:
  QObject context_;
  int count_ = 0;
};

}  // namespace

class LongProgramTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;

  QString written(const char* name, const QByteArray& text) const {
    QFile file(folder_.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) qFatal("cannot write %s", name);
    return file.fileName();
  }

 private slots:
  void a_long_file_is_read_with_progress_while_the_window_answers() {
    const QString path = written("long.ngc", winding_text(kBlocks));
    Opened window;
    window.openButterfly();
    auto& workspace = window.workspace();
    const Turns turns;
    int steps = 0;
    bool answered = false;
    std::set<int> told;  // turns in which a step came: all at once would mean that the window was held up
    connect(&workspace, &Workspace::progressed, this, [&] {
      if (++steps == 1) {
        const double before = workspace.cursorTime();
        QTest::keyClick(&window, Qt::Key_Right);
        answered = workspace.cursorTime() > before && !window.grab().isNull();
      }
      told.insert(turns.count());
    });
    window.openProgram(path);
    QVERIFY(workspace.isBusy());
    studio::settle(window);
    QVERIFY2(steps > 15, qPrintable(QString::number(steps)));
    QVERIFY2(told.size() > 3, qPrintable(QString::number(told.size())));
    QVERIFY2(answered, "a key moves the cursor of the program that was there before");
    QVERIFY(!workspace.isStale());
    QCOMPARE(workspace.document()->line_count(), qsizetype{kBlocks + 2});
    QVERIFY(workspace.timeline()->outcome()->summary.blocks >= kBlocks - 1);

    workspace.setCursorTime(workspace.timeline()->duration());
    QVERIFY(window.the<NcView>("ncView").currentLine() > kBlocks - 10);
    screenshot(window, "long-program");
    window.openButterfly();
    QCOMPARE(workspace.document()->name, QString("butterfly.ngc"));
  }

  void reading_is_cancelled_where_it_is() {
    const QString path = written("endless.ngc", endless_text());
    Opened window;
    window.openButterfly();
    auto& workspace = window.workspace();
    const auto document = workspace.document();
    const double example = workspace.timeline()->duration();
    double reached = 0;
    connect(&workspace, &Workspace::progressed, this, [&](double fraction) { reached = fraction; });
    window.openProgram(path);
    auto& cancel = window.the<QToolButton>("cancelButton");
    QVERIFY(eventually([&] { return cancel.isVisible(); }));
    QVERIFY(workspace.isBusy() && window.the<QProgressBar>("progressBar").isVisible());
    QTest::mouseClick(&cancel, Qt::LeftButton);
    studio::settle(window);
    QVERIFY2(reached < 0.6, "what stands behind the middle is never read");
    QCOMPARE(workspace.document(), document);
    QCOMPARE(workspace.timeline()->duration(), example);
    QVERIFY(!cancel.isVisible());
  }

  void curves_of_axes_are_made_by_a_worker_when_they_are_asked_for() {
    Opened window;
    window.open(winding_text(kBlocks / 3));
    auto& workspace = window.workspace();
    const auto series = workspace.plan().series;
    QVERIFY(!series->is_axis_made(0));
    QSignalSpy ready(&workspace, &Workspace::axesReady);
    QTest::mouseClick(&window.the<QToolButton>("showAxisX"), Qt::LeftButton);
    QCOMPARE(ready.count(), 0);
    QVERIFY(eventually(ready));
    QVERIFY(series->is_axis_made(0) && !series->is_axis_made(1));
    screenshot(window, "long-program-axis");
    // The next plan brings it along.
    workspace.tuning().edit("A", "a", [](Tuning& t) { t.machine.path.acceleration = 2000; });
    studio::settle(window);
    QVERIFY(workspace.plan().series != series && workspace.plan().series->is_axis_made(0));
    QCOMPARE(ready.count(), 1);
  }

  void the_cursor_moves_over_pictures_that_are_there() {
    Opened window;
    window.open(winding_text(kBlocks / 3));
    window.waitForProof();
    const auto& canvas = window.the<ContourCanvas>("contourCanvas");
    QSignalSpy plots(&window.the<ProfilePlot>("profilePlot"), &QCustomPlot::afterReplot);
    const std::size_t drawn = canvas.picturesDrawn();
    const double total = window.workspace().timeline()->duration();
    for (int i = 0; i < 20; ++i) {
      window.workspace().setCursorTime(total * (0.3 + 0.001 * i));
      window.grab();
    }
    QCOMPARE(canvas.picturesDrawn(), drawn);
    QCOMPARE(plots.count(), 0);
  }
};

TOOLPACE_UI_TEST(LongProgramTest)
#include "long_program_test.moc"
