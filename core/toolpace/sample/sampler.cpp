#include "toolpace/sample/sampler.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

// A duration that misses a whole number of periods by rounding alone ends on that period.
constexpr double kPeriodRounding = 1e-9;

bool moves_rotary(const Path& path) {
  return std::any_of(path.node.begin(), path.node.end(),
                     [&](const AxisVector& p) { return p.tail<3>() != path.node.front().tail<3>(); }) ||
         !path.node.front().tail<3>().isZero(0.0);
}

void resize(Setpoints& chunk, std::size_t count, bool rotary) {
  for (std::size_t k = 0; k < kAxisCount; ++k) chunk.position[k].resize(is_rotary(k) && !rotary ? 0 : count);
  chunk.speed.resize(count);
  chunk.acceleration.resize(count);
  chunk.jerk.resize(count);
  chunk.line.resize(count);
}

}  // namespace

std::size_t row_count(double duration, double period) {
  return 1 + static_cast<std::size_t>(std::max(0.0, std::ceil(duration / period - kPeriodRounding)));
}

Sampler::Sampler(const Path& path, const MotionPlan& plan, const Moves& moves, double period)
    : path_(path), plan_(plan), moves_(moves), period_(period), rotary_(moves_rotary(path)) {
  rows_ = row_count(plan.cycle_time(), period);
  if (path_.size() > 0) load_segment();
}

bool Sampler::next(Setpoints& chunk, std::size_t limit) {
  const std::size_t count = std::min(limit, rows_ - next_row_);
  chunk.first_row = next_row_;
  chunk.period = period_;
  resize(chunk, count, rotary_);
  for (std::size_t i = 0; i < count; ++i) write_row(chunk, next_row_ + i, i);
  next_row_ += count;
  return count > 0;
}

void Sampler::seek(std::size_t row) {
  next_row_ = std::min(row, rows_);
  const double time = static_cast<double>(next_row_) * period_;
  const auto after = std::upper_bound(plan_.phases.begin(), plan_.phases.end(), time,
                                      [](double t, const Phase& p) { return t < p.begin; });
  phase_ = after == plan_.phases.begin() ? 0 : static_cast<std::size_t>(after - plan_.phases.begin()) - 1;
  spline_ = 0;
  segment_ = 0;
  handover_ = 0;
  segment_begin_ = 0.0;
  if (path_.size() > 0) load_segment();
}

PhaseState Sampler::state_at(double time) {
  while (phase_ + 1 < plan_.phases.size() && plan_.phases[phase_ + 1].begin <= time) ++phase_;
  const Phase& phase = plan_.phases[phase_];
  return evaluate(phase, std::min(time - phase.begin, phase.duration));
}

/// The spline that is run at this time, if any. Times may only rise between calls.
const TimeSpline* Sampler::spline_at(double time) {
  const auto& splines = plan_.splines;
  while (spline_ < splines.size() && splines[spline_].begin + splines[spline_].duration() < time) ++spline_;
  return spline_ < splines.size() && splines[spline_].begin <= time ? &splines[spline_] : nullptr;
}

void Sampler::load_segment() {
  line_ = moves_.line[path_.move[segment_]];
  direction_ = (path_.node[segment_ + 1] - path_.node[segment_]) / path_.length[segment_];
}

void Sampler::enter_segment(double distance) {
  const std::size_t before = segment_;
  while (segment_ + 1 < path_.size() && distance >= segment_begin_ + path_.length[segment_]) {
    segment_begin_ += path_.length[segment_];
    ++segment_;
  }
  if (segment_ != before) load_segment();
  hand_over(distance - segment_begin_);
}

void Sampler::hand_over(double s) {
  const auto& handovers = path_.handovers;
  while (handover_ < handovers.size() && handovers[handover_].segment < segment_) ++handover_;
  for (; handover_ < handovers.size(); ++handover_) {
    const Path::Handover& h = handovers[handover_];
    if (h.segment != segment_ || h.at > s) return;
    line_ = moves_.line[h.move];
  }
}

void Sampler::write_row(Setpoints& chunk, std::size_t row, std::size_t at) {
  AxisVector point;
  PhaseState state{0, 0, 0, 0};
  if (row + 1 == rows_) {
    point = path_.node.back();
    if (path_.size() > 0) {
      line_ = moves_.line[move_at(path_, path_.size() - 1, path_.length.back())];
      if (chords_) chords_->add(path_.size() - 1, path_.length.back(), point);
    }
  } else {
    state = state_at(static_cast<double>(row) * period_);
    if (path_.size() > 0) {
      enter_segment(state.distance);
      const double time = static_cast<double>(row) * period_;
      if (const TimeSpline* spline = spline_at(time)) {
        const SplineState run = evaluate(*spline, time - spline->begin);
        write(chunk, at, run.position, {state.distance, run.speed, run.acceleration, run.jerk});
        return;
      }
      const double s = std::clamp(state.distance - segment_begin_, 0.0, path_.length[segment_]);
      if (path_.kind[segment_] == SegmentKind::line) {
        point = path_.node[segment_] + s * direction_;
      } else {
        point = point_at(path_, segment_, s);
      }
      if (chords_) chords_->add(segment_, s, point);
    } else {
      point = path_.node.front();
    }
  }
  write(chunk, at, point, state);
}

void Sampler::write(Setpoints& chunk, std::size_t at, const AxisVector& point, const PhaseState& state) const {
  const std::size_t axes = rotary_ ? kAxisCount : 3;
  for (std::size_t k = 0; k < axes; ++k) chunk.position[k][at] = point[static_cast<Eigen::Index>(k)];
  chunk.speed[at] = state.speed;
  chunk.acceleration[at] = state.acceleration;
  chunk.jerk[at] = state.jerk;
  chunk.line[at] = line_;
}

}  // namespace toolpace
