#include "drawing/profile_curves.h"

#include <QTest>
#include <cmath>
#include <numbers>

#include "plots/dashed_graph.h"
#include "support/planned.h"
#include "support/ui_test.h"
#include "toolpace/sample/motion.h"

using namespace toolpace;
using namespace toolpace::ui;

class ProfileCurvesTest : public QObject {
  Q_OBJECT

  static PhaseState state(const Outcome& outcome, double time) {
    return Motion(*outcome.path, outcome.plan).at(time).along();
  }

  static void check_curve(const Curve& curve) {
    QCOMPARE(curve.time.size(), curve.value.size());
    QVERIFY(std::is_sorted(curve.time.begin(), curve.time.end()));
  }

 private slots:
  void near_curves_are_the_phases_themselves() {
    const auto outcome = planned_butterfly();
    const auto series = make_profile_series(outcome);
    const TimeWindow window{1.10, 1.16, 1000};
    QVERIFY(!is_dense(*series, window));
    const MotionCurves curves = motion_curves(*series, window);
    check_curve(curves[kSpeedTrack]);
    QCOMPARE(curves[kSpeedTrack].time.front(), window.begin);
    QCOMPARE(curves[kSpeedTrack].time.back(), window.end);
    for (qsizetype i = 0; i < curves[kSpeedTrack].time.size(); ++i) {
      QVERIFY(std::abs(curves[kSpeedTrack].value[i] - state(*outcome, curves[kSpeedTrack].time[i]).speed) < 1e-6);
    }
  }

  void far_curves_miss_no_peak() {
    const auto outcome = planned(winding(30'000));
    const auto series = make_profile_series(outcome);
    const TimeWindow window{0, series->duration(), 400};
    QVERIFY(is_dense(*series, window));
    const MotionCurves curves = motion_curves(*series, window);
    QVERIFY(curves[kSpeedTrack].time.size() <= 2 * 400);
    for (std::size_t row = 0; row < 3; ++row) {
      const Curve& c = curves[static_cast<std::size_t>(row)];
      const Extent& e = series->whole[static_cast<std::size_t>(row)];
      check_curve(c);
      const auto [low, high] = std::minmax_element(c.value.begin(), c.value.end());
      QVERIFY(std::abs(*low - e.low) <= 1e-6 * std::abs(e.low) + 1e-9);
      QVERIFY(std::abs(*high - e.high) <= 1e-6 * std::abs(e.high) + 1e-9);
    }
  }

  // A plan behind another is drawn by its two sides: they hold every dip at a corner, and the peak of the rapid.
  void sides_of_a_far_plan_miss_no_peak_and_no_dip() {
    Program program = winding(30'000);
    program.rapid(4000, 100);
    const auto series = make_profile_series(planned(program));
    const TimeWindow window{0, series->duration(), 400};
    QVERIFY(is_dense(*series, window));
    const MotionEnvelope sides = motion_envelope(*series, window);
    for (std::size_t track = 0; track < kMotionTrackCount; ++track) {
      const Extent& e = series->whole[track];
      Extent drawn;
      for (const Curve* side : {&sides.high[track], &sides.low[track]}) {
        check_curve(*side);
        for (const double value : side->value) {
          if (!std::isnan(value)) drawn.add(static_cast<float>(value));
        }
      }
      const float slack = track == kSpeedTrack ? 0.011F * e.high : 1e-6F * std::abs(e.low) + 1e-6F;
      QVERIFY(std::abs(drawn.high - e.high) <= 1e-6F * std::abs(e.high) + 1e-6F);
      QVERIFY(std::abs(drawn.low - e.low) <= slack);
    }
  }

  void a_pixel_inside_a_long_phase_shows_only_its_part() {
    // A long cruise among thousands of micro-blocks: the cruise's pixels must be flat.
    Program program = winding(20'000);
    program.feed(4000, 0, 0, 50);
    const auto series = make_profile_series(planned(program));
    const TimeWindow window{0, series->duration(), 300};
    QVERIFY(is_dense(*series, window));
    const MotionCurves curves = motion_curves(*series, window);
    int flat = 0;
    for (qsizetype i = 0; i < curves[kAccelerationTrack].time.size(); ++i)
      flat += curves[kAccelerationTrack].value[i] == 0.0;
    QVERIFY(flat > 0);
  }

  void bounds_of_part_of_a_phase_are_those_of_fine_samples() {
    std::vector<Phase> phases(3);
    phases[0] = {0, 0.4, 0, 10, 0, 35, PhaseShape::quintic};
    phases[1] = {0, 0.5, 0, 40, 30, -200, PhaseShape::constant_jerk};
    phases[2] = {0, 0.3, 0, 40, -50, 0, PhaseShape::constant_jerk};
    for (const auto& p : phases) {
      for (const auto& [from, to] : {std::pair{0.0, p.duration}, std::pair{0.05, 0.12}, std::pair{0.1, 0.28}}) {
        const PhaseBounds b = bounds(p, from, to);
        PhaseBounds wanted{{1e9, -1e9}, {1e9, -1e9}, {1e9, -1e9}};
        for (int k = 0; k <= 20'000; ++k) {
          const PhaseState s = evaluate(p, from + (to - from) * k / 20'000);
          wanted.speed.add(s.speed);
          wanted.acceleration.add(s.acceleration);
          wanted.jerk.add(s.jerk);
        }
        const auto same = [](const Interval& x, const Interval& y, double scale) {
          return std::abs(x.low - y.low) < 1e-6 * scale && std::abs(x.high - y.high) < 1e-6 * scale;
        };
        QVERIFY(same(b.speed, wanted.speed, 100));
        QVERIFY(same(b.acceleration, wanted.acceleration, 1000));
        QVERIFY(same(b.jerk, wanted.jerk, 10'000));
      }
    }
  }

  void caps_and_feed_are_steps_at_the_blocks() {
    Program program;
    program.rapid(50, 0).feed(100, 0, 0, 60).feed(150, 0, 0, 30);
    const auto outcome = planned(program);
    const auto series = make_profile_series(outcome);
    const CapCurves caps = cap_curves(*series, {0, series->duration(), 1000});
    check_curve(caps.feed);
    QVERIFY(std::isnan(caps.feed.value.front()));
    QVERIFY(std::abs(caps.feed.value[2] - 60) < 1e-4);
    QVERIFY(std::abs(caps.feed.value.back() - 30) < 1e-4);
    QCOMPARE(caps.feed.time[2], outcome->node_time[1]);
    QVERIFY(std::abs(caps.high[kAccelerationTrack].value.front() - 3000) < 1e-2);
    QVERIFY(std::abs(caps.low[kAccelerationTrack].value.front() + 3000) < 1e-2);
    QVERIFY(std::abs(caps.high[kSpeedTrack].value.front() - 100) < 1e-4);
  }

  void the_override_scales_the_programmed_feed() {
    PlanOptions options;
    options.feed_override = 0.5;
    const auto series = make_profile_series(planned(Program().feed(100, 0, 0, 60), options));
    const CapCurves caps = cap_curves(*series, {0, series->duration(), 100});
    QVERIFY(std::abs(caps.feed.value.front() - 30) < 1e-4);
  }

  // On a circle of radius r at constant speed v an axis swings between ±v with an acceleration of ±v²/r.
  void axes_on_a_circle_swing_like_a_sine() {
    const auto series = make_profile_series(planned(Program().arc(0, 0, 0, 20, 0, 8 * std::numbers::pi, 40)));
    const double total = series->duration();
    const MotionCurves x = axis_curves(*series, {total * 0.3, total * 0.7, 2000}, 0);
    check_curve(x[kSpeedTrack]);
    const auto [slow, fast] = std::minmax_element(x[kSpeedTrack].value.begin(), x[kSpeedTrack].value.end());
    QVERIFY(std::abs(*fast - 40) < 0.01 && std::abs(*slow + 40) < 0.01);
    const auto [brake, push] =
        std::minmax_element(x[kAccelerationTrack].value.begin(), x[kAccelerationTrack].value.end());
    QVERIFY(std::abs(*push - 80) < 0.01 && std::abs(*brake + 80) < 0.01);
  }

  // 20 000 short blocks to a window of 40 pixels, one of them across the others: an axis moves in that one alone.
  void no_peak_of_an_axis_is_lost_however_many_blocks_share_a_pixel() {
    Program program;
    for (int i = 0; i < 20'000; ++i) program.feed(0.05 * (i + 1), i < 12'345 ? 0 : 0.4, 0, 50);
    const auto outcome = planned(program);
    const auto series = make_profile_series(outcome);
    const std::size_t across = 12'345;
    float wanted = 0;
    for (int k = 1; k < 200; ++k) {
      const double time =
          outcome->node_time[across] + (outcome->node_time[across + 1] - outcome->node_time[across]) * k / 200;
      wanted =
          std::max(wanted, static_cast<float>(Motion(*outcome->path, outcome->plan).at(time).axes().acceleration[1]));
    }
    QVERIFY(wanted > 100);
    for (const int columns : {1, 7, 40, 1000}) {
      const MotionCurves y = axis_curves(*series, {0, series->duration(), columns}, 1);
      check_curve(y[kAccelerationTrack]);
      const double peak = *std::max_element(y[kAccelerationTrack].value.begin(), y[kAccelerationTrack].value.end());
      QVERIFY2(peak >= wanted * 0.999, qPrintable(QString("%1 columns: %2 of %3").arg(columns).arg(peak).arg(wanted)));
      QVERIFY(peak <= axis_whole(*series, 1)[kAccelerationTrack].high * 1.0001);
    }
  }

  void a_plan_off_the_path_is_drawn_as_it_is_run() {
    PlanOptions options;
    options.corner.rule = CornerRule::smooth;
    options.corner.tolerance = 0.05;
    Program program;
    for (int i = 0; i < 12; ++i) program.feed(10 * (i + 1), i % 2 ? 0 : 6, 0, 60);
    const auto outcome = planned(program, options);
    QVERIFY(!outcome->plan.splines.empty());
    const auto series = make_profile_series(outcome);
    const MotionCurves curves = motion_curves(*series, {0, series->duration(), 4000});
    check_curve(curves[kSpeedTrack]);
    const TimeSpline& spline = outcome->plan.splines.front();
    for (qsizetype i = 0; i < curves[kSpeedTrack].time.size(); i += 11) {
      const double t = curves[kSpeedTrack].time[i] - spline.begin;
      if (t <= 0 || t >= spline.duration()) continue;
      QVERIFY(std::abs(curves[kSpeedTrack].value[i] - along(spline, evaluate(spline, t)).speed) < 1e-9);
    }
    // Along one axis: the integral of its speed is the way it goes.
    const MotionCurves x = axis_curves(*series, {0, series->duration(), 8000}, 0);
    double way = 0;
    for (qsizetype i = 1; i < x[kSpeedTrack].time.size(); ++i) {
      way += (x[kSpeedTrack].time[i] - x[kSpeedTrack].time[i - 1]) *
             (x[kSpeedTrack].value[i] + x[kSpeedTrack].value[i - 1]) / 2;
    }
    QVERIFY2(std::abs(way - 120) < 0.5, qPrintable(QString::number(way)));
  }

  // 20 zigzags a pixel over the whole width: a dash of 6 px of each 10 has ink, the 4 px between have none but their neighbours'.
  void dense_dashed_curves_keep_their_gaps() {
    QCustomPlot plot;
    plot.resize(300, 100);
    plot.xAxis->setRange(0, 1);
    plot.yAxis->setRange(-1, 1);
    auto* graph = new DashedGraph(plot.xAxis, plot.yAxis);
    graph->setAdaptiveSampling(false);
    for (int k = 0; k <= 12000; ++k) graph->addData(k / 12000.0, k % 2 == 0 ? 0.9 : 0.5);
    QPen pen(Qt::red, 1);
    pen.setDashPattern({6, 4});
    graph->setPen(pen);
    const QImage picture = plot.toPixmap(300, 100).toImage();
    const QRect seen = plot.axisRect()->rect();
    int inked = 0;
    for (int x = seen.left() + 10; x < seen.right() - 10; ++x) {
      const QColor colour = picture.pixelColor(x, qRound(plot.yAxis->coordToPixel(0.7)));
      inked += colour.green() < 128 && colour.red() > 200;
    }
    const double share = inked / (seen.width() - 20.0);
    QVERIFY2(share > 0.5 && share < 0.8, qPrintable(QString::number(share)));
  }

  void windows_beside_the_plan_and_empty_plans_are_empty() {
    const auto series = make_profile_series(planned(Program().feed(10, 0, 0, 60)));
    QVERIFY(motion_curves(*series, {50, 60, 100})[kSpeedTrack].time.isEmpty());
    QVERIFY(motion_curves(*series, {-9, -5, 100})[kSpeedTrack].time.isEmpty());
    QVERIFY(cap_curves(*series, {50, 60, 100}).feed.time.isEmpty());
    QVERIFY(make_profile_series(nullptr)->is_empty());
    QVERIFY(make_profile_series(std::make_shared<Outcome>())->is_empty());
    QVERIFY(motion_curves(*make_profile_series(nullptr), {0, 1, 10})[kSpeedTrack].time.isEmpty());
  }
};

TOOLPACE_UI_TEST(ProfileCurvesTest)
#include "profile_curves_test.moc"
