#include "toolpace/path/arc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "toolpace/path/path.h"

namespace toolpace {
namespace {

constexpr double kPi = std::numbers::pi;

AxisVector at(double x, double y, double z = 0) {
  AxisVector p = AxisVector::Zero();
  p.head<3>() << x, y, z;
  return p;
}

ArcDetail around(double x, double y, double sweep) {
  return {Eigen::Vector3d(x, y, 0), Eigen::Vector3d::UnitZ(), sweep};
}

/// Path of one arc.
Path one_arc(const AxisVector& begin, const AxisVector& end, const ArcDetail& detail) {
  Path path;
  path.arcs.push_back(make_arc(begin, end, detail));
  path.kind = {SegmentKind::arc};
  path.length = {arc_length(path.arcs[0])};
  path.move = {0};
  path.detail = {0};
  path.node = {begin, end};
  return path;
}

TEST(Arc, QuarterCircleHasLengthHalfPiTimesRadius) {
  const ArcCurve arc = make_arc(at(10, 0), at(0, 10), around(0, 0, kPi / 2));
  EXPECT_NEAR(arc_length(arc), 5 * kPi, 1e-14 * 10);
}

TEST(Arc, HelixLengthIsTheHypotenuseOfTurnAndRise) {
  const ArcCurve arc = make_arc(at(10, 0), at(10, 0, 30), around(0, 0, 4 * kPi));
  EXPECT_NEAR(arc_length(arc), std::hypot(40 * kPi, 30), 1e-11);
}

TEST(Arc, ClockwiseSweepTurnsTheOtherWay) {
  const Path path = one_arc(at(10, 0), at(0, -10), around(0, 0, -kPi / 2));
  const AxisVector middle = point_at(path, 0, path.length[0] / 2);
  EXPECT_NEAR(middle[0], 10 / std::sqrt(2), 1e-12);
  EXPECT_NEAR(middle[1], -10 / std::sqrt(2), 1e-12);
}

// Archimedean spiral r = φ from 0 to 2π: length = (a√(1+a²) + asinh a)/2 with a = 2π.
TEST(Arc, SpiralFromTheCentreHasTheTextbookLength) {
  ArcCurve arc = make_arc(at(1e-300, 0), at(2 * kPi, 0), around(0, 0, 2 * kPi));
  const double a = 2 * kPi;
  EXPECT_NEAR(arc_length(arc), (a * std::sqrt(1 + a * a) + std::asinh(a)) / 2, 1e-12 * 25);
}

TEST(Arc, SlightSpiralAgreesWithTheClosedFormOfAWideOne) {
  // Both branches of the length must meet: compare a 9 % spiral by quadrature with a fine chord sum.
  const ArcCurve arc = make_arc(at(10, 0), at(10.9, 0), around(0, 0, 2 * kPi));
  double sum = 0;
  constexpr int kChords = 200000;
  for (int i = 0; i < kChords; ++i) {
    const double a = arc.sweep * i / kChords, b = arc.sweep * (i + 1) / kChords;
    sum += (arc_point(arc, b) - arc_point(arc, a)).norm();
  }
  EXPECT_NEAR(arc_length(arc), sum, 1e-8);
}

TEST(Arc, AngleInvertsLengthOnSpirals) {
  const ArcCurve arc =
      make_arc(at(2, 0, 1), at(0, 9, 4), {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d::UnitZ(), 2.5 * kPi});
  const double length = arc_length(arc);
  ArcCurve part = arc;
  for (const double share : {0.1, 0.5, 0.9}) {
    const double angle = angle_at(arc, length, share * length);
    part.sweep = angle;
    part.end_radius = arc.start_radius + (arc.end_radius - arc.start_radius) * angle / arc.sweep;
    part.rise = arc.rise * angle / arc.sweep;
    EXPECT_NEAR(arc_length(part), share * length, 1e-12 * length);
  }
}

TEST(Arc, CurvatureOfAHelixIsTheTextbookOne) {
  const double r = 5, h = 3;  // rise per radian
  const Path path = one_arc(at(r, 0), at(r, 0, h * 2 * kPi), around(0, 0, 2 * kPi));
  const Frame f = frame_at(path, 0, path.length[0] * 0.3);
  EXPECT_NEAR(f.first.head<3>().norm(), 1, 1e-14);
  EXPECT_NEAR(f.second.head<3>().norm(), r / (r * r + h * h), 1e-14);
}

TEST(Arc, DerivativesByLengthAgreeWithDifferences) {
  const Path path = one_arc(at(2, 0, 0), at(0, 9, 4), around(0, 0, 2.5 * kPi));
  const double s = 0.4 * path.length[0], e = 1e-4;
  const Frame f = frame_at(path, 0, s);
  const Frame before = frame_at(path, 0, s - e), after = frame_at(path, 0, s + e);
  EXPECT_LT(((after.point - before.point) / (2 * e) - f.first).norm(), 1e-7);
  EXPECT_LT(((after.first - before.first) / (2 * e) - f.second).norm(), 1e-7);
  EXPECT_LT(((after.second - before.second) / (2 * e) - f.third).norm(), 1e-7);
}

TEST(Arc, EndsAreTheNodesToTheBit) {
  const AxisVector begin = at(0.1, 0.2, 0.3), end = at(-0.3, 0.7, 0.9);
  const Path path = one_arc(begin, end, {Eigen::Vector3d(-0.2, 0.4, 0.3), Eigen::Vector3d::UnitZ(), 2.0});
  EXPECT_EQ(point_at(path, 0, 0), begin);
  EXPECT_EQ(point_at(path, 0, path.length[0]), end);
}

}  // namespace
}  // namespace toolpace
