#include "plan_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "places.h"
#include "polylines.h"
#include "toolpace/nc/reader.h"

namespace toolpace::test {
namespace {

using Point = std::array<double, 3>;

double norm(const Point& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

double corner_cap(const Point& u, const Point& w, const PolylineRules& rules) {
  const Point step = {w[0] - u[0], w[1] - u[1], w[2] - u[2]};
  if (rules.corner_step) return *rules.corner_step / std::max(norm(step), 1e-12);
  if (!rules.servo_acceleration) return std::numeric_limits<double>::infinity();
  // |w − u| = 2·sin(α/2) covers the angle rule; each axis alone is weaker under equal limits.
  return *rules.servo_acceleration * rules.period / std::max(norm(step), 1e-12);
}

double axis_share(double limit, const Point& u) {
  const double largest = std::max({std::abs(u[0]), std::abs(u[1]), std::abs(u[2])});
  return limit > 0 ? limit / largest : std::numeric_limits<double>::infinity();
}

Dynamics block_dynamics(const Point& u, const PolylineRules& rules) {
  Dynamics d = rules.dynamics;
  for (RampLimits* r : {&d.up, &d.down}) {
    r->acceleration = std::min(r->acceleration, axis_share(rules.axis_acceleration, u));
    r->jerk = std::min(r->jerk, axis_share(rules.axis_jerk, u));
  }
  return d;
}

void finish(SpeedLimits& limits) {
  const std::size_t n = limits.size();
  limits.node_cap[0] = limits.node_cap[n] = 0;
  limits.block_cause.assign(n, Cause::feed);
  limits.node_cause.assign(n + 1, Cause::corner);
  limits.node_cause[0] = limits.node_cause[n] = Cause::stop;
}

}  // namespace

Dynamics symmetric(double acceleration, double jerk, double time) {
  const RampLimits r{acceleration, jerk, time};
  return {r, r};
}

SpeedLimits line_of(const std::vector<double>& length, const std::vector<double>& feed, const Dynamics& dynamics) {
  SpeedLimits limits;
  limits.length = length;
  limits.block_cap = feed;
  limits.ramp.assign(length.size(), 0);
  limits.node_cap.assign(length.size() + 1, std::numeric_limits<double>::infinity());
  limits.dynamics = {dynamics};
  finish(limits);
  return limits;
}

SpeedLimits ning_blocks(const Dynamics& dynamics) {
  const auto reading = read_file(source_dir() / "examples/nc/blocks20.ngc");
  if (!reading) throw std::runtime_error(reading.error().message);
  std::vector<double> length, feed;
  for (std::size_t i = 0; i < reading->moves.size(); ++i) {
    if (reading->moves.kind[i] != MoveKind::feed) continue;
    length.push_back((reading->moves.end[i] - reading->moves.begin_of(i)).norm());
    feed.push_back(reading->moves.feed[i]);
  }
  return line_of(length, feed, dynamics);
}

SpeedLimits limits_of(const Polyline& polyline, const PolylineRules& rules, std::size_t repeat) {
  SpeedLimits limits;
  std::vector<Point> unit;
  for (std::size_t round = 0; round < repeat; ++round) {
    for (std::size_t i = 1; i < polyline.points.size(); ++i) {
      const Point& a = polyline.points[i - 1];
      const Point& b = polyline.points[i];
      const Point d = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
      const double length = norm(d);
      if (!(length > 1e-9)) continue;
      const Point u = {d[0] / length, d[1] / length, d[2] / length};
      limits.length.push_back(length);
      limits.block_cap.push_back(std::min(polyline.feed[i], axis_share(rules.axis_speed, u)));
      limits.node_cap.push_back(unit.empty() ? 0.0 : corner_cap(unit.back(), u, rules));
      unit.push_back(u);
      const Dynamics own = block_dynamics(u, rules);
      if (limits.dynamics.empty() || !(limits.dynamics.back() == own)) limits.dynamics.push_back(own);
      limits.ramp.push_back(static_cast<std::uint32_t>(limits.dynamics.size() - 1));
    }
  }
  limits.node_cap.push_back(0.0);
  finish(limits);
  return limits;
}

namespace {

/// Numbers that are the same on every platform.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double uniform(double a, double b) { return a + (b - a) * (static_cast<double>(random_() >> 11) * 0x1p-53); }
  double log_uniform(double a, double b) { return std::exp(uniform(std::log(a), std::log(b))); }
  std::uint64_t below(std::uint64_t n) { return random_() % n; }

 private:
  std::mt19937_64 random_;
};

}  // namespace

SpeedLimits with_reversals(SpeedLimits limits, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (std::uint32_t node = 1; node < limits.size(); ++node) {
    if (random() % 3 == 0) limits.reversals.push_back(node);
  }
  return limits;
}

SpeedLimits wild_chain(std::uint64_t seed) {
  Draw draw(seed);
  const double mm = draw.log_uniform(1e-3, 1e3), s = draw.log_uniform(0.1, 10);
  const auto ramp = [&] {
    return RampLimits{draw.log_uniform(1, 1e5) * mm / s / s, draw.log_uniform(10, 1e9) * mm / s / s / s,
                      draw.log_uniform(1e-4, 1) * s};
  };
  SpeedLimits limits;
  const std::size_t kinds = draw.below(3) == 0 ? 3 : 1;
  for (std::size_t k = 0; k < kinds; ++k) {
    const RampLimits up = ramp();
    limits.dynamics.push_back({up, draw.below(3) == 0 ? ramp() : up});
  }
  const std::size_t blocks = 1 + draw.below(draw.below(4) == 0 ? 200 : 12);
  const double scale = draw.log_uniform(1e-4, 100);
  for (std::size_t i = 0; i < blocks; ++i) {
    const bool odd = draw.below(5) == 0;
    limits.length.push_back(mm * (odd ? draw.log_uniform(1e-6, 1e3) : draw.log_uniform(scale * 0.1, scale * 10)));
    limits.block_cap.push_back(mm / s * (draw.below(3) > 0 ? 100 : draw.log_uniform(0.01, 1000)));
    limits.ramp.push_back(static_cast<std::uint32_t>(draw.below(kinds)));
    const bool free = draw.below(3) > 0, rest = draw.below(9) == 0;
    limits.node_cap.push_back(free ? 1e300 : rest ? 0.0 : draw.log_uniform(1e-3, 300) * mm / s);
  }
  limits.node_cap.push_back(0.0);
  finish(limits);
  return limits;
}

SpeedLimits random_chain(std::uint64_t seed, std::size_t blocks, bool mixed_dynamics) {
  Draw draw(seed);
  const auto log_uniform = [&](double low, double high) { return draw.log_uniform(low, high); };
  const auto random = [&] { return draw.below(~std::uint64_t{0}); };
  const auto dynamics = [&] {
    Dynamics d = symmetric(log_uniform(50, 2e4), log_uniform(1e3, 1e7), log_uniform(1e-3, 0.2));
    if (random() % 2 == 0) d.down = {log_uniform(50, 2e4), log_uniform(1e3, 1e7), log_uniform(1e-3, 0.2)};
    return d;
  };
  SpeedLimits limits;
  limits.dynamics = {dynamics()};
  for (std::size_t k = 0; mixed_dynamics && k < 5; ++k) limits.dynamics.push_back(dynamics());
  const double scale = log_uniform(1e-3, 5), top = log_uniform(1, 500);
  const auto style = random() % 4;
  double feed = top, length = scale;
  std::uint32_t ramp = 0;
  for (std::size_t i = 0; i < blocks; ++i) {
    if (style == 0 || random() % 8 == 0) length = log_uniform(scale * 1e-2, scale * 10);
    if (style == 1 ? random() % 3 == 0 : random() % 20 == 0) feed = log_uniform(top * 0.05, top);
    if (random() % 6 == 0) ramp = static_cast<std::uint32_t>(random() % limits.dynamics.size());
    limits.length.push_back(length);
    limits.block_cap.push_back(feed);
    limits.ramp.push_back(ramp);
    const bool collinear = style == 2 ? random() % 16 != 0 : random() % 2 == 0;
    double cap = collinear ? std::numeric_limits<double>::infinity() : log_uniform(top * 0.01, top * 2);
    if (random() % 60 == 0) cap = 0;
    limits.node_cap.push_back(cap);
  }
  limits.node_cap.push_back(0.0);
  finish(limits);
  return limits;
}

}  // namespace toolpace::test
