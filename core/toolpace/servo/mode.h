#pragma once
/// The vibration of one mode of an axis over motions that are polynomials in time, exactly.

#include <array>
#include <complex>
#include <cstddef>
#include <span>

#include "toolpace/law/phase.h"

namespace toolpace {

inline constexpr std::size_t kAccelerationTerms = 6;
/// a(t) = Σ c[k]·t^k from the begin of a piece on.
using AccelerationPolynomial = std::array<double, kAccelerationTerms>;

/// Of a phase along its path. Exact for every law.
AccelerationPolynomial acceleration_of(const Phase& phase);

/// The polynomial through values at acceleration_places() of a piece, given in shares of its duration.
AccelerationPolynomial acceleration_through(const std::array<double, kAccelerationTerms>& values, double duration);
const std::array<double, kAccelerationTerms>& acceleration_places();

/// How far the slide is from where its drive has it: d̈ + 2ζω·ḋ + ω²·d = −a, the z − p of AxisServo. Each piece is solved in
/// closed form (as a power series where it is shorter than a radian of the mode), so errors are those of rounding:
/// 1e-12 of the static deflection a/ω².
class Mode {
 public:
  /// @param frequency [Hz] > 0; damping > 0, or 0 for none
  Mode(double frequency, double damping);

  /// Runs through a piece [s]. Its largest |d| is found between its samples, too: where ḋ changes its sign.
  void run(const AccelerationPolynomial& acceleration, double duration);
  /// A step of the drive's speed [mm/s].
  void step(double speed) { speed_ -= speed; }

  double displacement() const { return place_; }
  double speed() const { return speed_; }
  /// Largest |d| so far, and when [s] since the begin.
  double peak() const { return peak_; }
  double peak_time() const { return peak_time_; }
  double time() const { return time_; }
  /// Of the vibration that is left if the drive rests from now on.
  double amplitude() const;

 private:
  struct State {
    double place, speed;
  };
  State at(const AccelerationPolynomial& particular, const AccelerationPolynomial& a, State begin, double t) const;
  State free_at(State begin, double t) const;
  AccelerationPolynomial particular_of(const AccelerationPolynomial& a) const;
  void look_for_peak(const AccelerationPolynomial& particular, const AccelerationPolynomial& a, double duration);

  double omega_, damping_;
  double place_ = 0, speed_ = 0, time_ = 0, peak_ = 0, peak_time_ = 0;
};

/// A(jω) = ∫a(t)·e^(−jωt) dt over phases [mm/s], t from the first phase's begin: the residual of an undamped mode is |A|/ω.
/// Exact to 1e-12 of ∫|a|dt.
std::complex<double> acceleration_spectrum(std::span<const Phase> phases, double omega);

}  // namespace toolpace
