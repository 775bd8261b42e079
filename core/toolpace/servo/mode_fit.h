#pragma once
/// One mode fitted to a spectrum.

#include <optional>
#include <vector>

namespace toolpace::detail {

/// Of a whole recording. One that has died away at its end is taken as it is, another one under Hann's window.
class Periodogram {
 public:
  Periodogram(const std::vector<double>& samples, double period);
  double resolution() const { return resolution_; }  ///< [Hz]
  const std::vector<double>& power() const { return power_; }
  /// By how much scatter is larger than that of independent bins, as a factor of standard errors.
  double error_factor() const { return error_factor_; }

 private:
  double resolution_ = 0, error_factor_ = 1;
  std::vector<double> power_;
};

struct FitBand {
  double low, high;  ///< [Hz]
};

struct ModeFit {
  double frequency, damping, power;  ///< power at the peak
  double frequency_error, damping_error;
};

/// From a frequency and a damping near by. Nothing where the band has too few bins, or the best is no peak inside it.
std::optional<ModeFit> fit_mode(const Periodogram& whole, FitBand band, double frequency, double damping);

}  // namespace toolpace::detail
