/// What the workbench does between an edit and the new picture, and while a person looks round: pictures and frames a
/// second of processor time. Wanted: 15 replanned pictures of 1e5 blocks; 30 frames and cursor moves under 5 ms at 1e6.

#include <benchmark/benchmark.h>

#include <QApplication>
#include <QTimer>
#include <cmath>
#include <map>
#include <memory>

#include "jobs/planned.h"
#include "main_window.h"
#include "memory_policy.h"
#include "plots/profile_plot.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"
#include "screenshot.h"
#include "smooth_moves.h"
#include "toolpace/machine/setup.h"

namespace {

using namespace toolpace;
using namespace toolpace::ui;

/// Lives as long as the program: widgets need it.
QApplication& application() {
  studio::keep_memory_between_plans();
  static int argument_count = 1;
  static char name[] = "ui_bench";
  static char* arguments[] = {name, nullptr};
  static auto* app = new QApplication(argument_count, arguments);
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

/// The whole window with a program in it, planned and drawn.
class Opened {
 public:
  Opened(const QByteArray& text, const char* name) {
    application();
    window_ = std::make_unique<studio::MainWindow>(false);
    window_->resize(1280, 800);
    window_->show();
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
  count(state, "pictures");
}

void shades(benchmark::State& state) {
  made(state, [](const auto& o) {
    static std::shared_ptr<const SceneGeometry> geometry;
    const auto scene = make_contour_scene(o, nullptr, geometry);
    geometry = scene->geometry;
    return scene->colours->shades(ColourBy::speed).size();
  });
}
BENCHMARK(shades)->Name("worker_colours")->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// A frame of a widget after each turn of the wheel.
template <class View, class Turn>
void frames(benchmark::State& state, View& view, const Turn& turn) {
  view.resize(900, 640);
  view.show();
  QApplication::processEvents();
  int i = 0;
  for (auto _ : state) {
    turn(i++);
    view.repaint();
  }
  count(state, "frames");
}

void preview_zoom(benchmark::State& state) {
  application();
  ContourView view;
  view.setScene(make_contour_scene(outcome_of(1'000'000)));
  frames(state, view, [&](int i) { view.canvas().zoomBy(i % 30 < 15 ? 1.25 : 0.8, {450, 300}); });
}
void preview_pan(benchmark::State& state) {
  application();
  ContourView view;
  view.setScene(make_contour_scene(outcome_of(1'000'000)));
  frames(state, view, [&](int i) {
    Projection p = view.canvas().projection();
    p.pan({i % 2 ? 7.0 : -7.0, 3.0 - 6.0 * (i % 2)});
    view.canvas().setProjection(p);
    view.canvas().zoomBy(1.0, {450, 300});
  });
}
void plots_zoom(benchmark::State& state) {
  application();
  ProfileView view;
  view.setSeries(make_profile_series(outcome_of(1'000'000)));
  frames(state, view, [&](int i) {
    view.plot().zoom(i % 40 < 20 ? 1.3 : 1 / 1.3, 100);
    view.plot().replot();
  });
}
void plots_with_axes(benchmark::State& state) {
  application();
  ProfileView view;
  const auto series = make_profile_series(outcome_of(1'000'000));
  make_axes(*series, {true, true, false});  // a worker's business
  view.setSeries(series);
  view.setAxisShown(0, true);
  view.setAxisShown(1, true);
  frames(state, view, [&](int i) {
    view.setVisibleRange(0.1 * i, 1000 + 0.1 * i);
    view.plot().replot();
  });
}
void cursor_moves(benchmark::State& state) {
  application();
  ContourView contour;
  ProfileView profile;
  const auto outcome = outcome_of(1'000'000);
  contour.setScene(make_contour_scene(outcome));
  profile.setSeries(make_profile_series(outcome));
  profile.show();
  const double total = outcome->plan.cycle_time();
  frames(state, contour, [&](int i) {
    contour.setCursorTime(total * (i % 1000) / 1000);
    profile.setCursorTime(total * (i % 1000) / 1000);
    profile.repaint();
  });
}
BENCHMARK(preview_zoom)->Unit(benchmark::kMillisecond);
BENCHMARK(preview_pan)->Unit(benchmark::kMillisecond);
BENCHMARK(plots_zoom)->Unit(benchmark::kMillisecond);
BENCHMARK(plots_with_axes)->Unit(benchmark::kMillisecond);
BENCHMARK(cursor_moves)->Unit(benchmark::kMillisecond);

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

}  // namespace
