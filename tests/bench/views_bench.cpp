/// What a worker makes ready for a plan's views, and what the views cost while a person looks round a million blocks.
/// Wanted: 30 frames a second; the cursor and the value under the mouse in 5 ms.

#include <benchmark/benchmark.h>

#include <QMouseEvent>
#include <map>
#include <memory>

#include "application.h"
#include "drawing/pyramid.h"
#include "models/timeline.h"
#include "plots/profile_plot.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"
#include "smooth_moves.h"
#include "toolpace/machine/setup.h"

namespace {

using namespace toolpace;
using namespace toolpace::ui;
using bench::application;

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
void value_under_the_mouse(benchmark::State& state) {
  application();
  ContourView view;
  view.setScene(make_contour_scene(outcome_of(1'000'000)));
  frames(state, view, [&](int i) {
    const QPoint at(100 + 7 * (i % 100), 300);
    QMouseEvent move(QEvent::MouseMove, at, view.canvas().mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&view.canvas(), &move);
  });
}

/// Items are pixels: 3 rows of 1280, of 1e7 samples.
void pyramid_of_samples(benchmark::State& state) {
  constexpr std::size_t kPixels = 3 * 1280;
  std::vector<float> samples(10'000'000);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<float>((i * 2654435761u) % 1000);
  const auto scan = [&](std::size_t first, std::size_t last) {
    Extent extent;
    for (std::size_t i = first; i < last; ++i) extent.add(samples[i]);
    return extent;
  };
  const Pyramid<Extent> pyramid(samples.size(), scan);
  std::size_t frame = 0;
  for (auto _ : state) {
    const std::size_t begin = (frame++ % 20) * 1000, width = samples.size() - 2 * begin;
    for (std::size_t i = 0; i < kPixels; ++i) {
      benchmark::DoNotOptimize(pyramid.query(begin + width * i / kPixels, begin + width * (i + 1) / kPixels, scan));
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kPixels));
  state.SetLabel("pixels");
}
BENCHMARK(pyramid_of_samples)->Unit(benchmark::kMillisecond);

BENCHMARK(preview_zoom)->Unit(benchmark::kMillisecond);
BENCHMARK(preview_pan)->Unit(benchmark::kMillisecond);
BENCHMARK(plots_zoom)->Unit(benchmark::kMillisecond);
BENCHMARK(plots_with_axes)->Unit(benchmark::kMillisecond);
BENCHMARK(cursor_moves)->Unit(benchmark::kMillisecond);
BENCHMARK(value_under_the_mouse)->Unit(benchmark::kMillisecond);

}  // namespace
