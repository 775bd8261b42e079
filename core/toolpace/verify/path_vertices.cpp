#include "toolpace/verify/path_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toolpace {
namespace {

constexpr double kMostChords = 1e6;  // of one segment: a circle of 300 km at a sagitta of 1e-6 mm
constexpr double kCurvatureMargin =
    1.5;                         // pieces of splines change their curvature by at most a third of the larger value
constexpr int kNewtonSteps = 4;  // from a chord that is within 1e-5 mm of the curve
constexpr std::size_t kForgetAtOnce = 4096;

double curvature(const Path& path, std::size_t segment) {
  double largest = 0.0;
  for (const double s : {0.0, path.length[segment] / 2, path.length[segment]}) {
    largest = std::max(largest, weighted(frame_at(path, segment, s).second).norm());
  }
  return largest;
}

std::size_t chords_of(const Path& path, std::size_t segment, double sagitta) {
  if (path.kind[segment] == SegmentKind::line) return 1;
  // A chord of length c is off a circle of radius r by c²/(8r).
  const double bend = kCurvatureMargin * curvature(path, segment);
  const double chords = std::ceil(path.length[segment] * std::sqrt(bend / (8 * sagitta)));
  return static_cast<std::size_t>(std::clamp(chords, 1.0, kMostChords));
}

}  // namespace

AxisVector weighted(const AxisVector& point) {
  AxisVector w = point;
  w.tail<3>() /= kRadiansPerDegree;
  return w;
}

PathVertices::PathVertices(const Path& path, double sagitta) : path_(path), sagitta_(sagitta) {
  if (path.node.empty()) return;
  vertices_.push_back({weighted(path.node.front()), 0, 0.0, true, 0.0});
}

bool PathVertices::make_next() {
  if (segment_ >= path_.size()) return false;
  if (chords_ == 0) chords_ = chords_of(path_, segment_, sagitta_);
  ++chord_;
  const bool ends = chord_ == chords_;
  const double length = path_.length[segment_];
  const double s = ends ? length : length * static_cast<double>(chord_) / static_cast<double>(chords_);
  const AxisVector point = ends ? path_.node[segment_ + 1] : point_at(path_, segment_, s);
  const double sagitta = path_.kind[segment_] == SegmentKind::line ? 0.0 : sagitta_;
  vertices_.push_back({weighted(point), static_cast<std::uint32_t>(segment_), s, ends, sagitta});
  if (ends) {
    ++segment_;
    chord_ = chords_ = 0;
  }
  return true;
}

const PathVertex* PathVertices::at(std::size_t index) {
  while (index - first_ >= vertices_.size()) {
    if (!make_next()) return nullptr;
  }
  return &vertices_[index - first_];
}

void PathVertices::measure(std::size_t cell, double& t, double& distance, const AxisVector& point) {
  const PathVertex end = *at(cell + 1), begin = *at(cell);
  const double first = begin.is_node ? 0.0 : begin.s;
  if (end.sagitta == 0.0 || end.s <= first) return;
  const double low = first + t * (end.s - first) - end.sagitta;  // Newton may step back by what the chord hides
  double s = first + t * (end.s - first);
  distance = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kNewtonSteps; ++step) {
    const Frame frame = frame_at(path_, end.segment, s);
    const AxisVector off = point - weighted(frame.point), along = weighted(frame.first);
    if (off.norm() < distance) {
      distance = off.norm();
      t = (s - first) / (end.s - first);
    }
    const double slope = along.squaredNorm() - off.dot(weighted(frame.second));
    if (slope <= 0) break;
    s = std::clamp(s + off.dot(along) / slope, std::max(first, low), end.s);
  }
}

void PathVertices::forget_before(std::size_t index) {
  if (index < first_ + kForgetAtOnce) return;
  vertices_.erase(vertices_.begin(), vertices_.begin() + static_cast<std::ptrdiff_t>(index - first_));
  first_ = index;
}

}  // namespace toolpace
