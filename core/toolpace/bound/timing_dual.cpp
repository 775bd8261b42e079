#include "toolpace/bound/timing_dual.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toolpace::detail {
namespace {

constexpr double kStart = 0.02, kFirstWeight = 1e-2, kLastWeight = 1e-5, kDecay = 0.3;  // of the barrier, in cells
constexpr int kMostIdle = 4, kMostSteps = 400, kMostShortenings = 30;
constexpr double kInside = 0.95, kShortening = 0.6, kGained = 5e-5, kGoodShare = 0.4;
constexpr std::size_t kSigns = 2, kKinds = 2;  // λ and μ, each as the difference of two that are not negative

/// min over b in (0, most] of e/√b + c·b, and its first two derivatives by e and c.
struct LeastTime {
  double value, by_e, by_c, ee = 0, ec = 0, cc = 0;

  LeastTime(double e, double c, double most) {
    const double free = c > 0 ? std::cbrt(e / (2 * c)) : std::numeric_limits<double>::infinity();
    const double b = std::min(free * free, most), root = 1 / std::sqrt(b);
    value = e * root + c * b;
    by_e = root;
    by_c = b;
    if (free * free >= most) return;
    ee = -root / (3 * e);
    ec = 2 * b / (3 * e);
    cc = -2 * b / (3 * c);
  }
};

}  // namespace

TimingDual::TimingDual(double cell, std::vector<TimingSample> samples, const TimingLimits& limits,
                       const std::vector<std::size_t>& joints)
    : cell_(cell),
      cells_(samples.size() / kCellPlaces.size()),
      group_(limits.rows * kKinds * kSigns),
      samples_(std::move(samples)),
      limits_(limits),
      is_closed_(cells_ + 2, 0) {
  for (const std::size_t j : joints) {
    for (std::size_t i = j; i < j + 3; ++i) is_closed_[i] = 1;
  }
  is_used_.assign(unknowns(), 0);
  for (std::size_t k = 0; k < cells_; ++k) {
    for_each_term(k, 0, [this](std::size_t i, double, double, double) { is_used_[i] = 1; });
  }
}

/// Calls f(unknown, e, c, cost): what one of the unknowns (as a multiple of 1/J or 1/A) adds at a place, negative signs last.
template <class F>
void TimingDual::for_each_term(std::size_t cell, std::size_t place, F&& f) const {
  const TimingSample& s = samples_[cell * kCellPlaces.size() + place];
  const double x = kCellPlaces[place], y = 1 - x, h = cell_;
  const double value[] = {y * y / 2, (1 + 2 * x * y) / 2, x * x / 2};
  const double slope[] = {-y / h, (1 - 2 * x) / h, x / h}, bend[] = {1 / (h * h), -2 / (h * h), 1 / (h * h)};
  const double hat[] = {y, x}, rise[] = {-1 / h, 1 / h};
  for (std::size_t r = 0; r < limits_.rows; ++r) {
    for (std::size_t i = 0; i < 3 && limits_.jerk[r] < std::numeric_limits<double>::infinity(); ++i) {
      if (is_closed_[cell + i]) continue;
      const double c = (s.first[r] * bend[i] - s.second[r] * slope[i]) / (2 * limits_.jerk[r]);
      const std::size_t at = (cell + i) * group_ + r * kKinds * kSigns;
      f(at, -value[i], c, 0.0);
      f(at + 1, -value[i], -c, 0.0);
    }
    for (std::size_t i = 0; i < 2 && limits_.acceleration[r] < std::numeric_limits<double>::infinity(); ++i) {
      const double c = (s.second[r] * hat[i] - s.first[r] * rise[i]) / (2 * limits_.acceleration[r]);
      const std::size_t at = (cell + i) * group_ + r * kKinds * kSigns + kSigns;
      f(at, 0.0, c, hat[i]);
      f(at + 1, 0.0, -c, hat[i]);
    }
  }
}

TimingDual::Value TimingDual::value(const std::vector<double>& x, double weight) const {
  constexpr double kOutside = -std::numeric_limits<double>::infinity();
  Value v{0, 0};
  for (std::size_t k = 0; k < cells_; ++k) {
    for (std::size_t q = 0; q < kCellPlaces.size(); ++q) {
      double e = 1, c = 0, cost = 0;
      for_each_term(k, q, [&](std::size_t i, double de, double dc, double price) {
        e += de * x[i];
        c += dc * x[i];
        cost += price * x[i];
      });
      if (!(e > 0)) return {kOutside, kOutside};
      const LeastTime least(e, c, samples_[k * kCellPlaces.size() + q].fastest);
      v.bound += kCellWeights[q] * cell_ * (least.value - cost);
      v.barrier += std::log(e);
    }
  }
  for (std::size_t i = 0; i < x.size(); ++i) v.barrier += is_used_[i] ? std::log(x[i]) : 0.0;
  v.barrier = v.bound + weight * cell_ * v.barrier;
  return v;
}

/// Gradient and the negative second derivatives: a band of three groups.
void TimingDual::assemble(const std::vector<double>& x, double weight) {
  const std::size_t n = unknowns(), width = 3 * group_;
  gradient_.assign(n, 0.0);
  band_.assign(n * width, 0.0);
  struct Term {
    std::size_t at;
    double e, c, cost;
  };
  std::vector<Term> terms;
  for (std::size_t k = 0; k < cells_; ++k) {
    for (std::size_t q = 0; q < kCellPlaces.size(); ++q) {
      terms.clear();
      double e = 1, c = 0;
      for_each_term(k, q, [&](std::size_t i, double de, double dc, double cost) {
        e += de * x[i];
        c += dc * x[i];
        terms.push_back({i, de, dc, cost});
      });
      LeastTime least(e, c, samples_[k * kCellPlaces.size() + q].fastest);
      const double w = kCellWeights[q] * cell_;
      least.by_e += weight / (kCellWeights[q] * e);
      least.ee -= weight / (kCellWeights[q] * e * e);
      for (const Term& a : terms) {
        gradient_[a.at] += w * (least.by_e * a.e + least.by_c * a.c - a.cost);
        const double pe = w * (least.ee * a.e + least.ec * a.c), pc = w * (least.ec * a.e + least.cc * a.c);
        if (pe == 0 && pc == 0) continue;
        for (const Term& b : terms) {
          if (b.at >= a.at) band_[a.at * width + (b.at - a.at)] -= pe * b.e + pc * b.c;
        }
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (is_used_[i]) gradient_[i] += weight * cell_ / x[i];
    band_[i * width] += weight * cell_ / (x[i] * x[i]);
  }
}

/// Newton's step by the LDLᵀ decomposition of the band.
bool TimingDual::solve() {
  const std::size_t n = unknowns(), width = 3 * group_;
  step_ = gradient_;
  for (std::size_t j = 0; j < n; ++j) {
    const double* row = band_.data() + j * width;
    if (!(row[0] > 0)) return false;
    const std::size_t last = std::min(width, n - j);
    for (std::size_t i = 1; i < last; ++i) {
      if (row[i] == 0) continue;
      const double l = row[i] / row[0];
      double* below = band_.data() + (j + i) * width;
      for (std::size_t k = i; k < last; ++k) below[k - i] -= l * row[k];
      step_[j + i] -= l * step_[j];
    }
  }
  for (std::size_t j = n; j-- > 0;) {
    const double* row = band_.data() + j * width;
    const std::size_t last = std::min(width, n - j);
    double sum = step_[j];
    for (std::size_t i = 1; i < last; ++i) sum -= row[i] * step_[j + i];
    step_[j] = sum / row[0];
  }
  return true;
}

double TimingDual::maximise() {
  std::vector<double> x(unknowns(), kStart / static_cast<double>(limits_.rows)), trial(x);
  double weight = kFirstWeight, best = 0;
  Value now = value(x, weight);
  int idle = 0;  // steps in a row that gained next to nothing
  for (int k = 0; k < kMostSteps; ++k) {
    assemble(x, weight);
    if (!solve()) break;
    double share = 1;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (step_[i] < 0) share = std::min(share, -kInside * x[i] / step_[i]);
    }
    Value next = now;
    bool moved = false;
    for (int s = 0; s < kMostShortenings && !moved; ++s, share *= kShortening) {
      for (std::size_t i = 0; i < x.size(); ++i) trial[i] = x[i] + share * step_[i];
      next = value(trial, weight);
      moved = next.barrier > now.barrier;
    }
    const double gain = moved ? next.barrier - now.barrier : 0;
    if (moved) {
      x.swap(trial);
      now = next;
      best = std::max(best, now.bound);
    }
    idle = gain > kGained * std::abs(now.bound) ? 0 : idle + 1;
    if (idle < (share > kGoodShare ? 1 : kMostIdle) && moved) continue;
    idle = 0;
    if (weight <= kLastWeight) break;
    weight = std::max(kLastWeight, weight * kDecay);
    now = value(x, weight);
  }
  return best;
}

}  // namespace toolpace::detail
