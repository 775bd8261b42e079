#include "toolpace/path/blend_path.h"

#include <algorithm>
#include <cmath>

#include "toolpace/path/corner_chain.h"
#include "toolpace/path/merge_lines.h"
#include "toolpace/path/move_teller.h"

namespace toolpace {
namespace {

constexpr std::size_t kReportEvery = 1 << 16;
// |u2 − u1| = 2·sin(α/2) at 111°: beyond, a stop costs less than the curvature of a curve inside the tolerance.
constexpr double kSharpest = 1.65;
constexpr double kSameDirection = 1e-9;  // of unit vectors
constexpr double kSameCurvature = 1e-6;  // |Δκ| times the shorter segment
constexpr double kRest = 1e-9;           // a trimmed segment shorter than this share has vanished
constexpr int kChainRounds = 12;
constexpr double kShorter = 0.95;
constexpr std::size_t kChainPart = 256, kChainMargin = 4;  // nodes fitted at a time, and looked at beside them
constexpr double kChainShare =
    0.98;                 // of the tolerance at the nodes of a chain: between them it may be passed by a little
constexpr int kTold = 4;  // parts of a chain's piece in which moves are told by length
constexpr int kSearchSteps = 40;
constexpr int kSamples = 16;  // where the distance of a curve blend is looked at

/// Size of a difference as the tolerance counts it: one length in mm and degrees together, as a Fréchet test does.
double in_tube_unit(const AxisVector& d) {
  return std::hypot(d.head<3>().norm(), d.tail<3>().norm() / kRadiansPerDegree);
}

class Blender {
 public:
  Blender(const Path& path, const Moves& moves, const BlendOptions& options, const std::vector<double>& merge_error)
      : path_(path),
        moves_(moves),
        options_(options),
        merge_error_(merge_error),
        trim_(path.size() + 1, 0.0),
        chained_(path.size() + 1, false) {}

  BlendedPath run(const Monitor& monitor) {
    choose_trims();
    reserve();
    out_.path.node.push_back(path_.node.front());
    out_.path.splines = path_.splines;
    std::size_t pause = 0;
    for (std::size_t i = 0; i <= path_.size(); ++i) {
      if (i % kReportEvery == 0) monitor.report(static_cast<double>(i) / static_cast<double>(path_.size() + 1));
      if (i % kReportEvery == 0 && monitor.is_cancelled()) break;
      for (; pause < path_.pauses.size() && path_.pauses[pause].node == i; ++pause) {
        out_.path.pauses.push_back(path_.pauses[pause]);
        out_.path.pauses.back().node = static_cast<std::uint32_t>(out_.path.size());
      }
      if (chained_[i]) {
        std::size_t last = i;
        while (chained_[last]) ++last;
        add_chain(i, last);
        i = last;
      } else if (trim_[i] > 0) {
        add_blend(i);
      }
      if (i < path_.size()) add_rest(i);
    }
    return std::move(out_);
  }

 private:
  void reserve() {
    const auto blends =
        static_cast<std::size_t>(std::count_if(trim_.begin(), trim_.end(), [](double d) { return d > 0; }));
    const std::size_t n = path_.size() + blends;
    Path& p = out_.path;
    p.kind.reserve(n);
    p.length.reserve(n);
    p.move.reserve(n);
    p.detail.reserve(n);
    p.node.reserve(n + 1);
    p.corner_blends.reserve(blends);
  }

  double tolerance_at(std::size_t segment) const {
    const MoveMode& mode = moves_.modes[moves_.mode[path_.move[segment]]];
    const double programmed =
        mode.control == PathControl::blend && mode.tolerance > 0 ? mode.tolerance : options_.tolerance;
    return programmed - merge_error_[segment];
  }
  bool is_blended(std::size_t segment) const {
    const PathControl control = moves_.modes[moves_.mode[path_.move[segment]]].control;
    return control == PathControl::blend || (control == PathControl::job_default && options_.everywhere);
  }
  bool is_line(std::size_t segment) const { return path_.kind[segment] == SegmentKind::line; }

  /// How much of both neighbours of each node its blend replaces; 0 for none. Lines too short for the blends at both their
  /// ends are chained: the nodes of a chain become one spline.
  void choose_trims() {
    std::vector<bool> rests(path_.size() + 1, false);
    for (const Path::Pause& p : path_.pauses) rests[p.node] = true;
    for (std::size_t i = 1; i < path_.size(); ++i) {
      if (!rests[i] && is_blended(i - 1) && is_blended(i)) trim_[i] = wanted(i);
    }
    // Both rules read the wishes, so order does not matter.
    const std::vector<double> wish = trim_;
    for (std::size_t i = 1; i < path_.size(); ++i) {
      if (!(wish[i] > 0)) continue;
      trim_[i] = std::min(share(wish, i, i - 1, i - 1), share(wish, i, i, i + 1));
      chained_[i] = chains(wish, i);
      if (!(is_line(i - 1) && is_line(i))) trim_[i] = curve_trim(i, trim_[i]);
    }
    for (std::size_t i = 1; i < path_.size(); ++i) {
      if (!chained_[i] || chained_[i - 1]) continue;
      std::size_t last = i;
      while (chained_[last]) ++last;
      fit_chain(i, last);
    }
  }

  bool joins_lines(std::size_t node) const {
    return node > 0 && node < path_.size() && is_plain_line(node - 1) && is_plain_line(node);
  }
  bool is_plain_line(std::size_t segment) const {
    return is_line(segment) && path_.node[segment].tail<3>() == path_.node[segment + 1].tail<3>();
  }
  /// Does segment i link its two nodes into one spline?
  bool chains(const std::vector<double>& wish, std::size_t i) const {
    return wish[i] > 0 && wish[i + 1] > 0 && joins_lines(i) && joins_lines(i + 1) &&
           wish[i] + wish[i + 1] > path_.length[i];
  }
  /// What node i may take of one of its segments: all it wants where a chain or room lets it, else half, or what the node
  /// at the other end leaves.
  double share(const std::vector<double>& wish, std::size_t i, std::size_t segment, std::size_t other) const {
    const double length = path_.length[segment];
    if (segment == i ? chains(wish, i) : chains(wish, i - 1)) return wish[i];
    return std::min(wish[i], std::max(length / 2, length - wish[other]));
  }

  double wanted(std::size_t i) {
    if (is_rotary_only(path_, i - 1) || is_rotary_only(path_, i)) {
      ++out_.count.stops;
      return 0;
    }
    const double tol = std::min(tolerance_at(i - 1), tolerance_at(i));
    if (is_line(i - 1) && is_line(i)) {
      const AxisVector turn = start_direction(path_, i) - end_direction(path_, i - 1);
      const double chord = turn.head<3>().norm(), size = in_tube_unit(turn);
      if (chord > kSharpest) ++out_.count.stops;
      if (chord > kSharpest || size <= kSameDirection) return 0;
      return 8 * tol / size;
    }
    const Frame a = frame_at(path_, i - 1, path_.length[i - 1]), b = frame_at(path_, i, 0);
    const double chord = (b.first - a.first).head<3>().norm(), bend = (b.second - a.second).norm();
    const double shorter = std::min(path_.length[i - 1], path_.length[i]);
    if (chord > kSharpest) ++out_.count.stops;
    if (chord > kSharpest || (chord <= kSameDirection && bend * shorter <= kSameCurvature)) return 0;
    // An upper guess; curve_trim searches downwards from it. A kink is missed by 0.19·d·Δu, a jump of curvature by Δκ·d²/12.
    const double by_turn = chord > 0 ? 8 * tol / chord : kUnlimitedTrim;
    const double by_bend = bend > 0 ? std::sqrt(24 * tol / bend) : kUnlimitedTrim;
    return std::min(by_turn, by_bend);
  }

  CurveBlend curve_blend(std::size_t i, double d) const {
    const Frame a = frame_at(path_, i - 1, path_.length[i - 1] - d), b = frame_at(path_, i, d);
    return make_curve_blend({a.point, a.first, a.second}, {b.point, b.first, b.second}, 2 * d);
  }

  /// Distance of blend and path, coupled by the share of their lengths: an upper bound of the Fréchet distance up to what
  /// lies between the samples.
  double curve_deviation(std::size_t i, double d) const {
    const CurveBlend blend = curve_blend(i, d);
    double most = 0;
    for (int k = 1; k < kSamples; ++k) {
      const double t = static_cast<double>(k) / kSamples, s = (2 * t - 1) * d;
      const AxisVector p = s < 0 ? point_at(path_, i - 1, path_.length[i - 1] + s) : point_at(path_, i, s);
      most = std::max(most, in_tube_unit(blend_point(blend, t) - p));
    }
    return most;
  }

  /// Largest trim ≤ `most` whose blend stays inside the tolerance.
  double curve_trim(std::size_t i, double most) const {
    const double tol = std::min(tolerance_at(i - 1), tolerance_at(i)) * 0.99;
    double d = most;
    for (int k = 0; k < kSearchSteps; ++k) {
      const double deviation = curve_deviation(i, d);
      if (deviation <= tol) return d;
      d *= std::clamp(0.98 * tol / deviation, 0.3, 0.95);
    }
    return 0;
  }

  void push(SegmentKind kind, std::uint32_t move, double length, std::uint32_t detail, const AxisVector& end) {
    Path& p = out_.path;
    p.kind.push_back(kind);
    p.move.push_back(move);
    p.length.push_back(length);
    p.detail.push_back(detail);
    p.node.push_back(end);
  }

  /// The slower neighbour's move: its feed holds in the corner too.
  std::uint32_t slower_move(std::size_t i) const {
    const std::uint32_t a = path_.move[i - 1], b = path_.move[i];
    if (moves_.kind[a] == MoveKind::rapid) return b;
    if (moves_.kind[b] == MoveKind::rapid) return a;
    return moves_.feed[b] <= moves_.feed[a] ? b : a;
  }

  void add_blend(std::size_t i) {
    const double d = trim_[i];
    ++out_.count.corners;
    Path& p = out_.path;
    if (is_line(i - 1) && is_line(i)) {
      const CornerBlend blend{path_.node[i], d * end_direction(path_, i - 1), d * start_direction(path_, i)};
      note(i, in_tube_unit(blend.after - blend.before) / 8);
      p.corner_blends.push_back(blend);
      const auto index = static_cast<std::uint32_t>(p.corner_blends.size() - 1);
      push(SegmentKind::blend, slower_move(i), blend_length(blend), index, blend.corner + blend.after);
      tell_corner(i);
      return;
    }
    const CurveBlend blend = curve_blend(i, d);
    note(i, curve_deviation(i, d));
    p.curve_blends.push_back(blend);
    const auto index = static_cast<std::uint32_t>(p.curve_blends.size() - 1);
    push(SegmentKind::blend, slower_move(i), blend_length(blend), Path::kCurveBlend + index, blend.points[5]);
    tell_corner(i);
  }

  /// The blend just added passes its node in the middle.
  void tell_corner(std::size_t i) {
    const std::size_t now = out_.path.size() - 1;
    const double before = path_.length[i - 1], whole = out_.path.length[now];
    teller_.tell({i - 1, before - trim_[i], before}, {now, 0, whole / 2});
    teller_.tell({i, 0, trim_[i]}, {now, whole / 2, whole});
  }

  /// Shortens the trims of a chain until its spline passes every node within the tolerance.
  /// A node's distance hangs on its neighbours alone: part by part, until no part changes.
  void fit_chain(std::size_t first, std::size_t last) {
    bool good = false;
    for (int round = 0; round < kChainRounds && !good; ++round) {
      good = true;
      for (std::size_t begin = first; begin <= last; begin += kChainPart) {
        good &= fit_part(first, last, begin, std::min(begin + kChainPart - 1, last));
      }
    }
  }
  /// @return whether it was good at once
  bool fit_part(std::size_t first, std::size_t last, std::size_t begin, std::size_t end) {
    const std::size_t from = begin - std::min(begin - first, kChainMargin), to = std::min(last, end + kChainMargin);
    for (int round = 0; round < kChainRounds; ++round) {
      const CornerChain chain(path_, from, to, trim_);
      bool good = true;
      for (std::size_t i = begin; i <= end; ++i) {
        const double tol = kChainShare * node_tolerance(i), off = chain.deviation(i);
        if (off <= tol) continue;
        good = false;
        trim_[i] *= std::min(kShorter, tol / off);
      }
      if (good) return round == 0;
    }
    return false;
  }
  double node_tolerance(std::size_t i) const { return std::min(tolerance_at(i - 1), tolerance_at(i)); }

  /// Nodes first … last as one cubic spline between the trimmed lines before and after them.
  void add_chain(std::size_t first, std::size_t last) {
    const CornerChain chain(path_, first, last, trim_);
    for (std::size_t i = first; i <= last; ++i) note(i, chain.deviation(i));
    out_.count.corners += last - first + 1;
    Path& p = out_.path;
    const auto index = static_cast<std::uint32_t>(p.splines.size());
    p.splines.push_back(chain.curve());
    const auto pieces = chain.cut();
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      p.spline_pieces.push_back({index, pieces[k].begin, pieces[k].end});
      const AxisVector end = k + 1 < pieces.size() ? chain.point(pieces[k].end) : point_at(path_, last, trim_[last]);
      push(SegmentKind::spline, path_.move[pieces[k].segment], pieces[k].length,
           static_cast<std::uint32_t>(p.spline_pieces.size() - 1), end);
    }
    tell_chain(first, last, chain, pieces);
  }

  /// Tells which moves the pieces just added stand for. They end where the spline is simple, not where it passes the nodes.
  void tell_chain(std::size_t first, std::size_t last, const CornerChain& chain,
                  const std::vector<CornerChain::Piece>& pieces) {
    const std::size_t before = out_.path.size() - pieces.size();
    double from = 0, told = path_.length[first - 1] - trim_[first], told_at = 0;
    std::size_t k = 0;
    for (std::size_t segment = first - 1; segment <= last; ++segment, told = 0) {
      const double to = segment < last ? std::max(from, chain.passing(segment + 1)) : pieces.back().end;
      const double top = segment < last ? path_.length[segment] : trim_[last];
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
    const AxisVector chord = path_.node[segment + 1] - path_.node[segment], from = point - path_.node[segment];
    return std::clamp(from.head<3>().dot(chord.head<3>()) / path_.length[segment], 0.0, path_.length[segment]);
  }

  void note(std::size_t i, double deviation) {
    const double merged = std::max(merge_error_[i - 1], merge_error_[i]);
    out_.count.deviation = std::max(out_.count.deviation, deviation + merged);
  }

  /// What the blends leave of a segment.
  void add_rest(std::size_t i) {
    const double length = path_.length[i], begin = trim_[i], end = length - trim_[i + 1];
    out_.count.deviation = std::max(out_.count.deviation, merge_error_[i]);
    if (end - begin <= kRest * length) return;
    const AxisVector last = trim_[i + 1] > 0 ? point_at(path_, i, end) : path_.node[i + 1];
    push_rest(i, begin, end, last);
    const std::size_t now = out_.path.size() - 1;
    teller_.tell({i, begin, end}, {now, 0, out_.path.length[now]});
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

  static ArcCurve part_of_arc(const ArcCurve& arc, double length, double begin, double end) {
    const double from = begin > 0 ? angle_at(arc, length, begin) : 0,
                 to = end < length ? angle_at(arc, length, end) : arc.sweep;
    const auto radius = [&](double angle) {
      return arc.start_radius + (arc.end_radius - arc.start_radius) * angle / arc.sweep;
    };
    ArcCurve part = arc;
    part.centre = arc.centre + (arc.rise * from / arc.sweep) * arc.normal;
    part.radial = std::cos(from) * arc.radial + std::sin(from) * arc.lateral;
    part.lateral = std::cos(from) * arc.lateral - std::sin(from) * arc.radial;
    part.start_radius = radius(from);
    part.end_radius = radius(to);
    part.sweep = to - from;
    part.rise = arc.rise * (to - from) / arc.sweep;
    return part;
  }

  static constexpr double kUnlimitedTrim = 1e300;

  const Path& path_;
  const Moves& moves_;
  const BlendOptions& options_;
  const std::vector<double>& merge_error_;  // what a merged segment has used of its tolerance already
  std::vector<double> trim_;                // of each node
  std::vector<bool> chained_;               // segments that link their two nodes into one spline
  BlendedPath out_;
  MoveTeller teller_{path_, out_.path};
};

}  // namespace

bool asks_for_blends(const Moves& moves) {
  return std::any_of(moves.modes.begin(), moves.modes.end(),
                     [](const MoveMode& mode) { return mode.control == PathControl::blend; });
}

Result<BlendedPath> blend_path(const Path& path, const Moves& moves, const BlendOptions& options,
                               const Monitor& monitor) {
  if (path.size() == 0) return BlendedPath{path, {}};
  const MergedLines merged = merge_lines(path, moves, options);
  BlendedPath result = Blender(merged.path, moves, options, merged.error).run(monitor);
  if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
  result.count.merged = path.size() - merged.path.size();
  return result;
}

}  // namespace toolpace
