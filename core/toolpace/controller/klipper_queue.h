#pragma once
/// Klipper's look-ahead.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "toolpace/controller/tally.h"

namespace toolpace::detail::controller {

/// Squares of speeds [mm²/s²], lengths [mm].
struct KlipperMove {
  Eigen::Vector3d direction;
  double length, acceleration;
  double max_cruise2;
  double delta2;         ///< what the length can change at full acceleration
  double smooth_delta2;  ///< at the lower one of the second pass
  double junction_deviation;
  double extrusion;      ///< [mm] of filament a mm of way, negative where it is drawn back; ±1 of the extruder alone
  double extruder_step;  ///< [mm/s] by which the extruder's speed may jump between two moves
  bool is_extruder_alone;
  double max_start2, max_smoothed2;
  std::uint32_t row;
  bool is_rapid, starts_at_corner;
  TimeLimit cruise;
};

/// Holds moves until nothing that comes later can change them, and runs them.
/// @source Klipper, klippy/toolhead.py: Move.calc_junction(), LookAheadQueue.flush()
class KlipperQueue {
 public:
  explicit KlipperQueue(Tally& tally) : tally_(tally) {}

  void add(KlipperMove move, double junction_deviation);

  /// Runs all that is there, to rest.
  void finish() {
    flush(false);
    moves_.clear();
    first_ = 0;
  }

 private:
  /// Speeds of a move as it is run.
  struct Speeds {
    double start2, cruise2, end2;
  };

  void join(const KlipperMove& before, KlipperMove& move) const;
  void flush(bool lazy);
  void run(std::size_t count);

  Tally& tally_;
  std::vector<KlipperMove> moves_;
  std::size_t first_ = 0;  ///< of moves_, the first one that was not run
  std::size_t flush_at_ = 0;
  std::vector<Speeds> speeds_;
};

}  // namespace toolpace::detail::controller
