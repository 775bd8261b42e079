#include "drawing/vibration_trace.h"

#include <algorithm>

#include "toolpace/pipeline/sampled.h"
#include "toolpace/servo/vibration.h"

namespace toolpace::ui {

std::shared_ptr<const VibrationTrace> make_vibration_trace(const Outcome& outcome, const Monitor& monitor) {
  const auto& servo = outcome.job->machine.servo;
  if (std::all_of(servo.begin(), servo.end(), is_stiff)) return nullptr;
  auto trace = std::make_shared<VibrationTrace>();
  VibrationWatch watch;
  watch.step = std::max(outcome.job->machine.period, setpoints_duration(outcome) / kMostInstants);
  watch.take = [&](const AxisVector& row) {
    trace->time.push_back(static_cast<double>(trace->time.size()) * watch.step);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (!is_stiff(servo[axis]))
        trace->displacement[axis].push_back(static_cast<float>(row[static_cast<Eigen::Index>(axis)]));
    }
  };
  const auto found =
      vibration(*outcome.path, outcome.plan, outcome.node_time, servo, impulses_of(outcome), monitor, watch);
  if (!found || trace->time.empty()) return nullptr;
  return trace;
}

}  // namespace toolpace::ui
