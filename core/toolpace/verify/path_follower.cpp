#include "toolpace/verify/path_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toolpace {
namespace {

/// The distance up to which another place is equally near, but for rounding [mm].
double as_near(double distance) { return distance * (1 + 1e-9) + 1e-12; }

}  // namespace

PathFollower::PathFollower(PathVertices& vertices, double tolerance, bool rotary)
    : vertices_(vertices), tolerance_(tolerance), rotary_(rotary) {}

double PathFollower::dot(const AxisVector& a, const AxisVector& b) const {
  const double linear = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return rotary_ ? linear + (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]) : linear;
}

/// Where a + t·(b − a), 0 ≤ t ≤ 1, is within the radius of the centre.
PathFollower::Interval PathFollower::inside(const AxisVector& centre, const AxisVector& a, const AxisVector& b,
                                            double radius) const {
  const AxisVector d = b - a, e = a - centre;
  const double square = dot(d, d), distance = dot(e, e) - radius * radius;
  if (square == 0.0) return distance <= 0 ? Interval{0.0, 1.0} : Interval{};
  const double middle = -dot(d, e) / square;
  // The distance of the centre to the line, computed from the foot: no cancellation of large squares.
  const AxisVector foot = e + middle * d;
  const double half = radius * radius - dot(foot, foot);
  if (half < 0) return {};
  const double reach = std::sqrt(half / square);
  return {std::max(0.0, middle - reach), std::min(1.0, middle + reach)};
}

bool PathFollower::start(const AxisVector& point) {
  reachable_.clear();
  if (vertices_.at(0) == nullptr) return false;
  const AxisVector first = vertices_.at(0)->point;
  if (dot(point - first, point - first) > tolerance_ * tolerance_) return false;
  // Along the first setpoint's column the walk goes straight on from the path's beginning.
  for (std::size_t j = 0; vertices_.at(j + 1) != nullptr; ++j) {
    const AxisVector a = vertices_.at(j)->point, b = vertices_.at(j + 1)->point;
    const Interval here = inside(point, a, b, tolerance_);
    if (here.empty() || here.low > 0) break;
    reachable_.push_back({j, here.low, here.high});
    if (here.high < 1) break;
  }
  if (reachable_.empty()) reachable_.push_back({0, 0.0, 0.0});
  match_ = {};
  take_match(point);
  return true;
}

bool PathFollower::advance(const AxisVector& from, const AxisVector& to, double slack) {
  next_.clear();
  std::size_t left = 0;
  Interval bottom;  // reachable part of the setpoint chord at vertex j
  for (std::size_t j = reachable_.front().cell;; ++j) {
    while (left < reachable_.size() && reachable_[left].cell < j) ++left;
    const bool has_left = left < reachable_.size() && reachable_[left].cell == j;
    if (!has_left && bottom.empty()) {
      if (left >= reachable_.size()) break;
      j = reachable_[left].cell - 1;
      continue;
    }
    if (vertices_.at(j + 1) == nullptr) break;
    const AxisVector b = vertices_.at(j + 1)->point, a = vertices_.at(j)->point;
    const Interval right = inside(to, a, b, tolerance_);
    if (!right.empty() && !bottom.empty()) {
      next_.push_back({j, right.low, right.high});
    } else if (!right.empty() && right.high >= reachable_[left].low) {
      next_.push_back({j, std::max(right.low, reachable_[left].low), right.high});
    }
    Interval top = inside(b, from, to, tolerance_ + slack);
    if (!has_left) top.low = std::max(top.low, bottom.low);
    bottom = top;
  }
  std::swap(reachable_, next_);
  if (reachable_.empty()) return false;
  vertices_.forget_before(std::min(reachable_.front().cell, match_.cell));
  take_match(to);
  return true;
}

/// The place nearest to the point on a stretch, by its chord.
PathMatch PathFollower::nearest_on_chord(const Stretch& stretch, const AxisVector& point) {
  PathMatch place;
  place.cell = stretch.cell;
  const AxisVector b = vertices_.at(stretch.cell + 1)->point, a = vertices_.at(stretch.cell)->point;
  const AxisVector d = b - a, e = point - a;
  const double square = dot(d, d);
  place.t = square > 0 ? std::clamp(dot(d, e) / square, stretch.low, stretch.high) : stretch.low;
  const AxisVector off = e - place.t * d;
  place.distance = std::sqrt(dot(off, off));
  return place;
}

/// Never back, not within a chord either: where a stroke turns round, the way there and the way back are equally near.
/// Of places equally near the earliest is taken: the walk may still go on from there.
void PathFollower::take_match(const AxisVector& point) {
  places_.clear();
  double least = std::numeric_limits<double>::infinity();
  for (Stretch stretch : reachable_) {
    if (stretch.cell < match_.cell) continue;
    if (stretch.cell == match_.cell) stretch.low = std::max(stretch.low, match_.t);
    if (stretch.low > stretch.high) continue;
    if (vertices_.at(stretch.cell + 1) == nullptr) break;
    const double sagitta = vertices_.at(stretch.cell + 1)->sagitta;
    const PathMatch place = nearest_on_chord(stretch, point);
    if (place.distance - sagitta > as_near(least)) continue;
    places_.push_back(place);
    least = std::min(least, place.distance + sagitta);
  }
  const std::size_t first = reachable_.front().cell, last = reachable_.back().cell;
  if (places_.empty()) {  // only places before the last match are left: stay there
    match_.distance = tolerance_;
  } else {
    const auto too_far = [&](const PathMatch& p) {
      return p.distance - vertices_.at(p.cell + 1)->sagitta > as_near(least);
    };
    places_.erase(std::remove_if(places_.begin(), places_.end(), too_far), places_.end());
    const PathMatch* best = &places_.front();
    if (places_.size() > 1) {
      // A curve may be nearer than its chord says: where an arc turns round into a line, the line ahead would win.
      for (PathMatch& place : places_) vertices_.measure(place.cell, place.t, place.distance, point);
      for (const PathMatch& place : places_) {
        if (as_near(place.distance) < best->distance) best = &place;
      }
    }
    match_ = *best;
  }
  match_.first_cell = first;
  match_.last_cell = last;
}

bool PathFollower::reaches_end() {
  if (reachable_.empty()) return false;
  const std::size_t last = reachable_.back().cell;
  return vertices_.at(last + 2) == nullptr && reachable_.back().high >= 1.0;
}

}  // namespace toolpace
