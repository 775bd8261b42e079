#include "toolpace/sample/motion.h"

#include <algorithm>

#include "toolpace/plan/plan.h"

namespace toolpace {
namespace {

constexpr int kInstants = 8;       // in a knot interval, its end not counted
constexpr int kCurveInstants = 8;  // in a phase's part of a curve, both ends counted
constexpr double kSliver = 1e-9;   // of a phase: a shorter part of it belongs to the segment beside

/// Index of the last of `count` > 0 entries that is reached, looked for from a hint: O(1) there and beside it, O(log distance)
/// elsewhere. Entry 0 counts as reached.
/// @param reached  true for the first so many entries, false for the rest
template <class Reached>
std::size_t last_reached(std::size_t count, std::size_t hint, const Reached& reached) {
  std::size_t low = hint, high = hint + 1, step = 1;
  if (low == 0 || reached(low)) {
    for (; high < count && reached(high); step *= 2) {
      low = high;
      high = low + step;
    }
    high = std::min(high, count);
  } else {
    for (; low > 0 && !reached(low); step *= 2) {
      high = low;
      low = low > step ? low - step : 0;
    }
  }
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (reached(middle) ? low : high) = middle;
  }
  return low;
}

/// The chain rule: the motion along a path as that of its axes.
AxisMotion chained(const Frame& path, const PhaseState& along) {
  const double v = along.speed, a = along.acceleration;
  return {path.point, path.first * v, path.first * a + path.second * (v * v),
          path.first * along.jerk + path.second * (3 * v * a) + path.third * (v * v * v)};
}

PhaseState of_axis(const AxisMotion& motion, std::size_t axis) {
  const auto i = static_cast<Eigen::Index>(axis);
  return {motion.position[i], motion.speed[i], motion.acceleration[i], motion.jerk[i]};
}

}  // namespace

/// A part of a phase, between two times after its begin.
struct Motion::Part {
  const Phase& phase;
  double from, to;
};

Motion& Motion::at(double time) {
  const bool goes_on = time >= time_;
  time_ = std::clamp(time, 0.0, duration());
  along_ = {};
  node_ = 0;
  if (!plan_.phases.empty()) {
    phase_ = phase_at(time_);
    const Phase& phase = plan_.phases[phase_];
    along_ = evaluate(phase, std::min(time_ - phase.begin, phase.duration));
    node_ = phase.node;
  }
  if (time_ >= duration()) {
    along_.distance = 0;
    node_ = path_.size();
  }
  from_node_ = along_.distance;
  along_.distance += path_.position[node_];
  if (path_.size() > 0) find_segment(goes_on);
  spline_ = spline_at(time_);
  if (spline_) {
    beside_ = evaluate(*spline_, time_ - spline_->begin);
    const Rates rates = toolpace::along(*spline_, beside_);
    along_ = {along_.distance, rates.speed, rates.acceleration, rates.jerk};
  }
  return *this;
}

Motion& Motion::at(double time, std::size_t segment) {
  at(time);
  enter(segment);
  return *this;
}

double Motion::time_at(double position) {
  const auto& phases = plan_.phases;
  if (phases.empty()) return 0;
  const auto start = [&](std::size_t i) { return path_.position[phases[i].node] + phases[i].distance; };
  arriving_ = last_reached(phases.size(), arriving_, [&](std::size_t i) { return start(i) <= position; });
  return phases[arriving_].begin + time_to_cover(phases[arriving_], position - start(arriving_));
}

std::size_t Motion::phase_at(double time) const {
  return last_reached(plan_.phases.size(), phase_, [&](std::size_t i) { return plan_.phases[i].begin <= time; });
}

const TimeSpline* Motion::spline_at(double time) {
  const auto& splines = plan_.splines;
  if (splines.empty()) return nullptr;
  last_spline_ = last_reached(splines.size(), last_spline_, [&](std::size_t i) { return splines[i].begin <= time; });
  const TimeSpline& spline = splines[last_spline_];
  return spline.begin <= time && time <= spline.begin + spline.duration() ? &spline : nullptr;
}

/// @param goes_on  later than before: where positions are rounded at the seams of phases, a motion never steps back over a node
void Motion::find_segment(bool goes_on) {
  const std::size_t found = last_reached(path_.size(), segment_,
                                         [&](std::size_t i) { return path_.position.between(node_, i) <= from_node_; });
  enter(goes_on ? std::max(segment_, found) : found);
}

void Motion::enter(std::size_t segment) {
  segment_ = segment;
  const double length = path_.length[segment];
  // Positions are rounded: at the node the whole length is covered, whatever their difference.
  on_segment_ = from_node_ >= path_.position.between(node_, segment + 1)
                    ? length
                    : std::clamp(from_node_ - path_.position.between(node_, segment), 0.0, length);
}

std::uint32_t Motion::move() {
  const auto& handovers = path_.handovers;
  if (handovers.empty()) return path_.move[segment_];
  const auto passed = [&](std::size_t i) {
    const Path::Handover& h = handovers[i];
    return h.segment < segment_ || (h.segment == segment_ && h.at <= on_segment_);
  };
  handover_ = last_reached(handovers.size(), handover_, passed);
  return passed(handover_) && handovers[handover_].segment == segment_ ? handovers[handover_].move
                                                                       : path_.move[segment_];
}

const AxisVector& Motion::direction() {
  if (line_ != segment_) {
    direction_ = (path_.end_of(segment_) - path_.node[segment_]) / path_.length[segment_];
    line_ = segment_;
  }
  return direction_;
}

const PieceWalker& Motion::walker() {
  if (walked_ != segment_) {
    const SplinePiece& piece = path_.spline_pieces[path_.detail[segment_]];
    walker_.emplace(path_.splines[piece.spline], piece, path_.length[segment_]);
    walked_ = segment_;
  }
  return *walker_;
}

AxisVector Motion::position() {
  const AxisVector told = place();
  if (spline_ || path_.tellings.empty()) return told;
  return path_.size() > 0 ? curve_.axes_of(segment_, told) : told_about({}, path_.tellings.back().chain, told);
}

AxisVector Motion::place() {
  if (spline_) return beside_.position;
  if (path_.size() == 0) return path_.node.front();
  if (on_segment_ >= path_.length[segment_]) return path_.end_of(segment_);
  if (is_even_line(path_, segment_)) return path_.node[segment_] + on_segment_ * direction();
  if (on_segment_ <= 0) return path_.node[segment_];
  if (path_.kind[segment_] == SegmentKind::spline && walker().is_exact()) return walker().point_at(on_segment_);
  return point_at(path_, segment_, on_segment_);
}

AxisMotion Motion::axes() {
  if (spline_) return beside_;
  if (path_.size() == 0) return {position(), AxisVector::Zero(), AxisVector::Zero(), AxisVector::Zero()};
  AxisMotion motion = chained(curve_.frame_at(segment_, on_segment_), along_);
  motion.position = position();
  return motion;
}

/// Calls add(part) for each phase that runs between the two times, with the part of it that lies between them.
template <class Add>
void Motion::for_each_part(double begin, double end, const Add& add) {
  const auto& phases = plan_.phases;
  for (std::size_t i = phase_at(begin); i < phases.size() && phases[i].begin <= end; ++i) {
    const double from = std::max(begin - phases[i].begin, 0.0),
                 to = std::min(end - phases[i].begin, phases[i].duration);
    if (to > from || (to == from && end == begin)) add(Part{phases[i], from, to});
  }
}

PhaseBounds Motion::bounds(double begin, double end) {
  if (plan_.phases.empty()) return {};
  PhaseBounds box = PhaseBounds::nothing();
  for_each_part(begin, end, [&](const Part& part) {
    const TimeSpline* spline = spline_at(part.phase.begin + (part.from + part.to) / 2);
    if (!spline) return box.add(toolpace::bounds(part.phase, part.from, part.to));
    for (int k = 0; k <= kInstants; ++k) {
      const double time = part.phase.begin + part.from + (part.to - part.from) * k / kInstants - spline->begin;
      const Rates rates = toolpace::along(*spline, evaluate(*spline, time));
      box.add(PhaseState{0, rates.speed, rates.acceleration, rates.jerk});
    }
  });
  if (box.is_empty()) box.add(at(begin).along_);
  return box;
}

PhaseBounds Motion::bounds(double begin, double end, std::size_t axis) {
  if (plan_.phases.empty() || path_.size() == 0) return {};
  PhaseBounds box = PhaseBounds::nothing();
  for_each_part(begin, end, [&](const Part& part) {
    const double middle = part.phase.begin + (part.from + part.to) / 2;
    if (const TimeSpline* spline = spline_at(middle)) {
      const double offset = part.phase.begin - spline->begin;
      box.add(toolpace::bounds(*spline, offset + part.from, offset + part.to, axis));
    } else {
      add_on_path(part, axis, box);
    }
  });
  if (box.is_empty()) box.add(of_axis(at(begin).axes(), axis));
  return box;
}

void Motion::add_on_path(const Part& part, std::size_t axis, PhaseBounds& box) {
  const Phase& p = part.phase;
  const double reach = evaluate(p, part.to).distance, sliver = kSliver * p.duration;
  at(p.begin + part.from);
  for (double from = part.from;;) {
    const double end = path_.position.between(p.node, segment_ + 1);
    const bool is_last = segment_ + 1 == path_.size() || end >= reach;
    const double to = is_last ? part.to : std::clamp(time_to_cover(p, end - p.distance), from, part.to);
    if (to - from > sliver || part.to - part.from <= sliver) add_on_segment({p, from, to}, axis, box);
    if (is_last) return;
    ++segment_;
    from = to;
  }
}

void Motion::add_on_segment(const Part& part, std::size_t axis, PhaseBounds& box) {
  if (path_.kind[segment_] == SegmentKind::line && curve_.is_path(segment_)) {
    const double share = direction()[static_cast<Eigen::Index>(axis)];
    return box.add(toolpace::bounds(part.phase, part.from, part.to).scaled(share));
  }
  for (int k = 0; k < kCurveInstants; ++k) {
    const PhaseState state = evaluate(part.phase, part.from + (part.to - part.from) * k / (kCurveInstants - 1));
    const double s =
        std::clamp(state.distance - path_.position.between(part.phase.node, segment_), 0.0, path_.length[segment_]);
    box.add(of_axis(chained(curve_.frame_at(segment_, s), state), axis));
  }
}

}  // namespace toolpace
