#pragma once
/// Input shapers: commands that leave no vibration behind.
///
/// The command is convolved with a few impulses, whose answers of a mode cancel each other. Impulses are positive and sum to one, and all
/// axes get the same ones: each setpoint is then a mean of planned ones, so no axis and no speed, acceleration or jerk vector becomes
/// larger, straight lines stay straight, and what is rounded are corners and curves.

#include <array>
#include <string_view>
#include <vector>

#include "toolpace/base/axes.h"
#include "toolpace/limits/servo_axis.h"
#include "toolpace/plan/options.h"

namespace toolpace {

struct Impulse {
  double time;   ///< [s] ≥ 0 after the command
  double share;  ///< > 0; shares sum to 1
};
/// By rising time, the first at 0.
using Impulses = std::vector<Impulse>;

inline constexpr ShaperKind kShaperKinds[] = {ShaperKind::none, ShaperKind::zv, ShaperKind::zvd,
                                              ShaperKind::mzv,  ShaperKind::ei, ShaperKind::two_hump};

/// As flags call it: none, zv, zvd, mzv, ei, 2hump.
std::string_view shaper_name(ShaperKind kind);

/// For one mode. ZV and ZVD leave nothing at the frequency itself; EI and two-hump EI without damping 5 %, and no more over a wide band.
/// @param frequency  of the undamped mode [Hz] > 0
/// @param damping    0 ≤ ζ < 1
/// @source Singer, Seering, "Preshaping command inputs to reduce system vibration", 1990 (ZV, ZVD); Singhose, Seering, Singer,
/// "Residual vibration reduction using vector diagrams to generate shaped inputs", 1994 (EI); Singhose, Porter, Tuttle, Singer,
/// "Vibration reduction using multi-hump input shapers", 1997 (two-hump EI, undamped); Klipper, "Resonance compensation" (MZV).
/// With damping the impulses of the last three are those of the undamped mode, scaled by its decay.
Impulses shaper_for(ShaperKind kind, double frequency, double damping);

/// What is shaped for: every mode of every axis, whatever its share, those apart that do not swing (damping 1 and more). Modes of the
/// same frequency and damping count once.
std::vector<AxisMode> shaped_modes(const std::array<ServoAxis, kAxisCount>& servo);

/// For these, one after another. {0, 1} alone where there is none.
Impulses shaping(ShaperKind kind, const std::array<ServoAxis, kAxisCount>& servo);

/// By how much a shaped motion lasts longer [s].
inline double duration_of(const Impulses& impulses) { return impulses.back().time; }

/// Around which a shaped motion lies beside the planned one [s].
double mean_delay(const Impulses& impulses);

/// What is left of a mode's vibration, as a share of that without shaping: of a step, after the last impulse.
/// @source Singer, Seering 1990, eq. (4)
double residual_share(const Impulses& impulses, double frequency, double damping);

}  // namespace toolpace
