#include "toolpace/servo/mode_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "toolpace/servo/find_modes.h"

namespace toolpace {
namespace {

constexpr double kQuiet = 0.1;       // of the loudest part, that a recording has died away to at its end
constexpr std::size_t kParts = 20;   // of a recording, that are compared
constexpr double kHannError = 1.39;  // √(35/18): neighbours under Hann's window are correlated
constexpr std::size_t kFewestBins = 12;
constexpr int kFitRounds = 80;
constexpr double kEnough = 1e-10;  // of the likelihood

double mean_of(const std::vector<double>& s) {
  double sum = 0;
  for (const double x : s) sum += x;
  return sum / static_cast<double>(s.size());
}

double hann(std::size_t i, std::size_t count) {
  const double s = std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
  return s * s;
}

std::vector<double> squares_of_transform(std::vector<double>& samples) {
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> out;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  fft.fwd(out, samples);
  std::vector<double> squares;
  for (const auto& value : out) squares.push_back(std::norm(value));
  return squares;
}

/// log A, log f₀, log ζ, γ, log B.
using Parameters = Eigen::Matrix<double, 5, 1>;
using Information = Eigen::Matrix<double, 5, 5>;

/// Whittle's likelihood in a band.
class Likelihood {
 public:
  Likelihood(const detail::Periodogram& whole, std::size_t begin, std::size_t end)
      : whole_(whole), begin_(begin), end_(end) {}

  /// Its negative logarithm, its slope and what it tells of the parameters.
  double at(const Parameters& v, Parameters& slope, Information& information) const {
    slope.setZero();
    information.setZero();
    double sum = 0;
    const double f0 = std::exp(v[1]), zeta = std::exp(v[2]), floor = std::exp(v[4]);
    for (std::size_t i = begin_; i < end_; ++i) {
      const double r = static_cast<double>(i) * whole_.resolution() / f0, r2 = r * r, z2 = 4 * zeta * zeta;
      const double d = (1 - r2) * (1 - r2) + z2 * r2, beside = 2 * zeta * (1 - r2);
      const double n = z2 + v[3] * beside, scale = std::exp(v[0]) / d, model = scale * n + floor;
      if (!(model > 0)) return INFINITY;
      Parameters g;
      g << scale * n, scale * (2 * zeta * v[3] * 2 * r2 - n * (4 * r2 * (1 - r2) - 2 * z2 * r2) / d),
          scale * (2 * z2 + v[3] * beside - n * 2 * z2 * r2 / d), scale * beside, floor;
      g /= model;
      const double ratio = whole_.power()[i] / model;
      sum += std::log(model) + ratio;
      slope += (1 - ratio) * g;
      information += g * g.transpose();
    }
    return sum;
  }

 private:
  const detail::Periodogram& whole_;
  std::size_t begin_, end_;
};

/// Scoring with damping: steps that do not help are made shorter.
Parameters best_of(const Likelihood& likelihood, Parameters v, Information& information) {
  Parameters slope;
  double value = likelihood.at(v, slope, information), damp = 1e-3;
  for (int round = 0; round < kFitRounds; ++round) {
    Information damped = information;
    damped.diagonal() *= 1 + damp;
    damped.diagonal().array() += 1e-9;
    const Parameters step = damped.ldlt().solve(slope).cwiseMax(-0.5).cwiseMin(0.5);
    Parameters next_slope;
    Information next_information;
    const Parameters next = v - step;
    const double there = likelihood.at(next, next_slope, next_information);
    if (!(there < value)) {
      damp *= 8;
      if (damp > 1e9) break;
      continue;
    }
    const bool is_enough = value - there < kEnough * std::max(1.0, std::abs(value));
    v = next, value = there, slope = next_slope, information = next_information;
    damp = std::max(damp / 4, 1e-9);
    if (is_enough) break;
  }
  return v;
}

}  // namespace

PowerSpectrum power_spectrum(const std::vector<double>& samples, double period, std::size_t length) {
  PowerSpectrum spectrum{1 / (static_cast<double>(length) * period), std::vector<double>(length / 2 + 1, 0.0)};
  double weight = 0;
  for (std::size_t i = 0; i < length; ++i) weight += hann(i, length) * hann(i, length);
  std::size_t segments = 0;
  for (std::size_t begin = 0; begin + length <= samples.size();
       begin += std::max<std::size_t>(1, length / 2), ++segments) {
    std::vector<double> part(samples.begin() + static_cast<std::ptrdiff_t>(begin),
                             samples.begin() + static_cast<std::ptrdiff_t>(begin + length));
    const double mean = mean_of(part);
    for (std::size_t i = 0; i < length; ++i) part[i] = (part[i] - mean) * hann(i, length);
    const std::vector<double> squares = squares_of_transform(part);
    for (std::size_t i = 0; i < spectrum.power.size(); ++i) spectrum.power[i] += squares[i];
  }
  for (std::size_t i = 0; i < spectrum.power.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == spectrum.power.size();
    spectrum.power[i] *= (is_end ? 1 : 2) * period / (weight * static_cast<double>(segments));
  }
  return spectrum;
}

namespace detail {

Periodogram::Periodogram(const std::vector<double>& samples, double period) {
  const std::size_t count = samples.size() - samples.size() % 2;
  const double mean = mean_of(samples);
  std::vector<double> signal(count);
  for (std::size_t i = 0; i < count; ++i) signal[i] = samples[i] - mean;
  std::vector<double> loudness(kParts, 0.0);
  for (std::size_t i = 0; i < count; ++i) loudness[i * kParts / count] += signal[i] * signal[i];
  const double loudest = *std::max_element(loudness.begin(), loudness.end());
  if (loudness.back() > kQuiet * kQuiet * loudest) {
    for (std::size_t i = 0; i < count; ++i) signal[i] *= hann(i, count);
    error_factor_ = kHannError;
  }
  resolution_ = 1 / (static_cast<double>(count) * period);
  power_ = squares_of_transform(signal);
}

std::optional<ModeFit> fit_mode(const Periodogram& whole, FitBand band, double frequency, double damping) {
  const double bin = whole.resolution();
  const auto begin = static_cast<std::size_t>(std::max(1.0, std::ceil(band.low / bin)));
  const auto end = std::min(whole.power().size(), static_cast<std::size_t>(std::floor(band.high / bin)) + 1);
  if (end < begin + kFewestBins) return std::nullopt;
  double highest = 0, lowest = INFINITY;
  for (std::size_t i = begin; i < end; ++i) {
    highest = std::max(highest, whole.power()[i]);
    lowest = std::min(lowest, whole.power()[i]);
  }
  if (!(highest > 0)) return std::nullopt;
  const double top = std::log(highest), bottom = std::max(std::log(std::max(lowest, 1e-300)), top - 14);
  Parameters start;
  start << top - 0.5, std::log(frequency), std::log(damping), 0.0, bottom;
  Information information;
  const Parameters v = best_of(Likelihood(whole, begin, end), start, information);
  const ModeFit fit = {std::exp(v[1]), std::exp(v[2]), std::exp(v[0]), 0, 0};
  if (!(fit.frequency > band.low && fit.frequency < band.high && fit.damping < 0.7)) return std::nullopt;
  information.diagonal().array() += 1e-9;
  const Information spread = information.inverse();
  ModeFit result = fit;
  result.frequency_error = fit.frequency * std::sqrt(std::max(0.0, spread(1, 1))) * whole.error_factor();
  result.damping_error = fit.damping * std::sqrt(std::max(0.0, spread(2, 2))) * whole.error_factor();
  return result;
}

}  // namespace detail
}  // namespace toolpace
