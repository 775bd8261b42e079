#pragma once
/// A stretch between places of rest or of constant speed, timed anew under the axes' own limits.

#include <span>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/limits/machine.h"
#include "toolpace/path/path.h"
#include "toolpace/plan/retime/arc_motion.h"
#include "toolpace/plan/retime/path_sampler.h"
#include "toolpace/plan/retime/window_retimer.h"

namespace toolpace::detail::retime {

/// Limits along the path; may be infinite.
struct AlongLimits {
  double acceleration, jerk;  ///< [mm/s², mm/s³]
};

/// What a stretch runs along, and at most how fast.
struct StretchTask {
  const Path& path;
  const std::array<AxisLimits, kAxisCount>& axes;
  const AlongLimits& along;
  const std::vector<double>& speed;   ///< commanded, of each segment [mm/s]
  const std::vector<double>& corner;  ///< at each node [mm/s]; infinite for none
  std::size_t begin, end;             ///< segments begin … end − 1
};

/// Rounds of faster (in windows that move by half from round to round) and slower, until every limit is kept everywhere.
class StretchRetimer {
 public:
  explicit StretchRetimer(const StretchTask& task);

  /// @param start  a motion about within the limits
  /// @return with the same speeds at its ends; empty when cancelled, or where the limits cannot be kept with these speeds
  ArcMotion run(const ArcMotion& start, const Monitor& monitor);

  /// One round of faster.
  struct Hurry {
    double weight;   ///< of the barrier
    int samples;     ///< an interval
    bool is_slowed;  ///< whether what breaks limits is mended before: from there the barrier keeps them
  };

 private:
  ArcMotion run(ArcMotion motion, std::span<const Hurry> hurries, const Monitor& monitor);
  struct Sample;
  void set_limits(double step, double share);
  void measure(const ArcMotion& motion, int samples);
  void measure_interval(const ArcMotion& motion, std::size_t k, int samples, PathSampler& sampler);
  double corner_ratio(const ArcMotion& motion, std::size_t k, const PathSampler& sampler) const;
  double find_peaks(const ArcMotion& motion);
  double peak_of_interval(const ArcMotion& motion, std::size_t k, PathSampler& sampler) const;
  double peak_of_piece(const ArcMotion& motion, std::size_t k, double from, double to, PathSampler& sampler) const;
  Sample sample(const ArcMotion::State& state, const PathSampler& sampler) const;
  template <int rows>
  Sample sample_along(const ArcMotion::State& state, const PathSampler& sampler,
                      const CurveDerivatives<rows>& derivatives) const;
  ArcMotion hurry(const ArcMotion& motion, int round, double weight);
  ArcMotion resample(const ArcMotion& motion) const;
  void slow_down(ArcMotion& motion);

  StretchTask task_;
  std::vector<std::size_t> axes_;  // that move
  bool is_limited_along_;
  StepLimits limits_;
  std::vector<IntervalUse> use_;
  std::vector<double> excess_;  // of each interval: by how much time has to be stretched there, or unknown
  std::vector<double> b_;
  WindowRetimer window_;
};

}  // namespace toolpace::detail::retime
