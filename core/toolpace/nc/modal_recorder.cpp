#include "toolpace/nc/modal_recorder.h"

namespace toolpace::nc {

void ModalRecorder::record(const State& state, const Flow& flow) {
  const Modal& m = state.modal;
  const bool in_order = flow.turns() == 0 && flow.depth() == 0;
  if (in_order && last_ == m && last_tool_ == state.loaded.number && places_.empty()) return;
  last_ = m;
  last_tool_ = state.loaded.number;
  ModalSnapshot s;
  s.motion = m.motion;
  s.plane = m.plane;
  s.units = m.units;
  s.distance = m.distance;
  s.arc_distance = m.arc_distance;
  s.feed_mode = m.feed_mode;
  s.compensation = m.compensation;
  s.tool_length = m.tool_length;
  s.retract = m.retract;
  s.path_control = m.path_control;
  s.tolerance = m.path_control == 640 ? m.path_tolerance : 0.0;
  s.spindle_mode = m.spindle_mode;
  s.lathe_diameter = m.lathe_diameter;
  s.system = static_cast<std::int16_t>(m.system);
  s.tool = state.loaded.number;
  s.spindle_direction = static_cast<std::int8_t>(m.spindle_direction);
  s.mist = m.mist;
  s.flood = m.flood;
  s.spindle_speed = m.spindle_speed;
  s.feed = m.feed;
  // Loops and calls come by often: each line is listed once.
  if (!in_order) {
    if (!places_.insert((static_cast<std::uint64_t>(flow.file()) << 32) | flow.line_number()).second) return;
  }
  log_.record(flow.file(), flow.line_number(), s);
}

}  // namespace toolpace::nc
