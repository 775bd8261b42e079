#include "toolpace/servo/contour_error.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

constexpr std::size_t kRowsAhead = 64;          // of command after a row before it is measured
constexpr double kWindowLags = 4.0;             // of path on either side
constexpr std::size_t kPointsBehind = 1 << 16;  // at most

}  // namespace

void ContourMeter::pass(const AxisVector& commanded) {
  if (!points_.empty() && points_.back().commanded == commanded) return;
  const double way = points_.empty() ? 0.0 : points_.back().way + (commanded - points_.back().commanded).norm();
  points_.push_back({commanded, way});
}

void ContourMeter::take(const AxisVector& commanded, const AxisVector& actual) {
  pass(commanded);
  waiting_.push_back({actual, points_.size() - 1});
}

void ContourMeter::measure(bool all, std::vector<Row>& rows) {
  const std::size_t ready =
      all ? waiting_.size() : waiting_.size() - std::min<std::size_t>(waiting_.size(), kRowsAhead);
  for (std::size_t row = 0; row < ready; ++row) rows.push_back(measure_one(row));
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(ready));
  drop_old();
}

/// Half of a full window at a time, so that the points kept are moved seldom.
void ContourMeter::drop_old() {
  const std::size_t next = waiting_.empty() ? points_.size() : waiting_.front().point;
  if (next < 2 * kPointsBehind) return;
  const std::size_t gone = next - kPointsBehind;
  points_.erase(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(gone));
  for (Waiting& row : waiting_) row.point -= gone;
  nearest_ -= std::min(nearest_, gone);
}

ContourMeter::Row ContourMeter::measure_one(std::size_t row) {
  const auto& [actual, own] = waiting_[row];
  const double lag = (points_[own].commanded - actual).norm();
  const std::size_t ahead = std::min(row + kRowsAhead, waiting_.size()) - 1;
  const Window window{own - std::min(own, kPointsBehind), own, waiting_[ahead].point, kWindowLags * lag};
  Nearest best{lag, own};
  // Near where the last row was: a small distance to begin with lets whole stretches be passed over.
  for (std::size_t chord = std::max(nearest_, window.first); chord < std::min(nearest_ + 3, own); ++chord) {
    if (points_[chord].way >= points_[own].way - window.reach) look_at(actual, chord, best);
  }
  look_back(actual, window, best);
  look_ahead(actual, window, best);
  nearest_ = best.chord;
  return {lag, best.distance};
}

void ContourMeter::look_at(const AxisVector& actual, std::size_t chord, Nearest& best) const {
  const AxisVector& a = points_[chord].commanded;
  const AxisVector d = points_[chord + 1].commanded - a, e = actual - a;
  const double square = d.squaredNorm();
  const double t = square > 0 ? std::clamp(d.dot(e) / square, 0.0, 1.0) : 0.0;
  const double distance = (e - t * d).norm();
  if (distance < best.distance) best = {distance, chord};
}

/// A point at distance d has nothing nearer than `best` within d − best of path: chords in between are passed over.
void ContourMeter::look_back(const AxisVector& actual, const Window& window, Nearest& best) const {
  const double last = points_[window.own].way - window.reach;
  for (std::size_t i = window.own; i > window.first && points_[i].way >= last;) {
    const double clear = points_[i].way - ((actual - points_[i].commanded).norm() - best.distance);
    while (i > window.first && points_[i - 1].way > clear) --i;
    if (i == window.first || points_[i].way < last) return;
    look_at(actual, i - 1, best);
    --i;
  }
}

void ContourMeter::look_ahead(const AxisVector& actual, const Window& window, Nearest& best) const {
  const double last = points_[window.own].way + window.reach;
  for (std::size_t i = window.own; i < window.last && points_[i].way <= last;) {
    const double clear = points_[i].way + ((actual - points_[i].commanded).norm() - best.distance);
    while (i < window.last && points_[i + 1].way < clear) ++i;
    if (i == window.last || points_[i].way > last) return;
    look_at(actual, i, best);
    ++i;
  }
}

}  // namespace toolpace
