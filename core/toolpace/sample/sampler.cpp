#include "toolpace/sample/sampler.h"

#include <algorithm>
#include <cmath>

#include "toolpace/plan/time_spline.h"

namespace toolpace {
namespace {

// A duration that misses a whole number of periods by rounding alone ends on that period.
constexpr double kPeriodRounding = 1e-9;

bool moves_rotary(const Path& path) {
  return std::any_of(path.node.begin(), path.node.end(),
                     [&](const AxisVector& p) { return p.tail<3>() != path.node.front().tail<3>(); }) ||
         !path.node.front().tail<3>().isZero(0.0);
}

void resize(Setpoints& chunk, std::size_t count, bool rotary, bool tells_tool) {
  for (std::size_t k = 0; k < kAxisCount; ++k) chunk.position[k].resize(is_rotary(k) && !rotary ? 0 : count);
  chunk.speed.resize(count);
  chunk.acceleration.resize(count);
  chunk.jerk.resize(count);
  chunk.line.resize(count);
  chunk.tool_length.resize(tells_tool ? count : 0);
}

std::optional<double> first_tool_length(const Path& path) {
  for (const Path::Telling& t : path.tellings) {
    if (!t.chain.is_identity()) return t.chain.tool_length;
  }
  return std::nullopt;
}

AxisMotion at_rest(const AxisVector& position) {
  return {position, AxisVector::Zero(), AxisVector::Zero(), AxisVector::Zero()};
}

}  // namespace

std::size_t row_count(double duration, double period) {
  return 1 + static_cast<std::size_t>(std::max(0.0, std::ceil(duration / period - kPeriodRounding)));
}

Sampler::Sampler(const Path& path, const MotionPlan& plan, const Moves& moves, double period, const Impulses& impulses)
    : path_(path),
      moves_(moves),
      motion_(path, plan),
      period_(period),
      rows_(row_count(plan.cycle_time() + duration_of(impulses), period)),
      rotary_(moves_rotary(path)),
      tool_length_(first_tool_length(path)) {
  if (impulses.size() < 2) return;
  for (const Impulse& i : impulses) echoes_.push_back({i, Motion(path, plan)});
  delay_ = mean_delay(impulses);
}

bool Sampler::next(Setpoints& chunk, std::size_t limit) {
  const std::size_t count = std::min(limit, rows_ - next_row_);
  chunk.first_row = next_row_;
  chunk.period = period_;
  resize(chunk, count, rotary_, tool_length_.has_value());
  for (std::size_t i = 0; i < count; ++i) {
    if (is_shaped()) {
      write_shaped_row(chunk, next_row_ + i, i);
    } else {
      write_row(chunk, next_row_ + i, i);
    }
  }
  next_row_ += count;
  return count > 0;
}

/// Where in the program the motion is.
void Sampler::write_names(Setpoints& chunk, std::size_t at) {
  chunk.line[at] = path_.size() > 0 ? moves_.line[motion_.move()] : 0;
  if (!tool_length_) return;
  if (const Chain* const chain = path_.chain_of(motion_.segment())) tool_length_ = chain->tool_length;
  chunk.tool_length[at] = *tool_length_;
}

void Sampler::write_row(Setpoints& chunk, std::size_t row, std::size_t at) {
  const bool is_last = row + 1 == rows_;
  motion_.at(is_last ? motion_.duration() : static_cast<double>(row) * period_);
  const AxisVector place = motion_.place(), point = path_.tellings.empty() ? place : motion_.position();
  const PhaseState state = is_last ? PhaseState{} : motion_.along();
  if (chords_ && path_.size() > 0 && !motion_.leaves_path()) {
    chords_->add(motion_.segment(), motion_.on_segment(), place);
  }
  const std::size_t axes = rotary_ ? kAxisCount : 3;
  for (std::size_t k = 0; k < axes; ++k) chunk.position[k][at] = point[static_cast<Eigen::Index>(k)];
  chunk.speed[at] = state.speed;
  chunk.acceleration[at] = state.acceleration;
  chunk.jerk[at] = state.jerk;
  write_names(chunk, at);
}

void Sampler::write_shaped_row(Setpoints& chunk, std::size_t row, std::size_t at) {
  const bool is_last = row + 1 == rows_;
  const double time = static_cast<double>(row) * period_;
  const AxisMotion mean = is_last ? at_rest(motion_.at(motion_.duration()).position()) : mean_at(time);
  const std::size_t axes = rotary_ ? kAxisCount : 3;
  for (std::size_t k = 0; k < axes; ++k) chunk.position[k][at] = mean.position[static_cast<Eigen::Index>(k)];
  const Rates rates = along(Metric::along(mean.speed.head<3>().isZero(0.0)), mean);
  chunk.speed[at] = rates.speed;
  chunk.acceleration[at] = rates.acceleration;
  chunk.jerk[at] = rates.jerk;
  motion_.at(is_last ? motion_.duration() : time - delay_);
  write_names(chunk, at);
  constexpr Metric kApart = Metric::apart();
  const AxisMotion planned = motion_.axes();
  AxisVector off = mean.position - planned.position;
  const double square = kApart.squared_norm(planned.speed);
  if (square > 0) off -= planned.speed * (kApart.dot(off, planned.speed) / square);
  largest_offset_ = std::max(largest_offset_, kApart.norm(off));
}

AxisMotion Sampler::mean_at(double time) {
  AxisMotion mean = at_rest(echoes_.front().motion.at(time).position());
  const AxisVector first = mean.position;
  for (Echo& e : echoes_) {
    const double then = time - e.impulse.time;
    // Of differences, so that equal positions stay equal.
    mean.position += e.impulse.share * (e.motion.at(then).position() - first);
    if (!(then > 0) || !(then < e.motion.duration())) continue;
    const AxisMotion there = e.motion.axes();
    mean.speed += e.impulse.share * there.speed;
    mean.acceleration += e.impulse.share * there.acceleration;
    mean.jerk += e.impulse.share * there.jerk;
  }
  return mean;
}

}  // namespace toolpace
