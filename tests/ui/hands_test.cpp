/// Tab follows the eye, Fit fits what is drawn, Cancel cancels whatever is being done.

#include <QDockWidget>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include "opened.h"
#include "preview/contour_view.h"
#include "support/ui_test.h"
#include "tab_order.h"
#include "toolpace/nc/reader.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

/// How a run goes on after it was asked to stop when it had told its progress so many times.
struct Stopped {
  bool was_cancelled = false;
  int told_before = 0, told_after = 0;
};

Stopped run_and_stop(const std::shared_ptr<const Job>& job, int at) {
  Stopped stopped;
  std::stop_source stop;
  const Monitor monitor{stop.get_token(), [&](double) {
                          if (stop.stop_requested()) return void(++stopped.told_after);
                          if (++stopped.told_before > at) stop.request_stop();
                        }};
  const auto outcome = run(job, monitor);
  stopped.was_cancelled = !outcome && outcome.error().kind == ErrorKind::cancelled;
  return stopped;
}

}  // namespace

class HandsTest : public QObject {
  Q_OBJECT

 private slots:
  void tab_goes_row_by_row_through_the_tuning() {
    Opened window({1280, 800});
    window.openButterfly();
    window.activateWindow();
    window.the<QWidget>("lawBox").setFocus();
    QStringList names;
    for (int i = 0; i < 17; ++i) {
      names << QApplication::focusWidget()->objectName();
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    QCOMPARE(names,
             QStringList({"lawBox", "amEdit", "dmEdit", "jmEdit", "jdEdit", "vmaxEdit", "periodEdit", "lookaheadSlider",
                          "lookaheadEdit", "lookaheadAll", "rampsBox", "cornerBox", "holdEdit", "feedOverrideEdit",
                          "rapidOverrideEdit", "axisXSpeed", "axisXAcceleration"}));
  }

  // All that takes the focus is come by once, and Shift+Tab goes the same way back.
  void tab_comes_by_everything_from_panel_to_panel() {
    Opened window({1280, 800});
    window.openButterfly();
    QWidget* const first = &window.the<QWidget>("ncView");
    first->setFocus();
    std::vector<QWidget*> forth;
    do {
      forth.push_back(QApplication::focusWidget());
      QTest::keyClick(forth.back(), Qt::Key_Tab);
      QVERIFY(forth.size() < 300);
    } while (QApplication::focusWidget() != first);
    QCOMPARE(forth.size(), studio::reading_order(window).size());
    const auto place = [&forth](const char* name) {
      return std::find_if(forth.begin(), forth.end(), [name](const QWidget* w) { return w->objectName() == name; }) -
             forth.begin();
    };
    const std::array panels = {"ncView",    "colourBy",    "contourCanvas", "lawBox",
                               "showAxisX", "resultTable", "playButton"};
    for (std::size_t i = 0; i + 1 < panels.size(); ++i) {
      QVERIFY2(place(panels[i]) < place(panels[i + 1]), panels[i]);
    }
    for (auto back = forth.rbegin(); back != forth.rend(); ++back) {
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab);
      QCOMPARE(QApplication::focusWidget(), *back);
    }
  }

  void tab_follows_panels_that_are_moved() {
    Opened window({1280, 800});
    window.openButterfly();
    const auto before = [&](const char* a, const char* b) {
      const auto order = studio::reading_order(window);
      const auto at = [&](const char* name) {
        return std::find(order.begin(), order.end(), &window.the<QWidget>(name));
      };
      return at(a) < at(b);
    };
    QVERIFY(before("ncView", "lawBox"));
    window.addDockWidget(Qt::RightDockWidgetArea, &window.the<QDockWidget>("programDock"));
    window.addDockWidget(Qt::LeftDockWidgetArea, &window.the<QDockWidget>("tuningDock"));
    studio::settle(window);
    QVERIFY(before("lawBox", "ncView"));
  }

  // The rapid comes from 100 mm away; what is cut is 10 mm wide.
  void fit_fits_what_is_drawn() {
    Opened window({1280, 800});
    window.open("G21 G90\nG0 X100 Y100\nG1 F1000 X110\nY110\nX100\nY100\nM2\n");
    auto& canvas = window.the<ContourView>("contourView").canvas();
    const double whole = canvas.projection().scale;
    window.actions().rapids->trigger();
    QVERIFY(!canvas.areRapidsShown());
    QVERIFY2(canvas.projection().scale > 5 * whole, "it is fitted anew");
    const QPointF corner = canvas.projection().map({110, 110, 0});
    QVERIFY(QRectF(canvas.rect()).contains(corner));
    window.actions().rapids->trigger();
    QCOMPARE(canvas.projection().scale, whole);
    window.actions().rapids->trigger();
    window.open("G21 G90\nG0 X100 Y100\nM2\n");  // of rapids alone, all is fitted
    QVERIFY(canvas.projection().scale < 10);
  }

  // In whatever stage it is asked to stop: it does, and tells of hardly anything more.
  void a_run_stops_in_every_stage() {
    Opened window;
    window.openButterfly();
    const auto butterfly = window.workspace().timeline()->outcome();
    for (const auto rule : {CornerRule::servo, CornerRule::junction, CornerRule::blend, CornerRule::smooth}) {
      for (const auto ramps : {Ramps::block, Ramps::span}) {
        auto job = std::make_shared<Job>(*butterfly->job);
        job->options.corner.rule = rule;
        job->options.ramps = ramps;
        for (auto& axis : job->machine.axes) axis = {400, 4000, 2e5};
        const Stopped whole = run_and_stop(job, std::numeric_limits<int>::max());
        QVERIFY(!whole.was_cancelled);
        QVERIFY2(whole.told_before > 0, "it tells how far it is");
        const int step = std::max(whole.told_before / 6, 1);
        for (int at = 0; at + 1 < whole.told_before; at += step) {
          const Stopped stopped = run_and_stop(job, at);
          const QString where = QString("rule %1, ramps %2, after %3 of %4: %5 more")
                                    .arg(static_cast<int>(rule))
                                    .arg(static_cast<int>(ramps))
                                    .arg(at)
                                    .arg(whole.told_before)
                                    .arg(stopped.told_after);
          QVERIFY2(stopped.told_after <= 2, qPrintable(where));
        }
        QVERIFY(run_and_stop(job, 0).was_cancelled);
      }
    }
  }

  // The window: no plan comes after Cancel, neither the quick one nor the refined one, and nothing goes on.
  void cancel_ends_planning_and_refining() {
    Opened window({1280, 800});
    window.openButterfly();
    QSignalSpy planned(&window.workspace(), &Workspace::planChanged);
    for (const auto rule : {CornerRule::servo, CornerRule::blend, CornerRule::smooth}) {
      window.workspace().tuning().edit("", "", [rule](Tuning& t) { t.options.corner.rule = rule; });
      planned.clear();
      window.actions().cancel->trigger();
      studio::settle(window);
      QVERIFY(!window.workspace().isBusy());
      QVERIFY2(planned.count() <= 1, "what was made already may be shown, and no more");
    }
  }
};

TOOLPACE_UI_TEST(HandsTest)
#include "hands_test.moc"
