#include "toolpace/path/blend_path.h"

#include <algorithm>
#include <cmath>

#include "toolpace/path/blend_halves.h"
#include "toolpace/path/blend_trims.h"
#include "toolpace/path/corner_chain.h"
#include "toolpace/path/merge_lines.h"
#include "toolpace/path/move_teller.h"

namespace toolpace {
namespace {

constexpr double kRest = 1e-9;  // a trimmed segment shorter than this share has vanished
constexpr int kTold = 4;        // parts of a chain's piece in which moves are told by length
class Blender {
 public:
  Blender(const Path& path, const Moves& moves, const Rounding& options, const std::vector<double>& merge_error)
      : path_(path), moves_(moves), merge_error_(merge_error), trims_(path, moves, options, merge_error) {}

  BlendedPath run(const Monitor& monitor) {
    reserve();
    out_.count.stops = trims_.stops();
    out_.path.node.push_back(path_.node.front());
    out_.path.splines = path_.splines;
    out_.path.tellings = path_.tellings;
    out_.path.turns = path_.turns;
    out_.path.out_of_plane = path_.out_of_plane;
    std::size_t pause = 0, told = 0;
    for (std::size_t i = 0; i <= path_.size(); ++i) {
      if (i % kReportEvery == 0) monitor.report(static_cast<double>(i) / static_cast<double>(path_.size() + 1));
      if (i % kReportEvery == 0 && monitor.is_cancelled()) break;
      for (; pause < path_.pauses.size() && path_.pauses[pause].node == i; ++pause) {
        out_.path.pauses.push_back(path_.pauses[pause]);
        out_.path.pauses.back().node = static_cast<std::uint32_t>(out_.path.size());
      }
      if (told < path_.tellings.size() && path_.tellings[told].node == i) {
        out_.path.tellings[told++].node = static_cast<std::uint32_t>(out_.path.size());
        out_.path.node.back() =
            path_.node[i];  // a curve that took the whole segment before has ended there as told before
      }
      if (trims_.is_chained(i)) {
        std::size_t last = i;
        while (trims_.is_chained(last)) ++last;
        add_chain(i, last);
        i = last;
      } else if (trims_.at(i) > 0) {
        add_blend(i);
      }
      if (i < path_.size()) add_rest(i);
    }
    out_.path.position = NodePositions(out_.path.length);
    return std::move(out_);
  }

 private:
  void reserve() {
    std::size_t corners = 0, chained = 0;
    for (std::size_t i = 1; i < path_.size(); ++i) {
      const bool is_chained = trims_.is_chained(i) || trims_.is_chained(i - 1);
      chained += is_chained;
      corners += !is_chained && trims_.at(i) > 0;
    }
    const std::size_t n = path_.size() + corners + chained / 2;
    Path& p = out_.path;
    p.kind.reserve(n);
    p.length.reserve(n);
    p.move.reserve(n);
    p.detail.reserve(n);
    p.node.reserve(n + 1);
    p.corner_blends.reserve(corners);
    p.spline_pieces.reserve(path_.spline_pieces.size() + chained + chained / 2);
    p.handovers.reserve(path_.handovers.size() + chained);
  }

  void push(SegmentKind kind, std::uint32_t move, double length, std::uint32_t detail, const AxisVector& end) {
    Path& p = out_.path;
    p.kind.push_back(kind);
    p.move.push_back(move);
    p.length.push_back(length);
    p.detail.push_back(detail);
    p.node.push_back(end);
    if (!path_.turn.empty()) p.turn.push_back(kNoDetail);
  }

  void add_blend(std::size_t i) {
    const double d = trims_.at(i);
    ++out_.count.corners;
    Path& p = out_.path;
    if (trims_.is_line(i - 1) && trims_.is_line(i)) {
      const CornerBlend blend{path_.node[i], d * end_direction(path_, i - 1), d * start_direction(path_, i)};
      note(i, Metric::apart().norm(blend.after - blend.before) / 8);
      if (!trims_.has_one_feed(i)) return add_halves(i, as_curve_blend(blend));
      p.corner_blends.push_back(blend);
      const auto index = static_cast<std::uint32_t>(p.corner_blends.size() - 1);
      push(SegmentKind::blend, path_.move[i], blend_length(blend), index, blend.corner + blend.after);
      tell_corner(i);
      return;
    }
    const CurveBlend blend = trims_.curve_blend(i, d);
    note(i, trims_.curve_deviation(i, d));
    if (!trims_.has_one_feed(i)) return add_halves(i, blend);
    push(path_.move[i], blend);
    tell_corner(i);
  }

  void push(std::uint32_t move, const CurveBlend& blend) {
    Path& p = out_.path;
    p.curve_blends.push_back(blend);
    const auto index = static_cast<std::uint32_t>(p.curve_blends.size() - 1);
    push(SegmentKind::blend, move, blend_length(blend), Path::kCurveBlend + index, blend.points[5]);
  }

  /// Each half of the curve at a node is run at the feed of its own side.
  void add_halves(std::size_t i, const CurveBlend& blend) {
    const auto [before, after] = halves(blend);
    const double d = trims_.at(i), length = path_.length[i - 1];
    const std::size_t now = out_.path.size();
    push(path_.move[i - 1], before);
    teller_.tell({i - 1, length - d, length}, {now, 0, out_.path.length[now]});
    push(path_.move[i], after);
    teller_.tell({i, 0, d}, {now + 1, 0, out_.path.length[now + 1]});
  }

  /// The blend just added passes its node in the middle.
  void tell_corner(std::size_t i) {
    const std::size_t now = out_.path.size() - 1;
    const double before = path_.length[i - 1], whole = out_.path.length[now];
    teller_.tell({i - 1, before - trims_.at(i), before}, {now, 0, whole / 2});
    teller_.tell({i, 0, trims_.at(i)}, {now, whole / 2, whole});
  }

  /// Nodes first … last as one cubic spline between the trimmed lines before and after them.
  void add_chain(std::size_t first, std::size_t last) {
    CornerChain chain(path_, first, last, trims_.trims());
    for (std::size_t i = first; i <= last; ++i) {
      if (!is_noted(i, chain.offset(i))) note(i, chain.pass(i).deviation);
    }
    out_.count.corners += last - first + 1;
    Path& p = out_.path;
    const auto index = static_cast<std::uint32_t>(p.splines.size());
    const auto pieces = chain.cut();
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      p.spline_pieces.push_back({index, pieces[k].begin, pieces[k].end});
      const AxisVector end =
          k + 1 < pieces.size() ? chain.point(pieces[k].end) : point_at(path_, last, trims_.at(last));
      push(SegmentKind::spline, path_.move[pieces[k].segment], pieces[k].length,
           static_cast<std::uint32_t>(p.spline_pieces.size() - 1), end);
    }
    tell_chain(first, last, chain, pieces);
    p.splines.push_back(chain.release());
  }

  /// Tells which moves the pieces just added stand for. They end where the spline is simple, not where it passes the nodes.
  void tell_chain(std::size_t first, std::size_t last, const CornerChain& chain,
                  const std::vector<CornerChain::Piece>& pieces) {
    const std::size_t before = out_.path.size() - pieces.size();
    double from = 0, told = path_.length[first - 1] - trims_.at(first), told_at = 0;
    std::size_t k = 0;
    for (std::size_t segment = first - 1; segment <= last; ++segment, told = 0) {
      const double to = segment < last ? std::max(from, chain.pass(segment + 1).parameter) : pieces.back().end;
      const double top = segment < last ? path_.length[segment] : trims_.at(last);
      for (const int parts = teller_.is_divided(segment) ? kTold : 1; from < to;) {
        const CornerChain::Piece& piece = pieces[k];
        double next = std::min(to, piece.end);
        if (parts > 1) next = std::min(next, from + (piece.end - piece.begin) / parts);
        const AxisVector point = chain.point(next);
        const double reached = next < to ? std::clamp(along(segment, point), told, top) : top;
        const double at = next < piece.end ? length_to(before + k, point) : out_.path.length[before + k];
        teller_.tell({segment, told, reached}, {before + k, told_at, at});
        told = reached;
        told_at = at;
        from = next;
        if (from < piece.end || k + 1 == pieces.size()) continue;
        ++k;
        told_at = 0;
      }
    }
  }
  /// Path length up to a point of a curved segment of the new path, by its chords.
  double length_to(std::size_t segment, const AxisVector& point) const {
    const double before = (point - out_.path.node[segment]).head<3>().norm();
    const double after = (out_.path.node[segment + 1] - point).head<3>().norm();
    return out_.path.length[segment] * before / (before + after);
  }
  /// Path length from the start of a line to the foot of a point on it.
  double along(std::size_t segment, const AxisVector& point) const {
    const AxisVector chord = path_.end_of(segment) - path_.node[segment], from = point - path_.node[segment];
    return std::clamp(from.head<3>().dot(chord.head<3>()) / path_.length[segment], 0.0, path_.length[segment]);
  }

  double noted(std::size_t i, double deviation) const {
    return deviation + std::max(merge_error_[i - 1], merge_error_[i]);
  }
  /// Whether a deviation is no larger than what is known already.
  bool is_noted(std::size_t i, double deviation) const { return noted(i, deviation) <= out_.count.deviation; }
  void note(std::size_t i, double deviation) {
    out_.count.deviation = std::max(out_.count.deviation, noted(i, deviation));
  }

  /// What the blends leave of a segment.
  void add_rest(std::size_t i) {
    const double length = path_.length[i], begin = trims_.at(i), end = length - trims_.at(i + 1);
    out_.count.deviation = std::max(out_.count.deviation, merge_error_[i]);
    if (end - begin <= kRest * length) return;
    const AxisVector last = trims_.at(i + 1) > 0 ? point_at(path_, i, end) : path_.node[i + 1];
    push_rest(i, begin, end, last);
    if (path_.turn_of(i) != nullptr) turn_rest(i, begin);
    const std::size_t now = out_.path.size() - 1;
    teller_.tell({i, begin, end}, {now, 0, out_.path.length[now]});
  }

  void turn_rest(std::size_t i, double begin) {
    Path& p = out_.path;
    p.turn.back() = path_.turn[i];
    if (!(begin > 0)) return;
    p.turns.push_back(*path_.turn_of(i));
    p.turns.back().begin += begin;
    p.turn.back() = static_cast<std::uint32_t>(p.turns.size() - 1);
  }

  void push_rest(std::size_t i, double begin, double end, const AxisVector& last) {
    const double length = path_.length[i];
    Path& p = out_.path;
    switch (path_.kind[i]) {
      case SegmentKind::arc: {
        p.arcs.push_back(part_of_arc(path_.arcs[path_.detail[i]], length, begin, end));
        push(SegmentKind::arc, path_.move[i], end - begin, static_cast<std::uint32_t>(p.arcs.size() - 1), last);
        return;
      }
      case SegmentKind::spline: {
        SplinePiece piece = path_.spline_pieces[path_.detail[i]];
        const SplineCurve& curve = path_.splines[piece.spline];
        const double from = begin > 0 ? parameter_at(curve, piece, length, begin) : piece.begin;
        const double to = end < length ? parameter_at(curve, piece, length, end) : piece.end;
        p.spline_pieces.push_back({piece.spline, from, to});
        push(SegmentKind::spline, path_.move[i], piece_length(curve, from, to),
             static_cast<std::uint32_t>(p.spline_pieces.size() - 1), last);
        return;
      }
      default: push(SegmentKind::line, path_.move[i], end - begin, kNoDetail, last);
    }
  }

  const Path& path_;
  const Moves& moves_;
  const std::vector<double>& merge_error_;  // what a merged segment has used of its tolerance already
  BlendTrims trims_;
  BlendedPath out_;
  MoveTeller teller_{path_, out_.path};
};

}  // namespace

bool asks_for_blends(const Moves& moves) {
  return std::any_of(moves.modes.begin(), moves.modes.end(),
                     [](const MoveMode& mode) { return mode.control == PathControl::blend; });
}

Result<BlendedPath> blend_path(const Path& path, const Moves& moves, const Rounding& options, const Monitor& monitor) {
  if (path.size() == 0) return BlendedPath{path, {}};
  const MergedLines merged = merge_lines(path, moves, options);
  BlendedPath result = Blender(merged.path, moves, options, merged.error).run(monitor);
  if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
  result.count.merged = path.size() - merged.path.size();
  return result;
}

}  // namespace toolpace
