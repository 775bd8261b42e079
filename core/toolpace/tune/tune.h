#pragma once
/// The best settings for a job on its machine: cycle time against contour error and vibration.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/tune/pareto.h"
#include "toolpace/tune/tuning_space.h"

namespace toolpace {

struct TuneOptions {
  std::vector<Knob> turned = {kAllKnobs.begin(), kAllKnobs.end()};
  /// [mm] > 0: the largest contour error through the drives that the best may have; nothing = that of the job as it is.
  std::optional<double> contour = {};
  /// The same for the largest residual vibration of an axis [mm, deg].
  std::optional<double> vibration = {};
  std::size_t plans = 200;  ///< that may be made, ≥ 1
  std::function<bool()> is_over =
      {};  ///< asked before each batch of plans, if given: ends the search with what there is
};

/// A job that was tried.
struct Tuned {
  std::shared_ptr<const Job> job;
  Objectives objectives;
};

struct TuneResult {
  std::size_t plans = 0;            ///< that were made, those included that could not be
  Tuned present;                    ///< the job as it is
  std::vector<Tuned> front;         ///< by rising cycle time; none dominates another
  std::size_t knee = 0;             ///< index into `front`
  std::optional<std::size_t> best;  ///< index into `front`: the fastest within the limits; nothing where none is
  FlawLimits limits;                ///< that `best` keeps; without a resonance none on vibration
};

/// Of what asks about vibration where no axis has a mode.
Error no_resonance_error();

/// Plans the job again and again with other settings (TuningSpace), runs each plan through the machine's drives (follow()) and, where an
/// axis has a resonance, through that (vibration()), and keeps those that nothing beats. What these give for a job of the front is what
/// stands there, to the bit. Where to look next:
/// Search. Plans that a known one dominates anyway are not followed to their end.
/// On all cores; the same job and options give the same result whatever their number, if `is_over` does.
/// Errors: of run() and follow() for the job as it is; "tune-no-resonance" (usage) for a limit on vibration where no axis has one;
/// cancelled.
Result<TuneResult> tune(const std::shared_ptr<const Job>& job, const TuneOptions& options, const Monitor& monitor = {});

/// The same for settings that somebody else chose: all of them are tried. Positions of `space`.
Result<TuneResult> tune_by_list(const TuningSpace& space, const std::vector<Position>& list, const TuneOptions& options,
                                const Monitor& monitor = {});

}  // namespace toolpace
