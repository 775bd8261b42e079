/// Spectrum and histogram: sines are found where they are, and times add up.

#include "drawing/spectrum.h"

#include <qcustomplot.h>

#include <QDockWidget>
#include <QTest>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stop_token>

#include "opened.h"
#include "panels/spectrum_page.h"
#include "plots/profile_view.h"
#include "support/files.h"
#include "support/planned.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

std::vector<double> sines(std::size_t count, double period) {
  std::vector<double> samples(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) * period;
    samples[i] = 7 + 300 * std::sin(2 * std::numbers::pi * 50 * t) + 20 * std::cos(2 * std::numbers::pi * 120 * t + 1);
  }
  return samples;
}

}  // namespace

class SpectrumTest : public QObject {
  Q_OBJECT

 private slots:
  // 1000 samples of 1 ms: 1 Hz apart. A sine on a line has its amplitude there, half of it beside it (Hann), nothing elsewhere.
  void a_sine_stands_at_its_frequency_with_its_amplitude() {
    const Spectrum s = amplitude_spectrum(sines(1000, 1e-3), 1e-3);
    QCOMPARE(s.frequency.size(), std::size_t{501});
    QVERIFY(std::abs(s.resolution - 1) < 1e-12);
    QVERIFY(std::abs(s.frequency.back() - 500) < 1e-9);
    QVERIFY(std::abs(s.amplitude[0] - 7) < 1e-9);
    QVERIFY(std::abs(s.amplitude[50] - 300) < 1e-9);
    QVERIFY(std::abs(s.amplitude[49] - 150) < 1e-9 && std::abs(s.amplitude[51] - 150) < 1e-9);
    QVERIFY(std::abs(s.amplitude[120] - 20) < 1e-9);
    for (const std::size_t quiet : {10, 45, 55, 100, 140, 499}) QVERIFY(s.amplitude[quiet] < 1e-9);
  }

  // Two stretches of 2^20 samples; 50 Hz lies between two lines 1000/2^20 Hz apart, where a Hann window shows 0.85 of it at least.
  void long_stretches_are_averaged() {
    const std::size_t count = (std::size_t{1} << 21) + 5;
    const Spectrum s = amplitude_spectrum(sines(count, 1e-3), 1e-3);
    QCOMPARE(s.frequency.size(), (std::size_t{1} << 19) + 1);
    const auto peak = std::max_element(s.amplitude.begin() + 10, s.amplitude.end());
    const auto at = static_cast<std::size_t>(peak - s.amplitude.begin());
    QVERIFY(std::abs(s.frequency[at] - 50) <= s.resolution);
    QVERIFY(*peak > 0.84 * 300 && *peak < 300.0001);
  }

  void times_at_speeds_add_up_to_the_time_that_is_run() {
    const auto outcome = planned_butterfly();
    const auto result = analyse_motion({outcome, 0, 0, outcome->plan.cycle_time()});
    QVERIFY(result.has_value());
    const SpeedHistogram& h = result->histogram;
    const double period = outcome->job->machine.period;
    QVERIFY(std::abs(h.total() + outcome->summary.dwell_time - outcome->plan.cycle_time()) <= 2 * period);
    // By cause as the plan says, but for the periods at the seams of its restraints.
    for (std::size_t cause = 0; cause < kCauseCount; ++cause) {
      double sum = 0;
      for (const auto& row : h.time) sum += row[cause];
      if (static_cast<Cause>(cause) == Cause::dwell) continue;
      QVERIFY(std::abs(sum - outcome->summary.time_by_cause[cause]) <=
              period * static_cast<double>(outcome->restraints.size() + 1));
    }
  }

  void a_stretch_without_setpoints_is_refused_and_a_cancelled_one_ends() {
    const auto outcome = planned_butterfly();
    const auto none = analyse_motion({outcome, 0, 1.0, 1.005});
    QVERIFY(!none);
    QCOMPARE(none.error().code, std::string("too-few-setpoints"));
    std::stop_source stop;
    stop.request_stop();
    const auto cancelled = analyse_motion({outcome, 0, 0, 4}, Monitor{stop.get_token(), {}});
    QVERIFY(!cancelled);
    QCOMPARE(cancelled.error().kind, ErrorKind::cancelled);
  }

  void the_page_follows_axis_plan_and_visible_time() {
    Opened window({1280, 800});
    window.openButterfly();
    auto& page = window.the<SpectrumPage>("spectrumPage");
    QVERIFY(!page.analysis());  // nobody looks
    window.the<QDockWidget>("spectrumDock").show();
    studio::settle(window);
    QVERIFY(page.analysis());
    const auto whole = page.analysis();
    auto& axis = window.the<QComboBox>("spectrumAxis");
    QCOMPARE(axis.count(), 4);
    QCOMPARE(axis.currentText(), QString("axis X"));
    axis.setCurrentIndex(2);
    studio::settle(window);
    QVERIFY(page.analysis() != whole);
    QVERIFY(page.analysis()->spectrum.amplitude != whole->spectrum.amplitude);
    QCOMPARE(page.analysis()->histogram.time, whole->histogram.time);
    window.the<QComboBox>("spectrumRange").setCurrentIndex(1);
    window.the<ProfileView>("profileView").setVisibleRange(1.0, 1.5);
    studio::settle(window);
    QVERIFY(std::abs(page.analysis()->histogram.total() - 0.5) < 0.01);
    window.the<ProfileView>("profileView").setVisibleRange(1.0, 1.004);
    studio::settle(window);
    QVERIFY(!page.analysis());
    QCOMPARE(window.the<QLabel>("spectrumVerdict").text(), QString("The time is too short for a spectrum"));
    window.the<ProfileView>("profileView").setVisibleRange(0, 4);
    const auto before = page.analysis();
    window.workspace().tuning().edit("", "", [](Tuning& t) { t.machine.path.acceleration = 1000; });
    studio::settle(window);
    QVERIFY(page.analysis() && page.analysis() != before);
  }

  void pictures_of_the_page() {
    for (const char* language : {"en", "zh_CN"}) {
      Opened window({1280, 800});
      window.setLanguage(language);
      window.setDark(QString(language) != "en");
      window.setPerMinute(QString(language) != "en");
      window.openButterfly();
      window.workspace().tuning().edit("", "", [](Tuning& t) { t.machine.servo[0].resonance = 45; });
      window.the<QDockWidget>("spectrumDock").show();
      studio::settle(window);
      auto& page = window.the<SpectrumPage>("spectrumPage");
      QVERIFY(colours_in(screenshot(page, QString("spectrum-%1").arg(language))) > 10);
    }
  }
};

TOOLPACE_UI_TEST(SpectrumTest)
#include "spectrum_test.moc"
