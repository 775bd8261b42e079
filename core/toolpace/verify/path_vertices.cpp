#include "toolpace/verify/path_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toolpace {
namespace {

constexpr double kMostChords = 1e6;  // of one segment: a circle of 300 km at a sagitta of 1e-6 mm
constexpr double kCurvatureMargin =
    1.5;  // pieces of splines change their curvature by at most a third of the larger value
constexpr double kMostWidening = 0.1;  // of the radius, of arcs in sectors
constexpr std::size_t kForgetAtOnce = 4096;

double curvature(const Path& path, std::size_t segment) {
  double largest = 0.0;
  // That of turns is a polynomial of degree 3, and changes more near poles.
  const int parts = path.turn_of(segment) == nullptr ? 2 : 8;
  for (int k = 0; k <= parts; ++k) {
    largest = std::max(largest, weighted(frame_at(path, segment, path.length[segment] * k / parts).second).norm());
  }
  return largest;
}

std::size_t chords_of(const Path& path, std::size_t segment, double sagitta) {
  if (is_even_line(path, segment)) return 1;
  // A chord of length c is off a circle of radius r by c²/(8r).
  const double bend = kCurvatureMargin * curvature(path, segment);
  const double chords = std::ceil(path.length[segment] * std::sqrt(bend / (8 * sagitta)));
  return static_cast<std::size_t>(std::clamp(chords, 1.0, kMostChords));
}

std::size_t sectors_of(const ArcCurve& arc) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(arc.sweep / ArcSector::kWidest)));
}

}  // namespace

AxisVector weighted(const AxisVector& point) {
  AxisVector w = point;
  if (!w.tail<3>().isZero(0)) w.tail<3>() /= kRadiansPerDegree;
  return w;
}

PathVertices::PathVertices(const Path& path, double sagitta, std::vector<SegmentRule> rules)
    : path_(path), sagitta_(sagitta), rules_(std::move(rules)) {
  if (path.node.empty()) return;
  vertices_.push_back({weighted(path.node.front()), 0, PathVertex::kNoSector, 0.0, true, 0.0});
}

/// While rotary axes rest, and the radius stays about the same.
bool PathVertices::has_sectors(std::size_t segment) const {
  if (path_.kind[segment] != SegmentKind::arc) return false;
  const ArcCurve& arc = path_.arcs[path_.detail[segment]];
  return std::abs(arc.end_radius - arc.start_radius) <= kMostWidening * arc.start_radius &&
         path_.node[segment].tail<3>() == path_.end_of(segment).tail<3>();
}

bool PathVertices::make_next() {
  if (segment_ >= path_.size()) return false;
  const bool in_sectors = has_sectors(segment_);
  if (parts_ == 0) {
    parts_ = in_sectors ? sectors_of(path_.arcs[path_.detail[segment_]]) : chords_of(path_, segment_, sagitta_);
  }
  ++part_;
  const bool ends = part_ == parts_;
  const double length = path_.length[segment_], parts = static_cast<double>(parts_);
  const double s = ends ? length : length * static_cast<double>(part_) / parts;
  PathVertex vertex{{}, static_cast<std::uint32_t>(segment_), PathVertex::kNoSector, s, ends, 0.0};
  if (in_sectors) {
    const ArcCurve& arc = path_.arcs[path_.detail[segment_]];
    const double begin = arc.sweep * (static_cast<double>(part_ - 1) / parts);
    sectors_.emplace_back(arc, begin, ends ? arc.sweep : arc.sweep * (static_cast<double>(part_) / parts));
    vertex.sector = static_cast<std::uint32_t>(first_sector_ + sectors_.size() - 1);
    vertex.point = path_.node[segment_];
    vertex.point.head<3>() = sectors_.back().point(1.0);
  } else {
    vertex.point = point_at(path_, segment_, s);
    if (!is_even_line(path_, segment_)) vertex.sagitta = sagitta_;
  }
  if (ends) vertex.point = path_.end_of(segment_);
  vertex.point = weighted(vertex.point);
  vertices_.push_back(vertex);
  // Where the same place is told anew, a cell leads from the one to the other; what is behind it begins there.
  if (ends && path_.end_of(segment_) != path_.node[segment_ + 1]) {
    vertex = {weighted(path_.node[segment_ + 1]), vertex.segment, PathVertex::kNoSector, 0.0, false, 0.0};
    vertices_.push_back(vertex);
  }
  if (ends) {
    ++segment_;
    part_ = parts_ = 0;
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

AxisVector PathVertices::point(std::size_t cell, double t) {
  const PathVertex& end = *at(cell + 1);
  const AxisVector begin = at(cell)->point;  // made before its end, which stays where it is
  AxisVector point = begin + t * (end.point - begin);
  if (const ArcSector* arc = sector(end)) point.head<3>() = arc->point(t);
  return point;
}

void PathVertices::forget_before(std::size_t index) {
  if (index < first_ + kForgetAtOnce) return;
  const auto kept = vertices_.begin() + static_cast<std::ptrdiff_t>(index - first_);
  const auto gone = static_cast<std::size_t>(
      std::count_if(vertices_.begin(), kept, [](const PathVertex& v) { return v.sector != PathVertex::kNoSector; }));
  sectors_.erase(sectors_.begin(), sectors_.begin() + static_cast<std::ptrdiff_t>(gone));
  first_sector_ += gone;
  vertices_.erase(vertices_.begin(), kept);
  first_ = index;
}

}  // namespace toolpace
