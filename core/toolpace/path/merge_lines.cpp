#include "toolpace/path/merge_lines.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

constexpr Metric kAlong = Metric::along(false);  // lines of rotary axes alone are not merged
constexpr double kMergeShare = 1.0 / 3;          // of the tolerance
constexpr std::size_t kMostMerged = 32;          // lines in one, so that time stays linear
constexpr double kMostTurn = 0.94;               // cosine of the largest turn inside a run

class Merger {
 public:
  Merger(const Path& path, const Moves& moves, const Rounding& options)
      : path_(path), moves_(moves), options_(options) {}

  MergedLines run() {
    out_.path.arcs = path_.arcs;
    out_.path.splines = path_.splines;
    out_.path.spline_pieces = path_.spline_pieces;
    out_.path.node.push_back(path_.node.front());
    out_.path.tellings = path_.tellings;
    out_.path.turns = path_.turns;
    out_.path.out_of_plane = path_.out_of_plane;
    std::size_t pause = 0;
    for (std::size_t i = 0; i < path_.size();) {
      pass_pauses(i, pause);
      const std::size_t rest = pause < path_.pauses.size() ? path_.pauses[pause].node : path_.size();
      i = add_run(i, std::min(rest, i + kMostMerged));
    }
    pass_pauses(path_.size(), pause);
    out_.path.position = NodePositions(out_.path.length);
    return std::move(out_);
  }

 private:
  void pass_pauses(std::size_t node, std::size_t& pause) {
    for (; pause < path_.pauses.size() && path_.pauses[pause].node == node; ++pause) {
      out_.path.pauses.push_back(path_.pauses[pause]);
      out_.path.pauses.back().node = static_cast<std::uint32_t>(out_.path.size());
    }
    if (told_ < path_.tellings.size() && path_.tellings[told_].node == node)
      out_.path.tellings[told_++].node = static_cast<std::uint32_t>(out_.path.size());
  }

  bool joins(std::size_t a, std::size_t b) const {
    const std::uint32_t p = path_.move[a], q = path_.move[b];
    return is_even_line(path_, b) && moves_.kind[p] == moves_.kind[q] && moves_.feed[p] == moves_.feed[q] &&
           moves_.mode[p] == moves_.mode[q] && !is_rotary_only(path_, b);
  }

  /// Adds the longest run of lines from segment i, or the segment alone. @return the segment after it
  std::size_t add_run(std::size_t i, std::size_t limit) {
    std::size_t end = i + 1;
    double error = 0;
    if (is_even_line(path_, i) && !is_rotary_only(path_, i) && may_merge(i)) {
      while (end < limit && joins(i, end)) {
        const double wider = deviation(i, end + 1);
        if (!(wider <= kMergeShare * tolerance_at(i))) break;
        error = wider;
        ++end;
      }
    }
    Path& p = out_.path;
    p.kind.push_back(path_.kind[i]);
    p.move.push_back(path_.move[i]);
    if (!path_.turn.empty()) p.turn.push_back(path_.turn[i]);
    p.detail.push_back(path_.detail[i]);
    p.length.push_back(end == i + 1 ? path_.length[i] : kAlong.norm(path_.end_of(end - 1) - path_.node[i]));
    p.node.push_back(path_.node[end]);
    out_.error.push_back(error);
    tell_moves(i, end);
    return end;
  }

  /// Where the run just added passes the vertices that it leaves out.
  void tell_moves(std::size_t begin, std::size_t end) {
    Path& p = out_.path;
    const auto segment = static_cast<std::uint32_t>(p.size() - 1);
    const AxisVector chord = path_.end_of(end - 1) - p.node[segment];
    for (std::size_t k = begin + 1; k < end; ++k) {
      const double at = kAlong.dot(path_.node[k] - p.node[segment], chord) / p.length[segment];
      p.handovers.push_back({segment, path_.move[k], at});
    }
  }

  bool may_merge(std::size_t i) const { return tolerance_at(i) > 0; }
  double tolerance_at(std::size_t i) const { return tolerance_of(moves_.modes[moves_.mode[path_.move[i]]], options_); }

  /// Largest distance of the vertices between two nodes from the line that joins them; infinite where they go back or turn.
  double deviation(std::size_t begin, std::size_t end) const {
    const AxisVector& a = path_.node[begin];
    const AxisVector chord = path_.end_of(end - 1) - a;
    const double square = kAlong.squared_norm(chord);
    double most = 0, before = 0;
    for (std::size_t k = begin + 1; k < end; ++k) {
      const AxisVector d = path_.node[k] - a;
      const double along = kAlong.dot(d, chord) / square;
      if (!(along > before && along < 1)) return kNever;
      before = along;
      const AxisVector e = d - along * chord;
      most = std::max(most, Metric::apart().norm(e));
    }
    const double root = std::sqrt(square);
    for (const std::size_t k : {begin, end - 1}) {
      if (kAlong.dot(path_.end_of(k) - path_.node[k], chord) < kMostTurn * root * path_.length[k]) return kNever;
    }
    return most;
  }

  static constexpr double kNever = 1e300;

  const Path& path_;
  const Moves& moves_;
  const Rounding& options_;
  std::size_t told_ = 0;  ///< first of the tellings to come
  MergedLines out_;
};

}  // namespace

MergedLines merge_lines(const Path& path, const Moves& moves, const Rounding& options) {
  return Merger(path, moves, options).run();
}

}  // namespace toolpace
