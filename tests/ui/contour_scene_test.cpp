#include "drawing/contour_scene.h"

#include <QTest>
#include <numbers>
#include <set>

#include "models/instant.h"
#include "preview/scene_draw.h"
#include "preview/scene_pick.h"
#include "support/planned.h"
#include "support/ui_test.h"
#include "toolpace/path/path.h"
#include "toolpace/pipeline/replan.h"

using namespace toolpace;
using namespace toolpace::ui;

class ContourSceneTest : public QObject {
  Q_OBJECT

  static void check_sound(const ContourScene& scene) {
    const SceneGeometry& g = *scene.geometry;
    QCOMPARE(g.line.vertex.size(), g.line.pieces() + 1);
    QVERIFY(g.block.empty() || g.block.size() == g.line.pieces());
    QVERIFY(g.share.size() == g.block.size());
    QVERIFY(std::is_sorted(g.block.begin(), g.block.end()));
    for (const auto& v : g.line.vertex) QVERIFY(v.allFinite());
    double before = 0;
    for (std::size_t i = 0; i < g.line.pieces(); ++i) {
      const Stretch s = scene.colours->stretch(i, 0, 1);
      QVERIFY(s.begin <= s.end && s.begin >= before - 1e-9);
      before = s.end;
    }
    for (const ColourBy by : {ColourBy::speed, ColourBy::acceleration, ColourBy::jerk, ColourBy::limit}) {
      QVERIFY(scene.can_colour_by(by));
      for (std::size_t k = 0; k < g.lod.levels.size(); ++k) {
        const auto& level = g.lod.levels[k];
        QCOMPARE(scene.colours->shades(by, k).size(), level.is_full() ? g.line.pieces() : level.vertex.size() - 1);
      }
    }
  }

 private slots:
  void an_arc_is_round_at_any_enlargement() {
    Program program;
    program.feed(100, 0, 0, 80).arc(100, 0, 0, 100, 20, 2 * std::numbers::pi, 30);
    const auto scene = make_contour_scene(planned(program));
    check_sound(*scene);
    const SceneGeometry& g = *scene->geometry;
    for (std::size_t i = 0; i < g.line.pieces(); ++i) {
      if (g.block_of(i) == 0) continue;
      QVERIFY(std::abs((g.point(i + 1) - Eigen::Vector3d(100, 20, 0)).norm() - 20) < 1e-4);
    }
    QVERIFY(std::abs(g.box.high.x() - 120) < 0.05);
    QVERIFY(std::abs(g.box.high.y() - 40) < 0.05);
    // Enlarged 400 times the chords of the scene would be 1 px off; what is drawn is not.
    Projection view = fitted(named_view(View::xy), g.box, {400, 400}, 20);
    view.zoom(400, view.map({100 + 20 * std::sin(0.3), 20 - 20 * std::cos(0.3), 0}), 1e-9, 1e9);
    const QPointF centre = view.map({100, 20, 0});
    QImage image(400, 400, QImage::Format_RGB32);
    image.fill(Qt::white);
    SceneStyle style;
    const ColourTable colours = colour_table(ColourMap::cividis, Ground::light);
    style.colours = &colours;
    style.smooth = false;
    style.width = 1;
    draw_scene(image, *scene, view, style);
    int drawn = 0;
    for (int y = 0; y < 400; ++y) {
      for (int x = 0; x < 400; ++x) {
        if (image.pixel(x, y) == qRgb(255, 255, 255)) continue;
        ++drawn;
        const double off = std::hypot(x + 0.5 - centre.x(), y + 0.5 - centre.y()) - 20 * view.scale;
        QVERIFY2(std::abs(off) < 1.5, qPrintable(QString("%1, %2: %3 px off").arg(x).arg(y).arg(off)));
      }
    }
    QVERIFY(drawn > 300);
  }

  void a_long_line_changes_colour_along_it_and_more_so_enlarged() {
    const auto scene = make_contour_scene(planned(Program().feed(100, 0, 0, 80)));
    QCOMPARE(scene->geometry->line.pieces(), 1u);
    const ColourTable colours = colour_table(ColourMap::cividis, Ground::light);
    SceneStyle style;
    style.colours = &colours;
    style.smooth = false;
    const auto drawn = [&](double enlargement) {
      Projection view = fitted(named_view(View::xy), scene->geometry->box, {400, 100}, 20);
      view.zoom(enlargement, view.map({0.3, 0, 0}), 1e-9, 1e9);
      QImage image(400, 100, QImage::Format_RGB32);
      image.fill(Qt::white);
      draw_scene(image, *scene, view, style);
      std::set<QRgb> seen;
      for (int x = 0; x < 400; ++x) {
        for (int y = 40; y < 60; ++y) seen.insert(image.pixel(x, y));
      }
      return seen.size();
    };
    QVERIFY(drawn(1) >= 3);
    QVERIFY2(drawn(60) > 20, "the ramp at the start fills the picture");
  }

  void the_scale_belongs_to_the_feeds_and_rapids_are_marked() {
    Program program;
    program.rapid(100, 0).feed(100, 100, 0, 40).rapid(0, 0);
    const auto scene = make_contour_scene(planned(program));
    check_sound(*scene);
    QVERIFY(std::abs(scene->range(ColourBy::speed).high - 40) < 1e-6);
    const SceneGeometry& g = *scene->geometry;
    for (std::size_t i = 0; i < g.line.pieces(); ++i) {
      QCOMPARE(g.line.style[i] == static_cast<std::uint8_t>(PieceStyle::rapid), g.block_of(i) != 1);
    }
  }

  void parts_of_pieces_carry_their_exact_times() {
    Program program;
    program.feed(30, 0, 0, 80).dwell(0.7).arc(30, 0, 0, 30, 20, 2 * std::numbers::pi, 60).feed(0, 0, 5, 70);
    const auto outcome = planned(program);
    const auto scene = make_contour_scene(outcome);
    check_sound(*scene);
    const SceneGeometry& g = *scene->geometry;
    for (std::size_t i = 0; i < g.line.pieces(); ++i) {
      for (const double share : {0.0, 0.3, 0.9, 1.0}) {
        const double time = scene->colours->stretch(i, 0, share).end;
        const Eigen::Vector3d wanted = g.point(i) + share * (g.point(i + 1) - g.point(i));
        const double off = (instant_at(*outcome, time)->position.head<3>() - wanted).norm();
        // Chords leave their arc by a part in 2500 of the whole, 0.026 mm here.
        QVERIFY2(off < 0.026, qPrintable(QString("piece %1 at %2: %3 mm").arg(i).arg(share).arg(off)));
      }
    }
  }

  void plans_along_one_path_share_its_geometry() {
    const auto outcome = planned_butterfly();
    const auto first = make_contour_scene(outcome);
    auto faster = std::make_shared<Job>(*outcome->job);
    faster->machine.path.acceleration *= 2;
    auto again = replan(faster, *outcome);
    QVERIFY(again.has_value());
    const auto second =
        make_contour_scene(std::make_shared<const Outcome>(std::move(*again)), nullptr, first->geometry);
    QCOMPARE(second->geometry, first->geometry);
    QVERIFY(second->colours->shades(ColourBy::speed) != first->colours->shades(ColourBy::speed));
    // Another path, another geometry.
    QVERIFY(make_contour_scene(planned_butterfly(), nullptr, first->geometry)->geometry != first->geometry);
  }

  void mean_speeds_of_blocks_are_length_over_time() {
    const auto outcome = planned_butterfly();
    const auto scene = make_contour_scene(outcome);
    check_sound(*scene);
    const auto& shades = scene->colours->shades(ColourBy::speed);
    const double top = scene->range(ColourBy::speed).high;
    for (std::size_t i = 0; i < shades.size(); ++i) {
      const double mean = outcome->path->length[i] / (outcome->node_time[i + 1] - outcome->node_time[i]);
      const bool close = std::abs(shades[i] - std::min(mean / top, 1.0) * 255) <= 0.51;
      QVERIFY2(close, qPrintable(QString("block %1: %2 of %3").arg(i).arg(mean).arg(top)));
    }
  }

  void places_agree_with_the_setpoints_ends() {
    const auto outcome = planned_butterfly();
    const auto begin = instant_at(*outcome, -5), end = instant_at(*outcome, 1e9);
    QVERIFY((begin->position.head<3>() - outcome->path->node.front().head<3>()).norm() < 1e-9);
    QVERIFY((end->position.head<3>() - outcome->path->node.back().head<3>()).norm() < 1e-6);
    QVERIFY(std::abs(end->state.speed) < 1e-6);
    QVERIFY(instant_at(*outcome, std::nan("")).has_value());
  }

  void a_dwell_holds_the_place() {
    Program program;
    program.feed(10, 0, 0, 50).dwell(2.0).feed(10, 10, 0, 50);
    const auto outcome = planned(program);
    const auto scene = make_contour_scene(outcome);
    check_sound(*scene);
    const double arrival = outcome->node_time[1];
    QVERIFY((instant_at(*outcome, arrival + 1.0)->position.head<3>() - Eigen::Vector3d(10, 0, 0)).norm() < 1e-9);
    // What follows begins after the pause and is no slower for it.
    QVERIFY(scene->colours->stretch(1, 0.01, 1).begin >= arrival + 2.0);
    QVERIFY(std::abs(scene->colours->shades(ColourBy::speed)[1] - scene->colours->shades(ColourBy::speed)[0]) <= 2);
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
    for (std::size_t i = 0; i < scene->geometry->line.vertex.size(); ++i) {
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
    QCOMPARE(instant_at(*outcome, (span->first + span->second) / 2)->line, 2u);
  }

  void a_click_finds_the_piece_and_its_time() {
    Program program;
    program.feed(100, 0, 0, 50).feed(100, 100, 0, 50);
    const auto outcome = planned(program);
    const auto scene = make_contour_scene(outcome);
    const Projection view = fitted(named_view(View::xy), scene->geometry->box, {400, 400}, 20);
    const QPointF at = view.map({100, 50, 0});
    const auto hit = pick(*scene, view, at + QPointF(3, 0), 8);
    QVERIFY(hit.has_value());
    QVERIFY(std::abs(hit->distance - 3) < 1e-6);
    QVERIFY((instant_at(*outcome, hit->time)->position.head<3>() - Eigen::Vector3d(100, 50, 0)).norm() < 1.0);
    QVERIFY(!pick(*scene, view, at + QPointF(30, 0), 8));
  }

  void arrows_point_the_way_the_tool_goes() {
    const auto scene = make_contour_scene(planned(Program().feed(100, 0, 0, 50).rapid(100, 50).feed(0, 50, 0, 50)));
    const Projection view = fitted(named_view(View::xy), scene->geometry->box, {400, 400}, 20);
    const auto marks = direction_marks(*scene, view, {400, 400}, 60, 40);
    QVERIFY(marks.size() >= 8);
    const double lower = view.map({0, 0, 0}).y(), upper = view.map({0, 50, 0}).y();
    for (const auto& mark : marks) {
      QVERIFY2(std::abs(mark.at.y() - lower) < 1 || std::abs(mark.at.y() - upper) < 1, "none on the rapid");
      QVERIFY(mark.way.x() * (std::abs(mark.at.y() - lower) < 1 ? 1 : -1) > 0.999);
    }
    QVERIFY(direction_marks(*scene, view, {400, 400}, 1, 5).size() <= 6);
    QVERIFY(direction_marks(*make_contour_scene(nullptr), view, {400, 400}, 60, 40).empty());
  }

  void nothing_and_a_single_point_are_scenes_too() {
    QVERIFY(make_contour_scene(nullptr)->is_empty());
    auto bare = std::make_shared<Outcome>();
    QVERIFY(make_contour_scene(bare)->is_empty());
    auto path = std::make_shared<Path>();
    path->node.push_back(AxisVector::Constant(3));
    bare->path = path;
    const auto dot = make_contour_scene(bare);
    QCOMPARE(dot->geometry->line.vertex.size(), 1u);
    QImage image(50, 50, QImage::Format_RGB32);
    image.fill(Qt::white);
    SceneStyle style;
    const Projection view = fitted(named_view(View::iso), dot->geometry->box, {50, 50}, 5);
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

  void hatching_wears_no_arrows() {
    Program program;
    for (int i = 0; i < 200; ++i) program.feed(100, 0.5 * i, 0, 50).rapid(0, 0.5 * i + 0.5);
    const auto scene = make_contour_scene(planned(program));
    const Projection view = fitted(named_view(View::xy), scene->geometry->box, {400, 400}, 20);
    QVERIFY(direction_marks(*scene, view, {400, 400}, 60, 40).empty());
  }
};

TOOLPACE_UI_TEST(ContourSceneTest)
#include "contour_scene_test.moc"
