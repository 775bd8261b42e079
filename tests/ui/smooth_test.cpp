#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "drawing/tube_trace.h"
#include "jobs/refiner.h"
#include "opened.h"
#include "panels/number_field.h"
#include "preview/contour_view.h"
#include "support/planned.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

constexpr auto kZigzag =
    "G21 G90 G94\nF3000\nG1 X10\nY2\nX0\nY4\nX10\nY6\nX0\nY8\nX10\nG3 X10 Y18 I0 J5\nG1 X0 Y18\nM2\n";

/// Limits of every axis, which the motion through the tube needs.
void limit_axes(Workspace& workspace) {
  workspace.tuning().edit("axes", "axes", [](Tuning& t) {
    for (auto& axis : t.machine.axes) {
      axis.speed = 100;
      axis.acceleration = 3000;
      axis.jerk = 1e5;
    }
    t.options.corner.tolerance = 0.05;
  });
}

void choose_corner(Opened& window, CornerRule rule) {
  auto& box = window.the<QComboBox>("cornerBox");
  box.setFocus();
  box.setCurrentIndex(box.findData(static_cast<int>(rule)));
  emit box.activated(box.currentIndex());
}

/// Runs the event loop until a refinement has begun, then `act` in that moment, before anything comes of it.
template <class Act>
bool when_refining(Workspace& workspace, const Act& act) {
  QObject context;
  bool done = false;
  QObject::connect(&workspace, &Workspace::refinementChanged, &context, [&](Refiner::State state) {
    if (state != Refiner::State::running) return;
    // What comes of it comes later in the same queue.
    QMetaObject::invokeMethod(
        &context, [&] { done || (act(), done = true); }, Qt::QueuedConnection);
  });
  return eventually([&] { return done; });
}

QByteArray long_zigzag(int blocks) {
  QByteArray text = "G21 G90 G94 F6000\n";
  for (int i = 0; i < blocks; ++i) text += QString("G1 X%1 Y%2\n").arg(i % 2 ? 40 : 0).arg(i).toLatin1();
  return text + "M2\n";
}

}  // namespace

class SmoothTest : public QObject {
  Q_OBJECT

 private slots:
  void smooth_corners_show_a_quick_plan_first_and_the_refined_one_after_it() {
    Opened window;
    window.open(kZigzag);
    limit_axes(window.workspace());
    studio::settle(window);
    QSignalSpy plans(&window.workspace(), &Workspace::planChanged);
    std::vector<bool> refining;
    std::vector<double> times;
    connect(&window.workspace(), &Workspace::planChanged, this, [&] {
      refining.push_back(window.workspace().plan().timeline->outcome()->plan.splines.empty());
      times.push_back(window.workspace().timeline()->duration());
    });
    choose_corner(window, CornerRule::smooth);
    QVERIFY(when_refining(window.workspace(), [&] {
      QVERIFY(!window.workspace().isStale());
      QVERIFY(window.the<QLabel>("tuningDockBadge").isVisible());
      QVERIFY(window.the<QLabel>("tuningDockBadge").text().contains("refining"));
    }));
    studio::settle(window);
    QCOMPARE(times.size(), std::size_t{2});
    QVERIFY2(refining[0] && !refining[1], "a plan along blends first, then one through the tube");
    QVERIFY2(times[1] < times[0], "what took longer to compute takes less time to run");
    QVERIFY(!window.the<QLabel>("tuningDockBadge").isVisible());
  }

  void blended_corners_show_a_quick_plan_first_and_one_timed_anew_after_it() {
    Opened window;
    window.open(kZigzag);
    limit_axes(window.workspace());
    window.workspace().tuning().edit("law", "law", [](Tuning& t) {
      t.options.law = LawKind::seven_phase;
      t.options.ramps = Ramps::span;
    });
    studio::settle(window);
    std::vector<bool> refined;
    std::vector<double> times;
    connect(&window.workspace(), &Workspace::planChanged, this, [&] {
      refined.push_back(window.workspace().plan().timeline->outcome()->job->refined);
      times.push_back(window.workspace().timeline()->duration());
    });
    choose_corner(window, CornerRule::blend);
    studio::settle(window);
    QCOMPARE(refined, (std::vector<bool>{false, true}));
    QVERIFY2(times[1] < times[0], "what took longer to compute takes less time to run");
  }

  void an_edit_while_refining_is_planned_at_once_and_the_old_refinement_never_arrives() {
    Opened window;
    window.open(long_zigzag(100));
    auto& workspace = window.workspace();
    limit_axes(workspace);
    studio::settle(window);
    auto& feed = window.the<NumberField>("feedOverrideEdit");
    feed.setFocus();
    struct Shown {
      double feed_override;
      bool refined;
      bool operator==(const Shown&) const = default;
    };
    std::vector<Shown> shown;
    connect(&workspace, &Workspace::planChanged, this, [&] {
      const Outcome& outcome = *workspace.timeline()->outcome();
      shown.push_back({outcome.job->options.feed_override, !outcome.plan.splines.empty()});
    });
    // Progress while it refines: it has begun, and its result would come after this.
    bool edited = false;
    connect(&workspace, &Workspace::progressed, this, [&] {
      if (edited || !workspace.isRefining()) return;
      edited = true;
      QTest::keyClick(&feed, Qt::Key_Down);
    });
    choose_corner(window, CornerRule::smooth);
    studio::settle(window);
    QVERIFY(edited);
    const double lower = workspace.tuning().value().options.feed_override;
    QVERIFY(lower < 1.0);
    QCOMPARE(shown, (std::vector<Shown>{{1.0, false}, {lower, false}, {lower, true}}));
  }

  void cancelling_keeps_the_quick_plan_and_says_so() {
    Opened window;
    window.open(long_zigzag(1500));
    limit_axes(window.workspace());
    studio::settle(window);
    choose_corner(window, CornerRule::smooth);
    auto& cancel = window.the<QToolButton>("cancelButton");
    QVERIFY(eventually([&] { return window.workspace().isRefining() && cancel.isVisible(); }));
    screenshot(window, "smooth-refining");
    QTest::mouseClick(&cancel, Qt::LeftButton);
    QCOMPARE(window.workspace().refinement(), Refiner::State::given_up);
    QVERIFY(!window.workspace().isBusy());
    QVERIFY(window.workspace().plan().timeline->outcome()->plan.splines.empty());
    QVERIFY(window.the<QLabel>("tuningDockBadge").text().contains("not refined"));
    QTest::keyClick(&window, Qt::Key_F5);
    QVERIFY2(when_refining(window.workspace(), [&] { window.workspace().cancel(); }), "it begins anew");
  }

  void a_feed_hold_stops_on_the_smooth_motion_and_is_taken_away_again() {
    Opened window;
    window.open(kZigzag);
    limit_axes(window.workspace());
    choose_corner(window, CornerRule::smooth);
    studio::settle(window);
    const double free = window.workspace().timeline()->duration(), moment = 0.4 * free;
    window.workspace().setCursorTime(moment);
    window.actions().hold->trigger();
    studio::settle(window);
    const auto held = window.workspace().plan().timeline->outcome();
    QVERIFY2(!held->plan.splines.empty(), "still through the tube");
    QCOMPARE(held->job->options.hold_at, std::optional(moment));
    QVERIFY(held->plan.cycle_time() > free);
    double stands = 1e9, slowest = 1e9;
    for (double t = moment; t < moment + 0.5; t += 1e-4) {
      const double speed = window.workspace().timeline()->at(t).state.speed;
      if (speed < slowest) (slowest = speed, stands = t);
    }
    QVERIFY2(slowest < 1e-3 && stands < moment + 0.3, qPrintable(QString("%1 mm/s at %2 s").arg(slowest).arg(stands)));
    window.waitForProof();
    QVERIFY(window.workspace().plan().proof->report.passes());
    screenshot(window, "smooth-hold");
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    studio::settle(window);
    QVERIFY(!window.workspace().tuning().value().options.hold_at);
    QCOMPARE(window.workspace().timeline()->duration(), free);
  }

  void the_band_follows_the_programmed_path_and_never_exceeds_the_tolerance() {
    for (const CornerRule rule : {CornerRule::blend, CornerRule::smooth}) {
      Opened window;
      window.open(kZigzag);
      limit_axes(window.workspace());
      choose_corner(window, rule);
      window.waitForProof();
      const auto& proof = window.workspace().plan().proof;
      QVERIFY(proof && proof->tube);
      const TubeTrace& tube = *proof->tube;
      // Every setpoint found its place: the whole program was followed.
      QVERIFY(tube.time.back() > window.workspace().timeline()->duration() - 0.002);
      QVERIFY2(tube.largest_share <= 1.0 + 1e-3, qPrintable(QString::number(tube.largest_share)));
      QVERIFY2(tube.largest_share > 0.5, "corners of 90° are rounded by most of the tolerance");
      // By hand: the place on the programmed path of a setpoint on the first move is (x, 0).
      const std::size_t early = *tube.row_at(0.05);
      QVERIFY(std::abs(tube.programmed[early].y()) < 1e-6f);
      auto& view = window.the<ContourView>("contourView");
      auto& enlargement = window.the<QComboBox>("errorEnlargement");
      enlargement.setCurrentIndex(enlargement.findData(10));
      emit enlargement.activated(enlargement.currentIndex());
      QVERIFY(window.the<QToolButton>("showBand").isVisible());
      const QString name = rule == CornerRule::blend ? "band-blend" : "band-smooth";
      const QImage with = screenshot(window, name);
      QTest::mouseClick(&window.the<QToolButton>("showBand"), Qt::LeftButton);
      const QImage without = screenshot(window, name + "-off");
      QVERIFY(with != without);
      view.setEnlargement(1);
    }
  }

  void a_plan_that_stays_on_the_path_has_no_band() {
    Opened window;
    window.open(kZigzag);
    window.waitForProof();
    QVERIFY(!window.workspace().plan().proof->tube);
    QVERIFY(!window.the<QToolButton>("showBand").isVisible());
  }

  void tolerances_of_the_program_change_from_block_to_block() {
    Opened window;
    window.open("G21 G90 G94 F3000\nG64 P0.2\nG1 X10\nY10\nG61\nX0\nY0\nG64 P0.05\nX10\nY10\nM2\n");
    window.waitForProof();
    const auto& tube = window.workspace().plan().proof->tube;
    QVERIFY(tube);
    float least = 1, most = 0;
    for (const float t : tube->tolerance) (least = std::min(least, t), most = std::max(most, t));
    QCOMPARE(least, 0.0f);
    QCOMPARE(most, 0.2f);
    QVERIFY(tube->largest_share <= 1.001);
  }
};

TOOLPACE_UI_TEST(SmoothTest)
#include "smooth_test.moc"
