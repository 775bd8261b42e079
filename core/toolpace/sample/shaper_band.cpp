#include "toolpace/sample/shaper_band.h"

namespace toolpace {
namespace {

constexpr double kBandStep = 1e-3, kHighestShare = 3;
constexpr int kBandHalvings = 40;

}  // namespace

ShaperBand shaper_band(const Impulses& impulses, double frequency, double damping, double most) {
  const auto keeps = [&](double share) { return residual_share(impulses, share * frequency, damping) <= most; };
  // EI shapers leave as much as is allowed at the frequency itself: rounding apart.
  if (!(residual_share(impulses, frequency, damping) <= most * (1 + 1e-6))) return {};
  const auto edge = [&](double step) {
    double inside = 1;
    for (double share = 1 + step; share > 0 && share < kHighestShare; share += step) {
      if (!keeps(share)) {
        double outside = share;
        for (int k = 0; k < kBandHalvings; ++k) {
          const double middle = (inside + outside) / 2;
          (keeps(middle) ? inside : outside) = middle;
        }
        return inside;
      }
      inside = share;
    }
    return inside;
  };
  return {edge(-kBandStep), edge(kBandStep)};
}

}  // namespace toolpace
