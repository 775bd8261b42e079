#include "toolpace/sample/motion_cursor.h"

#include <algorithm>

namespace toolpace {

MotionCursor::MotionCursor(const Path& path, const MotionPlan& plan) : path_(path), plan_(plan) {
  begin_.reserve(path.size());
  double way = 0.0;
  for (const double length : path.length) {
    begin_.push_back(way);
    way += length;
  }
}

AxisVector MotionCursor::at(double time) {
  if (path_.size() == 0 || plan_.phases.empty() || time <= 0) return path_.node.front();
  if (time >= plan_.cycle_time()) return path_.node.back();
  const auto& splines = plan_.splines;
  while (spline_ > 0 && splines[spline_ - 1].begin + splines[spline_ - 1].duration() >= time) --spline_;
  while (spline_ < splines.size() && splines[spline_].begin + splines[spline_].duration() < time) ++spline_;
  if (spline_ < splines.size() && splines[spline_].begin <= time) {
    return evaluate(splines[spline_], time - splines[spline_].begin).position;
  }
  const auto& phases = plan_.phases;
  while (phase_ > 0 && phases[phase_].begin > time) --phase_;
  while (phase_ + 1 < phases.size() && phases[phase_ + 1].begin <= time) ++phase_;
  const Phase& phase = phases[phase_];
  const double distance = evaluate(phase, std::clamp(time - phase.begin, 0.0, phase.duration)).distance;
  while (segment_ > 0 && begin_[segment_] > distance) --segment_;
  while (segment_ + 1 < path_.size() && begin_[segment_ + 1] <= distance) ++segment_;
  const double s = std::clamp(distance - begin_[segment_], 0.0, path_.length[segment_]);
  return point_at(path_, segment_, s);
}

}  // namespace toolpace
