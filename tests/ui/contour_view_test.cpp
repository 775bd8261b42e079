#include "preview/contour_view.h"

#include <QComboBox>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <numbers>

#include "support/events.h"
#include "support/planned.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;

class ContourViewTest : public QObject {
  Q_OBJECT

 private:
  std::shared_ptr<const Outcome> outcome_;
  std::shared_ptr<const ContourScene> butterfly_;

  std::unique_ptr<ContourView> shown(std::shared_ptr<const ContourScene> scene, const QSize& size = {660, 480}) const {
    auto view = std::make_unique<ContourView>();
    view->resize(size);
    view->show();
    view->setScene(std::move(scene));
    QApplication::processEvents();
    return view;
  }

  static QPoint on_screen(ContourView& view, const Eigen::Vector3d& point) {
    return view.canvas().projection().map(point).toPoint();
  }

 private slots:
  void initTestCase() {
    outcome_ = planned_butterfly();
    butterfly_ = make_contour_scene(outcome_);
  }

  void pictures_in_both_themes() {
    for (const bool dark : {false, true}) {
      const Theme theme = dark ? dark_theme() : light_theme();
      wear(theme);
      auto view = shown(butterfly_);
      view->setTheme(theme);
      view->setCursorTime(1.0);
      view->setHighlightedLine(200);
      const QString suffix = dark ? "-dark" : "-light";
      QVERIFY(colours_in(screenshot(*view, "contour-speed" + suffix)) > 60);
      view->setColourBy(ColourBy::limit);
      screenshot(*view, "contour-limit" + suffix);
      view->setColourBy(ColourBy::acceleration);
      view->setColourMap(ColourMap::turbo);
      view->setView(View::iso);
      screenshot(*view, "contour-acceleration-iso" + suffix);
    }
    wear(light_theme());
  }

  void nothing_loaded_says_what_to_do() {
    auto view = shown(nullptr);
    QVERIFY(colours_in(screenshot(*view, "contour-empty")) > 4);
    view->setCursorTime(1.0);
    view->setHighlightedLine(3);
    view->fit();
    wheel(view->canvas(), {100, 100}, 120);
    drag(view->canvas(), {100, 100}, {150, 120});
  }

  void a_click_on_the_path_asks_for_its_time_and_one_beside_it_does_not() {
    auto view = shown(butterfly_);
    QSignalSpy asked(view.get(), &ContourView::cursorTimeRequested);
    const auto place = instant_at(*outcome_, 2.0);
    QTest::mouseClick(&view->canvas(), Qt::LeftButton, {}, on_screen(*view, place->position.head<3>()));
    QCOMPARE(asked.count(), 1);
    const auto hit = instant_at(*outcome_, asked[0][0].toDouble());
    QVERIFY((hit->position.head<3>() - place->position.head<3>()).norm() * view->canvas().projection().scale < 9);
    QTest::mouseClick(&view->canvas(), Qt::LeftButton, {}, {4, 4});
    QCOMPARE(asked.count(), 1);
  }

  void the_wheel_zooms_about_the_mouse_and_a_double_click_fits() {
    auto view = shown(butterfly_);
    const Eigen::Vector3d point = instant_at(*outcome_, 2.0)->position.head<3>();
    const QPoint at = on_screen(*view, point);
    const double before = view->canvas().projection().scale;
    wheel(view->canvas(), at, 360);
    QVERIFY(view->canvas().projection().scale > 1.5 * before);
    QVERIFY((on_screen(*view, point) - at).manhattanLength() <= 2);
    screenshot(*view, "contour-zoomed");
    QTest::mouseDClick(&view->canvas(), Qt::LeftButton, {}, {300, 300});
    QVERIFY(qAbs(view->canvas().projection().scale - before) < 1e-9 * before);
  }

  void dragging_moves_the_picture_and_no_cursor() {
    auto view = shown(butterfly_);
    QSignalSpy asked(view.get(), &ContourView::cursorTimeRequested);
    const Eigen::Vector3d point = instant_at(*outcome_, 2.0)->position.head<3>();
    const QPoint at = on_screen(*view, point);
    drag(view->canvas(), at, at + QPoint(60, -40));
    QVERIFY((on_screen(*view, point) - at - QPoint(60, -40)).manhattanLength() <= 2);
    QCOMPARE(asked.count(), 0);
    const Eigen::Vector3d right = view->canvas().projection().right;
    drag(view->canvas(), {200, 200}, {260, 220}, Qt::RightButton);
    QVERIFY((view->canvas().projection().right - right).norm() > 0.1);
  }

  void buttons_and_keys_choose_the_view() {
    auto view = shown(butterfly_);
    QTest::mouseClick(view->findChild<QToolButton*>("viewXZ"), Qt::LeftButton);
    QCOMPARE(view->view(), View::xz);
    QVERIFY(view->canvas().projection().up.isApprox(Eigen::Vector3d::UnitZ()));
    QTest::keyClick(&view->canvas(), Qt::Key_Z);
    QVERIFY(view->canvas().projection().up.isApprox(Eigen::Vector3d::UnitY()));
    QTest::keyClick(&view->canvas(), Qt::Key_X);
    QVERIFY(view->canvas().projection().right.isApprox(Eigen::Vector3d::UnitY()));
    const double fitted = view->canvas().projection().scale;
    // The button of the view that is looked from is lit, and none once it was orbited.
    const auto lit = [&](const char* button) { return view->findChild<QToolButton*>(button)->isChecked(); };
    QVERIFY(lit("viewYZ") && !lit("viewXZ"));
    drag(view->canvas(), {200, 200}, {260, 220}, Qt::RightButton);
    for (const char* button : {"viewXY", "viewXZ", "viewYZ", "viewIso"}) QVERIFY(!lit(button));
    QTest::keyClick(&view->canvas(), Qt::Key_X);
    QVERIFY(lit("viewYZ"));
    QTest::keyClick(&view->canvas(), Qt::Key_Plus);
    QVERIFY(view->canvas().projection().scale > fitted);
    QTest::keyClick(&view->canvas(), Qt::Key_F);
    QVERIFY(qAbs(view->canvas().projection().scale - fitted) < 1e-9 * fitted);
  }

  void replanning_keeps_the_camera() {
    auto view = shown(butterfly_);
    wheel(view->canvas(), {300, 200}, 360);
    const Projection before = view->canvas().projection();
    view->setScene(make_contour_scene(planned_butterfly()));
    QCOMPARE(view->canvas().projection().scale, before.scale);
    QCOMPARE(view->canvas().projection().origin, before.origin);
  }

  void colouring_and_map_are_chosen_in_the_header() {
    auto view = shown(butterfly_);
    QSignalSpy changed(view.get(), &ContourView::colourByChanged);
    auto* by = view->findChild<QComboBox*>("colourBy");
    by->setFocus();
    QTest::keyClick(by, Qt::Key_Down);
    QCOMPARE(view->colourBy(), ColourBy::acceleration);
    QCOMPARE(changed.count(), 1);
    QVERIFY(!view->findChild<QComboBox*>("colourMap")->isEnabled());
    QTest::keyClick(by, Qt::Key_Up);
    const QImage cividis = view->canvas().render({200, 160}, 1);
    auto* map = view->findChild<QComboBox*>("colourMap");
    map->setFocus();
    QTest::keyClick(map, Qt::Key_Down);
    QCOMPARE(view->colourMap(), ColourMap::viridis);
    QVERIFY(view->canvas().render({200, 160}, 1) != cividis);
  }

  void the_mouse_over_the_path_reads_its_values() {
    auto view = shown(butterfly_);
    QSignalSpy hovered(&view->canvas(), &ContourCanvas::hoverChanged);
    const QPoint at = on_screen(*view, instant_at(*outcome_, 2.0)->position.head<3>());
    QMouseEvent move(QEvent::MouseMove, at, view->canvas().mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&view->canvas(), &move);
    QVERIFY(hovered.count() >= 1);
    QVERIFY(view->canvas().hovered().has_value());
    screenshot(*view, "contour-hover");
  }

  void degenerate_paths_draw_sensibly() {
    struct Case {
      const char* name;
      Program program;
    };
    const std::vector<Case> cases = {
        {"micrometre", Program().feed(1e-6, 0, 0, 50).feed(1e-6, 1e-6, 0, 50)},
        {"ten-kilometres", Program().feed(1e7, 0, 0, 50).feed(1e7, 5e6, 0, 50)},
        {"vertical", Program().feed(0, 0, -30, 20)},
        {"straight", Program().feed(40, 0, 0, 50)},
        {"rapids-only", Program().rapid(40, 30).rapid(0, 30)},
        {"far-away", Program().rapid(1e6, 1e6).feed(1e6 + 1, 1e6, 0, 50).feed(1e6 + 1, 1e6 + 1, 0, 50)}};
    for (const auto& c : cases) {
      const auto outcome = planned(c.program);
      for (const View look : {View::xy, View::iso}) {
        auto view = shown(make_contour_scene(outcome), {400, 320});
        view->setView(look);
        const QString name = QString("contour-%1%2").arg(c.name, look == View::iso ? "-iso" : "");
        QVERIFY2(colours_in(screenshot(*view, name)) > 6, c.name);
        QVERIFY2(view->canvas().lastPieces() > 0, c.name);
        const Projection& p = view->canvas().projection();
        QVERIFY2(std::isfinite(p.scale) && p.scale > 0, c.name);
        for (int i = 0; i < 80; ++i) wheel(view->canvas(), {200, 150}, 1200);
        QVERIFY(std::isfinite(view->canvas().projection().scale));
        QApplication::processEvents();
        for (int i = 0; i < 200; ++i) wheel(view->canvas(), {200, 150}, -1200);
        QVERIFY(view->canvas().projection().scale > 0);
        QApplication::processEvents();
      }
    }
  }

  void an_enlarged_error_and_a_tolerance_band_show() {
    auto trace = std::make_shared<ErrorTrace>();
    for (double t = 0; t < outcome_->plan.cycle_time(); t += 0.002) {
      const auto place = instant_at(*outcome_, t);
      trace->time.push_back(t);
      trace->error.push_back(static_cast<float>(0.004 * (1 + std::sin(20 * t))));
      trace->commanded.push_back(place->position.head<3>().cast<float>());
      trace->offset.push_back(Eigen::Vector3f(0.005f * static_cast<float>(std::sin(9 * t)), 0.004f, 0));
    }
    auto view = shown(make_contour_scene(outcome_, trace));
    QVERIFY(view->canvas().scene()->can_colour_by(ColourBy::contour_error));
    auto* factor = view->findChild<QComboBox*>("errorEnlargement");
    QVERIFY(factor->isVisible());
    view->setColourBy(ColourBy::contour_error);
    const QImage plain = view->canvas().render({400, 300}, 1);
    view->setEnlargement(100);
    QCOMPARE(factor->currentText(), QString("×100"));
    QVERIFY(view->canvas().render({400, 300}, 1) != plain);
    view->setTolerance(0.4);
    QVERIFY(colours_in(screenshot(*view, "contour-error")) > 30);
    QVERIFY(!shown(butterfly_)->findChild<QComboBox*>("errorEnlargement")->isVisible());
  }

  void travel_and_ghost_show() {
    Program program;
    program.rapid(10, 10, 5).feed(90, 10, 0, 40).arc(90, 50, 0, 90, 30, std::numbers::pi, 40).feed(10, 50, 0, 40);
    Machine machine;
    for (std::size_t i = 0; i < 3; ++i) {
      machine.axes[i].travel_min = i == 2 ? -40 : -10;
      machine.axes[i].travel_max = i == 2 ? 20 : 130;
    }
    auto view = shown(make_contour_scene(planned(program, {}, machine)));
    view->setView(View::iso);
    const QImage alone = view->canvas().render({400, 300}, 1);
    Program other;
    other.feed(90, 0, 0, 40).feed(90, 60, 0, 40);
    view->setGhost(make_contour_scene(planned(other)));
    QVERIFY(view->canvas().render({400, 300}, 1) != alone);
    screenshot(*view, "contour-travel-ghost");
  }

  void pictures_are_exported_in_every_format() {
    auto view = shown(butterfly_);
    QTemporaryDir folder;
    for (const QString kind : {"png", "svg", "pdf"}) {
      const QString file = folder.filePath("contour." + kind);
      QVERIFY(view->exportPicture(file));
      QFile written(file);
      QVERIFY(written.open(QIODevice::ReadOnly));
      const QByteArray head = written.readAll();
      QVERIFY2(head.size() > 4000, qPrintable(kind));
      if (kind == "pdf") QVERIFY(head.startsWith("%PDF"));
      if (kind == "svg") QVERIFY(head.contains("<svg"));
      if (kind == "png") QVERIFY(colours_in(QImage::fromData(head)) > 60);
    }
    QVERIFY(!view->exportPicture(folder.filePath("missing/contour.png")));
  }

  void controls_have_names() {
    ContourView view;
    for (auto* control : view.findChildren<QWidget*>()) {
      if (!qobject_cast<QToolButton*>(control) && !qobject_cast<QComboBox*>(control)) continue;
      QVERIFY(!control->objectName().isEmpty());
      QVERIFY2(!control->accessibleName().isEmpty() && !control->toolTip().isEmpty(),
               qPrintable(control->objectName()));
    }
    QVERIFY(!view.canvas().accessibleName().isEmpty());
  }
};

TOOLPACE_UI_TEST(ContourViewTest)
#include "contour_view_test.moc"
