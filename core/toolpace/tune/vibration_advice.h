#pragma once
/// What keeps a machine that shakes from shaking, and what that costs: ramps whose times suit its modes, and shapers.

#include <memory>
#include <optional>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/pipeline/job.h"

namespace toolpace {

enum class CalmBy : std::uint8_t { nothing, five_phase, seven_phase, quintic, shaper };

struct CalmChoice {
  CalmBy by = CalmBy::nothing;
  std::shared_ptr<const Job> job;
  double cycle_time = 0;  ///< [s] of the setpoints
  double residual = 0;    ///< largest that a stop leaves on an axis [mm, deg]
};

struct VibrationAdvice {
  CalmChoice present;
  std::vector<CalmChoice> choices;  ///< one of each law, one of each shaper; by rising cycle time
  std::optional<std::size_t>
      best;  ///< the fastest of all that keeps the limit, unless the job does so anyway; without a limit the
             ///< one that leaves least
};

/// Ramp times, in order, at which a ramp leaves least behind, on all axes with modes, their damping counted: places of the smallest
/// residual of a ramp up to a speed, found by computing it. Of five-phase ramps (the whole ramp), of seven-phase ones (the rise of the
/// acceleration), of quintic ones (the whole ramp).
/// @param least  [s] none is shorter
std::vector<double> calm_times(CalmBy by, const std::array<ServoAxis, kAxisCount>& servo, double least);

/// Plans the job with each of the calm times that its limits allow (Tacc = Tdec; Jm = Jd, never above the job's), and with each shaper,
/// and measures what is left by vibration(). Of each kind the fastest that keeps the limit, or the one that leaves least.
/// @param limit  [mm, deg] > 0 for the residual, if given
/// Errors: of run() for the job as it is; usage: tune-no-resonance; cancelled
Result<VibrationAdvice> advise_on_vibration(const std::shared_ptr<const Job>& job, std::optional<double> limit,
                                            const Monitor& monitor = {});

}  // namespace toolpace
