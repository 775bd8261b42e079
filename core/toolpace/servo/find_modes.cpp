#include "toolpace/servo/find_modes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "toolpace/base/numbers.h"
#include "toolpace/servo/mode_fit.h"
#include "toolpace/servo/servo_range.h"

namespace toolpace {
namespace {

constexpr std::size_t kMostModes = 6;
constexpr std::size_t kSegments = 5;       // times the length of one that fit into a recording: nine, overlapping
constexpr double kRise = 8;                // over what is usual around
constexpr double kFaintest = 1e-4;         // of the highest peak's power
constexpr double kAround = 1.6;            // factor of frequency, up and down
constexpr double kHighest = 0.4;           // of the rate
constexpr double kLeastBins = 3;           // that the lowest mode is from 0 Hz
constexpr double kHannWidth = 1.44;        // at half power, in bins
constexpr double kApart = 0.1;             // of its frequency, that the next mode is away at least
constexpr double kNarrowest = 1.5;         // widths of a bin of the whole recording: narrower is a tone
constexpr std::size_t kFewestClipped = 4;  // rows in a row at the end of the range
constexpr double kSteepest = 8;            // steps of the recorder

Error accelerometer_error(const char* code, std::string message, std::string remedy) {
  return {ErrorKind::input, code, std::move(message), std::move(remedy), {}, {}};
}

/// The smallest difference between neighbours: the step in which the recorder counts.
double quantum_of(const std::vector<double>& s) {
  double least = INFINITY;
  for (std::size_t i = 1; i < s.size(); ++i) {
    if (s[i] != s[i - 1]) least = std::min(least, std::abs(s[i] - s[i - 1]));
  }
  return least;
}

/// Rows that stand at one end of the range as cut off. A peak that is no wider than the recorder's steps make it falls by four of them
/// in as many rows again; one that was cut off falls faster.
std::size_t cut_rows(const std::vector<double>& s, double end, double quantum) {
  std::size_t cut = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s[i] != end) continue;
    std::size_t last = i;
    while (last + 1 < s.size() && s[last + 1] == end) ++last;
    const std::size_t rows = last - i + 1, beyond = rows / 2;
    if (rows >= kFewestClipped && i >= beyond && last + beyond < s.size()) {
      const double falls = std::abs(s[i - beyond] - end) + std::abs(s[last + beyond] - end);
      if (falls > 2 * kSteepest * quantum) cut += rows;
    }
    i = last;
  }
  return cut;
}

Result<void> check_signal(const std::vector<double>& s) {
  const auto [low, high] = std::minmax_element(s.begin(), s.end());
  const double range = *high - *low;
  if (!(range > 1e-12 * std::max(std::abs(*low), std::abs(*high)))) {
    return tl::unexpected(accelerometer_error("accelerometer-still", "the accelerometer felt nothing",
                                              "record while the axis is shaken or tapped"));
  }
  const double quantum = quantum_of(s);
  if (cut_rows(s, *low, quantum) + cut_rows(s, *high, quantum) >= 2 * kFewestClipped) {
    return tl::unexpected(accelerometer_error("accelerometer-saturated", "the accelerometer is saturated",
                                              "shake less, or give it a larger range"));
  }
  return {};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Peak {
  double frequency, width, power, rise;  ///< [Hz], at half power [Hz]
};

class PeakSearch {
 public:
  explicit PeakSearch(const PowerSpectrum& s) : s_(s) {}

  /// The highest first.
  std::vector<Peak> peaks() const {
    std::vector<Peak> found;
    const auto begin = static_cast<std::size_t>(kLeastBins);
    const auto end = static_cast<std::size_t>(2 * kHighest * static_cast<double>(s_.power.size() - 1));
    double highest = 0;
    for (std::size_t i = begin; i < end; ++i) highest = std::max(highest, s_.power[i]);
    for (std::size_t i = begin; i < end; ++i) {
      if (!is_highest_around(i) || s_.power[i] < kFaintest * highest) continue;
      const double rise = s_.power[i] / usual_around(i);
      if (rise >= kRise) found.push_back({static_cast<double>(i) * s_.resolution, width_of(i), s_.power[i], rise});
    }
    std::sort(found.begin(), found.end(), [](const Peak& a, const Peak& b) { return a.power > b.power; });
    return found;
  }

 private:
  bool is_highest_around(std::size_t i) const {
    const auto reach = std::max<std::size_t>(2, static_cast<std::size_t>(kApart * static_cast<double>(i)));
    for (std::size_t k = i - std::min(i, reach); k <= std::min(i + reach, s_.power.size() - 1); ++k) {
      if (s_.power[k] > s_.power[i] || (s_.power[k] == s_.power[i] && k < i)) return false;
    }
    return true;
  }
  double usual_around(std::size_t i) const {
    const auto f = static_cast<double>(i);
    const auto low = static_cast<std::size_t>(f / kAround);
    const auto high = std::min(s_.power.size() - 1, std::max(i + 6, static_cast<std::size_t>(f * kAround)));
    return median({s_.power.begin() + static_cast<std::ptrdiff_t>(low > 2 ? low : 1),
                   s_.power.begin() + static_cast<std::ptrdiff_t>(high) + 1});
  }
  /// Between the places where half the power is passed, on straight lines from bin to bin.
  double width_of(std::size_t i) const {
    const double half = s_.power[i] / 2;
    const auto side = [&](int step) {
      std::size_t k = i;
      while (k > 0 && k + 1 < s_.power.size() && s_.power[k] > half) k = step > 0 ? k + 1 : k - 1;
      const std::size_t inner = step > 0 ? k - 1 : k + 1;
      const double share = (s_.power[inner] - half) / std::max(s_.power[inner] - s_.power[k], 1e-300);
      return std::abs(static_cast<double>(inner) - static_cast<double>(i)) + std::clamp(share, 0.0, 1.0);
    };
    return (side(1) + side(-1)) * s_.resolution;
  }

  const PowerSpectrum& s_;
};

/// Of a peak of Lorentz whose picture under a window of width `window` is `seen` wide.
double width_without(double window, double seen) {
  if (seen <= window) return 0.05 * window;
  double low = 0, high = seen;
  for (int i = 0; i < 60; ++i) {
    const double width = (low + high) / 2;
    (0.5346 * width + std::sqrt(0.2166 * width * width + window * window) < seen ? low : high) = width;
  }
  return std::max(low, 0.05 * window);
}

/// How far a fit may look: to the middle between it and its neighbours.
detail::FitBand band_of(const Peak& peak, const std::vector<Peak>& all, double damping) {
  const double reach = std::clamp(8 * damping, 0.08, 0.4);
  detail::FitBand band = {peak.frequency * (1 - reach), peak.frequency * (1 + reach)};
  for (const Peak& other : all) {
    const double middle = (other.frequency + peak.frequency) / 2;
    if (other.frequency < peak.frequency) band.low = std::max(band.low, middle);
    if (other.frequency > peak.frequency) band.high = std::min(band.high, middle);
  }
  return band;
}

}  // namespace

Result<FoundModes> find_modes(const std::vector<double>& samples, double period) {
  if (auto fine = check_signal(samples); !fine) return tl::unexpected(fine.error());
  std::size_t length = 128;
  while (length * 2 * kSegments <= samples.size()) length *= 2;
  FoundModes found;
  found.spectrum = power_spectrum(samples, period, length);
  std::vector<Peak> peaks = PeakSearch(found.spectrum).peaks();
  if (peaks.size() > kMostModes) peaks.resize(kMostModes);
  const detail::Periodogram whole(samples, period);
  std::vector<double> weights;  // of the modes' displacements: 2ζ·√(power at the peak)
  for (const Peak& peak : peaks) {
    const double width = width_without(kHannWidth * found.spectrum.resolution, peak.width);
    const double damping = std::clamp(width / (2 * peak.frequency), kServoDamping.least, 0.5);
    const auto fit = detail::fit_mode(whole, band_of(peak, peaks, damping), peak.frequency, damping);
    if (!fit) continue;
    const bool is_tone =
        2 * fit->damping * fit->frequency < kNarrowest * whole.resolution() || fit->damping < kServoDamping.least;
    if (is_tone) {
      found.tones.push_back(fit->frequency);
      continue;
    }
    found.modes.push_back(
        {{fit->frequency, fit->damping, 1.0}, fit->frequency_error, fit->damping_error, damping, peak.rise});
    weights.push_back(2 * fit->damping * std::sqrt(fit->power));
  }
  const double largest = weights.empty() ? 1.0 : *std::max_element(weights.begin(), weights.end());
  for (std::size_t i = 0; i < weights.size(); ++i)
    found.modes[i].mode.share = std::clamp(weights[i] / largest, kServoShare.least, kServoShare.most);
  const auto by_frequency = [](const FoundMode& a, const FoundMode& b) { return a.mode.frequency < b.mode.frequency; };
  std::sort(found.modes.begin(), found.modes.end(), by_frequency);
  std::sort(found.tones.begin(), found.tones.end());
  return found;
}

}  // namespace toolpace
