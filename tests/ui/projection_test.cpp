#include "drawing/projection.h"
#include "support/ui_test.h"

#include <QTest>
#include <cmath>

using namespace toolpace::ui;

class ProjectionTest : public QObject {
  Q_OBJECT

 private slots:
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

  void a_path_that_would_be_seen_from_its_edge_is_looked_at_from_another_side() {
    const auto box = [](double x, double y, double z) {
      return Box{Eigen::Vector3d::Zero(), Eigen::Vector3d(x, y, z)};
    };
    QCOMPARE(suited_view(View::xy, box(60, 0, 45)), View::xz);  // a lathe
    QCOMPARE(suited_view(View::xy, box(0, 60, 45)), View::yz);
    QCOMPARE(suited_view(View::xy, box(0, 0, -50 + 100)), View::xz);  // a single plunge
    QCOMPARE(suited_view(View::xz, box(60, 40, 0)), View::xy);
    for (const View view : {View::xy, View::xz, View::yz, View::iso}) {
      QCOMPARE(suited_view(view, box(60, 40, 3)), view);  // as it was left
      QCOMPARE(suited_view(view, box(0, 0, 0)), view);
      QCOMPARE(suited_view(view, Box{}), view);
    }
    QCOMPARE(suited_view(View::xy, box(60, 0, 0)), View::xy);  // a line is a line
    QCOMPARE(suited_view(View::iso, box(60, 0, 45)), View::iso);
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

TOOLPACE_UI_TEST(ProjectionTest)
#include "projection_test.moc"
