#include "toolpace/plan/retime/window_retimer.h"

#include <algorithm>
#include <cmath>

namespace toolpace::detail::retime {
namespace {

constexpr double kFirstWeight = 0.02, kWeightDecay = 0.4;
constexpr double kUrgent = 30;   // times the weight, for rows that are broken
constexpr double kRoom = 1.001;  // of what a broken row uses
constexpr double kAnyRoom = 1e30;
constexpr double kNearBoundary = 0.95;  // of the way to a limit that a step may go
constexpr double kShortening = 0.6;
constexpr int kMostShortenings = 12, kMostSteps = 60;
constexpr double kLeastSquare = 0.05, kMostSlowing = 0.3;  // of b, and of b before the step
constexpr double kGoodStep = 0.3, kSettledChange = 1e-3;
constexpr double kTie = 1e4;
constexpr std::size_t kTied = 5;  // coefficients at a rest: a start at full jerk stays a polynomial

using Triple = std::array<double, 3>;
constexpr Triple kValue = {0.125, 0.75, 0.125}, kSlope = {-0.5, 0, 0.5}, kBend = {1, -2, 1};

double dot(const Triple& w, const double* b) { return w[0] * b[0] + w[1] * b[1] + w[2] * b[2]; }

}  // namespace

/// Uses of the limits in the middle of an interval, from the three coefficients there.
struct WindowRetimer::Rows {
  double value, slope, bend, root;

  explicit Rows(const double* b)
      : value(dot(kValue, b)), slope(dot(kSlope, b)), bend(dot(kBend, b)), root(std::sqrt(value)) {}

  double acceleration(const IntervalUse& u, std::size_t a) const {
    return u.second[a] * value + u.first[a] / 2 * slope;
  }
  /// Jerk over √b.
  double linear_jerk(const IntervalUse& u, std::size_t a) const {
    return u.third[a] * value + 1.5 * u.second[a] * slope + 0.5 * u.first[a] * bend;
  }
  double jerk(const IntervalUse& u, std::size_t a) const { return root * linear_jerk(u, a); }
};

/// Gradient and second derivatives by the three coefficients of an interval.
struct WindowRetimer::Cell {
  Triple g{};
  double h00 = 0, h01 = 0, h02 = 0, h11 = 0, h12 = 0, h22 = 0;

  /// A term f(r) with first and second derivative f′, f″, r linear with derivatives d.
  void add(double first, double second, const Triple& d) {
    for (std::size_t i = 0; i < 3; ++i) g[i] += first * d[i];
    const double s0 = second * d[0], s1 = second * d[1];
    h00 += s0 * d[0];
    h01 += s0 * d[1];
    h02 += s0 * d[2];
    h11 += s1 * d[1];
    h12 += s1 * d[2];
    h22 += second * d[2] * d[2];
  }

  /// −log(1 − use²).
  void add_limit(double use, double weight, const Triple& d) {
    const double left = 1 / (1 - use * use);
    add(weight * 2 * use * left, weight * 2 * (1 + use * use) * left * left, d);
  }
};

void WindowRetimer::find_room() {
  const std::size_t axes = limits_->count;
  for (std::size_t k = 0; k < count_; ++k) {
    const Rows rows(b_.data() + k);
    for (std::size_t a = 0; a < axes; ++a) {
      double* room = room_.data() + (k * axes + a) * 2;
      const double x = std::abs(rows.acceleration(use_[k], a)) / limits_->acceleration[a];
      const double y = std::abs(rows.jerk(use_[k], a)) / limits_->jerk[a];
      room[0] = std::min(room[0], std::max(1.0, x * kRoom));
      room[1] = std::min(room[1], std::max(1.0, y * kRoom));
    }
  }
}

void WindowRetimer::add_interval(std::size_t k, double weight, Cell& cell) const {
  const Rows rows(b_.data() + k);
  const IntervalUse& u = use_[k];
  const double inverse = 1 / rows.value, time = inverse * rows.root;
  const double left = 1 / (u.fastest - rows.value);
  cell.add(-0.5 * time * inverse + weight * left, 0.75 * time * inverse * inverse + weight * left * left, kValue);
  for (std::size_t a = 0; a < limits_->count; ++a) {
    const double* room = room_.data() + (k * limits_->count + a) * 2;
    const double by_acceleration = 1 / (limits_->acceleration[a] * room[0]);
    if (by_acceleration > 0) {
      const double p2 = u.second[a] * by_acceleration, p1 = 0.5 * u.first[a] * by_acceleration;
      cell.add_limit(p2 * rows.value + p1 * rows.slope, room[0] > 1 ? kUrgent * weight : weight,
                     {p2 * 0.125 - p1 * 0.5, p2 * 0.75, p2 * 0.125 + p1 * 0.5});
    }
    const double by_jerk = 1 / (limits_->jerk[a] * room[1]);
    if (by_jerk > 0) {
      const double linear = rows.linear_jerk(u, a) * by_jerk, scale = rows.root * by_jerk;
      const double p3 = u.third[a] * scale + linear / (2 * rows.root);  // √b changes too
      const double p2 = 1.5 * u.second[a] * scale, p1 = 0.5 * u.first[a] * scale;
      cell.add_limit(linear * rows.root, room[1] > 1 ? kUrgent * weight : weight,
                     {p3 * 0.125 - p2 * 0.5 + p1, p3 * 0.75 - 2 * p1, p3 * 0.125 + p2 * 0.5 + p1});
    }
  }
}

void WindowRetimer::assemble(double weight) {
  std::fill(gradient_.begin(), gradient_.end(), 0.0);
  std::fill(band_.begin(), band_.end(), Triple{});
  for (std::size_t k = 0; k < count_; ++k) {
    Cell cell;
    add_interval(k, weight, cell);
    for (std::size_t i = 0; i < 3; ++i) gradient_[k + i] += cell.g[i];
    band_[k][0] += cell.h00;
    band_[k][1] += cell.h01;
    band_[k][2] += cell.h02;
    band_[k + 1][0] += cell.h11;
    band_[k + 1][1] += cell.h12;
    band_[k + 2][0] += cell.h22;
  }
  for (std::size_t j = 0; j < kTied && j < count_ / 2; ++j) {
    if (!pinned_begin_) tie(j);
    if (!pinned_end_) tie(count_ - j);
  }
  const std::size_t n = count_ + 2;
  if (pinned_begin_) pin(0), pin(1);
  if (pinned_end_) pin(n - 1), pin(n - 2);
}

void WindowRetimer::tie(std::size_t j) {
  const double difference = b_[j] - b_[j + 1];
  gradient_[j] += kTie * difference;
  gradient_[j + 1] -= kTie * difference;
  band_[j][0] += kTie;
  band_[j + 1][0] += kTie;
  band_[j][1] -= kTie;
}

void WindowRetimer::pin(std::size_t j) {
  gradient_[j] = 0;
  band_[j] = {1, 0, 0};
  if (j >= 1) band_[j - 1][1] = 0;
  if (j >= 2) band_[j - 2][2] = 0;
}

/// Newton's step by the LDLᵀ decomposition.
bool WindowRetimer::solve() {
  const std::size_t n = count_ + 2;
  for (std::size_t j = 0; j < n; ++j) {
    const double d = band_[j][0];
    if (!(d > 0)) return false;
    const double l1 = band_[j][1] / d, l2 = band_[j][2] / d;
    if (j + 1 < n) {
      band_[j + 1][0] -= l1 * band_[j][1];
      band_[j + 1][1] -= l1 * band_[j][2];
      gradient_[j + 1] -= l1 * gradient_[j];
    }
    if (j + 2 < n) {
      band_[j + 2][0] -= l2 * band_[j][2];
      gradient_[j + 2] -= l2 * gradient_[j];
    }
  }
  for (std::size_t j = n; j-- > 0;) {
    double sum = -gradient_[j];
    if (j + 1 < n) sum -= band_[j][1] * step_[j + 1];
    if (j + 2 < n) sum -= band_[j][2] * step_[j + 2];
    step_[j] = sum / band_[j][0];
  }
  return true;
}

bool WindowRetimer::keeps_limits(std::size_t k, double share) const {
  const double* b = b_.data() + k;
  const Triple trial = {b[0] + share * step_[k], b[1] + share * step_[k + 1], b[2] + share * step_[k + 2]};
  const Rows before(b);
  const double lowest = std::min({dot(kValue, trial.data()), (trial[0] + trial[1]) / 2, (trial[1] + trial[2]) / 2});
  if (!(lowest > std::max(kLeastSquare, kMostSlowing * before.value))) return false;
  const Rows after(trial.data());
  const IntervalUse& u = use_[k];
  if (!(after.value < before.value + kNearBoundary * (u.fastest - before.value))) return false;
  const auto keeps = [](double from, double to, double limit) {
    const double use = std::abs(from);
    return std::abs(to) <= use + kNearBoundary * (limit - use);
  };
  for (std::size_t a = 0; a < limits_->count; ++a) {
    const double* room = room_.data() + (k * limits_->count + a) * 2;
    if (!keeps(before.acceleration(u, a), after.acceleration(u, a), limits_->acceleration[a] * room[0])) return false;
    if (!keeps(before.jerk(u, a), after.jerk(u, a), limits_->jerk[a] * room[1])) return false;
  }
  return true;
}

/// Largest tried share of the step that keeps all limits; 0 for none.
double WindowRetimer::longest_step() const {
  double share = 1;
  std::size_t kept = 0;  // intervals in a row, from `k` on and around, that this share suits
  int shortenings = 0;
  for (std::size_t k = 0; kept < count_; k = k + 1 < count_ ? k + 1 : 0, ++kept) {
    while (!keeps_limits(k, share)) {
      if (++shortenings > kMostShortenings) return 0;
      share *= kShortening;
      kept = 0;
    }
  }
  return share;
}

const std::vector<double>& WindowRetimer::run(const IntervalUse* use, std::size_t count, const StepLimits& limits,
                                              bool pinned_begin, bool pinned_end, double last_weight) {
  use_ = use;
  count_ = count;
  limits_ = &limits;
  pinned_begin_ = pinned_begin;
  pinned_end_ = pinned_end;
  const std::size_t n = count + 2;
  b_.assign(n, 1.0);
  gradient_.resize(n);
  step_.resize(n);
  band_.resize(n);
  room_.assign(count * limits.count * 2, kAnyRoom);
  double weight = kFirstWeight;
  for (int k = 0; k < kMostSteps; ++k) {
    find_room();
    assemble(weight);
    if (!solve()) break;
    const double share = longest_step();
    double change = 0;
    for (std::size_t j = 0; j < n; ++j) {
      b_[j] += share * step_[j];
      change = std::max(change, std::abs(share * step_[j]));
    }
    const bool good = share > kGoodStep || change < kSettledChange;
    if (share == 0 || (weight <= last_weight && good)) break;
    if (good) weight = std::max(weight * kWeightDecay, last_weight);
  }
  return b_;
}

}  // namespace toolpace::detail::retime
