/// What the whole window costs: between an edit and the new picture while a slider is dragged, and while long programs are
/// opened, cancelled and left. Wanted: 15 replanned pictures of 1e5 blocks a second, no turn of the event loop over
/// 100 ms, the first picture of 1e6 blocks within 2 s of reading and 600 bytes a block.

#include <benchmark/benchmark.h>

#include <QAbstractEventDispatcher>
#include <QFile>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <memory>

#include "application.h"
#include "main_window.h"
#include "meter.h"
#include "screenshot.h"
#include "smooth_moves.h"

namespace {

using namespace toolpace;
using namespace toolpace::ui;
using bench::application;
using bench::Meter;

/// A polyline of so many short blocks.
QByteArray smooth_text(std::size_t blocks) {
  QByteArray text = "x_mm,y_mm,feed_mm_min\n0,0,6000\n";
  const Moves moves = bench::smooth_moves(blocks);
  for (const auto& end : moves.end) {
    text += QByteArray::number(end[0], 'f', 4) + ',' + QByteArray::number(end[1], 'f', 4) + ",6000\n";
  }
  return text;
}

/// So many long lines and arcs in turn, across a plate: every block speeds up and slows down.
QByteArray long_text(std::size_t blocks) {
  QByteArray text = "G21 G90 G94 G17\nF6000\n";
  for (std::size_t i = 0; i < blocks / 2; ++i) {
    const double at = static_cast<double>(i), x = 40 * std::cos(at * 0.05), y = 40 * std::sin(at * 0.05065);
    text += "G1 X" + QByteArray::number(x, 'f', 3) + " Y" + QByteArray::number(y, 'f', 3) + "\nG2 X" +
            QByteArray::number(x + 2, 'f', 3) + " Y" + QByteArray::number(y, 'f', 3) + " I1 J0\n";
  }
  return text + "M2\n";
}

/// The whole window.
class Opened {
 public:
  Opened() {
    application();
    window_ = std::make_unique<studio::MainWindow>(false);
    window_->resize(1280, 800);
    window_->show();
  }
  /// With a program in it, planned and drawn.
  Opened(const QByteArray& text, const char* name) : Opened() {
    window_->workspace().openText(text, name);
    studio::settle(*window_);
  }

  void edit() {
    const int step = ++edits_;
    window_->workspace().tuning().edit("A", "acceleration",
                                       [step](Tuning& t) { t.machine.path.acceleration = 2000 + 50 * (step % 40); });
  }
  /// Until a new plan is shown and painted.
  void wait_for_picture() {
    QEventLoop loop;
    const auto connection = QObject::connect(&workspace(), &Workspace::planChanged, &loop, &QEventLoop::quit);
    loop.exec();
    QObject::disconnect(connection);
    window_->repaint();
    QApplication::processEvents();
  }
  Workspace& workspace() { return window_->workspace(); }
  studio::MainWindow& window() { return *window_; }

 private:
  std::unique_ptr<studio::MainWindow> window_;
  int edits_ = 0;
};

/// Edits come every 10 ms, as from a slider.
template <QByteArray (*Text)(std::size_t)>
void drag(benchmark::State& state) {
  Opened opened(Text(static_cast<std::size_t>(state.range(0))), Text == smooth_text ? "smooth.csv" : "long.ngc");
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] { opened.edit(); });
  opened.workspace().tuning().beginGesture();
  timer.start(10);
  for (auto _ : state) opened.wait_for_picture();
  timer.stop();
  opened.workspace().tuning().endGesture();
  studio::settle(opened.window());
  state.SetItemsProcessed(state.iterations());
  state.SetLabel("pictures");
}

BENCHMARK(drag<smooth_text>)->Name("drag")->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(drag<smooth_text>)
    ->Name("drag_both_threads")
    ->Arg(100'000)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(drag<long_text>)
    ->Name("drag_long_blocks_both_threads")
    ->Arg(100'000)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(drag<smooth_text>)->Name("drag_wall")->Arg(100'000)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(drag<long_text>)->Name("drag_long_blocks_wall")->Arg(100'000)->UseRealTime()->Unit(benchmark::kMillisecond);

/// The longest that the event loop worked without coming back, since it was made [s of processor time].
class Standstill {
 public:
  Standstill() {
    auto* loop = QAbstractEventDispatcher::instance();
    QObject::connect(loop, &QAbstractEventDispatcher::aboutToBlock, &context_, [this] { (void)longest(); });
    QObject::connect(loop, &QAbstractEventDispatcher::awake, &context_, [this] { (void)longest(); });
  }
  double longest() {
    longest_ = std::max(longest_, since_.thread());
    since_ = Meter();
    return longest_;
  }

 private:
  QObject context_;
  Meter since_;
  double longest_ = 0;
};

/// A file of 100 MB: 3.6 million lines.
class BigFile {
 public:
  BigFile() : path_(folder_.filePath("big.ngc")) {
    QFile file(path_);
    if (!file.open(QIODevice::WriteOnly)) qFatal("cannot write %s", qPrintable(path_));
    file.write("G21 G90 G94 G17 F6000\n");
    while (file.pos() < 100'000'000) {
      QByteArray part;
      for (int i = 0; i < 10'000; ++i, ++lines_) {
        const double turn = std::sqrt(static_cast<double>(lines_)) * 0.06, radius = 1.5 * turn;
        part += "G1 X" + QByteArray::number(radius * std::cos(turn), 'f', 4) + " Y" +
                QByteArray::number(radius * std::sin(turn), 'f', 4) + "\n";
      }
      file.write(part);
    }
    file.write("M2\n");
  }
  const QString& path() const { return path_; }
  std::int64_t lines() const { return lines_; }

 private:
  QTemporaryDir folder_;
  QString path_;
  std::int64_t lines_ = 0;
};

/// Between the end of reading and the first picture, all threads; bytes are those of the whole window, reading included.
void first_picture(benchmark::State& state) {
  const QByteArray text = smooth_text(1'000'000);
  double bytes = 0;
  for (auto _ : state) {
    Opened opened;
    Meter since_read;
    QObject::connect(&opened.workspace(), &Workspace::documentChanged, &opened.window(), [&] { since_read = Meter(); });
    bytes = bench::peak_bytes([&] {
      opened.workspace().openText(text, "million.csv");
      studio::settle(opened.window());
      opened.window().grab();
    });
    state.SetIterationTime(since_read.process());
  }
  state.counters["bytes_an_item"] = bytes / 1e6;
  state.SetItemsProcessed(state.iterations() * 1'000'000);
  state.SetLabel("blocks");
}
BENCHMARK(first_picture)->UseManualTime()->Iterations(3)->Unit(benchmark::kMillisecond);

/// All threads, from the file to the picture.
void open_100_megabytes(benchmark::State& state) {
  const BigFile file;
  double bytes = 0;
  for (auto _ : state) {
    Opened opened;
    const Meter meter;
    bytes = bench::peak_bytes([&] {
      opened.window().openProgram(file.path());
      studio::settle(opened.window());
    });
    state.SetIterationTime(meter.process());
  }
  state.counters["bytes_an_item"] = bytes / static_cast<double>(file.lines());
  state.SetItemsProcessed(state.iterations() * file.lines());
  state.SetLabel("lines");
}
BENCHMARK(open_100_megabytes)->UseManualTime()->Iterations(1)->Unit(benchmark::kMillisecond);

/// The longest turn of the event loop while a file of 100 MB is opened, looked at, and left for another program.
void longest_turn(benchmark::State& state) {
  const BigFile file;
  for (auto _ : state) {
    Opened opened;
    opened.window().openExample();
    studio::settle(opened.window());
    Standstill standstill;
    opened.window().openProgram(file.path());
    studio::settle(opened.window());
    for (int i = 1; i <= 20; ++i) {
      opened.workspace().setCursorTime(opened.workspace().timeline()->duration() * i / 20);
      QApplication::processEvents();
    }
    opened.window().openExample();
    studio::settle(opened.window());
    state.SetIterationTime(standstill.longest());
  }
  state.SetItemsProcessed(state.iterations());
  state.SetLabel("turns");
}
BENCHMARK(longest_turn)->UseManualTime()->Iterations(1)->Unit(benchmark::kMillisecond);

/// What is still done after reading a file of 100 MB was cancelled, all threads.
void cancel_reading(benchmark::State& state) {
  const BigFile file;
  for (auto _ : state) {
    Opened opened;
    Meter since;
    bool asked = false;
    QObject::connect(&opened.workspace(), &Workspace::progressed, &opened.window(), [&](double fraction) {
      if (fraction < 0.3 || asked) return;
      asked = true;
      since = Meter();
      opened.workspace().cancel();
    });
    opened.window().openProgram(file.path());
    studio::settle(opened.window());
    state.SetIterationTime(since.process());
  }
  state.SetItemsProcessed(state.iterations());
  state.SetLabel("stops");
}
BENCHMARK(cancel_reading)->UseManualTime()->Iterations(3)->Unit(benchmark::kMillisecond);

}  // namespace
