#include "toolpace/limits/curve_budget.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace toolpace {
namespace {

constexpr double kTopShare = 0.999;  // of the speed at which nothing is left
constexpr double kRounding = 1e-9;   // of a third derivative that is all against the direction; of a root
/// Places of a ramp, evenly spread between its cap and two thirds of that, between which the jerk's terms in v³ are those of the
/// faster end. With a = √(2j(cap − v)) the turning part v·a is largest at two thirds of the cap, and what holds there holds below.
constexpr int kPlaces = 48;
constexpr double place(int i) { return 1 - i / (3.0 * kPlaces); }

constexpr double kLeastJerk = 1e-6;  // of what is left at constant speed
constexpr double kFineness = 1e-4;   // of a jerk that is chosen
constexpr int kHalvings = 13, kMostSteps = 20;

double squared(double x) { return x * x; }
double cubed(double x) { return x * x * x; }
double root_of(double x) { return std::sqrt(std::max(0.0, x)); }

/// Largest acceleration beside a speed.
double acceleration_at(double speed, const CurveRow& row, double curvature) {
  const double square = speed * speed, left = 1 - row.across * square;
  const double apart = row.along > 0 ? left / row.along : left >= 0 ? kUnlimited : 0.0;
  const double together = row.plane > 0 ? root_of(squared(1 / row.plane) - squared(curvature * square)) : 0.0;
  return std::max({apart, together, 0.0});
}

/// Newton's steps towards a root of f, given with its slope as {f, f'}, from a side on which they do not pass it.
template <class F>
double root_by_newton(double x, const F& f) {
  for (int i = 0; i < kMostSteps; ++i) {
    const auto [value, slope] = f(x);
    const double step = value / slope;
    if (!(std::abs(step) > kRounding * x)) break;
    x -= step;
  }
  return x;
}

/// Largest acceleration of a ramp that ends (begins) at the cap with jerk j, by the sum: the first root of
/// along·a + across·(cap − a²/2j)² = 1. The left side bends downwards up to a² = 2j·cap/3 and upwards from there, so it has one
/// hump at most, in the first part, where Newton's steps do not pass a root from below; in the second they do not from above.
/// No ramp passes a² = j·cap.
double acceleration_by_sum(double cap, double jerk, const CurveRow& row) {
  struct Line {
    double value, slope;
  };
  const double half = 1 / (2 * jerk);
  const auto excess = [&](double a) {
    const double speed = cap - a * a * half;
    return Line{row.along * a + row.across * speed * speed - 1, row.along - 4 * row.across * speed * a * half};
  };
  const double most = std::sqrt(jerk * cap), bend = std::sqrt(2 * jerk * cap / 3);
  if (excess(0).value > 0) return 0;
  double top = bend;  // of the part that rises
  if (excess(bend).slope < 0) {
    const double level = row.along * jerk / (2 * row.across);  // a·speed(a) where the left side is level
    top = root_by_newton(0.0, [&](double a) { return Line{a * (cap - a * a * half) - level, cap - 3 * a * a * half}; });
  }
  if (excess(top).value > 0) return root_by_newton(0.0, excess);
  if (!(excess(most).value > 0)) return most;
  const double root = (1 - kRounding) * root_by_newton(most, excess);
  return excess(root).value > 0 ? top : root;  // never beyond a root that is hard to find
}

/// The same by the right angle: y = a² with y + κ²(cap − y/2j)⁴ = 1/plane². The left side is convex in y, so Newton's steps from
/// above do not pass the root. No ramp passes y = 1/plane² either.
double acceleration_by_right_angle(double cap, double jerk, const CurveRow& row, double curvature) {
  if (!(row.plane > 0) || row.plane * curvature * cap * cap > 1) return 0;
  const double most = squared(1 / row.plane);
  double y = std::min(jerk * cap, most);
  for (int i = 0; i < 30; ++i) {
    const double u = cap - y / (2 * jerk), turned = squared(curvature * u * u);
    const double excess = y + turned - most;
    if (excess <= 0) break;
    const double slope = 1 - 2 * turned / (u * jerk);
    if (!(slope > 0)) break;
    const double next = y - excess / slope;
    if (next >= y * (1 - 1e-9)) break;
    y = std::max(next, 0.0);
  }
  return std::sqrt(y * (1 - 1e-9));
}

/// The highest of all three, or one that is no less than `enough`: no axis that leaves more than another one decides.
double acceleration_towards(double cap, double jerk, const CurveRow& row, double curvature, double enough) {
  const double at_cap = acceleration_at(cap, row, curvature);
  if (at_cap >= enough) return at_cap;
  const double square = std::max(at_cap, acceleration_by_right_angle(cap, jerk, row, curvature));
  return square >= enough ? square : std::max(square, acceleration_by_sum(cap, jerk, row));
}

/// Jerk that is left at a constant speed.
double jerk_at(double speed, const CurveBudget& b) {
  const double volume = cubed(speed);
  double least = kUnlimited;
  for (const CurveRow& row : b.rows()) {
    if (row.jerk > 0) least = std::min(least, (1 - row.rest * volume) / row.jerk - b.bend * volume);
  }
  return least;
}

/// Largest v·a beside a speed and a jerk.
double turning_at(double speed, double jerk, const CurveBudget& b) {
  const double volume = cubed(speed), bent = jerk + b.bend * volume;
  double least = kUnlimited;
  for (const CurveRow& row : b.rows()) {
    const double all = 1 - row.rest * volume, left = all - (row.jerk > 0 ? row.jerk * bent : 0.0);
    const double apart = row.turning > 0 ? left / (3 * row.turning) : left >= 0 ? kUnlimited : 0.0;
    if (apart >= least) continue;
    const double free = row.jerk_plane > 0 && all > 0 ? root_of(squared(all / row.jerk_plane) - squared(bent)) : 0.0;
    const double together = free > 0 ? free / (3 * b.curvature) : 0.0;  // infinite where nothing turns
    least = std::min(least, std::max({apart, together, 0.0}));
  }
  return least;
}

/// x²·y at each place but the first, with x = 1 − y the speed as a part of the cap.
const std::array<double, kPlaces>& rises() {
  static const std::array<double, kPlaces> all = [] {
    std::array<double, kPlaces> rise{};
    for (int i = 0; i < kPlaces; ++i) {
      const double x = place(i + 1);
      rise[static_cast<std::size_t>(i)] = x * x * (1 - x);
    }
    return rise;
  }();
  return all;
}

/// The highest jerk beside which a ramp keeps v·a = √(jerk)·part at a speed.
double jerk_beside(double speed, double part, const CurveBudget& b) {
  const double volume = cubed(speed), bent = b.bend * volume;
  double least = kUnlimited;
  for (const CurveRow& row : b.rows()) {
    const double all = 1 - row.rest * volume;
    double apart = all >= 0 ? kUnlimited : 0.0, together = 0;
    if (row.jerk > 0 || row.turning > 0) {  // row.jerk·(j + bent) + 3·turning·part·√j = all, a square of √j
      const double turned = 3 * row.turning * part, left = all - row.jerk * bent;
      apart = left > 0 ? squared(2 * left / (turned + std::sqrt(squared(turned) + 4 * row.jerk * left))) : 0.0;
    }
    if (apart >= least) continue;
    if (row.jerk_plane > 0 && all > 0) {  // (j + bent)² + (3κ·part)²·j = (all/jerk_plane)²
      const double left = squared(all / row.jerk_plane) - squared(bent);
      const double half = bent + squared(3 * b.curvature * part) / 2;
      together = left > 0 ? left / (half + std::sqrt(squared(half) + left)) : 0.0;
    }
    least = std::min(least, std::max(apart, together));
  }
  return least;
}

double rise_at(int i) { return rises()[static_cast<std::size_t>(i)]; }

/// The first place from i on that rises above some value; kPlaces where none does.
int first_broken(int i, double most) {
  return static_cast<int>(std::upper_bound(rises().begin() + i, rises().end(), most) - rises().begin());
}

/// By how much of the cap a ramp towards it may begin below, so that it keeps the jerk: with x = 1 − y the speed as a part of the
/// cap, x²·y ≤ (v·a)²/(2j·cap³) all the way. The left side rises in y below a third, ever more slowly, so Newton's steps from
/// below do not pass the root. The right side rises, too: what holds at one place with the right side of a faster one holds.
double fall_towards(double cap, double jerk, const CurveBudget& b) {
  const double whole = 2 * jerk * cubed(cap);
  for (int i = 0;;) {
    const double most = squared(turning_at(place(i) * cap, jerk, b)) / whole;
    const int next = first_broken(i, most);
    if (next == kPlaces) return 1;
    if (next > i) {
      i = next;
      continue;
    }
    double y = 1 - place(i);
    for (int k = 0; k < kMostSteps; ++k) {
      const double x = 1 - y, step = (most - x * x * y) / (x * (3 * x - 2));
      if (!(step > kRounding * y)) break;
      y += step;
    }
    return y;
  }
}

/// The highest jerk ≤ most with which a ramp towards the cap keeps the jerk from wherever it begins.
double jerk_from_anywhere(double cap, double most, const CurveBudget& b) {
  const double whole = 2 * cubed(cap);
  const auto at = [&](int i) { return jerk_beside(place(i) * cap, std::sqrt(rise_at(i) * whole), b); };
  double jerk = std::min({most, at(kPlaces / 2), at(kPlaces - 1)});  // most often one of these is nearly the lowest
  for (int i = 0; i < kPlaces && jerk > 0;) {
    const int next = first_broken(i, squared(turning_at(place(i) * cap, jerk, b)) / (whole * jerk));
    if (next == i) jerk = std::min(jerk, at(i));
    i = std::max(i + 1, next);
  }
  return jerk;
}

/// Largest acceleration ≤ `most` beside a cap and a jerk, whatever jerk the axes may have.
double acceleration_beside(double cap, double jerk, AtCap at_cap, const CurveBudget& b, double most = kUnlimited) {
  const bool rests = at_cap == AtCap::rests && jerk < kUnlimited;
  double least = most;
  for (const CurveRow& row : b.rows()) {
    if (!(row.along > 0) && !(row.across > 0)) continue;  // no limit
    const double a =
        rests ? acceleration_towards(cap, jerk, row, b.curvature, least) : acceleration_at(cap, row, b.curvature);
    least = std::min(least, a);
  }
  return least;
}

/// No higher than what turning leaves the jerk for.
double acceleration_under(double cap, double jerk, AtCap at_cap, const CurveBudget& b) {
  if (at_cap == AtCap::changes || !(jerk < kUnlimited)) return turning_at(cap, jerk, b) / cap;
  const double fall = fall_towards(cap, jerk, b);
  return fall < 1 ? std::sqrt(2 * jerk * cap * fall) : kUnlimited;
}

/// The highest jerk ≤ most beside which turning_at() leaves a part v·a.
double jerk_beside_turning(double speed, double most, double part, const CurveBudget& b) {
  const double volume = cubed(speed), bent = b.bend * volume;
  double least = most + bent;
  for (const CurveRow& row : b.rows()) {
    const double all = 1 - row.rest * volume, left = all - 3 * row.turning * part;
    const double apart = row.jerk > 0 ? left / row.jerk : left >= 0 ? kUnlimited : 0.0;
    if (apart >= least) continue;
    const double turned = 3 * b.curvature * part;
    const double together =
        row.jerk_plane > 0 && all > 0 ? root_of(squared(all / row.jerk_plane) - squared(turned)) : 0.0;
    least = std::min(least, std::max({apart, together, 0.0}));
  }
  return std::max(0.0, least - bent);
}

/// The highest jerk ≤ most that leaves all of the acceleration: up to some jerk turning leaves whatever a ramp could ask for;
/// above it, where a ramp may begin is bounded, which may still be enough.
double jerk_beside_all(double cap, double most, AtCap at_cap, const CurveBudget& b) {
  const auto leaves_all = [&](double jerk) {
    return acceleration_beside(cap, jerk, at_cap, b) <= acceleration_under(cap, jerk, at_cap, b);
  };
  if (leaves_all(most)) return most;
  if (at_cap == AtCap::changes) {  // what there is beside turning is the same beside all jerks
    const double all = acceleration_beside(cap, most, at_cap, b);
    return all < kUnlimited ? (1 - kFineness) * jerk_beside_turning(cap, most, cap * all, b) : 0.0;
  }
  double low = (1 - kRounding) * jerk_from_anywhere(cap, most, b), high = most;
  if (!leaves_all(std::max((1 + kFineness) * low, kFineness * most))) return low;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (leaves_all(middle) ? low : high) = middle;
  }
  return low;
}

CurveShare along_line(const CurveBudget& b) {
  CurveShare share{kUnlimited, jerk_at(0, b)};
  for (const CurveRow& row : b.rows()) {
    if (row.along > 0) share.acceleration = std::min(share.acceleration, 1 / row.along);
  }
  return share;
}

bool is_never_less(const CurveRow& a, const CurveRow& b) {
  return a.along >= b.along && a.across >= b.across && a.plane >= b.plane && a.jerk >= b.jerk &&
         a.turning >= b.turning && a.jerk_plane >= b.jerk_plane && a.rest >= b.rest;
}

}  // namespace

bool CurveBudget::bends() const {
  const auto all = rows();
  return std::any_of(all.begin(), all.end(), [&](const CurveRow& r) {
    return r.across > 0 || r.turning > 0 || r.rest > 0 || (r.jerk > 0 && bend > 0);
  });
}

double CurveBudget::top_speed() const {
  double top = kUnlimited;
  for (const CurveRow& r : rows()) {
    const double across = r.plane > 0 ? std::min(r.across, r.plane * curvature) : r.across;
    top = std::min({top, std::sqrt(1 / across), std::cbrt(1 / (r.rest + r.jerk * bend))});
  }
  return std::min(speed, kTopShare * top);
}

JerkRange CurveBudget::jerk_range(double cap, AtCap at_cap) const {
  const double most = bends() ? jerk_at(cap, *this) : kUnlimited;
  const double all = most < kUnlimited ? jerk_beside_all(cap, most, at_cap, *this) : most;
  return {all, most, acceleration_beside(cap, all, at_cap, *this)};
}

CurveShare CurveBudget::at(double cap, const JerkRange& range, double split, AtCap at_cap) const {
  if (!bends()) return along_line(*this);
  if (split == 0 && range.most < kUnlimited && range.beside_all > 0) return {range.acceleration, range.beside_all};
  double jerk = range.most;
  if (jerk < kUnlimited) {
    jerk = split > 0 ? range.beside_all + split * (range.most - range.beside_all) : (1 + split) * range.beside_all;
    if (!(jerk > 0)) jerk = kLeastJerk * range.most;  // turning takes all
  }
  const double under = acceleration_under(cap, jerk, at_cap, *this);
  return {acceleration_beside(cap, jerk, at_cap, *this, under), jerk};
}

void CurveBudgets::add(const CurveBudget& budget) {
  const auto first = static_cast<std::ptrdiff_t>(rows_.size());
  for (const CurveRow& row : budget.rows()) {
    const auto covers = [&](const CurveRow& other) { return is_never_less(other, row); };
    if (std::any_of(rows_.begin() + first, rows_.end(), covers)) continue;
    const auto covered = [&](const CurveRow& other) { return is_never_less(row, other); };
    rows_.erase(std::remove_if(rows_.begin() + first, rows_.end(), covered), rows_.end());
    rows_.push_back(row);
  }
  curves_.push_back({budget.speed, budget.curvature, budget.bend, rows_.size()});
}

CurveBudget CurveBudgets::operator[](std::size_t index) const {
  const Curve& curve = curves_[index];
  CurveBudget budget;
  budget.speed = curve.speed;
  budget.curvature = curve.curvature;
  budget.bend = curve.bend;
  const std::size_t begin = index > 0 ? curves_[index - 1].end : 0;
  budget.count = curve.end - begin;
  std::copy_n(rows_.begin() + static_cast<std::ptrdiff_t>(begin), budget.count, budget.row.begin());
  return budget;
}

Dynamics within(const Dynamics& along, const CurveShare& share) {
  const auto tight = [&share](const RampLimits& r) {
    return RampLimits{std::min(r.acceleration, share.acceleration), std::min(r.jerk, share.jerk), r.time};
  };
  return {tight(along.up), tight(along.down)};
}

CurveBudget curve_budget(const CurveBounds& b, const std::array<AxisLimits, kAxisCount>& axes) {
  CurveBudget budget;
  budget.curvature = b.curvature;
  budget.bend = b.bend;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const double first = b.first[i], second = b.second[i];
    if (first > 0) budget.speed = std::min(budget.speed, axes[k].speed / first);
    CurveRow one{};
    const double together = is_rotary(k) ? 0.0 : b.together[i];  // none: there is no right angle
    if (axes[k].acceleration < kUnlimited) {
      const double part = 1 / axes[k].acceleration;
      one.along = part * first, one.across = part * second, one.plane = part * together;
    }
    if (axes[k].jerk < kUnlimited) {
      const double part = 1 / axes[k].jerk, rest = b.third[i] - b.bend * first;
      one.jerk = part * first, one.turning = part * second, one.jerk_plane = part * together;
      if (rest > kRounding * b.third[i]) one.rest = part * rest;
    }
    if (first > 0 || second > 0 || b.third[i] > 0) budget.row[budget.count++] = one;
  }
  return budget;
}

}  // namespace toolpace
