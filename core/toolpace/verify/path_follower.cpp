#include "toolpace/verify/path_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toolpace {
namespace {

constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kCellsAhead = 64;  // in which a setpoint behind an exact corner is looked for

/// The distance up to which another place is equally near, but for rounding [mm].
double as_near(double distance) { return distance * (1 + 1e-9) + 1e-12; }

}  // namespace

PathFollower::PathFollower(PathVertices& vertices, double tolerance, bool rotary)
    : vertices_(vertices), tolerance_(tolerance), rotary_(rotary) {}

double PathFollower::dot(const AxisVector& a, const AxisVector& b) const {
  const double linear = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return rotary_ ? linear + (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]) : linear;
}

/// ε in the cell that ends there.
double PathFollower::radius(const PathVertex& end) const {
  return std::min(tolerance_, vertices_.rule(end).tolerance) + end.sagitta;
}

/// ε at a vertex: that of the stricter cell beside it.
double PathFollower::node_radius(std::size_t vertex) {
  const double before = radius(*vertices_.at(vertex));
  const PathVertex* const next = vertices_.at(vertex + 1);
  return next != nullptr ? std::min(before, radius(*next)) : before;
}

/// Where a + t·(b − a), 0 ≤ t ≤ 1, is within the radius of the centre.
CurveInterval PathFollower::inside(const AxisVector& centre, const AxisVector& a, const AxisVector& b,
                                   double radius) const {
  const AxisVector d = b - a, e = a - centre;
  const double square = dot(d, d);
  CurveInterval interval;
  interval.nearest = square > 0 ? -dot(d, e) / square : 0.0;
  // The distance of the centre to the line, computed from the foot: no cancellation of large squares.
  const AxisVector foot = e + interval.nearest * d;
  const double least = dot(foot, foot), half = radius * radius - least;
  interval.distance = std::sqrt(least);
  if (half < 0) return interval;
  if (square == 0.0) return {0.0, 1.0, 0.0, interval.distance};
  const double reach = std::sqrt(half / square);
  interval.low = std::max(0.0, interval.nearest - reach);
  interval.high = std::min(1.0, interval.nearest + reach);
  return interval;
}

/// Where a cell is within ε of the point.
CurveInterval PathFollower::inside_cell(std::size_t cell, const AxisVector& point) {
  const PathVertex* const end = vertices_.at(cell + 1);
  const ArcSector* const sector = vertices_.sector(*end);
  if (sector == nullptr) return inside(point, vertices_.at(cell)->point, end->point, radius(*end));
  if (!rotary_) return sector->within(point.head<3>(), radius(*end));
  const double beside = (point - end->point).tail<3>().norm(), r = radius(*end);
  CurveInterval interval = sector->within(point.head<3>(), std::sqrt(std::max(0.0, r * r - beside * beside)));
  if (beside > r) interval.low = 1.0, interval.high = 0.0;
  interval.distance = std::hypot(interval.distance, beside);
  return interval;
}

double PathFollower::distance_at(std::size_t cell, double t, const AxisVector& point) {
  const AxisVector off = point - vertices_.point(cell, t);
  return std::sqrt(dot(off, off));
}

/// Whether the stretch low … high of an arc's cell stands out too far from the straight line between the two setpoints.
bool PathFollower::bulges(std::size_t cell, double low, double high, const Step& step) {
  const PathVertex& end = *vertices_.at(cell + 1);
  const ArcSector* const sector = vertices_.sector(end);
  if (sector == nullptr || high <= low || sector->bulge(low, high) <= step.slack.between) return false;
  const double most = radius(end) + step.slack.between;
  return inside(vertices_.point(cell, (low + high) / 2), step.from, step.to, most).empty();
}

/// Whether a motion that is exactly on the path on both sides of a vertex goes through it: with it a corner near by.
bool PathFollower::is_passed_exactly(std::size_t vertex, Step& step) {
  const PathVertex node = *vertices_.at(vertex);
  const PathVertex* const next = vertices_.at(vertex + 1);
  if (next == nullptr) return false;
  if (tolerance_ <= 2 * kOnPath || vertices_.rule(node).is_exact || vertices_.rule(*next).is_exact) return true;
  if (!step.slack.from_path) return false;
  for (std::size_t k = vertex; step.cell_of_to == kUnknown && k < vertex + kCellsAhead; ++k) {
    if (vertices_.at(k + 1) == nullptr) break;
    const CurveInterval place = inside_cell(k, step.to);
    const double t = std::clamp(place.nearest, 0.0, 1.0);
    if (distance_at(k, t, step.to) <= kOnPath + vertices_.at(k + 1)->sagitta) step.cell_of_to = k;
  }
  return step.cell_of_to != kUnknown && step.cell_of_to >= vertex;
}

/// The part of the line between the two setpoints that a vertex may be matched to.
CurveInterval PathFollower::at_vertex(std::size_t vertex, Step& step) {
  const AxisVector point = vertices_.at(vertex)->point;
  const double least = node_radius(vertex);
  const CurveInterval part = inside(point, step.from, step.to, least + step.slack.between);
  if (!part.empty() || step.slack.at_corner <= step.slack.between || !is_passed_exactly(vertex, step)) return part;
  return inside(point, step.from, step.to, least + step.slack.at_corner);
}

bool PathFollower::start(const AxisVector& point) {
  reachable_.clear();
  if (vertices_.at(0) == nullptr || vertices_.at(1) == nullptr) return false;
  const AxisVector first = vertices_.at(0)->point;
  const double off = std::sqrt(dot(point - first, point - first));
  if (off > radius(*vertices_.at(1))) return false;
  // Along the first setpoint's column the walk goes straight on from the path's beginning.
  for (std::size_t j = 0; vertices_.at(j + 1) != nullptr; ++j) {
    const CurveInterval here = inside_cell(j, point);
    if (here.empty() || here.low > 0) break;
    reachable_.push_back({j, here.low, here.high, here.nearest, here.distance});
    if (here.high < 1) break;
  }
  if (reachable_.empty()) reachable_.push_back({0, 0.0, 0.0, 0.0, off});
  match_ = {};
  take_match(point);
  return true;
}

/// What of a cell's far sides is reached from its near sides.
/// @param left    reachable part of the cell at the last setpoint; may be null
/// @param bottom  reachable part of the setpoints' line at the cell's first vertex; becomes that at its second
void PathFollower::reach_cell(std::size_t cell, const Stretch* left, CurveInterval& bottom, Step& step) {
  CurveInterval right = inside_cell(cell, step.to);
  const bool from_bottom = !right.empty() && !bottom.empty() && !bulges(cell, 0.0, right.low, step);
  if (!from_bottom && !right.empty() && left != nullptr) {
    right.low = std::max(right.low, left->low);
    if (right.low <= right.high && bulges(cell, left->high, right.low, step)) right.low = 1.0, right.high = 0.0;
  } else if (!from_bottom) {
    right.low = 1.0, right.high = 0.0;
  }
  if (!right.empty()) next_.push_back({cell, right.low, right.high, right.nearest, right.distance});
  CurveInterval top = at_vertex(cell + 1, step);
  const bool spans_left = !top.empty() && left != nullptr && !bulges(cell, left->high, 1.0, step);
  if (!spans_left && (top.empty() || bottom.empty() || bulges(cell, 0.0, 1.0, step))) {
    bottom = {};
    return;
  }
  if (!spans_left) top.low = std::max(top.low, bottom.low);
  bottom = top;
}

bool PathFollower::advance(const AxisVector& from, const AxisVector& to, const Slack& slack) {
  next_.clear();
  Step step{from, to, slack, kUnknown};
  std::size_t left = 0;
  CurveInterval bottom;
  for (std::size_t j = reachable_.front().cell;; ++j) {
    while (left < reachable_.size() && reachable_[left].cell < j) ++left;
    const bool has_left = left < reachable_.size() && reachable_[left].cell == j;
    if (!has_left && bottom.empty()) {
      if (left >= reachable_.size()) break;
      j = reachable_[left].cell - 1;
      continue;
    }
    if (vertices_.at(j + 1) == nullptr) break;
    reach_cell(j, has_left ? &reachable_[left] : nullptr, bottom, step);
  }
  std::swap(reachable_, next_);
  if (reachable_.empty()) return false;
  vertices_.forget_before(std::min(reachable_.front().cell, match_.cell));
  take_match(to);
  return true;
}

/// The place nearest to the point on a stretch; on chords, by the chord.
PathMatch PathFollower::nearest_in(const Stretch& stretch, const AxisVector& point) {
  PathMatch place;
  place.cell = stretch.cell;
  place.t = std::clamp(stretch.nearest, stretch.low, stretch.high);
  place.distance = place.t == stretch.nearest ? stretch.distance : distance_at(stretch.cell, place.t, point);
  return place;
}

/// Never back, not within a cell either: where a stroke turns round, the way there and the way back are equally near.
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
    const PathMatch place = nearest_in(stretch, point);
    if (place.distance - sagitta > as_near(least)) continue;
    places_.push_back(place);
    least = std::min(least, place.distance + sagitta);
  }
  const std::size_t first = reachable_.front().cell, last = reachable_.back().cell;
  if (places_.empty()) {  // only places before the last match are left: stay there, and be as near as they are
    match_.distance = std::numeric_limits<double>::infinity();
    for (const Stretch& stretch : reachable_)
      match_.distance = std::min(match_.distance, nearest_in(stretch, point).distance);
  } else {
    const auto too_far = [&](const PathMatch& p) {
      return p.distance - vertices_.at(p.cell + 1)->sagitta > as_near(least);
    };
    places_.erase(std::remove_if(places_.begin(), places_.end(), too_far), places_.end());
    const PathMatch* best = &places_.front();
    if (places_.size() > 1) {
      // A curve may be nearer than its chord says: where it turns round into a line, the line ahead would win.
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
