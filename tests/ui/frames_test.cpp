/// What the whole window costs with long programs, in processor time so that a busy machine does not matter: pictures a
/// second while a slider is dragged, the first picture of a million blocks, frames, memory.

#include <QFile>
#include <QSlider>
#include <QTest>
#include <cmath>
#include <ctime>

#include "main_window.h"
#include "memory_policy.h"
#include "plots/profile_plot.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"
#include "screenshot.h"
#include "support/events.h"
#include "support/screenshot.h"

using namespace toolpace;
using namespace toolpace::studio;

namespace {

/// 15 is wanted (scripts/bench measures it); cores that other work shares count up to twice the time.
constexpr double kLeastRate = 7.5;

double processor_ms(clockid_t clock = CLOCK_PROCESS_CPUTIME_ID) {
  timespec now;
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

/// A line of /proc/self/status [MB], such as "VmRSS".
double memory_mb(const QByteArray& key) {
  QFile file("/proc/self/status");
  if (!file.open(QIODevice::ReadOnly)) return 0;
  for (const QByteArray& line : file.readAll().split('\n')) {
    if (line.startsWith(key + ":")) return line.mid(key.size() + 1).trimmed().split(' ').first().toDouble() / 1024;
  }
  return 0;
}

/// So many blocks of about 0.2 mm that wind over a plate, as text.
QByteArray winding_text(int blocks) {
  QByteArray text = "G21 G90 G94 G17\nF6000\n";
  text.reserve(blocks * 28LL);
  for (int i = 0; i < blocks; ++i) {
    const double turn = std::sqrt(static_cast<double>(i)) * 0.06, radius = 1.5 * turn;
    text += "G1 X" + QByteArray::number(radius * std::cos(turn) + 0.02 * std::sin(0.7 * i), 'f', 4) + " Y" +
            QByteArray::number(radius * std::sin(turn), 'f', 4) + "\n";
  }
  return text + "M2\n";
}

void report(const char* what, double value, const char* unit, double limit) {
  qInfo("%-52s %9.2f %s (limit %g)", what, value, unit, limit);
}

}  // namespace

class FramesTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<MainWindow> window_;

  template <class T>
  T& the(const char* name) {
    auto* found = window_->findChild<T*>(name);
    if (!found) qFatal("no %s", name);
    return *found;
  }
  void open(const QByteArray& text, const char* name) {
    window_->workspace().openText(text, name);
    settle(*window_);
  }
  /// Drags the slider for a while; pictures shown a second of processor time, of all threads together.
  double drag_rate(int milliseconds) {
    int shown = 0;
    const auto counting = connect(&window_->workspace(), &ui::Workspace::planChanged, this, [&shown] { ++shown; });
    auto& slider = the<QSlider>("lookaheadSlider");
    const double begin = processor_ms();
    emit slider.sliderPressed();
    QElapsedTimer clock;
    clock.start();
    for (int position = 900; clock.elapsed() < milliseconds || shown < 4; position -= 2) {
      slider.setValue(300 + (position % 600 + 600) % 600);
      QTest::qWait(10);
      if (clock.elapsed() > 60'000) break;
    }
    emit slider.sliderReleased();
    const double spent = processor_ms() - begin;
    disconnect(counting);
    settle(*window_);
    return shown / spent * 1e3;
  }

 private slots:
  void initTestCase() { keep_memory_between_plans(); }
  void init() {
    window_ = std::make_unique<MainWindow>(false);
    window_->setLanguage("en");
    window_->resize(1280, 800);
    window_->show();
  }
  void cleanup() { window_.reset(); }

  void a_drag_over_100_000_blocks_shows_15_pictures_a_second() {
    open(winding_text(100'000), "short.ngc");
    QVERIFY(window_->workspace().timeline()->outcome()->summary.blocks >= 99'999);
    const double rate = drag_rate(1500);
    report("drag over 1e5 blocks, all threads", rate, "pictures/s", 15);
    QVERIFY(rate >= kLeastRate);
  }

  void long_blocks_and_arcs_are_no_slower() {
    QByteArray text = "G21 G90 G94 G17\nF6000\n";
    for (int i = 0; i < 50'000; ++i) {
      const double x = 40 * std::cos(i * 0.05), y = 40 * std::sin(i * 0.05065);
      text += "G1 X" + QByteArray::number(x, 'f', 3) + " Y" + QByteArray::number(y, 'f', 3) + "\nG2 X" +
              QByteArray::number(x + 2, 'f', 3) + " Y" + QByteArray::number(y, 'f', 3) + " I1 J0\n";
    }
    open(text + "M2\n", "arcs.ngc");
    QVERIFY(window_->workspace().timeline()->outcome()->summary.blocks >= 99'999);
    const double rate = drag_rate(1500);
    report("drag over 1e5 long lines and arcs, all threads", rate, "pictures/s", 15);
    QVERIFY(rate >= kLeastRate / 2);
    ui::screenshot(*window_, "window-long-blocks");
  }

  void a_million_blocks_open_draw_and_fit_into_memory() {
    const double before = memory_mb("VmRSS");
    double read_at = 0;
    connect(&window_->workspace(), &ui::Workspace::documentChanged, this, [&] { read_at = processor_ms(); });
    open(winding_text(1'000'000), "million.ngc");
    window_->grab();
    const double first = (processor_ms() - read_at) / 1e3;
    report("first picture of 1e6 blocks after reading", first, "s", 2);
    const double memory = memory_mb("VmRSS") - before, peak = memory_mb("VmHWM") - before;
    report("memory with 1e6 blocks", memory, "MB", 600);
    report("its peak while reading and planning", peak, "MB", 1200);
    QVERIFY(window_->workspace().timeline()->outcome()->summary.blocks >= 999'999);
    QVERIFY(first <= 2);
    QVERIFY(memory <= 600);
    frames();
    ui::screenshot(*window_, "window-million");
  }

  void a_program_that_is_still_read_leaves_the_window_alive_and_can_be_cancelled() {
    window_->openExample();
    settle(*window_);
    const double example = window_->workspace().timeline()->duration();
    window_->workspace().openText(winding_text(1'500'000), "long.ngc");
    QVERIFY(window_->workspace().isBusy());
    // The window answers all the while: no turn of its event loop takes longer than a person notices.
    double longest = 0;
    for (int i = 0; i < 6 && window_->workspace().isBusy(); ++i) {
      const double begin = processor_ms(CLOCK_THREAD_CPUTIME_ID);
      QApplication::processEvents();
      window_->workspace().setCursorTime(0.1 * i);
      window_->grab();
      longest = std::max(longest, processor_ms(CLOCK_THREAD_CPUTIME_ID) - begin);
      QTest::qWait(20);
    }
    report("a turn of the event loop while reading", longest, "ms", 100);
    QVERIFY(longest < 100);
    window_->actions().cancel->trigger();
    settle(*window_);
    QCOMPARE(window_->workspace().timeline()->duration(), example);
    QVERIFY(!window_->workspace().isBusy());
  }

 private:
  /// Mean of the frames that `turn` makes, of the window's own thread [ms].
  template <class Turn>
  static double mean_ms(int count, const Turn& turn) {
    const double begin = processor_ms(CLOCK_THREAD_CPUTIME_ID);
    for (int i = 0; i < count; ++i) turn(i);
    return (processor_ms(CLOCK_THREAD_CPUTIME_ID) - begin) / count;
  }

  void frames() {
    auto& canvas = the<ui::ContourCanvas>("contourCanvas");
    auto& plot = the<ui::ProfilePlot>("profilePlot");
    const auto painted = [](QWidget& widget) {
      widget.repaint();
      QApplication::sendPostedEvents();
    };
    const double zoom = mean_ms(30, [&](int i) {
      ui::wheel(canvas, {300, 150}, i < 15 ? 120 : -120);
      painted(canvas);
    });
    const double pan = mean_ms(20, [&](int i) {
      QTest::keyClick(&canvas, i % 2 ? Qt::Key_Left : Qt::Key_Right, Qt::ShiftModifier);
      painted(canvas);
    });
    const double plots = mean_ms(40, [&](int i) {
      ui::wheel(plot, {500, 100}, i < 20 ? 120 : -120);
      plot.replot();
    });
    const double total = window_->workspace().timeline()->duration();
    const double cursor = mean_ms(40, [&](int i) {
      window_->workspace().setCursorTime(total * (0.3 + 0.001 * i));
      window_->grab();
    });
    const double still = mean_ms(10, [&](int) { window_->grab(); });
    report("preview of 1e6 blocks in the window, zoom", zoom, "ms", 33);
    report("preview of 1e6 blocks in the window, pan", pan, "ms", 33);
    report("plots of 1e6 blocks in the window, zoom", plots, "ms", 33);
    report("cursor moves, beyond painting the window", cursor - still, "ms", 5);
    QVERIFY(zoom <= 33 && pan <= 33 && plots <= 33 && cursor - still <= 5);
  }
};

QTEST_MAIN(FramesTest)
#include "frames_test.moc"
