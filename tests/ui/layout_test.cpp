/// Where things stand: axes of time line up, panels come back to their sizes, numbers have the room that they need.

#include <QComboBox>
#include <QDockWidget>
#include <QTest>
#include <QToolButton>

#include "opened.h"
#include "panels/number_field.h"
#include "plots/limit_ribbon.h"
#include "plots/overview_strip.h"
#include "plots/profile_plot.h"
#include "plots/profile_view.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

/// Of a point of a widget, in the window [px].
double in_window(const QWidget& widget, double x) { return widget.mapTo(widget.window(), QPointF(x, 0)).x(); }

}  // namespace

class LayoutTest : public QObject {
  Q_OBJECT

 private slots:
  void plots_ribbon_and_overview_share_one_time_axis_to_the_pixel() {
    for (const QSize size : {QSize(1024, 700), QSize(1280, 800), QSize(3840, 2160)}) {
      Opened window(size);
      window.openButterfly();
      const auto& plot = window.the<ProfilePlot>("profilePlot");
      const auto& ribbon = window.the<LimitRibbon>("limitRibbon");
      const auto& overview = window.the<OverviewStrip>("overviewStrip");
      const double end = window.workspace().timeline()->duration();
      for (const double time : {0.0, end / 3, end}) {
        const double x = in_window(plot, plot.xOf(time));
        QVERIFY(std::abs(in_window(overview, overview.xOf(time)) - x) < 0.01);
        QVERIFY(std::abs(in_window(ribbon, ribbon.xOf(time)) - x) < 0.01);
      }
      window.the<ProfileView>("profileView").setVisibleRange(end / 4, end / 2);
      studio::settle(window);
      for (const double time : {end / 4, end / 3, end / 2}) {
        QVERIFY(std::abs(in_window(ribbon, ribbon.xOf(time)) - in_window(plot, plot.xOf(time))) < 0.01);
      }
    }
  }

  void every_value_fits_into_its_field_in_every_unit() {
    for (const bool touch : {false, true}) {
      Opened window({1024, 700});
      window.setTouch(touch);
      window.openButterfly();
      for (const bool inch : {false, true}) {
        window.setInch(inch);
        for (const double value : {1e-5, 0.00012345678, 1234.5678, 1234567.89, 123456789.0, 9.87654321e8}) {
          window.workspace().tuning().edit("values", "values", [value](Tuning& t) {
            t.machine.path.acceleration = t.machine.path.jerk = t.machine.path.jerk_deceleration = value;
            for (auto& axis : t.machine.axes) axis.speed = axis.acceleration = axis.jerk = value;
          });
          studio::settle(window);
          for (const auto* field : window.findChildren<NumberField*>()) {
            if (!field->isVisible()) continue;
            QVERIFY2(field->width() >= field->minimumSizeHint().width(), qPrintable(field->objectName()));
            QVERIFY2(field->text().size() <= 9, qPrintable(field->text()));
            const int free = field->minimumSizeHint().width() - field->fontMetrics().horizontalAdvance(field->text());
            QVERIFY2(free >= 2 * (1 + 6), qPrintable(field->objectName() + " " + field->text()));  // frame and padding
          }
        }
      }
    }
  }

  void a_value_that_is_shown_rounded_is_told_whole_and_stays_as_it_is() {
    NumberField field("f", "f", Quantity::acceleration, {0, 1e9});
    field.setValue(0.000123456789);
    QVERIFY(field.text().size() <= 9);
    QVERIFY(field.toolTip().contains("0.000123456789"));
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_Return);
    QCOMPARE(field.value(), 0.000123456789);
  }

  void a_law_with_other_rows_moves_no_other_control() {
    Opened window;
    window.openButterfly();
    auto& law = window.the<QComboBox>("lawBox");
    const std::vector<const char*> others = {"amEdit", "vmaxEdit", "lookaheadSlider", "cornerBox", "axisXSpeed"};
    std::vector<QPoint> places;
    for (int index = 0; index < law.count(); ++index) {
      law.setCurrentIndex(index);
      emit law.activated(index);
      studio::settle(window);
      std::vector<QPoint> now;
      for (const char* name : others) now.push_back(window.the<QWidget>(name).mapTo(&window, QPoint()));
      if (places.empty()) places = now;
      QVERIFY2(now == places, qPrintable(law.currentText()));
    }
  }

  void what_is_made_smaller_with_the_window_grows_with_it_again() {
    Opened window({1920, 1200});
    window.openButterfly();
    const QDockWidget &program = window.the<QDockWidget>("programDock"), &plots = window.the<QDockWidget>("plotsDock");
    const int wide = program.width(), high = plots.height();
    window.resize(1024, 700);
    studio::settle(window);
    QVERIFY(plots.height() < high);
    window.resize(1920, 1200);
    studio::settle(window);
    QVERIFY2(std::abs(program.width() - wide) <= 2, qPrintable(QString("%1, was %2").arg(program.width()).arg(wide)));
    QVERIFY(std::abs(plots.height() - high) <= 2);
  }

  void a_floating_panel_has_a_frame_and_buttons_to_dock_and_to_close_it() {
    Opened window;
    window.openButterfly();
    for (const QString name : {"plotsDock", "programDock", "resultsDock", "singleMoveDock"}) {
      auto& dock = window.the<QDockWidget>(name.toLatin1());
      dock.setFloating(true);
      dock.show();
      studio::settle(window);
      auto& close = window.the<QToolButton>((name + "Close").toLatin1());
      auto& back = window.the<QToolButton>((name + "Dock").toLatin1());
      QVERIFY2(close.isVisible() && back.isVisible(), qPrintable(name));
      const QImage picture = dock.grab().toImage();
      const QRgb frame = picture.pixel(0, picture.height() / 2);
      QCOMPARE(picture.pixel(picture.width() - 1, picture.height() / 2), frame);
      QVERIFY2(frame != picture.pixel(picture.width() / 2, 4), "told apart from what is inside");
      screenshot(dock, "floating-" + name);
      QTest::mouseClick(&close, Qt::LeftButton);
      QVERIFY(!dock.isVisible());
      dock.show();
      QTest::mouseClick(&back, Qt::LeftButton);
      studio::settle(window);
      QVERIFY(!dock.isFloating() && !close.isVisible());
    }
  }
};

TOOLPACE_UI_TEST(LayoutTest)
#include "layout_test.moc"
