#include "toolpace/sample/shaper.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace toolpace {
namespace {

constexpr double kLeft = 0.05;       // of the vibration, that EI shapers leave at their frequency
constexpr double kSameTime = 1e-12;  // [s]

/// Shares at even steps of the damped period, each scaled by the decay up to it.
Impulses scaled(const std::vector<double>& shares, double step_of_period, double frequency, double damping) {
  const double root = std::sqrt(1 - damping * damping), period = 1 / (frequency * root);
  const double decay = std::exp(-2 * std::numbers::pi * step_of_period * damping / root);
  Impulses impulses;
  double sum = 0, scale = 1;
  for (std::size_t i = 0; i < shares.size(); ++i, scale *= decay) {
    impulses.push_back({static_cast<double>(i) * step_of_period * period, shares[i] * scale});
    sum += shares[i] * scale;
  }
  for (Impulse& i : impulses) i.share /= sum;
  return impulses;
}

Impulses one_after_another(const Impulses& first, const Impulses& second) {
  Impulses both;
  for (const Impulse& a : first) {
    for (const Impulse& b : second) both.push_back({a.time + b.time, a.share * b.share});
  }
  std::sort(both.begin(), both.end(), [](const Impulse& a, const Impulse& b) { return a.time < b.time; });
  Impulses merged;
  for (const Impulse& i : both) {
    if (!merged.empty() && i.time - merged.back().time < kSameTime) {
      merged.back().share += i.share;
    } else {
      merged.push_back(i);
    }
  }
  return merged;
}

}  // namespace

std::string_view shaper_name(ShaperKind kind) {
  switch (kind) {
    case ShaperKind::zv: return "zv";
    case ShaperKind::zvd: return "zvd";
    case ShaperKind::mzv: return "mzv";
    case ShaperKind::ei: return "ei";
    case ShaperKind::two_hump: return "2hump";
    default: return "none";
  }
}

Impulses shaper_for(ShaperKind kind, double frequency, double damping) {
  switch (kind) {
    case ShaperKind::zv: return scaled({1, 1}, 0.5, frequency, damping);
    case ShaperKind::zvd: return scaled({1, 2, 1}, 0.5, frequency, damping);
    case ShaperKind::mzv: {
      const double outer = 1 - std::numbers::sqrt2 / 2;
      return scaled({outer, std::numbers::sqrt2 - 1, outer}, 0.375, frequency, damping);
    }
    case ShaperKind::ei: return scaled({1 + kLeft, 2 * (1 - kLeft), 1 + kLeft}, 0.5, frequency, damping);
    case ShaperKind::two_hump: {
      const double x = std::cbrt(kLeft * kLeft * (std::sqrt(1 - kLeft * kLeft) + 1));
      const double outer = (3 * x * x + 2 * x + 3 * kLeft * kLeft) / (16 * x);
      return scaled({outer, 0.5 - outer, 0.5 - outer, outer}, 0.5, frequency, damping);
    }
    default: return {{0, 1}};
  }
}

std::vector<AxisMode> shaped_modes(const std::array<ServoAxis, kAxisCount>& servo) {
  std::vector<AxisMode> shaped;
  for (const ServoAxis& axis : servo) {
    for (const AxisMode& mode : modes_of(axis)) {
      const bool is_there = std::any_of(shaped.begin(), shaped.end(), [&](const AxisMode& m) {
        return m.frequency == mode.frequency && m.damping == mode.damping;
      });
      if (mode.damping < 1 && !is_there) shaped.push_back(mode);
    }
  }
  return shaped;
}

Impulses shaping(ShaperKind kind, const std::array<ServoAxis, kAxisCount>& servo) {
  Impulses impulses = {{0, 1}};
  for (const AxisMode& mode : shaped_modes(servo))
    impulses = one_after_another(impulses, shaper_for(kind, mode.frequency, mode.damping));
  return impulses;
}

double mean_delay(const Impulses& impulses) {
  double mean = 0;
  for (const Impulse& i : impulses) mean += i.share * i.time;
  return mean;
}

double residual_share(const Impulses& impulses, double frequency, double damping) {
  const double omega = 2 * std::numbers::pi * frequency, damped = omega * std::sqrt(1 - damping * damping);
  std::complex<double> sum = 0;
  for (const Impulse& i : impulses) sum += i.share * std::exp(std::complex(damping * omega, damped) * i.time);
  return std::abs(sum) * std::exp(-damping * omega * impulses.back().time);
}

}  // namespace toolpace
