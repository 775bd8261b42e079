#pragma once
/// What the values of a drive may be.

namespace toolpace {

/// Values that the simulation is true for. It steps the exact solution over a period T, by the exponential of a matrix of
/// size 2π·f·T: beyond 1e5 Hz nothing of the drive is left to see in a period, and digits are lost with the size.
struct ServoRange {
  double least, most;        ///< both included
  bool may_be_zero = false;  ///< 0 too: none
};
inline constexpr ServoRange kServoGain = {1e-3, 1e5};             ///< Kv [1/s]
inline constexpr ServoRange kServoBandwidth = {1e-2, 1e5};        ///< [Hz]
inline constexpr ServoRange kServoResonance = {1e-2, 1e5, true};  ///< [Hz]
inline constexpr ServoRange kServoDamping = {1e-3, 1e2};          ///< of the velocity loop and of modes
inline constexpr ServoRange kServoMode = {1e-2, 1e5};             ///< [Hz] of a mode beside the resonance
inline constexpr ServoRange kServoShare = {1e-3, 1};              ///< of a mode

}  // namespace toolpace
