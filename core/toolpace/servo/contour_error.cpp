#include "toolpace/servo/contour_error.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

constexpr std::size_t kRowsAhead = 64;   // of command after a row before it is measured
constexpr double kWindowLags = 4.0;      // of path on either side
constexpr std::size_t kRowsKept = 4096;  // behind, before what is out of every window is dropped

}  // namespace

void ContourMeter::take(const AxisVector& commanded, const AxisVector& actual) {
  const double way = points_.empty() ? 0.0 : points_.back().way + (commanded - points_.back().commanded).norm();
  points_.push_back({commanded, way});
  actual_.push_back(actual);
  longest_lag_ = std::max(longest_lag_, (commanded - actual).norm());
}

void ContourMeter::measure(bool all, std::vector<Row>& rows) {
  while (next_actual_ < actual_.size() && (all || measured_ + kRowsAhead < points_.size())) {
    rows.push_back(measure_one(measured_));
    ++next_actual_;
    ++measured_;
  }
  actual_.erase(actual_.begin(), actual_.begin() + static_cast<std::ptrdiff_t>(next_actual_));
  next_actual_ = 0;
  drop_old();
}

/// Keeps what the longest lag so far may still look back at.
void ContourMeter::drop_old() {
  if (measured_ < 2 * kRowsKept) return;
  const double oldest = points_[measured_].way - 2 * kWindowLags * longest_lag_;
  std::size_t gone = measured_ - kRowsKept;
  while (gone > 0 && points_[gone].way >= oldest) --gone;
  points_.erase(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(gone));
  measured_ -= gone;
  nearest_ -= std::min(nearest_, gone);
}

ContourMeter::Row ContourMeter::measure_one(std::size_t index) {
  const AxisVector& actual = actual_[next_actual_];
  const double lag = (points_[index].commanded - actual).norm();
  const double window = kWindowLags * lag;
  Nearest best{lag, index};
  // Near where the last row was: a small distance to begin with lets whole stretches be passed over.
  for (std::size_t chord = nearest_; chord < std::min(nearest_ + 3, index); ++chord) {
    if (points_[chord].way >= points_[index].way - window) look_at(actual, chord, best);
  }
  look_back(actual, index, window, best);
  look_ahead(actual, index, window, best);
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
void ContourMeter::look_back(const AxisVector& actual, std::size_t index, double window, Nearest& best) const {
  const double last = points_[index].way - window;
  for (std::size_t i = index; i > 0 && points_[i].way >= last;) {
    const double clear = points_[i].way - ((actual - points_[i].commanded).norm() - best.distance);
    while (i > 0 && points_[i - 1].way > clear) --i;
    if (i == 0 || points_[i].way < last) return;
    look_at(actual, i - 1, best);
    --i;
  }
}

void ContourMeter::look_ahead(const AxisVector& actual, std::size_t index, double window, Nearest& best) const {
  const double last = points_[index].way + window;
  const std::size_t end = std::min(points_.size(), index + kRowsAhead) - 1;
  for (std::size_t i = index; i < end && points_[i].way <= last;) {
    const double clear = points_[i].way + ((actual - points_[i].commanded).norm() - best.distance);
    while (i < end && points_[i + 1].way < clear) ++i;
    if (i == end || points_[i].way > last) return;
    look_at(actual, i, best);
    ++i;
  }
}

}  // namespace toolpace
