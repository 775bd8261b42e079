/// The walk along setpoints and path at once: against a Fréchet decision over the whole free-space diagram, and by mutation.

#include "toolpace/verify/path_follower.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "planned_program.h"

namespace toolpace {
namespace {

using namespace testing;
using Points = std::vector<AxisVector>;

AxisVector at(double x, double y, double z = 0) {
  AxisVector p = AxisVector::Zero();
  p.head<3>() << x, y, z;
  return p;
}

struct Interval {
  double low = 1, high = 0;
  bool empty() const { return low > high; }
};

Interval inside(const AxisVector& centre, const AxisVector& a, const AxisVector& b, double radius) {
  const AxisVector d = b - a, e = a - centre;
  const double aa = d.squaredNorm(), bb = d.dot(e), cc = e.squaredNorm() - radius * radius;
  if (aa == 0) return cc <= 0 ? Interval{0, 1} : Interval{};
  const double root = bb * bb - aa * cc;
  if (root < 0) return {};
  return {std::max(0.0, (-bb - std::sqrt(root)) / aa), std::min(1.0, (-bb + std::sqrt(root)) / aa)};
}

/// Alt and Godau's decision, cell by cell over the whole diagram.
bool is_within(const Points& p, const Points& q, double e) {
  const std::size_t n = p.size() - 1, m = q.size() - 1;
  if ((p[0] - q[0]).norm() > e || (p[n] - q[m]).norm() > e) return false;
  const auto from_start = [](const Interval& i) { return !i.empty() && i.low == 0 ? i : Interval{}; };
  std::vector<Interval> left(m);  // reachable on the left sides of column i
  for (std::size_t j = 0; j < m; ++j) {
    left[j] = from_start(inside(p[0], q[j], q[j + 1], e));
    if (left[j].empty() || left[j].high < 1) break;
  }
  bool along_bottom = true;
  for (std::size_t i = 0; i < n; ++i) {
    Interval bottom = along_bottom ? from_start(inside(q[0], p[i], p[i + 1], e)) : Interval{};
    along_bottom = !bottom.empty() && bottom.high == 1;
    for (std::size_t j = 0; j < m; ++j) {
      const Interval l = left[j], b = bottom;
      left[j] = inside(p[i + 1], q[j], q[j + 1], e);
      bottom = inside(q[j + 1], p[i], p[i + 1], e);
      if (b.empty()) left[j] = l.empty() ? Interval{} : Interval{std::max(left[j].low, l.low), left[j].high};
      if (l.empty()) bottom = b.empty() ? Interval{} : Interval{std::max(bottom.low, b.low), bottom.high};
    }
  }
  return !left[m - 1].empty() && left[m - 1].high == 1;
}

bool follows(const Program& program, const Points& setpoints, double tolerance, const Slack& slack = {0, 0, false}) {
  const Path path = build_path(program.moves(), 0).value();
  PathVertices vertices(path, 1e-6);
  PathFollower follower(vertices, tolerance, false);
  if (!follower.start(setpoints[0])) return false;
  for (std::size_t k = 1; k < setpoints.size(); ++k) {
    if (!follower.advance(setpoints[k - 1], setpoints[k], slack)) return false;
  }
  return follower.reaches_end();
}

Program polyline(const Points& corners) {
  Program program;
  program.start(corners[0][0], corners[0][1], corners[0][2]);
  for (std::size_t i = 1; i < corners.size(); ++i) program.line(corners[i][0], corners[i][1], corners[i][2]);
  return program;
}

double draw(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// Walks that follow each other roughly, turn back, cross themselves; the tolerance is about what they need.
TEST(PathFollower, DecidesAsTheWholeFreeSpaceDiagramDoes) {
  std::mt19937 random(1);
  int follow = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    Points path = {at(0, 0)}, walk;
    for (std::size_t i = 2 + random() % 8; i > 0; --i) {
      path.push_back(path.back() + at(draw(random, -1, 1.5), draw(random, -1, 1), draw(random, -0.3, 0.3)));
    }
    const double noise = draw(random, 0, 0.5);
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (random() % 6 == 0) continue;
      walk.push_back(path[i] + noise * at(draw(random, -1, 1), draw(random, -1, 1)));
      if (random() % 3 == 0 && i + 1 < path.size()) walk.push_back((path[i] + path[i + 1]) / 2);
    }
    if (walk.size() < 2) continue;
    const double tolerance = draw(random, 0.05, 1);
    const bool expected = is_within(walk, path, tolerance);
    ASSERT_EQ(follows(polyline(path), walk, tolerance), expected) << "trial " << trial;
    follow += expected;
  }
  EXPECT_GT(follow, 400);
  EXPECT_LT(follow, 3600);
}

/// An arc, helix or spiral, and points along it, some of them off.
struct RoundCase {
  Program program;
  Points fine;  ///< chords 1e-4 mm off the arc at most
};

RoundCase random_arc(std::mt19937& random) {
  RoundCase c;
  const double radius = std::exp(draw(random, -1, 3)), sweep = (random() % 2 == 0 ? 1 : -1) * draw(random, 0.3, 9);
  const double rise = random() % 2 == 0 ? 0 : draw(random, -4, 4) * radius;
  c.program.start(radius, 0, 0).arc(0, 0, sweep, rise);
  const auto parts = static_cast<int>(std::ceil(std::abs(sweep) * std::sqrt(radius / 8e-4))) + 1;
  for (int k = 0; k <= parts; ++k) {
    const double u = static_cast<double>(k) / parts;
    c.fine.push_back(at(radius * std::cos(sweep * u), radius * std::sin(sweep * u), rise * u));
  }
  return c;
}

TEST(PathFollower, DecidesOnArcsAsOnTheirFineChords) {
  std::mt19937 random(2);
  int follow = 0, trials = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const RoundCase c = random_arc(random);
    const double tolerance = std::exp(draw(random, -5, 0));
    Points walk;
    const std::size_t stride = 1 + random() % 12;
    const double noise = tolerance * draw(random, 0, 1.2);
    for (std::size_t k = 0; k < c.fine.size(); k += stride) {
      walk.push_back(c.fine[k] +
                     noise * at(draw(random, -1, 1), draw(random, -1, 1), draw(random, -1, 1)).normalized());
    }
    walk.back() = c.fine.back();
    if (random() % 4 == 0 && walk.size() > 12) {  // a stretch is left out
      const auto from = walk.begin() + static_cast<std::ptrdiff_t>(3 + random() % (walk.size() / 2));
      walk.erase(from, from + static_cast<std::ptrdiff_t>(std::min<std::size_t>(walk.size() / 3, 1 + random() % 40)));
    }
    if (walk.size() < 3) continue;
    // Only far from where the verdict turns may both be asked for it: sectors are judged to a part in a hundred there.
    const bool surely = is_within(walk, c.fine, tolerance * 0.98 - 1e-4);
    const bool possibly = is_within(walk, c.fine, tolerance * 1.02 + 1e-4);
    if (surely != possibly) continue;
    ++trials;
    ASSERT_EQ(follows(c.program, walk, tolerance), surely) << "trial " << trial;
    follow += surely;
  }
  EXPECT_GT(trials, 80);
  EXPECT_GT(follow, 20);
  EXPECT_LT(follow, trials - 20);
}

/// Points every `step` along a polyline.
Points along(const Points& corners, double step) {
  Points points = {corners.front()};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const AxisVector d = corners[i] - corners[i - 1];
    const int n = static_cast<int>(std::ceil(d.norm() / step));
    for (int k = 1; k <= n; ++k) points.push_back(corners[i - 1] + d * k / n);
  }
  return points;
}

TEST(PathFollower, CatchesWhatNearestDistancesAreBlindTo) {
  constexpr double kTolerance = 0.01;
  const Points eight = {at(0, 0), at(10, 10), at(10, 0), at(0, 10)};
  const Points holes = {at(0, 0), at(5, 0), at(5, 0, -3), at(5, 0), at(10, 0), at(10, 0, -3), at(10, 0), at(12, 0)};
  const Points strokes = {at(0, 0), at(8, 0), at(2, 0), at(9, 0)};
  const auto keeps = [&](const Points& path, const Points& walk) { return follows(polyline(path), walk, kTolerance); };
  for (const Points& path : {eight, holes, strokes}) EXPECT_TRUE(keeps(path, along(path, 0.05)));
  // The loop of the eight is left out; run the other way round; a corner is cut by 0.1/√2 mm.
  EXPECT_FALSE(keeps(eight, along({at(0, 0), at(5, 5), at(0, 10)}, 0.05)));
  EXPECT_FALSE(keeps(eight, along({at(0, 0), at(5, 5), at(10, 0), at(10, 10), at(5, 5), at(0, 10)}, 0.05)));
  EXPECT_FALSE(keeps(eight, along({at(0, 0), at(9.9, 9.9), at(10, 9.9), at(10, 0), at(0, 10)}, 0.05)));
  // The first or the second hole is missed; drilled twice; not deep enough.
  EXPECT_FALSE(keeps(holes, along({at(0, 0), at(10, 0), at(10, 0, -3), at(10, 0), at(12, 0)}, 0.05)));
  EXPECT_FALSE(keeps(holes, along({at(0, 0), at(5, 0), at(5, 0, -3), at(5, 0), at(12, 0)}, 0.05)));
  Points twice = holes;
  twice.insert(twice.begin() + 4, {at(5, 0, -3), at(5, 0)});
  EXPECT_FALSE(keeps(holes, along(twice, 0.05)));
  Points flat = holes;
  flat[5][2] = -2.98;
  EXPECT_FALSE(keeps(holes, along(flat, 0.05)));
  // A stroke less, a stroke more, a step back by more than the tolerance; by less it is rounding.
  EXPECT_FALSE(keeps(strokes, along({at(0, 0), at(9, 0)}, 0.05)));
  EXPECT_FALSE(keeps(strokes, along({at(0, 0), at(8, 0), at(2, 0), at(8, 0), at(2, 0), at(9, 0)}, 0.05)));
  EXPECT_FALSE(keeps(strokes, along({at(0, 0), at(4, 0), at(3.97, 0), at(8, 0), at(2, 0), at(9, 0)}, 0.05)));
  EXPECT_TRUE(keeps(strokes, along({at(0, 0), at(4, 0), at(3.99, 0), at(8, 0), at(2, 0), at(9, 0)}, 0.05)));
  // Rows that stay where they are belong to a dwell or a feed hold.
  Points held = along(eight, 0.05);
  held.insert(held.begin() + 100, 50, held[100]);
  EXPECT_TRUE(keeps(eight, held));
  // The end is missing.
  Points shorter = along(eight, 0.05);
  shorter.resize(shorter.size() - 5);
  EXPECT_FALSE(keeps(eight, shorter));
}

Points on_circle(const std::vector<double>& turns, double radius) {
  Points points;
  for (const double t : turns) {
    points.push_back(at(radius * std::cos(2 * std::numbers::pi * t), radius * std::sin(2 * std::numbers::pi * t)));
  }
  return points;
}

TEST(PathFollower, CountsTurnsOfACircle) {
  constexpr int kRows = 1000;  // a turn; on 5 mm they are 5·(1 − cos(π/1000)) = 2.5e-5 mm off the chords
  Program program;
  program.start(5, 0).arc(0, 0, 6 * std::numbers::pi);
  const auto turns = [](double begin, double end) {
    std::vector<double> t;
    const int n = static_cast<int>(std::abs(end - begin) * kRows);
    for (int k = 0; k <= n; ++k) t.push_back(begin + (end - begin) * k / n);
    return t;
  };
  const auto keeps = [&](const std::vector<double>& t) { return follows(program, on_circle(t, 5), 0.001); };
  EXPECT_TRUE(keeps(turns(0, 3)));
  EXPECT_FALSE(keeps(turns(0, 2)));
  EXPECT_FALSE(keeps(turns(0, 4)));
  EXPECT_FALSE(keeps(turns(0, -3)));
  std::vector<double> back = turns(0, 1.3);
  for (const double t : turns(1.3, 1.2)) back.push_back(t);
  for (const double t : turns(1.2, 3)) back.push_back(t);
  EXPECT_FALSE(keeps(back));
  // A chord across 3° of it stands off by 5·(1 − cos 1.5°) = 1.7e-3 mm, one across 1.8° by 6e-4.
  std::vector<double> cut = turns(0, 1), whole = cut;
  for (const double t : turns(1 + 3.0 / 360, 3)) cut.push_back(t);
  for (const double t : turns(1 + 1.8 / 360, 3)) whole.push_back(t);
  EXPECT_FALSE(keeps(cut));
  EXPECT_TRUE(keeps(whole));
}

TEST(PathFollower, KeepsTheToleranceOfEachSegment) {
  const Points corners = {at(0, 0), at(10, 0), at(10, 10), at(20, 10)};
  const Path path = build_path(polyline(corners).moves(), 0).value();
  // Both corners are cut by 0.05/√2 = 0.0354 mm.
  const Points walk = along({at(0, 0), at(9.95, 0), at(10, 0.05), at(10, 9.95), at(10.05, 10), at(20, 10)}, 0.05);
  const auto keeps = [&](std::vector<SegmentRule> rules) {
    PathVertices vertices(path, 1e-6, std::move(rules));
    PathFollower follower(vertices, 0.05, false);
    bool goes_on = follower.start(walk[0]);
    for (std::size_t k = 1; k < walk.size() && goes_on; ++k)
      goes_on = follower.advance(walk[k - 1], walk[k], {0, 0, false});
    return goes_on && follower.reaches_end();
  };
  EXPECT_TRUE(keeps({}));
  EXPECT_TRUE(keeps({{0.05, false}, {0.05, false}, {0.05, false}}));
  EXPECT_FALSE(keeps({{0.03, false}, {0.05, false}, {0.05, false}}));
  EXPECT_FALSE(keeps({{0.05, false}, {0.05, false}, {0.03, false}}));
}

TEST(ArcSector, MeasuresAsFinePointsDo) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 300; ++trial) {
    ArcCurve arc{};
    arc.radial << 1, 0, 0;
    arc.lateral << 0, 1, 0;
    arc.normal << 0, 0, 1;
    arc.centre << draw(random, -5, 5), draw(random, -5, 5), draw(random, -5, 5);
    arc.start_radius = std::exp(draw(random, -2, 4));
    arc.end_radius = arc.start_radius * (random() % 2 == 0 ? 1 : draw(random, 0.93, 1.07));
    arc.sweep = draw(random, 0.01, 1);
    arc.rise = random() % 2 == 0 ? 0 : draw(random, -3, 3) * arc.start_radius;
    const ArcSector sector(arc, 0, arc.sweep);
    constexpr int kParts = 20000;
    const double u = draw(random, 0, 1), radius = arc.start_radius * std::exp(draw(random, -9, -1));
    const Eigen::Vector3d off(draw(random, -1, 1), draw(random, -1, 1), draw(random, -1, 1));
    const Eigen::Vector3d point = arc_point(arc, arc.sweep * u).head<3>() + off * radius;
    double low = 2, high = -1;
    for (int k = 0; k <= kParts; ++k) {
      const double t = static_cast<double>(k) / kParts;
      if ((arc_point(arc, arc.sweep * t).head<3>() - point).norm() > radius) continue;
      low = std::min(low, t);
      high = std::max(high, t);
    }
    const CurveInterval found = sector.within(point, radius);
    if (low > high) {
      EXPECT_LT(found.high - found.low, 2.0 / kParts) << trial;
      continue;
    }
    ASSERT_FALSE(found.empty()) << trial;
    EXPECT_NEAR(found.low, low, 1.1 / kParts) << trial;
    EXPECT_NEAR(found.high, high, 1.1 / kParts) << trial;
    EXPECT_NEAR(sector.distance(point, u), (arc_point(arc, arc.sweep * u).head<3>() - point).norm(),
                1e-12 * arc.start_radius + 1e-14);
    EXPECT_LE(found.distance, sector.distance(point, std::clamp(found.nearest, 0.0, 1.0)) + 1e-12) << trial;
  }
}

}  // namespace
}  // namespace toolpace
