#include "toolpace/controller/klipper_queue.h"

#include <algorithm>
#include <cmath>

namespace toolpace::detail::controller {
namespace {

constexpr std::size_t kMovesAFlush = 512;  // gathered before what is certain is run
constexpr double kOfTheMoveBefore = -1;    // stands for a cruise speed

}  // namespace

void KlipperQueue::add(KlipperMove move, double junction_deviation) {
  move.junction_deviation = junction_deviation;
  move.max_start2 = move.max_smoothed2 = 0.0;
  // The extruder alone begins and ends at rest.
  if (moves_.size() > first_ && !move.is_extruder_alone && !moves_.back().is_extruder_alone) join(moves_.back(), move);
  moves_.push_back(move);
  if (moves_.size() - first_ < std::max(flush_at_, kMovesAFlush)) return;
  flush(true);
  flush_at_ = 2 * (moves_.size() - first_);
}

/// How fast the corner between two moves may be passed.
void KlipperQueue::join(const KlipperMove& before, KlipperMove& move) const {
  const double plain2 = std::min({move.max_cruise2, before.max_cruise2, before.max_start2 + before.delta2});
  double corner2 = plain2;
  const double jump = std::abs(move.extrusion - before.extrusion);
  const double extruder2 = jump > 0 ? (move.extruder_step / jump) * (move.extruder_step / jump) : plain2;
  const double cosine = -before.direction.dot(move.direction);
  const double sine_half = std::sqrt(std::max(0.5 * (1.0 - cosine), 0.0));
  const double cosine_half = std::sqrt(std::max(0.5 * (1.0 + cosine), 0.0));
  if (sine_half < 1.0 && cosine_half > 0.0) {
    const double radius = sine_half / (1.0 - sine_half);
    const double quarter_tangent = 0.25 * sine_half / cosine_half;
    corner2 = std::min({radius * move.junction_deviation * move.acceleration,
                        radius * before.junction_deviation * before.acceleration, move.delta2 * quarter_tangent,
                        before.delta2 * quarter_tangent});
  }
  corner2 = std::min(corner2, extruder2);
  move.max_start2 = std::min(plain2, corner2);
  move.starts_at_corner = corner2 < plain2;
  move.max_smoothed2 = std::min(move.max_start2, before.max_smoothed2 + before.smooth_delta2);
}

void KlipperQueue::flush(bool lazy) {
  std::size_t count = moves_.size();
  speeds_.resize(count - first_);
  double end2 = 0, end_smoothed2 = 0, peak2 = 0;
  std::size_t waiting = 0;  // moves from here on whose cruise hangs on one before them
  for (std::size_t i = count; i-- > first_;) {
    const KlipperMove& move = moves_[i];
    const double reachable2 = end2 + move.delta2, start2 = std::min(move.max_start2, reachable2);
    const double reachable_smoothed2 = end_smoothed2 + move.smooth_delta2;
    const double smoothed2 = std::min(move.max_smoothed2, reachable_smoothed2);
    double cruise2 = kOfTheMoveBefore;
    ++waiting;
    if (smoothed2 < reachable_smoothed2) {  // it may speed up
      if (smoothed2 + move.smooth_delta2 > end_smoothed2 || waiting > 1) {
        if (lazy && peak2 > 0) {
          count = i + waiting;
          lazy = false;
        }
        peak2 = 0.5 * (smoothed2 + reachable_smoothed2);
      }
      cruise2 = std::min({0.5 * (start2 + reachable2), move.max_cruise2, peak2});
      waiting = 0;
    }
    speeds_[i - first_] = {start2, cruise2, end2};
    end2 = start2;
    end_smoothed2 = smoothed2;
  }
  if (!lazy) run(count);
}

void KlipperQueue::run(std::size_t count) {
  double before2 = 0;
  for (std::size_t i = first_; i < count; ++i) {
    const KlipperMove& move = moves_[i];
    const Speeds& found = speeds_[i - first_];
    const double cruise2 = found.cruise2 < 0 ? std::min(before2, found.start2) : found.cruise2;
    const double start2 = std::min(found.start2, cruise2), end2 = std::min(found.end2, cruise2);
    before2 = cruise2;
    Trapezoid t;
    t.peak = std::sqrt(cruise2);
    t.entry = std::sqrt(start2);
    t.exit = std::sqrt(end2);
    const double half = 0.5 / move.acceleration;
    t.up = (t.peak - t.entry) / move.acceleration;
    t.down = (t.peak - t.exit) / move.acceleration;
    const double cruise_way = move.length - (cruise2 - start2) * half - (cruise2 - end2) * half;
    t.cruise = cruise_way / t.peak;
    if (move.is_extruder_alone) t.entry = t.peak = t.exit = 0;  // the tool rests
    const bool is_last = i + 1 == moves_.size();
    const TimeLimit why = is_last ? TimeLimit::stops
                          : moves_[i + 1].starts_at_corner && end2 >= moves_[i + 1].max_start2
                              ? TimeLimit::corner
                              : TimeLimit::acceleration;
    tally_.add_block(t, move.row, move.is_rapid, cruise2 < move.max_cruise2 ? TimeLimit::acceleration : move.cruise,
                     why);
  }
  first_ = count;
  // Run moves leave memory now and then.
  if (2 * first_ > moves_.size()) {
    moves_.erase(moves_.begin(), moves_.begin() + static_cast<std::ptrdiff_t>(first_));
    first_ = 0;
  }
}

}  // namespace toolpace::detail::controller
