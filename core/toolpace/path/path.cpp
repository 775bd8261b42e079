#include "toolpace/path/path.h"

#include <algorithm>

namespace toolpace {
namespace {

constexpr double kNoParameterSpeed = 1e-9;  // of a piece's mean |dp/du|
constexpr double kNoTurnSpeed = 1e-6;       // below it a spline may have a cusp
constexpr double kBeside = 1e-3;            // of a piece

Frame arc_frame(const Path& path, std::size_t i, double s) {
  const ArcCurve& arc = path.arcs[path.detail[i]];
  const double angle = angle_at(arc, path.length[i], s);
  ParameterDerivatives d = arc_derivatives(arc, angle);
  const AxisVector change = path.end_of(i) - path.node[i];
  d.first.tail<3>() = change.tail<3>() / arc.sweep;
  Frame frame;
  frame.point = arc_point(arc, angle);
  frame.point.tail<3>() = path.node[i].tail<3>() + (angle / arc.sweep) * change.tail<3>();
  const ParameterDerivatives by_length = by_arc_length(d);
  frame.first = by_length.first;
  frame.second = by_length.second;
  frame.third = by_length.third;
  return frame;
}

/// With the rotary axes as they turn where they do so unevenly.
Frame turned(Frame frame, const RotaryTurn* turn, double s) {
  if (turn == nullptr) return frame;
  const auto d = turn->at(s);
  frame.point.tail<3>() = d[0];
  frame.first.tail<3>() = d[1];
  frame.second.tail<3>() = d[2];
  frame.third.tail<3>() = d[3];
  return frame;
}

Frame spline_frame(const Path& path, std::size_t i, double s) {
  const SplinePiece& piece = path.spline_pieces[path.detail[i]];
  const SplineCurve& curve = path.splines[piece.spline];
  const double u = parameter_at(curve, piece, path.length[i], s);
  const ParameterDerivatives d = by_arc_length(spline_derivatives(curve, piece, u));
  return {spline_point(curve, u), d.first, d.second, d.third};
}

template <class Blend>
Frame blend_frame(const Blend& blend, double length, double s) {
  const double t = blend_parameter(blend, length, s);
  const ParameterDerivatives d = by_arc_length(blend_derivatives(blend, t));
  return {blend_point(blend, t), d.first, d.second, d.third};
}

Frame blend_frame(const Path& path, std::size_t i, double s) {
  const std::uint32_t detail = path.detail[i];
  if (detail < Path::kCurveBlend) return blend_frame(path.corner_blends[detail], path.length[i], s);
  return blend_frame(path.curve_blends[detail - Path::kCurveBlend], path.length[i], s);
}

}  // namespace

const AxisVector& Path::told_end_of(std::size_t segment) const {
  const auto at =
      std::partition_point(tellings.begin(), tellings.end(), [&](const Telling& t) { return t.node <= segment; });
  return at != tellings.end() && at->node == segment + 1 ? at->before : node[segment + 1];
}

const Chain* Path::told_chain_of(std::size_t segment) const {
  const auto after =
      std::partition_point(tellings.begin(), tellings.end(), [&](const Telling& t) { return t.node <= segment; });
  return after == tellings.begin() || (after - 1)->chain.is_identity() ? nullptr : &(after - 1)->chain;
}

AxisVector point_at(const Path& path, std::size_t i, double s) {
  if (s <= 0) return path.node[i];
  if (s >= path.length[i]) return path.end_of(i);
  if (is_even_line(path, i)) {
    return path.node[i] + (s / path.length[i]) * (path.end_of(i) - path.node[i]);
  }
  return frame_at(path, i, s).point;
}

Frame frame_at(const Path& path, std::size_t i, double s) {
  Frame frame;
  switch (path.kind[i]) {
    case SegmentKind::arc: frame = turned(arc_frame(path, i, s), path.turn_of(i), s); break;
    case SegmentKind::spline: frame = spline_frame(path, i, s); break;
    case SegmentKind::blend: frame = blend_frame(path, i, s); break;
    default:
      frame.first = (path.end_of(i) - path.node[i]) / path.length[i];
      frame.point = path.node[i] + s * frame.first;
      frame.second.setZero();
      frame.third.setZero();
      frame = turned(frame, path.turn_of(i), s);
  }
  if (s <= 0) frame.point = path.node[i];
  if (s >= path.length[i]) frame.point = path.end_of(i);
  return frame;
}

AxisVector point_at_share(const Path& path, std::size_t i, double share) {
  const std::uint32_t detail = path.detail[i];
  if (path.kind[i] == SegmentKind::spline) {
    const SplinePiece& piece = path.spline_pieces[detail];
    return spline_point(path.splines[piece.spline], piece.begin + share * (piece.end - piece.begin));
  }
  if (detail < Path::kCurveBlend) return blend_point(path.corner_blends[detail], share);
  return blend_point(path.curve_blends[detail - Path::kCurveBlend], share);
}

ParameterDerivatives derivatives_at_share(const Path& path, std::size_t i, double share) {
  const std::uint32_t detail = path.detail[i];
  if (path.kind[i] == SegmentKind::spline) {
    const SplinePiece& piece = path.spline_pieces[detail];
    const auto at = [&](double u) {
      return spline_derivatives(path.splines[piece.spline], piece, piece.begin + u * (piece.end - piece.begin));
    };
    ParameterDerivatives d = at(share);
    // Coincident control points: the curve starts (or ends, or turns) without speed in its parameter. Look beside it.
    const double mean = path.length[i] / (piece.end - piece.begin);
    if (d.first.head<3>().norm() <= kNoParameterSpeed * mean) d = at(share + (share < 0.5 ? kBeside : -kBeside));
    return by_arc_length(d);
  }
  if (detail < Path::kCurveBlend) return by_arc_length(blend_derivatives(path.corner_blends[detail], share));
  return by_arc_length(blend_derivatives(path.curve_blends[detail - Path::kCurveBlend], share));
}

double parameter_speed(const Path& path, std::size_t i, double share) {
  const std::uint32_t detail = path.detail[i];
  if (path.kind[i] == SegmentKind::spline) {
    const SplinePiece& piece = path.spline_pieces[detail];
    const double width = piece.end - piece.begin;
    const double u = piece.begin + share * width;
    return width * spline_derivatives(path.splines[piece.spline], piece, u).first.head<3>().norm();
  }
  if (detail < Path::kCurveBlend) {
    return blend_derivatives(path.corner_blends[detail], share).first.head<3>().norm();
  }
  return blend_derivatives(path.curve_blends[detail - Path::kCurveBlend], share).first.head<3>().norm();
}

AxisVector start_direction(const Path& path, std::size_t i) {
  if (path.kind[i] >= SegmentKind::spline) return derivatives_at_share(path, i, 0.0).first;
  return frame_at(path, i, 0.0).first;
}

AxisVector end_direction(const Path& path, std::size_t i) {
  if (path.kind[i] >= SegmentKind::spline) return derivatives_at_share(path, i, 1.0).first;
  return frame_at(path, i, path.length[i]).first;
}

bool is_inside_spline(const Path& path, std::size_t node) {
  if (path.kind[node - 1] != SegmentKind::spline || path.kind[node] != SegmentKind::spline) return false;
  const SplinePiece& before = path.spline_pieces[path.detail[node - 1]];
  const SplinePiece& after = path.spline_pieces[path.detail[node]];
  // Without parameter speed the curve may turn back.
  return is_smooth_between(path.splines[before.spline], before, after) &&
         parameter_speed(path, node - 1, 1.0) > kNoTurnSpeed * path.length[node - 1];
}

std::uint32_t move_at(const Path& path, std::size_t i, double s) {
  const auto after = std::partition_point(path.handovers.begin(), path.handovers.end(), [&](const Path::Handover& h) {
    return h.segment < i || (h.segment == i && h.at <= s);
  });
  const bool told = after != path.handovers.begin() && (after - 1)->segment == i;
  return told ? (after - 1)->move : path.move[i];
}

bool is_rotary_only(const Path& path, std::size_t i) {
  return path.kind[i] == SegmentKind::line && path.node[i].head<3>() == path.end_of(i).head<3>();
}

}  // namespace toolpace
