#include "toolpace/limits/curve_budget.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

constexpr double kTopShare = 0.999;  // of the speed at which nothing is left
constexpr double kRounding = 1e-9;   // of a third derivative that is all against the direction
/// Share of the jerk, as an angle's sine, that the turning part 3κva takes at most where a ramp may do anything at its cap.
constexpr double kTurningShare = 0.7;
/// Speeds x as shares of the cap where a ramp is looked at: with a = √(2j(cap − v)) the turning part v·a peaks at 2/3. Between
/// two of these places, h apart, its square ∝ (1 − x)·x² rises above its chord by |2 − 6x|·h²/8, no more than by so much of its
/// own; the part along the path is convex, and below its chord.
constexpr double kPlaces[] = {1.0, 0.985, 0.965, 0.94, 0.91, 0.88, 0.835, 0.79, 0.75, 0.71, 0.64, 0.57, 0.5};
constexpr double kBetweenPlaces = 1.012;
/// A rectangle inside another one beats the ellipse where its sides are at most this much shorter.
constexpr double kMuchApart = 1.3;
constexpr double kSettled = 1e-4;  // of the jerk that is looked for
constexpr int kMostSteps = 40;

double squared(double x) { return x * x; }

double level_at(double speed, const CurveBudget& b) {
  return b.slope > 0 ? std::max(0.0, b.level - b.slope * speed * speed) : b.level;
}

/// Largest acceleration of a ramp that ends (begins) at the cap with jerk j: y = a² with y/A² + (cap − y/2j)⁴/Q² = 1. The left
/// side is convex in y, so Newton's steps from above do not pass the root. Neither y = j·cap nor A² is passed by any ramp.
double acceleration_towards(double cap, double jerk, const CurveBudget& b) {
  if (cap * cap > b.square) return level_at(cap, b);  // on the other form's side
  double y = std::min(jerk * cap, squared(b.acceleration));
  const double by_square = 1 / squared(b.acceleration);
  for (int i = 0; i < 30; ++i) {
    const double u = cap - y / (2 * jerk), turned = squared(u * u / b.square);
    const double excess = y * by_square + turned - 1;
    if (excess <= 0) break;
    const double slope = by_square - 2 * turned / (u * jerk);
    if (!(slope > 0)) break;
    const double next = y - excess / slope;
    if (next >= y * (1 - 1e-9)) break;
    y = std::max(next, 0.0);
  }
  // Rounding aside this holds already, but where the cap itself is at the limit.
  return std::max(std::min(b.acceleration, std::sqrt(y * (1 - 1e-9))), level_at(cap, b));
}

/// By how much the squares of the parts of the jerk pass what there is, at the worst place of a ramp with jerk j.
double excess_of_jerk(double cap, double jerk, const CurveBudget& b) {
  const double slowest = cap - squared(acceleration_towards(cap, jerk, b)) / (2 * jerk);
  double worst = -1;
  for (const double place : kPlaces) {
    const double v = std::max(place * cap, slowest), cube = v * v * v;
    const double turning = kBetweenPlaces * 2 * jerk * (cap - v) * squared(v / b.turning);
    const double along = squared((jerk + b.bend * cube) / b.jerk), left = squared(std::max(0.0, 1 - cube / b.cube));
    worst = std::max(worst, (b.is_apart ? std::max(along, turning) : along + turning) - left);
    if (v > place * cap) break;
  }
  return worst;
}

/// Largest jerk of a ramp that ends at the cap. The excess rises with the jerk: false position, held to the side that keeps the
/// limits.
double jerk_towards(double cap, double most, const CurveBudget& b) {
  double low = 0, high = most, at_low = excess_of_jerk(cap, most * 1e-6, b), at_high = excess_of_jerk(cap, most, b);
  if (at_high <= 0) return most;
  if (!(at_low < 0)) return most * 1e-6;  // turning takes all
  for (int i = 0, side = 0; i < kMostSteps && high - low > kSettled * high; ++i) {
    const double share = i % 4 == 3 ? 0.5 : at_low / (at_low - at_high);
    const double x = low + share * (high - low), excess = excess_of_jerk(cap, x, b);
    if (excess <= 0) {
      low = x;
      at_low = excess;
      if (side == -1) at_high /= 2;
      side = -1;
    } else {
      high = x;
      at_high = excess;
      if (side == 1) at_low /= 2;
      side = 1;
    }
  }
  return low > 0 ? low : most * 1e-6;
}

/// What an axis uses of its limit at most where t and n lie inside an ellipse with these half axes: the share of the direction
/// in it times t and that of the normal (by curvature) times n, or, by their right angle, both together.
double use(double first, double second, double together, double along, double across) {
  const double apart = std::hypot(first > 0 ? first * along : 0.0, second > 0 ? second * across : 0.0);
  return std::min(apart, together);
}

/// Makes the ellipse of accelerations so small that it holds for every axis, and finds the line under what each axis alone
/// leaves: level − slope·v² between a standstill and the highest speed.
void fit_acceleration(const CurveBounds& b, const std::array<AxisLimits, kAxisCount>& axes, CurveBudget& budget) {
  budget.level = budget.acceleration;
  if (!(budget.square < kUnlimited) || !(budget.acceleration < kUnlimited)) return;
  double worst = 1, at_top = kUnlimited;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (!(axes[k].acceleration < kUnlimited)) continue;
    const double both =
        is_rotary(k) ? kUnlimited : b.together[i] * std::max(budget.acceleration, b.curvature * budget.square);
    worst =
        std::max(worst, use(b.first[i], b.second[i], both, budget.acceleration, budget.square) / axes[k].acceleration);
    if (b.first[i] > 0) at_top = std::min(at_top, (axes[k].acceleration - b.second[i] * budget.square) / b.first[i]);
  }
  budget.slope = (budget.acceleration - std::max(0.0, at_top)) / budget.square;
  budget.acceleration /= worst;
  budget.square /= worst;
}

/// The same for jerk: as an ellipse, or, where they lose less by it, with both parts apart.
void fit_jerk(const CurveBounds& b, const std::array<AxisLimits, kAxisCount>& axes, CurveBudget& budget) {
  if (!(budget.turning < kUnlimited)) return;
  double together = 1, apart = 1;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (!(axes[k].jerk < kUnlimited)) continue;
    const double along = b.first[i] > 0 ? b.first[i] * budget.jerk : 0.0;
    const double across = b.second[i] > 0 ? 3 * b.second[i] * budget.turning : 0.0;
    const double both =
        is_rotary(k) ? kUnlimited : b.together[i] * std::max(budget.jerk, 3 * b.curvature * budget.turning);
    together = std::max(together, std::min(std::hypot(along, across), both) / axes[k].jerk);
    apart = std::max(apart, (along + across) / axes[k].jerk);
  }
  budget.is_apart = apart < kMuchApart * together;
  budget.jerk /= budget.is_apart ? apart : together;
  budget.turning /= budget.is_apart ? apart : together;
}

}  // namespace

double CurveBudget::top_speed() const {
  double top = std::sqrt(slope > 0 ? std::max(square, level / slope) : square);
  if (cube < kUnlimited || (bend > 0 && jerk < kUnlimited)) {
    top = std::min(top, std::cbrt(1 / (1 / cube + (bend > 0 ? bend / jerk : 0.0))));
  }
  return std::min(speed, kTopShare * top);
}

CurveShare CurveBudget::at(double cap, AtCap at_cap) const {
  if (!bends()) return {acceleration, jerk};
  const double turned = std::min(1.0, squared(cap * cap / square));
  const double any = std::max(acceleration * std::sqrt(1 - turned), level_at(cap, *this));
  if (!(jerk < kUnlimited) && !(turning < kUnlimited) && !(cube < kUnlimited)) return {any, kUnlimited};
  const double volume = cap * cap * cap, left = 1 - volume / cube;
  const double bent = jerk < kUnlimited ? bend * volume / jerk : 0.0;
  if (is_apart && at_cap == AtCap::changes) {
    return {std::min(any, left * turning / cap), jerk < kUnlimited ? jerk * (left - bent) : kUnlimited};
  }
  if (at_cap == AtCap::changes || !(jerk < kUnlimited)) {
    const double free = std::sqrt(std::max(0.0, left * left - bent * bent));
    const double a = std::min(any, kTurningShare * free * turning / cap);
    const double turned_jerk = turning < kUnlimited ? cap * a / turning : 0.0;
    const double rest = std::sqrt(std::max(0.0, left * left - squared(turned_jerk)));
    return {a, jerk < kUnlimited ? jerk * (rest - bent) : kUnlimited};
  }
  const double j = jerk_towards(cap, jerk * (left - bent), *this);
  return {acceleration_towards(cap, j, *this), j};
}

Dynamics within(const Dynamics& along, const CurveShare& share) {
  const auto tight = [&share](const RampLimits& r) {
    return RampLimits{std::min(r.acceleration, share.acceleration), std::min(r.jerk, share.jerk), r.time};
  };
  return {tight(along.up), tight(along.down)};
}

CurveBudget curve_budget(const CurveBounds& b, const std::array<AxisLimits, kAxisCount>& axes) {
  CurveBudget budget;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (b.first[i] > 0) {
      budget.speed = std::min(budget.speed, axes[k].speed / b.first[i]);
      budget.acceleration = std::min(budget.acceleration, axes[k].acceleration / b.first[i]);
      budget.jerk = std::min(budget.jerk, axes[k].jerk / b.first[i]);
    }
    if (b.second[i] > 0) {
      budget.square = std::min(budget.square, axes[k].acceleration / b.second[i]);
      budget.turning = std::min(budget.turning, axes[k].jerk / (3 * b.second[i]));
    }
    const double rest = b.third[i] - b.bend * b.first[i];
    if (rest > kRounding * b.third[i]) budget.cube = std::min(budget.cube, axes[k].jerk / rest);
  }
  budget.bend = b.bend;
  fit_acceleration(b, axes, budget);
  fit_jerk(b, axes, budget);
  return budget;
}

}  // namespace toolpace
