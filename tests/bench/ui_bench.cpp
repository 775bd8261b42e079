/// What the workbench does between an edit and the new picture, and while a person looks round: pictures and frames a
/// second of processor time. Wanted: 15 replanned pictures of 1e5 blocks; 30 frames and cursor moves under 5 ms at 1e6.

#include <benchmark/benchmark.h>

#include <QApplication>
#include <QTimer>
#include <memory>

#include "jobs/planned.h"
#include "main_window.h"
#include "plots/profile_plot.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"
#include "screenshot.h"
#include "smooth_moves.h"
#include "toolpace/pipeline/setup.h"

namespace {

using namespace toolpace;
using namespace toolpace::ui;

/// Lives as long as the program: widgets need it.
QApplication& application() {
  static int count = 1;
  static char name[] = "ui_bench";
  static char* arguments[] = {name, nullptr};
  static auto* app = new QApplication(count, arguments);
  return *app;
}

std::shared_ptr<const Job> job_of(std::size_t blocks, double acceleration = 3000) {
  static std::map<std::size_t, std::shared_ptr<const Reading>> readings;
  auto& reading = readings[blocks];
  if (!reading) {
    auto made = std::make_shared<Reading>();
    made->moves = bench::smooth_moves(blocks);
    reading = made;
  }
  auto job = std::make_shared<Job>();
  const Setup setup = default_setup();
  job->program_name = "smooth";
  job->program = reading;
  job->machine = setup.machine;
  job->machine.path.acceleration = acceleration;
  job->options = setup.options;
  return job;
}

std::shared_ptr<const Outcome> outcome_of(std::size_t blocks) {
  static std::map<std::size_t, std::shared_ptr<const Outcome>> outcomes;
  auto& outcome = outcomes[blocks];
  if (!outcome) outcome = std::make_shared<const Outcome>(*run(job_of(blocks)));
  return outcome;
}

void count(benchmark::State& state, const char* what) {
  state.SetItemsProcessed(state.iterations());
  state.SetLabel(what);
}

void worker_plan(benchmark::State& state) {
  const auto job = job_of(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(run(job));
  count(state, "plans");
}
BENCHMARK(worker_plan)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

template <class Make>
void made(benchmark::State& state, const Make& make) {
  const auto outcome = outcome_of(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(make(outcome));
  count(state, "plans");
}
void worker_timeline(benchmark::State& state) {
  made(state, [](const auto& o) { return std::make_shared<const Timeline>(o); });
}
void worker_scene(benchmark::State& state) {
  made(state, [](const auto& o) { return make_contour_scene(o); });
}
void worker_series(benchmark::State& state) {
  made(state, [](const auto& o) { return make_profile_series(o); });
}
BENCHMARK(worker_timeline)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(worker_scene)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(worker_series)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// The whole window with a program of so many blocks, planned and drawn.
class Opened {
 public:
  explicit Opened(std::size_t blocks) {
    application();
    window_ = std::make_unique<studio::MainWindow>(false);
    window_->resize(1280, 800);
    window_->show();
    QByteArray text = "x_mm,y_mm,feed_mm_min\n0,0,6000\n";
    const Moves moves = bench::smooth_moves(blocks);
    for (const auto& end : moves.end) {
      text += QByteArray::number(end[0], 'f', 4) + ',' + QByteArray::number(end[1], 'f', 4) + ",6000\n";
    }
    window_->workspace().openText(text, "smooth.csv");
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
void drag(benchmark::State& state) {
  Opened opened(static_cast<std::size_t>(state.range(0)));
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] { opened.edit(); });
  opened.workspace().tuning().beginGesture();
  timer.start(10);
  for (auto _ : state) opened.wait_for_picture();
  timer.stop();
  opened.workspace().tuning().endGesture();
  studio::settle(opened.window());
  count(state, "pictures");
}
BENCHMARK(drag)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(drag)->Name("drag_both_threads")->Arg(100'000)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(drag)->Name("drag_wall")->Arg(100'000)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
