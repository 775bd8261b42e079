#pragma once
/// The fastest way from one speed cap to another.

#include <cstdint>

#include "toolpace/plan/span/kernel.h"

namespace toolpace::detail {

enum class BridgeKind : std::uint8_t {
  peak,           ///< up to a peak and down
  rise,           ///< up to the bottom of the far kernel, a plateau
  fall,           ///< down from the bottom of the near kernel, a plateau
  rising_flank,   ///< up, and across the far kernel with acceleration left over
  falling_flank,  ///< down, leaving the near kernel with deceleration already
  far_is_idle,    ///< the far kernel cannot be reached: it does not matter
  near_is_idle    ///< the near kernel cannot be left fast enough: it does not matter
};

struct Bridge {
  double leave = 0.0;                      ///< acceleration on leaving the near kernel [mm/s²]
  double meet = 0.0;                       ///< acceleration on meeting the far one [mm/s²]
  ExactPlace leave_at = {}, meet_at = {};  ///< ends of the bottoms' parts that are used [mm]
  double peak = 0.0;  ///< speed in which both ramps end [mm/s]; of flanks the one they would end in
  BridgeKind kind = BridgeKind::far_is_idle;
};

/// Bridge between two kernels, `far` behind `near`.
///
/// With U the peak acceleration of a ramp of dv, R its length: R_up(m_i, vp) + R_down(m_k, vp) = gap gives the peak; a flank
/// solves R(m_i, vp) − (m_k + vp)·y/J = gap, vp = m_k + y²/J, for the acceleration y left over when it meets the kernel.
/// Bounded Newton steps from above, or within a bracket; lengths are met to about 1e-15 of the gap.
Bridge bridge(const Kernel& near, const Kernel& far, const SpanLimits& limits);

}  // namespace toolpace::detail
