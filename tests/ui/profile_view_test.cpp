#include "plots/profile_view.h"

#include <QClipboard>
#include <QLabel>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "plots/limit_ribbon.h"
#include "plots/overview_strip.h"
#include "plots/profile_plot.h"
#include "support/events.h"
#include "support/planned.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

class ProfileViewTest : public QObject {
  Q_OBJECT

 private:
  std::shared_ptr<const ProfileSeries> butterfly_, slow_;

  /// A view as in the window, with the butterfly in it.
  std::unique_ptr<ProfileView> shown(const QSize& size = {960, 380}) const {
    auto view = std::make_unique<ProfileView>();
    view->resize(size);
    view->setSeries(butterfly_);
    view->show();
    QApplication::processEvents();
    return view;
  }

  static QPoint place(ProfileView& view, double time) {
    const auto [begin, end] = view.visibleRange();
    const auto [left, right] = view.plot().edges();
    return {static_cast<int>(left + (time - begin) / (end - begin) * (right - left)), view.plot().height() / 3};
  }

 private slots:
  void initTestCase() {
    butterfly_ = make_profile_series(planned_butterfly());
    PlanOptions options;
    options.lookahead = 3;
    slow_ = make_profile_series(planned_butterfly(options));
  }

  void pictures_in_both_themes() {
    for (const bool dark : {false, true}) {
      const Theme theme = dark ? dark_theme() : light_theme();
      wear(theme);
      auto view = shown();
      view->setTheme(theme);
      view->setGhost(slow_);
      view->setCursorTime(1.0);
      const QString suffix = dark ? "-dark" : "-light";
      QVERIFY(colours_in(screenshot(*view, "profile-whole" + suffix)) > 20);
      view->setVisibleRange(0.9, 1.2);
      view->setMeasuring(true);
      screenshot(*view, "profile-zoomed" + suffix);
      view->setMeasuring(false);
      view->setGhost(nullptr);
      view->setAxisShown(0, true);
      view->setAxisShown(1, true);
      screenshot(*view, "profile-axes" + suffix);
    }
    wear(light_theme());
  }

  void a_click_asks_for_the_time_under_the_mouse() {
    auto view = shown();
    QSignalSpy asked(view.get(), &ProfileView::cursorTimeRequested);
    QTest::mouseClick(&view->plot(), Qt::LeftButton, {}, place(*view, 2.0));
    QCOMPARE(asked.count(), 1);
    QVERIFY(qAbs(asked[0][0].toDouble() - 2.0) < 0.01);
    auto* ribbon = view->findChild<LimitRibbon*>("limitRibbon");
    QTest::mouseClick(ribbon, Qt::LeftButton, {}, {place(*view, 3.0).x(), 8});
    QCOMPARE(asked.count(), 2);
    QVERIFY(qAbs(asked[1][0].toDouble() - 3.0) < 0.01);
  }

  void the_wheel_zooms_about_the_mouse() {
    auto view = shown();
    QSignalSpy changed(view.get(), &ProfileView::visibleRangeChanged);
    const QPoint at = place(*view, 1.5);
    wheel(view->plot(), at, 480);
    QVERIFY(changed.count() >= 1);
    const auto [begin, end] = view->visibleRange();
    QVERIFY(end - begin < 2.0);
    QVERIFY(qAbs(place(*view, 1.5).x() - at.x()) <= 2);
    for (int i = 0; i < 200; ++i) wheel(view->plot(), at, 1200);
    QVERIFY(view->visibleRange().second > view->visibleRange().first);
    for (int i = 0; i < 200; ++i) wheel(view->plot(), at, -1200);
    QVERIFY(view->visibleRange().first <= 0 && view->visibleRange().second >= butterfly_->duration());
  }

  void dragging_pans_and_does_not_move_the_cursor() {
    auto view = shown();
    view->setVisibleRange(1, 2);
    QSignalSpy asked(view.get(), &ProfileView::cursorTimeRequested);
    const QPoint from = place(*view, 1.5);
    drag(view->plot(), from, from - QPoint(200, 0));
    QVERIFY(view->visibleRange().first > 1.1);
    QVERIFY(qAbs(view->visibleRange().second - view->visibleRange().first - 1) < 1e-9);
    QCOMPARE(asked.count(), 0);
  }

  void shift_and_wheel_pan() {
    auto view = shown();
    view->setVisibleRange(1, 2);
    wheel(view->plot(), place(*view, 1.5), -120, Qt::ShiftModifier);
    QVERIFY(qAbs(view->visibleRange().first - 1.1) < 1e-6);
  }

  void keys_zoom_pan_and_fit() {
    auto view = shown();
    view->plot().setFocus();
    QTest::keyClick(&view->plot(), Qt::Key_Plus);
    const double width = view->visibleRange().second - view->visibleRange().first;
    QVERIFY(width < butterfly_->duration());
    const double before = view->visibleRange().first;
    QTest::keyClick(&view->plot(), Qt::Key_PageDown);
    QVERIFY(view->visibleRange().first > before);
    QTest::keyClick(&view->plot(), Qt::Key_F);
    QVERIFY(view->visibleRange().first <= 0);
    QTest::keyClick(&view->plot(), Qt::Key_M);
    QVERIFY(view->isMeasuring());
  }

  void two_cursors_measure_differences() {
    auto view = shown();
    QTest::mouseClick(view->findChild<QToolButton*>("measure"), Qt::LeftButton);
    QVERIFY(view->isMeasuring());
    const double first = *view->plot().measures()[0];
    drag(view->plot(), place(*view, first), place(*view, 0.5));
    QVERIFY(qAbs(*view->plot().measures()[0] - 0.5) < 0.02);
    const double a = *view->plot().measures()[0], b = *view->plot().measures()[1];
    const QString wanted = QString("Δt %1 s").arg(b - a, 0, 'f', 4);
    QVERIFY2(view->measureText().startsWith(wanted), qPrintable(view->measureText()));
    QCOMPARE(view->findChild<QLabel*>("profileReadout")->text(), view->measureText());
    QVERIFY(view->measureText().contains("Δv") && view->measureText().contains("Δs"));
    QTest::mouseClick(view->findChild<QToolButton*>("measure"), Qt::LeftButton);
    QVERIFY(view->measureText().isEmpty());
  }

  void the_overview_moves_the_visible_time() {
    auto view = shown();
    view->setVisibleRange(1.0, 1.4);
    auto* strip = view->findChild<OverviewStrip*>("overviewStrip");
    const auto x_of = [strip](double t) { return static_cast<int>(std::lround(strip->xOf(t))); };
    drag(*strip, {x_of(1.2), 15}, {x_of(2.2), 15});
    QVERIFY(qAbs(view->visibleRange().first - 2.0) < 0.03);
    QVERIFY(qAbs(view->visibleRange().second - 2.4) < 0.03);
    drag(*strip, {x_of(2.4), 15}, {x_of(3.0), 15});
    QVERIFY(qAbs(view->visibleRange().second - 3.0) < 0.03);
    QVERIFY(qAbs(view->visibleRange().first - 2.0) < 0.03);
    QTest::mouseClick(strip, Qt::LeftButton, {}, {x_of(0.6), 15});
    QVERIFY(qAbs((view->visibleRange().first + view->visibleRange().second) / 2 - 0.6) < 0.03);
  }

  void replanning_keeps_the_visible_time() {
    auto view = shown();
    view->setVisibleRange(1.0, 1.4);
    view->setSeries(slow_);
    QVERIFY(qAbs(view->visibleRange().first - 1.0) < 1e-9);
    QVERIFY(qAbs(view->visibleRange().second - 1.4) < 1e-9);
    view->fit();
    view->setSeries(butterfly_);
    QVERIFY(view->visibleRange().second > butterfly_->duration());
    QVERIFY(view->visibleRange().second < butterfly_->duration() * 1.1);
  }

  void inches_change_numbers_and_titles() {
    auto view = shown();
    view->setCursorTime(1.0);
    auto* readout = view->findChild<QLabel*>("profileReadout");
    QVERIFY2(readout->text().contains("mm/s"), qPrintable(readout->text()));
    view->setUnits({.inch = true});
    QVERIFY2(readout->text().contains("in/s") && !readout->text().contains("mm"), qPrintable(readout->text()));
    QVERIFY(view->plot().axisRect(0)->axis(QCPAxis::atLeft)->label().contains("in/s"));
  }

  // 3937 in/s³ in a low plot: the ticks that fit are 5000 apart, which leaves zero alone.
  void every_plot_has_a_number_besides_zero_however_low_it_is() {
    for (const double jerk : {1e5, 1.7e5, 3e5, 5.5e5, 9e5}) {
      Machine machine;
      machine.path = {
          .speed = 100, .acceleration = 3000, .deceleration = 3000, .jerk = jerk, .jerk_deceleration = jerk};
      const auto series = make_profile_series(planned(Program().feed(40, 0, 0, 60).feed(40, 30, 0, 60), {}, machine));
      for (const int height : {200, 240, 300, 420}) {
        auto view = shown({560, height});
        view->setSeries(series);
        for (const bool inch : {false, true}) {
          view->setUnits({.inch = inch});
          view->plot().replot();
          for (int i = 0; i < 3; ++i) {
            const QCPAxis* axis = view->plot().axisRect(i)->axis(QCPAxis::atLeft);
            const QVector<double> ticks = axis->tickVector();
            QVERIFY2(std::any_of(ticks.begin(), ticks.end(),
                                 [&](double tick) { return tick != 0 && axis->range().contains(tick); }),
                     qPrintable(QString("plot %1, %2 high, jerk %3").arg(i).arg(height).arg(jerk)));
          }
        }
      }
    }
  }

  void the_three_plots_share_their_edges_and_heights() {
    auto view = shown();
    QCOMPARE(view->plot().axisRectCount(), 3);
    const auto* a = view->plot().axisRect(0);
    for (int i = 1; i < 3; ++i) {
      QCOMPARE(view->plot().axisRect(i)->left(), a->left());
      QCOMPARE(view->plot().axisRect(i)->right(), a->right());
      QVERIFY(qAbs(view->plot().axisRect(i)->height() - a->height()) <= 6);
    }
  }

  void pictures_are_exported_in_every_format() {
    auto view = shown();
    QTemporaryDir folder;
    for (const QString kind : {"png", "svg", "pdf"}) {
      const QString file = folder.filePath("plots." + kind);
      QVERIFY(view->exportPicture(file));
      QFile written(file);
      QVERIFY(written.open(QIODevice::ReadOnly));
      const QByteArray head = written.readAll();
      QVERIFY2(head.size() > 5000, qPrintable(kind));
      if (kind == "pdf") QVERIFY(head.startsWith("%PDF"));
      if (kind == "svg") QVERIFY(head.contains("<svg"));
      if (kind == "png") QVERIFY(colours_in(QImage::fromData(head)) > 20);
    }
    QVERIFY(!view->exportPicture(folder.filePath("missing/plots.png")));
  }

  void a_contour_error_is_a_fourth_plot() {
    auto trace = std::make_shared<ErrorTrace>();
    for (double t = 0; t < butterfly_->duration(); t += 0.001) {
      trace->time.push_back(t);
      trace->error.push_back(static_cast<float>(0.003 + 0.002 * std::sin(7 * t) + (t > 2 && t < 2.002 ? 0.01 : 0)));
    }
    const SampleSeries samples(trace);
    QVERIFY(qAbs(samples.largest() - 0.0149) < 0.0002);
    const Curve far = samples.curve({0, butterfly_->duration(), 300});
    QVERIFY(far.time.size() <= 600);
    QCOMPARE(static_cast<float>(*std::max_element(far.value.begin(), far.value.end())), samples.largest());
    const Curve near = samples.curve({1.0, 1.1, 300});
    QVERIFY(near.time.front() <= 1.0 && near.time.back() >= 1.1);
    QVERIFY(SampleSeries(nullptr).curve({0, 1, 10}).time.isEmpty());

    auto view = shown();
    view->setErrorTrace(trace);
    view->setCursorTime(2.0);
    QCOMPARE(view->plot().axisRectCount(), 3);
    QTest::mouseClick(view->findChild<QToolButton*>("showError"), Qt::LeftButton);
    QCOMPARE(view->plot().axisRectCount(), 4);
    screenshot(*view, "profile-error");
    view->setVisibleRange(1.9, 2.1);
    QCOMPARE(view->plot().axisRect(3)->axis(QCPAxis::atBottom)->range().lower, view->visibleRange().first);
    view->setErrorTrace(nullptr);
    QCOMPARE(view->plot().axisRectCount(), 4);
    QTest::mouseClick(view->findChild<QToolButton*>("showError"), Qt::LeftButton);
    QCOMPARE(view->plot().axisRectCount(), 3);
    screenshot(*view, "profile-error-gone");
  }

  void the_visible_values_stand_in_a_table_and_are_copied() {
    auto view = shown();
    view->setVisibleRange(1.0, 1.5);
    QTest::mouseClick(view->findChild<QToolButton*>("showTable"), Qt::LeftButton);
    auto* table = view->findChild<QTableView*>("profileTable");
    QVERIFY(table->isVisible());
    screenshot(*view, "profile-table");
    const auto* model = table->model();
    QCOMPARE(model->index(0, 0).data().toString(), QString("1.0000"));
    QCOMPARE(model->index(model->rowCount() - 1, 0).data().toString(), QString("1.5000"));
    QVERIFY(model->headerData(2, Qt::Horizontal, Qt::DisplayRole).toString().contains("mm/s"));
    QSignalSpy asked(view.get(), &ProfileView::cursorTimeRequested);
    emit table->activated(model->index(model->rowCount() - 1, 0));
    QVERIFY(qAbs(asked[0][0].toDouble() - 1.5) < 1e-9);
    QTest::mouseClick(view->findChild<QToolButton*>("showTable"), Qt::LeftButton);
    QTest::keyClick(&view->plot(), Qt::Key_C, Qt::ControlModifier);
    const QStringList lines = QApplication::clipboard()->text().split('\n');
    QCOMPARE(lines.size(), model->rowCount() + 2);
    QCOMPARE(lines[1].split('\t').size(), 5);
  }

  void nothing_loaded_and_dwells_alone_draw_quietly() {
    ProfileView view;
    view.resize(600, 300);
    view.show();
    view.setCursorTime(3.0);
    view.setMeasuring(true);
    screenshot(view, "profile-empty");
    view.setSeries(make_profile_series(nullptr));
    view.setSeries(nullptr);
    view.setSeries(make_profile_series(planned(Program().feed(1e-6, 0, 0, 50))));
    QVERIFY(view.visibleRange().second > view.visibleRange().first);
    screenshot(view, "profile-tiny");
    view.setSeries(make_profile_series(planned(Program().feed(1e7, 0, 0, 50))));
    screenshot(view, "profile-ten-kilometres");
  }

  void controls_have_names() {
    ProfileView view;
    for (auto* button : view.findChildren<QToolButton*>()) {
      QVERIFY(!button->objectName().isEmpty());
      QVERIFY2(!button->accessibleName().isEmpty() && !button->toolTip().isEmpty(), qPrintable(button->objectName()));
    }
    for (const char* name : {"profilePlot", "profileTable", "limitRibbon", "overviewStrip", "profileReadout"}) {
      auto* widget = view.findChild<QWidget*>(name);
      QVERIFY2(widget && !widget->accessibleName().isEmpty(), name);
    }
  }
};

TOOLPACE_UI_TEST(ProfileViewTest)
#include "profile_view_test.moc"
