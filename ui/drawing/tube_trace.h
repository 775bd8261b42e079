#pragma once
/// Where the planned motion runs inside the tolerance around the programmed path, setpoint by setpoint.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

/// Row k belongs to the setpoint at time[k]. XYZ in mm.
struct TubeTrace {
  std::vector<double> time;                 ///< [s], ascending
  std::vector<Eigen::Vector3f> programmed;  ///< the place on the programmed path that the setpoint is matched to
  std::vector<Eigen::Vector3f> offset;      ///< planned minus programmed
  std::vector<float> tolerance;             ///< in force there, of the job or of G64 P; 0 = the path is to be kept
  double largest_share = 0;                 ///< of a tolerance that is used
  double largest_offset = 0;                ///< [mm]
  std::size_t worst = 0;                    ///< row of the largest share

  std::size_t size() const { return time.size(); }
  /// Distance from the programmed path as a share of the tolerance; 0 where there is none.
  double share(std::size_t row) const;
  /// Row at or before a time; nothing outside the trace.
  std::optional<std::size_t> row_at(double time) const;
};

/// True for a plan that may leave the programmed path: rounded corners by the job's rule or by G64 P.
bool leaves_programmed_path(const Outcome& outcome);

/// Follows the programmed path with the plan's setpoints, in order, so that strokes that cross or pass close by do not
/// count. Null for plans that stay on the path, and when cancelled. Call it on the worker.
std::shared_ptr<const TubeTrace> make_tube_trace(const Outcome& outcome, const Monitor& monitor = {});

}  // namespace toolpace::ui
