#include "toolpace/controller/linuxcnc_run.h"

#include <algorithm>
#include <cmath>

namespace toolpace::detail::controller {
namespace {

constexpr double kEndOfWay = 1e-12;   // [mm]
constexpr double kLeastSpeed = 1e-8;  // [mm/s]
constexpr double kLeastTime = 1e-12;  // [s]
constexpr std::size_t kAhead = 4;     // segments besides those of the look-ahead

}  // namespace

void LinuxcncRun::add(Segment segment) {
  segment.top = std::min(segment.top, segment.length / cycle_);
  segment.cycle = cycle_;
  if (!queue_.empty()) {
    Segment blend;
    bool consumed = false;
    const bool has_blend = join(queue_.back(), segment, limits_, blend, consumed);
    finalize(queue_.back(), cycle_);
    if (consumed) queue_.pop_back();
    if (has_blend) {
      blend.cycle = cycle_;
      queue_.push_back(blend);
    }
  }
  queue_.push_back(segment);
  while (queue_.size() > depth_ + kAhead) run_first();
}

void LinuxcncRun::finish() {
  while (!queue_.empty()) run_first();
}

void LinuxcncRun::run_first() {
  constexpr std::size_t kCyclesALook = 4096;
  const std::size_t before = queue_.size();
  for (std::size_t cycle = 1; queue_.size() == before; ++cycle) {
    if (cycle % kCyclesALook == 0 && monitor_.is_cancelled()) return queue_.clear();
    step();
  }
}

/// What holds the speed as it is.
TimeLimit LinuxcncRun::reason(const Segment& now, double before) const {
  if (now.speed > before + kLeastSpeed) return TimeLimit::acceleration;
  if (now.speed >= before - kLeastSpeed) {
    if (now.shape != Shape::line && now.top < now.wanted) return TimeLimit::corner;
    return now.cruise;
  }
  const bool rests = now.ending == Ending::stop || queue_.size() == 1;
  return rests ? TimeLimit::stops : TimeLimit::corner;
}

void LinuxcncRun::step() {
  Segment& now = queue_.front();
  Segment* next = at(1);
  activate(now);
  if (!now.is_splitting && !now.is_ramp) skip_cruise(now, next);
  const double before = now.speed;
  if (now.is_splitting) {
    run_split(now, next);
  } else {
    run_regular(now, next);
  }
  tally_.add_time(reason(now, before), cycle_, now.row, now.is_rapid);
  if (!now.is_done) return;
  tally_.count_block();
  queue_.pop_front();
}

/// The highest speed at the end of a segment of the queue, seen from as far ahead as LinuxCNC looks.
double LinuxcncRun::looked_ahead(std::size_t index) const {
  if (queue_[index].ending != Ending::tangent || index + 1 >= queue_.size()) return 0.0;
  const std::size_t tail = std::min(index + depth_ + 1, queue_.size() - 1);
  const auto limit2 = [&](std::size_t k) {
    const Segment& before = queue_[k - 1];
    double limit = std::min(queue_[k].top, before.top);
    if (before.kink_speed >= 0) limit = std::min(limit, before.kink_speed);
    return limit * limit;
  };
  // Of the last one only a half is sure.
  const Segment& last = queue_[tail];
  double speed2 = std::min({limit2(tail), last.path_acceleration() * last.length,
                            last.target(limits_.feed_scale) * last.target(limits_.feed_scale)});
  if (queue_[tail - 1].ending != Ending::tangent) speed2 = 0;
  for (std::size_t k = tail - 1; k > index; --k) {
    if (queue_[k - 1].ending != Ending::tangent) {
      speed2 = 0;
      continue;
    }
    speed2 = std::min(limit2(k), speed2 + 2.0 * queue_[k].path_acceleration() * queue_[k].length);
  }
  return std::sqrt(speed2);
}

double LinuxcncRun::final_speed(Segment& now, const Segment* next) {
  if (now.ending != Ending::tangent || !next) return 0.0;
  if (now.final < 0) now.final = looked_ahead(index_of(now));
  return std::min({now.final, now.target(), next->target()});
}

void LinuxcncRun::activate(Segment& now) {
  if (now.is_active) return;
  now.is_active = true;
  const double end = std::min(final_speed(now, at(1)), now.target());
  const double time = 2.0 * (now.length - now.progress) / (now.speed + end);
  now.is_ramp = time < cutoff_ && !now.is_rapid && now.ending == Ending::tangent && now.length > now.progress;
}

/// Cycles at a steady speed, far from where it has to fall, all alike.
void LinuxcncRun::skip_cruise(Segment& now, const Segment* next) {
  constexpr double kCyclesBefore = 8;  // of slowing down that are run one by one
  if (now.speed != now.target() || now.blends_next || now.progress == 0) return;
  const double end = final_speed(now, next), way = now.speed * cycle_;
  const double braking = (now.speed * now.speed - end * end) / (2.0 * now.path_acceleration());
  const double cycles = std::floor((now.length - now.progress - std::max(braking, 0.0)) / way - kCyclesBefore);
  if (!(cycles > 0)) return;
  now.progress += cycles * way;
  tally_.add_time(reason(now, now.speed), cycles * cycle_, now.row, now.is_rapid);
}

void LinuxcncRun::run_regular(Segment& now, Segment* next) {
  now.cycle = cycle_;
  update(now, next);
  if (!next || now.ending != Ending::parabolic) return;
  const ParabolicSpeeds speeds = parabolic_speeds(now, *next);
  now.blends_next = now.blends_next || (now.slows_down && now.speed < speeds.first);
  if (!now.blends_next) return;
  next->cycle = cycle_;
  update(*next, nullptr);
}

/// A segment ends within a cycle: the rest of it is the next one's.
void LinuxcncRun::run_split(Segment& now, Segment* next) {
  if (now.is_done) return;
  now.progress = now.length;
  now.is_done = true;
  if (!next) return;
  if (now.ending == Ending::tangent) {
    next->cycle = cycle_ - now.cycle;
    next->speed = now.end_speed;
  }
  update(*next, at(2));
}

void LinuxcncRun::update(Segment& now, const Segment* next) {
  const double dt = std::max(now.cycle, kLeastTime), left = now.length - now.progress;
  const double most = now.path_acceleration(), end = final_speed(now, next);
  double a = 0, desired = 0;
  if (now.is_ramp && now.ending == Ending::tangent && end >= kLeastSpeed) {
    const double mean = 0.5 * (now.speed + end);
    const double time = mean > kLeastSpeed ? std::max(left / mean, 1e-16) : 1e-16;
    a = std::clamp((end - now.speed) / time, -most, most);
    desired = end;
  } else {
    // The highest speed after this cycle from which the end can still be met.
    const double half = 0.5 * most * now.cycle;
    const double under = end * end + most * (2.0 * left - now.speed * now.cycle) + half * half;
    desired = -half + (under > half * half ? std::sqrt(under) : 0.0);
    const double target = now.target();
    a = std::clamp((std::clamp(desired, -target, target) - now.speed) / dt, -most, most);
  }
  const double speed = now.speed + a * now.cycle;
  if (speed < 0) {
    if (left < now.speed * now.cycle) now.progress = now.length;
    now.speed = 0;
  } else {
    now.progress = std::clamp(now.progress + 0.5 * (speed + now.speed) * now.cycle, 0.0, now.length);
    now.speed = speed;
  }
  now.slows_down = std::abs(desired - now.speed) < kLeastSpeed && a < 0;
  check_end(now, next);
}

/// Whether a segment ends within its next cycle.
void LinuxcncRun::check_end(Segment& now, const Segment* next) const {
  now.cycle = cycle_;
  const double left = now.length - now.progress;
  const bool rests = now.ending == Ending::stop || now.ending == Ending::exact;
  if (left <= kEndOfWay) {
    now.progress = now.length;
    now.is_splitting = true;
    now.cycle = 0;
    now.end_speed = now.speed;
    now.is_done = now.is_done || rests;
    return;
  }
  if (rests) return;
  double end =
      now.ending == Ending::tangent && next ? std::min({std::max(now.final, 0.0), now.target(), next->target()}) : 0.0;
  const double mean = 0.5 * (now.speed + end);
  if (mean <= kLeastSpeed) return;
  double dt = std::max(0.5 * kLeastTime, left / mean);
  const double most = now.path_acceleration(), wanted = (end - now.speed) / dt;
  if (std::abs(wanted) > most) {
    const double a = std::copysign(most, wanted), ratio = now.speed / a, under = ratio * ratio + 2.0 / a * left;
    if (under < 0) return;
    dt = -ratio + (under < kLeastTime * kLeastTime ? 0.0 : std::copysign(std::sqrt(under), a));
    end = now.speed + dt * a;
  }
  if (dt >= cycle_) return;
  now.is_splitting = true;
  if (dt < kLeastTime) now.progress = now.length;
  now.cycle = dt < kLeastTime ? 0.0 : dt;
  now.end_speed = end;
}

}  // namespace toolpace::detail::controller
