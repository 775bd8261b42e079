/// Frame times of the views on a program of a million blocks, in processor time so that a busy machine does not matter.

#include <QTest>
#include <ctime>

#include "plots/profile_plot.h"
#include "plots/profile_view.h"
#include "plots/pyramid.h"
#include "preview/contour_view.h"
#include "support/events.h"
#include "support/planned.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

double processor_ms() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

/// Mean of `count` frames [ms].
template <class Frame>
double mean_ms(int count, const Frame& frame) {
  const double begin = processor_ms();
  for (int i = 0; i < count; ++i) frame(i);
  return (processor_ms() - begin) / count;
}

}  // namespace

class ViewSpeedTest : public QObject {
  Q_OBJECT

 private:
  std::shared_ptr<const Outcome> outcome_;

  static void report(const char* what, double ms, double most) {
    qInfo("%-44s %8.2f ms (limit %.0f)", what, ms, most);
    QVERIFY2(ms <= most, what);
  }

 private slots:
  void initTestCase() { outcome_ = planned(winding(1'000'000)); }

  void scenes_and_series_of_a_million_blocks_are_made_in_time() {
    std::shared_ptr<const ContourScene> scene;
    std::shared_ptr<const ProfileSeries> series;
    report("make_contour_scene, 1e6 blocks", mean_ms(1, [&](int) { scene = make_contour_scene(outcome_); }), 1500);
    report("make_profile_series, 1e6 blocks", mean_ms(1, [&](int) { series = make_profile_series(outcome_); }), 1000);
    QVERIFY(scene->geometry->line.pieces() >= 1'000'000);
  }

  void the_preview_pans_and_zooms_30_times_a_second() {
    ContourView view;
    view.resize(900, 640);
    view.show();
    view.setScene(make_contour_scene(outcome_));
    QApplication::processEvents();
    ContourCanvas& canvas = view.canvas();
    const double pan = mean_ms(20, [&](int i) {
      Projection p = canvas.projection();
      p.pan({i % 2 ? 7.0 : -7.0, 3.0});
      canvas.setProjection(p);
      canvas.zoomBy(1.0, {10, 10});
      canvas.grab();
    });
    report("preview, pan, whole path", pan, 33);
    const double zoom = mean_ms(30, [&](int i) {
      wheel(canvas, {450, 300}, i < 15 ? 120 : -120);
      canvas.grab();
    });
    report("preview, zoom to cursor", zoom, 33);
    report("preview, cursor moves",
           mean_ms(50,
                   [&](int i) {
                     view.setCursorTime(i * 10.0);
                     canvas.grab();
                   }),
           5);
    report("preview, value under the mouse",
           mean_ms(50,
                   [&](int i) {
                     const QPoint at(100 + 10 * i, 300);
                     QMouseEvent move(QEvent::MouseMove, at, canvas.mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                                      Qt::NoModifier);
                     QApplication::sendEvent(&canvas, &move);
                   }),
           5);
  }

  void the_plots_pan_and_zoom_30_times_a_second() {
    ProfileView view;
    view.resize(900, 380);
    view.show();
    view.setSeries(make_profile_series(outcome_));
    QApplication::processEvents();
    ProfilePlot& plot = view.plot();
    const double total = outcome_->plan.cycle_time();
    report("plots, whole program",
           mean_ms(10,
                   [&](int i) {
                     view.setVisibleRange(0.001 * i * total, total);
                     plot.replot();
                   }),
           33);
    report("plots, zoom",
           mean_ms(40,
                   [&](int i) {
                     wheel(plot, {500, 100}, i < 30 ? 120 : -240);
                     plot.replot();
                   }),
           33);
    report("plots, cursor moves", mean_ms(50, [&](int i) { view.setCursorTime(total * 0.001 * i); }), 5);
  }

  void ten_million_samples_are_summed_up_for_each_pixel() {
    std::vector<float> samples(10'000'000);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<float>((i * 2654435761u) % 1000);
    const auto scan = [&](std::size_t first, std::size_t last) {
      Extent extent;
      for (std::size_t i = first; i < last; ++i) extent.add(samples[i]);
      return extent;
    };
    const Pyramid<Extent> pyramid(samples.size(), scan);
    float sum = 0;
    const double ms = mean_ms(20, [&](int frame) {
      const std::size_t begin = static_cast<std::size_t>(frame) * 1000, width = samples.size() - 2 * begin;
      for (std::size_t column = 0; column < 3 * 1280; ++column) {
        const auto first = begin + width * column / (3 * 1280), last = begin + width * (column + 1) / (3 * 1280);
        sum += pyramid.query(first, last, scan).high;
      }
    });
    QVERIFY(sum > 0);
    report("pyramid, 3 x 1280 pixels of 1e7 samples", ms, 12);
  }
};

TOOLPACE_UI_TEST(ViewSpeedTest)
#include "view_speed_test.moc"
