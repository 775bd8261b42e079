#include "preview/contour_scene.h"

#include <QTest>
#include <numbers>
#include <set>

#include "preview/scene_draw.h"
#include "support/planned.h"
#include "toolpace/path/path.h"

using namespace toolpace;
using namespace toolpace::ui;

class ContourSceneTest : public QObject {
  Q_OBJECT

  static void check_sound(const ContourScene& scene) {
    QCOMPARE(scene.time.size(), scene.line.vertex.size());
    QCOMPARE(scene.block.size(), scene.line.pieces());
    QCOMPARE(scene.line.vertex.size(), scene.line.pieces() + 1);
    QVERIFY(std::is_sorted(scene.time.begin(), scene.time.end()));
    QVERIFY(std::is_sorted(scene.block.begin(), scene.block.end()));
    for (const auto& levels : scene.line.level) QVERIFY(levels.empty() || levels.size() == scene.line.pieces());
    for (const auto& v : scene.line.vertex) QVERIFY(v.allFinite());
  }

 private slots:
  void an_arc_is_round_and_a_long_line_changes_colour() {
    Program program;
    program.feed(100, 0, 0, 80).arc(100, 0, 0, 100, 20, 2 * std::numbers::pi, 30);
    const auto outcome = planned(program);
    const auto scene = make_contour_scene(outcome);
    check_sound(*scene);
    std::set<std::uint8_t> line_levels;
    for (std::size_t i = 0; i < scene->line.pieces(); ++i) {
      if (scene->block[i] == 0) line_levels.insert(scene->line.level[0][i]);
      if (scene->block[i] != 0) {
        const double radius = (scene->point(i + 1) - Eigen::Vector3d(100, 20, 0)).norm();
        QVERIFY(std::abs(radius - 20) < 1e-4);
      }
    }
    QVERIFY(line_levels.size() > 20);
    QVERIFY(std::abs(scene->box.high.x() - 120) < 0.05);
    QVERIFY(std::abs(scene->box.high.y() - 40) < 0.05);
  }

  void the_scale_belongs_to_the_feeds_and_rapids_are_marked() {
    Program program;
    program.rapid(100, 0).feed(100, 100, 0, 40).rapid(0, 0);
    const auto scene = make_contour_scene(planned(program));
    check_sound(*scene);
    QVERIFY(std::abs(scene->range[0].high - 40) < 1e-6);
    for (std::size_t i = 0; i < scene->line.pieces(); ++i) {
      QCOMPARE(scene->line.style[i] == static_cast<std::uint8_t>(PieceStyle::rapid), scene->block[i] != 1);
    }
  }

  void pieces_carry_the_exact_time_of_their_ends() {
    const auto outcome = planned_butterfly();
    const auto scene = make_contour_scene(outcome);
    check_sound(*scene);
    for (std::size_t i = 1; i < scene->line.vertex.size(); i += 7) {
      const auto place = place_at(*outcome, scene->time[i]);
      QVERIFY(place.has_value());
      QVERIFY2((place->point - scene->point(i)).norm() < 1e-4, qPrintable(QString("vertex %1").arg(i)));
    }
  }

  void places_agree_with_the_setpoints_ends() {
    const auto outcome = planned_butterfly();
    const auto begin = place_at(*outcome, -5), end = place_at(*outcome, 1e9);
    QVERIFY((begin->point - outcome->path->node.front().head<3>()).norm() < 1e-9);
    QVERIFY((end->point - outcome->path->node.back().head<3>()).norm() < 1e-6);
    QVERIFY(std::abs(end->state.speed) < 1e-6);
    QVERIFY(place_at(*outcome, std::nan("")).has_value());
  }

  void a_dwell_holds_the_place() {
    Program program;
    program.feed(10, 0, 0, 50).dwell(2.0).feed(10, 10, 0, 50);
    const auto outcome = planned(program);
    const auto scene = make_contour_scene(outcome);
    check_sound(*scene);
    const double arrival = outcome->node_time[1];
    QVERIFY((place_at(*outcome, arrival + 1.0)->point - Eigen::Vector3d(10, 0, 0)).norm() < 1e-9);
    // The first piece after the pause spans it, and the rest moves on.
    QVERIFY(scene->time.back() >= arrival + 2.0);
  }

  void a_path_that_is_cut_short_at_corners_is_drawn_as_it_is_run() {
    PlanOptions options;
    options.corner.rule = CornerRule::smooth;
    options.corner.tolerance = 0.2;
    const auto outcome = planned(Program().feed(20, 0, 0, 60).feed(20, 20, 0, 60).feed(40, 20, 0, 60), options);
    QVERIFY(!outcome->plan.splines.empty());
    const auto scene = make_contour_scene(outcome);
    check_sound(*scene);
    double nearest = 1e9;
    for (std::size_t i = 0; i < scene->line.vertex.size(); ++i) {
      nearest = std::min(nearest, (scene->point(i) - Eigen::Vector3d(20, 0, 0)).norm());
    }
    QVERIFY2(nearest > 0.01 && nearest < 0.5, qPrintable(QString::number(nearest)));
  }

  void a_line_is_found_by_its_number() {
    Program program;
    program.feed(10, 0, 0, 50).feed(10, 10, 0, 50).feed(0, 10, 0, 50);
    const auto outcome = planned(program);
    const auto span = time_of_line(*outcome, 2);
    QVERIFY(span.has_value());
    QCOMPARE(span->first, outcome->node_time[1]);
    QCOMPARE(span->second, outcome->node_time[2]);
    QVERIFY(!time_of_line(*outcome, 99));
    QCOMPARE(place_at(*outcome, (span->first + span->second) / 2)->line, 2u);
  }

  void a_click_finds_the_piece_and_its_time() {
    Program program;
    program.feed(100, 0, 0, 50).feed(100, 100, 0, 50);
    const auto outcome = planned(program);
    const auto scene = make_contour_scene(outcome);
    const Projection view = fitted(named_view(View::xy), scene->box, {400, 400}, 20);
    const QPointF at = view.map({100, 50, 0});
    const auto hit = pick(*scene, view, at + QPointF(3, 0), 8);
    QVERIFY(hit.has_value());
    QVERIFY(std::abs(hit->distance - 3) < 1e-6);
    QVERIFY((place_at(*outcome, hit->time)->point - Eigen::Vector3d(100, 50, 0)).norm() < 1.0);
    QVERIFY(!pick(*scene, view, at + QPointF(30, 0), 8));
  }

  void nothing_and_a_single_point_are_scenes_too() {
    QVERIFY(make_contour_scene(nullptr)->is_empty());
    auto bare = std::make_shared<Outcome>();
    QVERIFY(make_contour_scene(bare)->is_empty());
    auto path = std::make_shared<Path>();
    path->node.push_back(AxisVector::Constant(3));
    bare->path = path;
    const auto dot = make_contour_scene(bare);
    QCOMPARE(dot->line.vertex.size(), 1u);
    QImage image(50, 50, QImage::Format_RGB32);
    image.fill(Qt::white);
    SceneStyle style;
    const Projection view = fitted(named_view(View::iso), dot->box, {50, 50}, 5);
    QCOMPARE(draw_scene(image, *dot, view, style), 1u);
    QVERIFY(image.pixel(25, 25) != qRgb(255, 255, 255));
  }

  void travel_is_a_box_only_where_all_three_axes_are_bounded() {
    Program program;
    program.feed(10, 0, 0, 50);
    Machine machine;
    for (std::size_t i = 0; i < 3; ++i) {
      QVERIFY(!make_contour_scene(planned(program, {}, machine))->travel);
      machine.axes[i].travel_min = -50;
      machine.axes[i].travel_max = 200;
    }
    const auto scene = make_contour_scene(planned(program, {}, machine));
    QVERIFY(scene->travel.has_value());
    QCOMPARE(scene->travel->high.z(), 200.0);
  }

  void views_look_where_their_names_say() {
    const auto map = [](View view, const Eigen::Vector3d& point) { return named_view(view).map(point); };
    QCOMPARE(map(View::xy, {2, 3, 7}), QPointF(2, -3));
    QCOMPARE(map(View::xz, {2, 3, 7}), QPointF(2, -7));
    QCOMPARE(map(View::yz, {2, 3, 7}), QPointF(3, -7));
    for (const View view : {View::xy, View::xz, View::yz, View::iso}) {
      const Projection p = named_view(view);
      QVERIFY(std::abs(p.right.dot(p.up)) < 1e-12);
      QVERIFY(std::abs(p.right.norm() - 1) < 1e-12 && std::abs(p.up.norm() - 1) < 1e-12);
    }
    QVERIFY(map(View::iso, {0, 0, 1}).y() < 0);
  }

  void zooming_leaves_the_point_under_the_mouse_where_it_is() {
    Projection p =
        fitted(named_view(View::iso), {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(10, 20, 30)}, {640, 480}, 30);
    const Eigen::Vector3d point(3, 4, 5);
    const QPointF before = p.map(point);
    p.zoom(7.0, before, 1e-9, 1e9);
    const QPointF after = p.map(point);
    QVERIFY(std::hypot(after.x() - before.x(), after.y() - before.y()) < 1e-9);
    p.orbit(0.3, 0.2);
    QVERIFY(std::abs(p.right.dot(p.up)) < 1e-12);
  }
};

QTEST_GUILESS_MAIN(ContourSceneTest)
#include "contour_scene_test.moc"
