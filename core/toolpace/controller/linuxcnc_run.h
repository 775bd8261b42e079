#pragma once
/// LinuxCNC's queue of motion, run cycle by cycle of the servo thread.

#include <deque>

#include "toolpace/controller/linuxcnc_segment.h"
#include "toolpace/controller/tally.h"

namespace toolpace::detail::controller {

class LinuxcncRun {
 public:
  /// @param monitor  once it is cancelled, nothing more is run
  LinuxcncRun(const LinuxcncSettings& settings, const JointLimits& limits, Tally& tally, const Monitor& monitor)
      : limits_(limits),
        tally_(tally),
        monitor_(monitor),
        cycle_(settings.period),
        depth_(static_cast<std::size_t>(settings.depth)),
        cutoff_(settings.ramp_frequency > 0 ? 1.0 / settings.ramp_frequency : 0.0) {}

  void add(Segment segment);

  /// Runs all that is there, to rest.
  void finish();

 private:
  void run_first();
  void step();
  void run_regular(Segment& now, Segment* next);
  void skip_cruise(Segment& now, const Segment* next);
  void run_split(Segment& now, Segment* next);
  void update(Segment& now, const Segment* next);
  void check_end(Segment& now, const Segment* next) const;
  void activate(Segment& now);
  double final_speed(Segment& now, const Segment* next);
  double looked_ahead(std::size_t index) const;
  std::size_t index_of(const Segment& s) const { return &s == &queue_.front() ? 0 : 1; }
  Segment* at(std::size_t k) { return k < queue_.size() ? &queue_[k] : nullptr; }
  TimeLimit reason(const Segment& now, double before) const;

  JointLimits limits_;
  Tally& tally_;
  const Monitor& monitor_;
  double cycle_;
  std::size_t depth_;
  double cutoff_;  ///< [s] shorter segments are one ramp
  std::deque<Segment> queue_;
};

}  // namespace toolpace::detail::controller
