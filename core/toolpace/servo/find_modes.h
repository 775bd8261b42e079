#pragma once
/// What an accelerometer felt -> the modes of the axis that it rode on.

#include <vector>

#include "toolpace/base/result.h"
#include "toolpace/limits/servo_axis.h"

namespace toolpace {

inline constexpr std::size_t kFewestAccelerations = 512;  ///< rows that modes are looked for in

/// Mean power by frequency, after Welch: segments that overlap by half, each less its mean, under Hann's window.
struct PowerSpectrum {
  double resolution = 0;      ///< [Hz] between two values; the first one is of 0 Hz
  std::vector<double> power;  ///< one-sided density [unit²/Hz]
};

/// @param samples  at least two
/// @param length   of a segment: a power of two, at most as many as samples
/// @source Welch, "The use of fast Fourier transform for the estimation of power spectra", 1967
PowerSpectrum power_spectrum(const std::vector<double>& samples, double period, std::size_t length);

struct FoundMode {
  AxisMode
      mode;  ///< the shares are relative to the strongest mode, whose is 1, where what shook them is as strong at all frequencies
  double frequency_error = 0, damping_error = 0;  ///< standard errors, of noise that shakes; [Hz], of the damping
  double half_power_damping = 0;  ///< from the width of Welch's peak at half its power, less the window's
  double rise = 0;                ///< of the peak over what is usual around it, as a factor of power
};

/// What was looked at, and found.
struct FoundModes {
  PowerSpectrum spectrum;
  std::vector<FoundMode> modes;  ///< by rising frequency
  std::vector<double>
      tones;  ///< [Hz] of peaks as narrow as the recording lets them be: a fan, a spindle, mains; no modes
};

/// Looks for peaks that stand out of Welch's spectrum by a factor of eight, up to 0.4 of the rate, six at most, and fits to each of
/// them power(f) = A·(4ζ² + γ·2ζ(1 − r²))/((1 − r²)² + 4ζ²r²) + B, r = f/f₀, in the spectrum of the whole recording (Whittle's
/// likelihood); γ is what else shakes in time with it: the axis itself, and the flanks of other modes.
/// It starts from the width at half power. True for recordings of taps (a ring-down), of slow sweeps, and under noise that shakes.
/// @param samples  accelerations at an even period [s], ≥ kFewestAccelerations; any unit
/// Errors: input: accelerometer-still (no signal), accelerometer-saturated.
/// @source Fano, "Effects of configuration interaction on intensities and phase shifts", 1961, for the form of the peak; Whittle, "Estimation and information in stationary time series", 1953; Olivero, Longbothum, "Empirical fits to the Voigt
/// line width", 1977, for what the window adds to a width
Result<FoundModes> find_modes(const std::vector<double>& samples, double period);

}  // namespace toolpace
