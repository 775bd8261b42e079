#include "toolpace/limits/curve_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "toolpace/path/build_path.h"

namespace toolpace {
namespace {

Moves one_arc(double radius, double sweep, double rise, double feed) {
  Moves moves;
  moves.start[0] = radius;
  AxisVector end = AxisVector::Zero();
  end[0] = radius * std::cos(sweep);
  end[1] = radius * std::sin(sweep);
  end[2] = rise;
  moves.kind = {MoveKind::arc};
  moves.line = {1};
  moves.file = {0};
  moves.mode = {0};
  moves.detail = {0};
  moves.end = {end};
  moves.feed = {feed};
  moves.arcs = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), sweep}};
  return moves;
}

std::array<AxisLimits, kAxisCount> axes_with(double speed, double acceleration, double jerk) {
  std::array<AxisLimits, kAxisCount> axes;
  for (std::size_t k = 0; k < 3; ++k) {
    axes[k].speed = speed;
    axes[k].acceleration = acceleration;
    axes[k].jerk = jerk;
  }
  return axes;
}

TEST(CurveBudget, LineLeavesWhatItsDirectionAllows) {
  CurveBounds bounds;
  bounds.first << 0.6, 0.8, 0, 0, 0, 0;
  const CurveBudget budget = curve_budget(bounds, axes_with(100, 2000, 50000));
  EXPECT_FALSE(budget.bends());
  EXPECT_DOUBLE_EQ(budget.speed, 125);
  EXPECT_DOUBLE_EQ(budget.at(100, 0.7, AtCap::changes).acceleration, 2500);
  EXPECT_DOUBLE_EQ(budget.at(100, 0.7, AtCap::rests).jerk, 62500);
}

// Full circle of radius r: √(a² + v⁴/r²) ≤ A, so 44 % of A are free where turning takes 90 %.
TEST(CurveBudget, TurningAndChangingSpeedAreAtRightAngles) {
  const auto path = build_path(one_arc(5, 2 * std::numbers::pi, 0, 1000), 0);
  ASSERT_TRUE(path);
  const CurveBudget budget = curve_budget(curve_bounds(*path, 0), axes_with(1000, 2000, kUnlimited));
  const double v = std::sqrt(0.9 * 2000 * 5);
  EXPECT_NEAR(budget.at(v, 0.7, AtCap::changes).acceleration, std::sqrt(1 - 0.81) * 2000, 1e-6);
  // With jerk limits: (j + v³/r²)² + (3va/r)² ≤ J², at constant speed v³/r² ≤ J.
  const CurveBudget jerky = curve_budget(curve_bounds(*path, 0), axes_with(1000, 1e6, 50000));
  EXPECT_NEAR(jerky.top_speed(), 0.999 * std::cbrt(50000.0 * 25), 1e-6);
  const CurveShare share = jerky.at(60, 0.7, AtCap::changes);
  EXPECT_NEAR(std::hypot(share.jerk + 60 * 60 * 60 / 25.0, 3 * 60 * share.acceleration / 5), 50000, 1e-6);
}

TEST(CurveBudget, SmallCircleIsCappedByItsCurvature) {
  const auto path = build_path(one_arc(0.5, std::numbers::pi, 0, 1000), 0);
  ASSERT_TRUE(path);
  const CurveBudget budget = curve_budget(curve_bounds(*path, 0), axes_with(1000, 2000, kUnlimited));
  EXPECT_LE(budget.top_speed() * budget.top_speed() / 0.5, 2000);
  EXPECT_GT(budget.at(budget.top_speed(), 0.7, AtCap::changes).acceleration, 0);
}

/// What an axis does at a place of a path.
void expect_within(const Frame& f, double v, double a, double j, const std::array<AxisLimits, kAxisCount>& axes,
                   int n) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    const AxisLimits& axis = axes[static_cast<std::size_t>(k)];
    EXPECT_LE(std::abs(f.first[k] * v), axis.speed * (1 + 1e-9)) << "case " << n;
    EXPECT_LE(std::abs(f.first[k] * a + f.second[k] * v * v), axis.acceleration * (1 + 1e-9)) << "case " << n;
    EXPECT_LE(std::abs(f.first[k] * j + 3 * f.second[k] * v * a + f.third[k] * v * v * v), axis.jerk * (1 + 1e-9))
        << "case " << n;
  }
}

// Whatever v ≤ cap, |a| ≤ acceleration, |j| ≤ jerk: axis acceleration u·a + k·v² and axis jerk u·j + 3k·v·a + t·v³.
TEST(CurveBudget, AxesKeepTheirLimitsOnRandomArcsAnywhere) {
  std::mt19937_64 random(20260101);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int n = 0; n < 4000; ++n) {
    const double radius = std::pow(10, 2 * unit(random)), sweep = 0.01 + 3.2 * (1 + unit(random));
    const auto path = build_path(one_arc(radius, sweep, n % 2 == 0 ? 3 * radius * unit(random) : 0.0, 1000), 0);
    ASSERT_TRUE(path);
    auto axes = axes_with(100 * (2 + unit(random)), 1000 * (2 + unit(random)), 30000 * (2 + unit(random)));
    axes[1].acceleration *= 2 + unit(random);
    axes[0].jerk *= 2 + unit(random);
    const CurveBudget b = curve_budget(curve_bounds(*path, 0), axes);
    const double cap = b.top_speed() * (1 - 0.5 * std::abs(unit(random)));
    const double part = 0.95 * unit(random);
    ASSERT_GT(cap, 0);
    const CurveShare any = b.at(cap, part, AtCap::changes), rested = b.at(cap, part, AtCap::rests);
    for (const CurveShare& s : {any, rested}) {
      ASSERT_GT(s.acceleration, 0);
      ASSERT_GT(s.jerk, 0);
    }
    // At rest at the cap, the same jerk leaves more.
    const JerkRange same{0, 2 * any.jerk, 0};
    EXPECT_GE(b.at(cap, same, 0.5, AtCap::rests).acceleration, any.acceleration * (1 - 1e-6)) << "case " << n;
    for (int m = 0; m < 30; ++m) {
      const Frame f = frame_at(*path, 0, path->length[0] * (1 + unit(random)) / 2);
      expect_within(f, cap * (1 + unit(random)) / 2, any.acceleration * unit(random), any.jerk * unit(random), axes, n);
      // Below the cap by what the jerk needs to take the acceleration away, and above what it needed to build it up.
      const double a = std::min(rested.acceleration, std::sqrt(rested.jerk * cap)) * unit(random);
      const double room = a * a / (2 * rested.jerk);
      const double v = m % 3 == 0 ? cap - room : room + (cap - 2 * room) * (1 + unit(random)) / 2;
      expect_within(f, v, a, rested.jerk * (m % 2 == 0 ? 1 : -1), axes, n);
    }
  }
}

// By hand: a ramp with jerk j rests at its cap, so a = √(2j(cap − v)) below it, and on a circle (j + v³/r²)² + (3va/r)² ≤ J²
// everywhere on the way there. Near 0.873 of the top speed the jerk at the cap and that a tenth below it are equal.
TEST(CurveBudget, RampsOnACircleKeepTheJerkAllTheWayToTheirCap) {
  constexpr double kRadius = 2, kJerk = 30000;
  const auto path = build_path(one_arc(kRadius, 2 * std::numbers::pi, 0, 1000), 0);
  ASSERT_TRUE(path);
  const CurveBudget budget = curve_budget(curve_bounds(*path, 0), axes_with(1000, 1e6, kJerk));
  for (double part = 0.3; part <= 1.0; part += 0.0003) {
    const double cap = part * budget.top_speed(), split = std::fmod(part * 100, 1.9) - 0.92;
    const CurveShare share = budget.at(cap, split, AtCap::rests);
    for (double v = 0.5 * cap; v <= cap; v += 0.002 * cap) {
      const double a = std::min(share.acceleration, std::sqrt(2 * share.jerk * (cap - v)));
      const double along = share.jerk + v * v * v / (kRadius * kRadius), across = 3 * v * a / kRadius;
      ASSERT_LE(std::hypot(along, across), kJerk * (1 + 1e-9)) << part << ", " << v / cap;
    }
  }
}

/// Bounds of a curve that may do anything: more than real ones, whose derivatives hang together.
CurveBounds random_bounds(std::mt19937_64& engine) {
  const auto or_none = [&](double low, double high) {
    if (engine() % 3 == 0) return 0.0;
    return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(engine));
  };
  CurveBounds bounds;
  bounds.curvature = or_none(1e-3, 1e2);
  bounds.bend = engine() % 2 == 0 ? bounds.curvature * bounds.curvature : 0.0;
  for (Eigen::Index k = 0; k < bounds.first.size(); ++k) {
    bounds.first[k] = std::min(1.0, or_none(1e-2, 1));
    bounds.second[k] = or_none(1e-3, 1e2);
    bounds.third[k] = or_none(1e-3, 1e3);
  }
  return bounds;
}

// An easier problem may do all that the harder one may: one limit higher never leaves less, at any cap, beside any jerk.
TEST(CurveBudget, AHigherLimitOfWhateverAxisNeverLeavesLess) {
  std::mt19937_64 engine(20260505);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int n = 0; n < 6'000; ++n) {
    const CurveBounds bounds = random_bounds(engine);
    std::array<AxisLimits, kAxisCount> axes;
    for (AxisLimits& a : axes) {
      a.speed = 500 * unit(engine) + 10;
      a.acceleration = std::pow(10, 2 + 2 * unit(engine));
      a.jerk = n % 5 == 0 ? kUnlimited : std::pow(10, 3 + 3 * unit(engine));
    }
    auto higher = axes;
    AxisLimits& raised = higher[engine() % kAxisCount];
    (n % 3 == 0 ? raised.speed : n % 3 == 1 ? raised.acceleration : raised.jerk) *= 1 + 3 * unit(engine);
    const CurveBudget before = curve_budget(bounds, axes), after = curve_budget(bounds, higher);
    ASSERT_GE(after.top_speed(), before.top_speed()) << n;
    if (!before.bends() || !(before.top_speed() < kUnlimited)) continue;
    const double cap = before.top_speed() * (0.05 + 0.95 * unit(engine));
    for (const AtCap at_cap : {AtCap::rests, AtCap::changes}) {
      const double jerk = before.at(cap, 1.9 * unit(engine) - 0.95, at_cap).jerk;
      ASSERT_LE(before.jerk_range(cap, at_cap).most, after.jerk_range(cap, at_cap).most) << n;
      // Beside the same jerk.
      const JerkRange same{0, 2 * jerk, 0};
      const double was = before.at(cap, same, 0.5, at_cap).acceleration;
      ASSERT_GE(after.at(cap, same, 0.5, at_cap).acceleration, was * (1 - 1e-6)) << n;
    }
  }
}

/// Largest derivatives by dense sampling, against the bound: never above it, and the bound not far above them. Axes that
/// have little of the whole are judged by a part of it.
void expect_tight(const Path& path, std::size_t i, const char* what) {
  constexpr int kSamples = 1500;
  const CurveBounds bound = curve_bounds(path, i);
  CurveBounds most;
  for (int k = 0; k <= kSamples; ++k) {
    const ParameterDerivatives d = derivatives_at_share(path, i, static_cast<double>(k) / kSamples);
    most.first = most.first.cwiseMax(d.first.cwiseAbs());
    most.second = most.second.cwiseMax(d.second.cwiseAbs());
    most.third = most.third.cwiseMax(d.third.cwiseAbs());
  }
  const double length = path.length[i];
  const auto compare = [&](const AxisVector& b, const AxisVector& m, double rounding, int order) {
    for (Eigen::Index axis = 0; axis < m.size(); ++axis) {
      const double whole = (axis < 3 ? m.head<3>() : m.tail<3>()).maxCoeff();
      EXPECT_LE(m[axis], b[axis] * (1 + 1e-9) + rounding) << what << ", derivative " << order << ", axis " << axis;
      EXPECT_LE(b[axis], 1.15 * m[axis] + 0.02 * whole + rounding)
          << what << ", derivative " << order << ", axis " << axis;
    }
  };
  compare(bound.first, most.first, 1e-9, 1);
  compare(bound.second, most.second, 1e-8 / length, 2);
  compare(bound.third, most.third, 1e-8 / (length * length), 3);
}

// Whatever a curve does not do (bend, turn, change its curvature) and whatever has no limit: something is left at any cap, and no
// more than the axes have where nothing turns.
TEST(CurveBudget, LeavesSomethingWhateverIsMissing) {
  std::mt19937_64 engine(3);
  const auto or_none = [&](double none, double low, double high) {
    if (engine() % 3 == 0) return none;
    return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(engine));
  };
  for (int n = 0; n < 20'000; ++n) {
    CurveBounds bounds{};
    bounds.first.setZero();
    bounds.second.setZero();
    bounds.third.setZero();
    bounds.together.setConstant(2);
    bounds.curvature = or_none(0, 1e-6, 1e2);
    bounds.bend = or_none(0, 1e-9, 1e2);
    std::array<AxisLimits, kAxisCount> axes;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      bounds.first[i] = std::min(1.0, or_none(0, 1e-6, 1));
      bounds.second[i] = or_none(0, 1e-9, 1e2);
      bounds.third[i] = or_none(0, 1e-15, 1e2);
      axes[k].acceleration = or_none(kUnlimited, 1, 1e5);
      axes[k].jerk = or_none(kUnlimited, 1, 1e7);
    }
    const CurveBudget budget = curve_budget(bounds, axes);
    const double top = std::min(budget.top_speed(), 1e4);
    ASSERT_GT(top, 0);
    for (const double share : {1.0, 0.9, 0.3, 1e-3}) {
      for (const AtCap at_cap : {AtCap::rests, AtCap::changes}) {
        const CurveShare left = budget.at(share * top, usual_split(at_cap), at_cap);
        ASSERT_GT(left.acceleration, 0) << n;
        ASSERT_GT(left.jerk, 0) << n;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
          const double first = bounds.first[static_cast<Eigen::Index>(k)];
          if (!(first > 0)) continue;
          ASSERT_LE(left.acceleration * first, axes[k].acceleration * (1 + 1e-9)) << n;
          ASSERT_LE(left.jerk * first, axes[k].jerk * (1 + 1e-9)) << n;
        }
      }
    }
  }
}

TEST(CurveBounds, ContainRandomSplinesTightly) {
  std::mt19937_64 random(20260202);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::size_t pieces = 0;
  for (int n = 0; n < 60; ++n) {
    const int degree = 2 + n % 4;
    const int spans = 1 + n % 5, count = degree + spans;
    SplineDetail spline;
    spline.degree = degree;
    for (int k = 0; k < count; ++k) {
      spline.points.emplace_back(10.0 * k + 6 * unit(random), 20 * unit(random), n % 3 == 0 ? 5 * unit(random) : 0.0);
      if (n % 2 == 0) spline.weights.push_back(std::exp(unit(random)));
    }
    for (int k = 0; k <= count + degree; ++k) {
      spline.knots.push_back(std::clamp(k - degree, 0, spans));
    }
    Moves moves = one_arc(1, 1, 0, 1000);
    moves.start.head<3>() = spline.points.front();
    moves.end[0].setZero();
    moves.end[0].head<3>() = spline.points.back();
    if (n % 5 == 0) moves.end[0][3] = unit(random);
    moves.kind = {MoveKind::spline};
    moves.arcs.clear();
    moves.splines = {spline};
    const auto path = build_path(moves, 0);
    ASSERT_TRUE(path);
    for (std::size_t i = 0; i < path->size(); i += 3) expect_tight(*path, i, "spline");
    pieces += path->size();
  }
  EXPECT_GT(pieces, 500u);
}

TEST(CurveBounds, ContainBlendsOfEveryAngleTightly) {
  std::mt19937_64 random(20260303);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int n = 0; n < 300; ++n) {
    const double angle = 3.05 * unit(random), turned = 3 * unit(random);  // corner, and how it lies
    Path path;
    AxisVector before = AxisVector::Zero(), after = AxisVector::Zero();
    before.head<3>() << std::cos(turned), std::sin(turned), 0.0;
    after.head<3>() << std::cos(turned + angle), std::sin(turned + angle), 0.0;
    if (n % 3 == 0) after[3] = unit(random);
    path.kind = {SegmentKind::blend};
    path.detail = {0};
    path.corner_blends = {{AxisVector::Zero(), before, after}};
    path.length = {blend_length(path.corner_blends[0])};
    path.node = {-before, after};
    expect_tight(path, 0, "corner blend");
    const BlendEnd begin{-before, before, AxisVector::Zero()};
    AxisVector bend = AxisVector::Zero();
    bend.head<3>() << -after[1], after[0], 0.0;
    const BlendEnd end{after, after, 0.5 * unit(random) * bend};
    if (std::abs(angle) > 1.8) continue;  // sharper corners get no blend
    path.detail = {Path::kCurveBlend};
    path.curve_blends = {make_curve_blend(begin, end, 1.6)};
    path.length = {blend_length(path.curve_blends[0])};
    expect_tight(path, 0, "curve blend");
  }
}

}  // namespace
}  // namespace toolpace
