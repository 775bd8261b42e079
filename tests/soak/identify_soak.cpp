/// Identification, many times: random drives in noisy traces, and how often their values are found again.

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "noisy_axis.h"

namespace {

using namespace toolpace;

constexpr double kNoise = 0.0005;      // [mm]
constexpr std::size_t kRows = 12'000;  // 12 s at 1 kHz

struct Tally {
  int inside = 0, close = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const int runs = argc > 1 ? std::atoi(argv[1]) : 100, first = argc > 2 ? std::atoi(argv[2]) : 1;
  std::array<Tally, 8> tally;
  for (int seed = first; seed < first + runs; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    const ServoAxis a = test::random_drive(random);
    const std::array<double, 8> truth = {
        a.position_gain, a.velocity_feed_forward, a.acceleration_feed_forward, a.bandwidth, a.damping, a.backlash,
        a.resonance,     a.resonance_damping};
    const auto found = identify_axis(test::noisy_axis(a, random, kRows, kNoise), {});
    std::printf("seed %d, noise %.6f mm\n", seed, found ? found->noise : NAN);
    for (std::size_t i = 0; found && i < truth.size(); ++i) {
      const IdentifiedValue& v = found->values[i];
      const double off = v.value - truth[i];
      tally[i].inside += v.is_told && std::abs(off) <= 3 * v.error;
      // Gain within 1 %, resonance within 0.5 %, backlash within 1 µm; the others within 5 %.
      const double least = i == 5 ? 0.001 : truth[i] * (i == 0 ? 0.01 : i == 6 ? 0.005 : 0.05);
      tally[i].close += v.is_told && std::abs(off) <= least;
      if (std::abs(off) > 3 * v.error || !v.is_told)
        std::printf("  %s: %.6g ± %.2g where %.6g is true\n", kIdentifiedNames[i], v.value, v.error, truth[i]);
    }
    std::fflush(stdout);
  }
  bool fine = true;
  for (std::size_t i = 0; i < tally.size(); ++i) {
    std::printf("%-26s within three standard errors %d of %d, close %d\n", kIdentifiedNames[i], tally[i].inside, runs,
                tally[i].close);
    fine = fine && tally[i].inside >= 0.95 * runs && ((i != 0 && i != 5 && i != 6) || tally[i].close >= 0.95 * runs);
  }
  return fine ? 0 : 1;
}
