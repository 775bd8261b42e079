#include "toolpace/path/corner_chain.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace toolpace {
namespace {

constexpr double kChainAccuracy = 1e-10;
/// Square of a step along the curve, as a part of that of the distance to it: what is left changes the distance by half of it.
constexpr double kNearEnoughPlace = 1e-3;
constexpr int kNearestSteps = 2;
constexpr double kShortestPiece = 1.0 / 64;  // of a span
constexpr double kNearEnough = 0.8;          // of a line: a trim longer than this needs no control point of its own

Eigen::Vector4d homogeneous(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z(), 1.0}; }

Eigen::Vector3d direction(const Path& path, std::size_t segment) {
  return (path.node[segment + 1] - path.node[segment]).head<3>() / path.length[segment];
}

}  // namespace

/// Control points inside a line of a chain, where a node wants one nearer than the next node.
struct CornerChain::Inner {
  std::size_t count = 0;
  std::array<double, 2> at;  // from the line's start

  Inner(double length, double left, double right) {
    // A point next to a node would make a tiny span of high curvature change; a little more distance is mended by the fit.
    const bool from_left = left < kNearEnough * length, from_right = right < kNearEnough * length;
    if (from_left && from_right && left + right > kNearEnough * length) {
      at[count++] = length * left / (left + right);
      return;
    }
    if (from_left) at[count++] = left;
    if (from_right) at[count++] = length - right;
  }
};

CornerChain::CornerChain(const Path& path, std::size_t first, std::size_t last, const std::vector<double>& trim)
    : path_(path), first_(first), last_(last), curve_{3, {}, {}, path.node[first], path.node[first], true} {
  const auto inner = [&](std::size_t segment) { return Inner(path.length[segment], trim[segment], trim[segment + 1]); };
  std::size_t stations = last - first + 1;
  for (std::size_t i = first; i < last; ++i) stations += inner(i).count;
  curve_.points.reserve(stations + 4);
  curve_.knots.reserve(stations + 8);
  segment_of_.reserve(stations);
  node_at_.reserve(last - first + 1);

  const Eigen::Vector3d begin = path.node[first].head<3>(), end = path.node[last].head<3>();
  const Eigen::Vector3d before = trim[first] * direction(path, first - 1), after = trim[last] * direction(path, last);
  curve_.points.push_back(homogeneous(begin - before));
  curve_.points.push_back(homogeneous(begin - before * (2.0 / 3)));
  for (std::size_t i = first; i <= last; ++i) {
    if (i > first) {
      const Inner points = inner(i - 1);
      const Eigen::Vector3d a = path.node[i - 1].head<3>(), u = direction(path, i - 1);
      for (std::size_t k = 0; k < points.count; ++k) add_control(a + points.at[k] * u, i - 1);
    }
    node_at_.push_back(static_cast<std::uint32_t>(segment_of_.size()));
    add_control(path.node[i].head<3>(), i - 1);
  }
  curve_.points.push_back(homogeneous(end + after * (2.0 / 3)));
  curve_.points.push_back(homogeneous(end + after));
  // Equal knot intervals: a node is then missed by a third of its height over its neighbours, whatever their distances.
  curve_.knots.assign(3, 0.0);
  for (std::size_t k = 0; k <= stations + 1; ++k) curve_.knots.push_back(static_cast<double>(k));
  curve_.knots.insert(curve_.knots.end(), 3, static_cast<double>(stations + 1));
}

void CornerChain::add_control(const Eigen::Vector3d& point, std::size_t segment_before) {
  segment_of_.push_back(static_cast<std::uint32_t>(segment_before));
  curve_.points.push_back(homogeneous(point));
}

double CornerChain::Span::length(double from, double to) const {
  return integrate([&](double x) { return slope(x).norm(); }, from, to);
}

/// Away from the ends all knots around are evenly spaced.
CornerChain::Span CornerChain::span(std::size_t k) const {
  if (k >= 2 && k + 2 <= stations()) {
    const auto c = [&](std::size_t i) { return curve_.points[k + i].head<3>(); };
    return {(c(0) + 4 * c(1) + c(2)) / 6, (c(2) - c(0)) / 2, c(0) - 2 * c(1) + c(2), c(3) - c(0) + 3 * (c(1) - c(2))};
  }
  const auto at = static_cast<double>(k);
  const ParameterDerivatives d = spline_derivatives(curve_, at);
  return {spline_point(curve_, at).head<3>(), d.first.head<3>(), d.second.head<3>(), d.third.head<3>()};
}

AxisVector CornerChain::point(double parameter) const {
  const std::size_t k = std::min(static_cast<std::size_t>(std::max(parameter, 0.0)), spans() - 1);
  AxisVector point = curve_.rotary_begin;  // the same all along
  point.head<3>() = span(k).point(parameter - static_cast<double>(k));
  return point;
}

std::vector<CornerChain::Piece> CornerChain::cut() const {
  std::vector<Piece> pieces;
  pieces.reserve(spans());
  for (std::size_t k = 0; k < spans(); ++k) {
    const auto begin = static_cast<double>(k);
    cut_span(span(k), {begin, begin + 1, 0, k < stations() ? segment_of_[k] : static_cast<std::uint32_t>(last_)},
             pieces);
  }
  return pieces;
}

/// In halves, until one quadrature will do for each.
void CornerChain::cut_span(const Span& span, const Piece& piece, std::vector<Piece>& pieces) {
  const double offset = std::floor(piece.begin), from = piece.begin - offset, to = piece.end - offset;
  const double middle = (from + to) / 2, whole = span.length(from, to);
  const double halves = span.length(from, middle) + span.length(middle, to);
  if (std::abs(whole - halves) <= kChainAccuracy * halves || to - from <= kShortestPiece) {
    pieces.push_back({piece.begin, piece.end, whole, piece.segment});
    return;
  }
  cut_span(span, {piece.begin, offset + middle, 0, piece.segment}, pieces);
  cut_span(span, {offset + middle, piece.end, 0, piece.segment}, pieces);
}

CornerChain::Passing CornerChain::pass(std::size_t node) const {
  const std::size_t at = node_at_[node - first_];
  const Eigen::Vector3d p = path_.node[node].head<3>();
  Span here = span(at + 1);                          // behind the node's station, at first
  double x = 0, best = 0, least = 1e300, begin = 0;  // from there
  for (int k = 0; k <= kNearestSteps; ++k) {
    const double y = x - begin;
    const Eigen::Vector3d e = here.point(y) - p, slope = here.slope(y);
    if (const double square = e.squaredNorm(); square < least) {
      least = square;
      best = x;
    }
    const double square = slope.squaredNorm(), change = square + std::max(0.0, e.dot(here.bend(y)));
    if (!(change > 0)) break;
    const double next = std::clamp(x - e.dot(slope) / change, -1.0, 1.0);
    const double step = next - x;
    if (step * step * square <= kNearEnoughPlace * least) return {static_cast<double>(at + 1) + next, std::sqrt(least)};
    x = next;
    if ((x < 0) != (begin < 0)) {
      begin = x < 0 ? -1 : 0;
      here = span(x < 0 ? at : at + 1);
    }
  }
  return {static_cast<double>(at + 1) + best, std::sqrt(least)};
}

double CornerChain::offset(std::size_t node) const {
  return (span(node_at_[node - first_] + 1).start - path_.node[node].head<3>()).norm();
}

}  // namespace toolpace
