#pragma once
/// One move from a speed to a speed over a length: ramp, cruise, ramp.
///
/// The peak speed is the largest v ≤ feed with d(start→v) + d(v→end) ≤ length; the rest of the length is cruised at it.
///
/// ERRATA of Zheng et al. 2014, whose eqs. (11)–(29) this generalises to every law:
/// - Table 2 prints fmax = 91.1893 for its second move. Eq. (27) gives 92.666667, and only that agrees with the
///   jerks and accelerations of the same table.
/// - Five-phase by time has a gap. Eq. (27) can give an fmax below the higher end speed; used as it stands, eq. (29)
///   then has negative jerk in the "acceleration" phase. Here the one ramp that is needed is run alone and the rest
///   cruised at the higher speed, if (fs+fe)/2·T ≤ L; otherwise the exit speed cannot be reached, which is an error.
///
/// ERRATUM of the seven-phase text: t1 = a/J, t2 = v/a − a/J, t4 = (s − s_acc − s_dec)/v hold only where every phase
/// exists and both ends stand still; here every phase may vanish and the end speeds are free.

#include <cmath>
#include <utility>

#include "toolpace/base/result.h"
#include "toolpace/law/law.h"
#include "toolpace/law/law_table.h"
#include "toolpace/law/peak_speed.h"
#include "toolpace/law/phase_list.h"

namespace toolpace {

/// One of the two ramps of a move.
struct MoveRamp {
  double length = 0.0;             ///< [mm]
  double time = 0.0;               ///< [s]
  double peak_acceleration = 0.0;  ///< magnitude [mm/s²]
  double peak_jerk = 0.0;          ///< magnitude [mm/s³]; infinite where the law does not bound it
};

struct SingleMove {
  PhaseList phases;           ///< those that exist, without gaps; not in order of kind but of time
  double peak = 0.0;          ///< highest speed [mm/s], ≤ feed
  bool reaches_feed = false;  ///< peak is the feed
  MoveRamp up, down;          ///< from the start to the peak, from the peak to the end
  double cruise_time = 0.0;   ///< [s]
  double total_time() const { return up.time + cruise_time + down.time; }
};

/// Checks everything a move needs: finite numbers, 0 or 1e-30 … 1e30; 0 ≤ start, end ≤ feed, feed > 0; limits > 0 (they
/// may be infinite) and times ≥ 0; and that the end speed can be reached.
/// @return the error: kind usage for numbers that make no sense, kind infeasible for an end speed that cannot be
///         reached within the length (attainable = the nearest one that can; the message says which length would do)
std::optional<Error> check_move(LawKind law, const MoveRequest& move, const Dynamics& dynamics);

namespace detail {

/// A peak and the durations of the ramps to it and from it.
struct FittedPeak {
  double speed, up_time, down_time;
};

/// peak_speed(), less the last ulp where a ramp that changes the speed by hardly more would be too long with them.
FittedPeak fitting_peak(const MoveRequest& move, const MoveTerms& terms);

template <class Law>
MoveRamp write_move_ramp(const SpeedChange& ramp, const RampLimits& limits, PhaseList& phases) {
  const RampPeaks peaks = Law::peaks(std::abs(ramp.to - ramp.from), ramp.time, limits);
  Law::write_ramp(ramp, limits, phases);
  return {(ramp.from + ramp.to) / 2 * ramp.time, ramp.time, peaks.acceleration, peaks.jerk};
}

template <class Law>
void fill_move(const MoveRequest& move, const Dynamics& dynamics, SingleMove& result) {
  const MoveTerms terms = move_terms<Law>(dynamics);
  const auto [peak, up_time, down_time] = fitting_peak(move, terms);
  result.peak = peak;
  result.reaches_feed = peak >= move.feed;
  result.up = write_move_ramp<Law>({move.start, peak, up_time}, dynamics.up, result.phases);
  const double cruise = move.length - result.up.length - (peak + move.end) / 2 * down_time;
  // Rounding may leave a cruise of either sign where none is meant.
  if (cruise > 1e-14 * move.length && peak > 0) {
    result.cruise_time = cruise / peak;
    RampCursor cursor = end_of(result.phases);
    append_piece({result.cruise_time, peak, 0.0, 0.0}, cursor, result.phases);
  }
  result.down = write_move_ramp<Law>({peak, move.end, down_time}, dynamics.down, result.phases);
}

}  // namespace detail

/// The move of least time under a law, or why there is none. See check_move() for the errors. Closed form or bounded
/// iteration (see peak_speed()), no heap. Distances and speeds are exact to 1e-12 relative.
/// @source Zheng et al. 2014, eqs. (11)–(29); Ning et al. 2014, section 2; the seven-phase text (docs/SOURCES.md)
template <VelocityLaw Law>
Result<SingleMove> single_move(const MoveRequest& move, const Dynamics& dynamics) {
  Result<SingleMove> result{tl::in_place};  // the one object that is returned: nothing is copied
  if (auto error = check_move(Law::kKind, move, dynamics)) {
    result = tl::make_unexpected(std::move(*error));
  } else {
    detail::fill_move<Law>(move, dynamics, *result);
  }
  return result;
}

/// The same for a law that is known at run time.
Result<SingleMove> single_move(LawKind law, const MoveRequest& move, const Dynamics& dynamics);

}  // namespace toolpace
