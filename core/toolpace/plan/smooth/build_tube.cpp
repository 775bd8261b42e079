#include "toolpace/plan/smooth/build_tube.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

constexpr double kChordShare = 0.02;     // of the tolerance, for chords of curves
constexpr double kMergeShare = 0.02;     // of the tolerance, for short segments made one
constexpr std::size_t kMostMerged = 32;  // segments in one
constexpr double kMostTime = 1.0;  // [s] of a segment at its feed: longer ones are cut, so that windows stay small
constexpr double kMostPieces = 1e6;
constexpr double kLeastOfClosed = 3;  // chords of a full turn, however small

class Builder {
 public:
  Builder(const Path& path, const Commands& commands) : path_(path), commands_(commands) {}

  TubePath build(std::size_t begin, std::size_t end) {
    choose_axes(begin, end);
    push(path_.node[begin]);
    tube_.distance.push_back(0.0);
    for (std::size_t i = begin; i < end; ++i) add_segment(i);
    close(path_.node[end]);
    return std::move(tube_);
  }

 private:
  void choose_axes(std::size_t begin, std::size_t end) {
    std::array<bool, kAxisCount> moves{};
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t a = 0; a < kAxisCount; ++a) {
        const auto at = static_cast<Eigen::Index>(a);
        moves[a] =
            moves[a] || path_.node[i + 1][at] != path_.node[begin][at] || (a < 3 && path_.kind[i] != SegmentKind::line);
      }
    }
    for (std::size_t a = 0; a < kAxisCount; ++a) {
      if (!moves[a]) continue;
      if (a < 3) ++tube_.linear;
      tube_.axis[static_cast<std::size_t>(tube_.axes++)] = static_cast<int>(a);
    }
  }

  void push(const AxisVector& p) {
    for (int a = 0; a < tube_.axes; ++a) {
      const int axis = tube_.axis[static_cast<std::size_t>(a)];
      tube_.points.push_back(counted(static_cast<std::size_t>(axis), p[axis]));
    }
  }

  double chords(std::size_t i) const {
    if (path_.kind[i] == SegmentKind::line) return 1;
    double bend = 0;
    for (const double part : {0.0, 0.5, 1.0}) {
      bend = std::max(bend, frame_at(path_, i, part * path_.length[i]).second.head<3>().norm());
    }
    const double needed = path_.length[i] * std::sqrt(1.1 * bend / (8 * kChordShare * commands_[i].tolerance));
    const bool is_closed = path_.node[i] == path_.node[i + 1];
    return is_closed ? std::max(needed, kLeastOfClosed) : needed;
  }

  void add_segment(std::size_t i) {
    const double top = commands_[i].speed, length = path_.length[i];
    const double pieces =
        std::min(kMostPieces, std::max(chords(i), top < kUnlimited ? length / (top * kMostTime) : 1.0));
    const double count = std::max(1.0, std::ceil(pieces - 1e-9));
    for (double k = 1; k <= count; ++k) {
      add_vertex(k < count ? point_at(path_, i, length * k / count) : path_.node[i + 1], done_ + length * k / count,
                 top, commands_[i].tolerance * (path_.kind[i] == SegmentKind::line ? 1 : 1 - kChordShare));
    }
    done_ += length;
  }

  void add_vertex(const AxisVector& p, double distance, double top, double tol) {
    const std::size_t axes = static_cast<std::size_t>(tube_.axes);
    push(p);
    if (merge(distance, top, tol)) return;
    const double* last = tube_.points.data() + tube_.points.size() - 2 * axes;
    if (std::equal(last, last + axes, last + axes)) {  // nothing that moves has moved
      tube_.points.resize(tube_.points.size() - axes);
      tube_.distance.back() = distance;
      return;
    }
    inner_.clear();
    tube_.feed.push_back(top);
    tube_.tolerance.push_back(tol);
    merge_error_.push_back(0.0);
    tube_.distance.push_back(distance);
  }

  /// Lets the last segment end at the vertex just pushed, if all between stay close to it, in order.
  bool merge(double distance, double top, double tol) {
    const std::size_t axes = static_cast<std::size_t>(tube_.axes), n = tube_.segments();
    if (n == 0 || tube_.feed.back() != top || tube_.tolerance.back() != tol) return false;
    if (inner_.size() / axes + 1 >= kMostMerged) return false;
    if (distance - tube_.distance[n - 1] > top * kMostTime) return false;
    const double* b = tube_.points.data() + tube_.points.size() - axes;
    const double *middle = b - axes, *a = middle - axes;
    inner_.insert(inner_.end(), middle, middle + axes);
    const double error = farthest(a, b);
    if (!(error <= kMergeShare * tol)) {
      inner_.resize(inner_.size() - axes);
      return false;
    }
    merge_error_.back() = error;
    tube_.points.erase(tube_.points.end() - 2 * static_cast<std::ptrdiff_t>(axes),
                       tube_.points.end() - static_cast<std::ptrdiff_t>(axes));
    tube_.distance.back() = distance;
    return true;
  }

  /// Largest distance of the inner points from the chord a b; none where they do not follow one another along it.
  double farthest(const double* a, const double* b) const {
    const auto axes = static_cast<std::size_t>(tube_.axes);
    double dd = 0;
    for (std::size_t q = 0; q < axes; ++q) dd += (b[q] - a[q]) * (b[q] - a[q]);
    if (!(dd > 0)) return kUnlimited;  // there and back
    double before = 0, most = 0;
    for (std::size_t k = 0; k < inner_.size(); k += axes) {
      double along = 0, square = 0;
      for (std::size_t q = 0; q < axes; ++q) along += (inner_[k + q] - a[q]) * (b[q] - a[q]);
      if (!(along >= before && along <= dd)) return kUnlimited;
      before = along;
      for (std::size_t q = 0; q < axes; ++q) {
        const double e = inner_[k + q] - a[q] - along / dd * (b[q] - a[q]);
        square += e * e;
      }
      most = std::max(most, square);
    }
    return std::sqrt(most);
  }

  /// A last vertex that was left out because it repeats the one before must still be the exact end.
  void close(const AxisVector& end) {
    if (tube_.segments() == 0) return;
    tube_.points.resize(tube_.points.size() - static_cast<std::size_t>(tube_.axes));
    push(end);
    for (std::size_t k = 0; k < tube_.segments(); ++k) tube_.tolerance[k] -= merge_error_[k];
  }

  const Path& path_;
  const Commands& commands_;
  TubePath tube_;
  double done_ = 0;
  std::vector<double> inner_;        // vertices that the last segment passes by
  std::vector<double> merge_error_;  // of each segment: how far from it they are
};

}  // namespace

TubePath build_tube(const Path& path, const Commands& commands, std::size_t begin, std::size_t end) {
  return Builder(path, commands).build(begin, end);
}

TubeLimits tube_limits(const Machine& machine) {
  TubeLimits limits;
  for (std::size_t a = 0; a < kAxisCount; ++a) {
    limits.speed[a] = counted(a, machine.axes[a].speed);
    limits.acceleration[a] = counted(a, machine.axes[a].acceleration);
    limits.jerk[a] = counted(a, machine.axes[a].jerk);
  }
  limits.path_acceleration = std::min(machine.path.acceleration, machine.path.deceleration);
  limits.path_jerk = std::min(machine.path.jerk, machine.path.jerk_deceleration);
  return limits;
}

}  // namespace toolpace
