/// A file of 100 MB from disk: the window stays alive while it is read, planned and let go, says how far it is, can be
/// cancelled, and its memory is known.

#include <QElapsedTimer>
#include <QFile>
#include <QProgressBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "memory_policy.h"
#include "opened.h"
#include "panels/nc_view.h"
#include "support/meter.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

constexpr qint64 kBytes = 100'000'000;

/// Windings of about 0.2 mm chords over a plate, until the file is that long. Returns the number of its lines.
int write_program(const QString& path, qint64 bytes) {
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly)) qFatal("cannot write %s", qPrintable(path));
  file.write("G21 G90 G94 G17 F6000\n");
  int lines = 2;
  QByteArray part;
  for (qint64 written = 0; written < bytes; written += part.size()) {
    part.clear();
    for (int i = 0; i < 10'000; ++i, ++lines) {
      const double turn = std::sqrt(static_cast<double>(lines)) * 0.06, radius = 1.5 * turn;
      part += "G1 X" + QByteArray::number(radius * std::cos(turn), 'f', 4) + " Y" +
              QByteArray::number(radius * std::sin(turn), 'f', 4) + "\n";
    }
    file.write(part);
  }
  file.write("M2\n");
  return lines;
}

}  // namespace

class BigFileTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString path_;
  int lines_ = 0;

  /// Runs the event loop until `done`, or for a minute.
  template <class Done>
  static bool wait_until(const Done& done) {
    QElapsedTimer clock;
    for (clock.start(); !done() && clock.elapsed() < 120'000;) QTest::qWait(5);
    return done();
  }

 private slots:
  void initTestCase() {
    studio::keep_memory_between_plans();
    path_ = folder_.filePath("big.ngc");
    lines_ = write_program(path_, kBytes);
  }

  void a_hundred_megabytes_are_read_with_progress_and_without_a_standstill() {
    Opened window;
    window.openButterfly();
    const double before = memory_mb("VmRSS");
    auto& progress = window.the<QProgressBar>("progressBar");
    Standstill standstill;
    window.openProgram(path_);
    QVERIFY(window.workspace().isBusy());
    QTRY_VERIFY_WITH_TIMEOUT(progress.isVisible(), 2000);
    int steps = 0, last = progress.value();
    QVERIFY(wait_until([&] {
      if (progress.value() != last) (++steps, last = progress.value());
      return !window.workspace().isBusy() && window.workspace().document()->line_count() == lines_;
    }));
    QVERIFY2(steps > 10, qPrintable(QString::number(steps)));
    QVERIFY(!window.workspace().isStale());
    QVERIFY(window.workspace().timeline()->outcome()->summary.blocks > 3'000'000);
    window.grab();
    qInfo("longest turn of the event loop: %.0f ms of its thread", standstill.longest_ms());
    qInfo("memory: %.0f MB, at most %.0f MB", memory_mb("VmRSS") - before, memory_mb("VmHWM") - before);
    QVERIFY2(standstill.longest_ms() < 100, qPrintable(QString::number(standstill.longest_ms())));

    // It is looked at, and another program takes its place.
    Standstill looking;
    auto& view = window.the<NcView>("ncView");
    for (int i = 1; i <= 20; ++i) {
      window.workspace().setCursorTime(window.workspace().timeline()->duration() * i / 20);
      QTest::qWait(10);
    }
    QVERIFY(view.currentLine() > lines_ - 10);
    screenshot(window, "big-file");
    qInfo("longest turn while looking round: %.0f ms", looking.longest_ms());
    Standstill leaving;
    window.openButterfly();
    qInfo("longest turn while leaving: %.0f ms", leaving.longest_ms());
    QVERIFY2(leaving.longest_ms() < 100, qPrintable(QString::number(leaving.longest_ms())));
  }

  void reading_is_cancelled_at_once() {
    Opened window;
    window.openButterfly();
    const auto document = window.workspace().document();
    window.openProgram(path_);
    auto& cancel = window.the<QToolButton>("cancelButton");
    QTRY_VERIFY(cancel.isVisible());
    QVERIFY(window.workspace().isBusy());
    const Meter meter;
    QTest::mouseClick(&cancel, Qt::LeftButton);
    QVERIFY(wait_until([&] { return !window.workspace().isBusy(); }));
    qInfo("stopped after %.0f ms of all threads", meter.process_ms());
    QVERIFY2(meter.process_ms() < 300, qPrintable(QString::number(meter.process_ms())));
    QCOMPARE(window.workspace().document(), document);
  }
};

TOOLPACE_UI_TEST(BigFileTest)
#include "big_file_test.moc"
