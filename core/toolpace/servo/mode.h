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

struct ModeState {
  double place = 0, speed = 0;  ///< [mm, rad], [mm/s, rad/s]
};

/// A mode in a piece of motion: d̈ + 2ζω·ḋ + ω²·d = −a, in closed form (as a power series where it is shorter than a radian of the
/// mode), so errors are those of rounding: 1e-12 of the static deflection a/ω².
class ModePiece {
 public:
  ModePiece(double omega, double damping, const ModeState& begin, const AccelerationPolynomial& acceleration);

  /// @param t  [s] since the piece's begin, ≥ 0
  ModeState at(double t) const;

 private:
  double omega_, damping_;
  ModeState begin_;
  AccelerationPolynomial acceleration_, particular_;
};

/// How far the slide is from where its drive has it: the z − p of AxisServo.
class Mode {
 public:
  /// @param frequency [Hz] > 0; damping > 0, or 0 for none
  Mode(double frequency, double damping);

  /// A piece that begins now.
  ModePiece piece(const AccelerationPolynomial& acceleration) const { return {omega_, damping_, state_, acceleration}; }
  /// Goes on to a state of it.
  void set(const ModeState& state) { state_ = state; }
  /// Runs through a piece [s].
  void run(const AccelerationPolynomial& acceleration, double duration);
  /// A step of the drive's speed [mm/s].
  void step(double speed) { state_.speed -= speed; }

  double displacement() const { return state_.place; }
  double speed() const { return state_.speed; }
  /// Of the vibration that is left if the drive rests from now on.
  double amplitude() const;
  double omega() const { return omega_; }  ///< [rad/s]

 private:
  double omega_, damping_;
  ModeState state_;
};

/// A(jω) = ∫a(t)·e^(−jωt) dt over phases [mm/s], t from the first phase's begin: the residual of an undamped mode is |A|/ω.
/// Exact to 1e-12 of ∫|a|dt.
std::complex<double> acceleration_spectrum(std::span<const Phase> phases, double omega);

}  // namespace toolpace
