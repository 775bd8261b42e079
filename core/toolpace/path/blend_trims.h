#pragma once
/// How much of its segments each corner takes.

#include <algorithm>
#include <cmath>
#include <vector>

#include "toolpace/nc/moves.h"
#include "toolpace/path/blend_path.h"
#include "toolpace/path/corner_chain.h"

namespace toolpace {

/// Chooses where the curves of all corners begin and end, so that each stays inside the tolerance.
class BlendTrims {
 public:
  /// @param merge_error  of each segment: what it has used of its tolerance already [mm, deg]. Keeps references.
  BlendTrims(const Path& path, const Moves& moves, const Rounding& options, const std::vector<double>& merge_error)
      : path_(path),
        moves_(moves),
        options_(options),
        merge_error_(merge_error),
        trim_(path.size() + 1, 0.0),
        chained_(path.size() + 1, false) {
    choose_trims();
  }

  /// What the curve at each node replaces of both its segments [mm]; 0 where there is none.
  const std::vector<double>& trims() const { return trim_; }
  double at(std::size_t node) const { return trim_[node]; }
  /// Whether a segment links its two nodes into one spline.
  bool is_chained(std::size_t segment) const { return chained_[segment]; }
  /// Corners left as they are because they turn back or lie beside rotary axes alone.
  std::size_t stops() const { return stops_; }
  bool is_line(std::size_t segment) const { return is_even_line(path_, segment); }
  /// Whether one feed holds on both sides of a node, or rapid traverse does.
  bool has_one_feed(std::size_t node) const {
    const std::uint32_t a = path_.move[node - 1], b = path_.move[node];
    const bool is_rapid = moves_.kind[a] == MoveKind::rapid;
    return is_rapid == (moves_.kind[b] == MoveKind::rapid) && (is_rapid || moves_.feed[a] == moves_.feed[b]);
  }

  /// Curve at a node where not two lines meet.
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
      most = std::max(most, Metric::apart().norm(blend_point(blend, t) - p));
    }
    return most;
  }

 private:
  // |u2 − u1| = 2·sin(α/2) at 111°: beyond, a stop costs less than the curvature of a curve inside the tolerance.
  static constexpr double kSharpest = 1.65;
  static constexpr double kSameDirection = 1e-9;  // of unit vectors
  static constexpr double kSameCurvature = 1e-6;  // |Δκ| times the shorter segment
  static constexpr int kChainRounds = 12;
  static constexpr double kShorter = 0.95;
  static constexpr std::size_t kChainPart = 256, kChainMargin = 4;  // nodes fitted at a time, and looked at beside them
  static constexpr std::size_t kTrimReach = 2;                      // nodes away to which a trim changes the curve
  static constexpr double kChainShare =
      0.98;  // of the tolerance at the nodes of a chain: between them it may be passed by a little
  static constexpr int kSearchSteps = 40;
  static constexpr int kSamples = 16;  // where the distance of a curve blend is looked at
  static constexpr double kUnlimitedTrim = 1e300;

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

  double tolerance_at(std::size_t segment) const {
    return tolerance_of(mode_of(segment), options_) - merge_error_[segment];
  }
  bool is_blended(std::size_t segment) const { return tolerance_of(mode_of(segment), options_) > 0; }
  const MoveMode& mode_of(std::size_t segment) const { return moves_.modes[moves_.mode[path_.move[segment]]]; }
  /// Between two feeds a curve of its own is cut where it passes the node.
  bool joins_lines(std::size_t node) const {
    return node > 0 && node < path_.size() && is_plain_line(node - 1) && is_plain_line(node) && has_one_feed(node);
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
      ++stops_;
      return 0;
    }
    const double tol = std::min(tolerance_at(i - 1), tolerance_at(i));
    if (is_line(i - 1) && is_line(i)) {
      const AxisVector turn = start_direction(path_, i) - end_direction(path_, i - 1);
      const double chord = Metric::along(false).norm(turn), size = Metric::apart().norm(turn);
      if (chord > kSharpest) ++stops_;
      if (chord > kSharpest || size <= kSameDirection) return 0;
      return 8 * tol / size;
    }
    const Frame a = frame_at(path_, i - 1, path_.length[i - 1]), b = frame_at(path_, i, 0);
    const double chord = Metric::along(false).norm(b.first - a.first), bend = (b.second - a.second).norm();
    const double shorter = std::min(path_.length[i - 1], path_.length[i]);
    if (chord > kSharpest) ++stops_;
    if (chord > kSharpest || (chord <= kSameDirection && bend * shorter <= kSameCurvature)) return 0;
    // An upper guess; curve_trim searches downwards from it. A kink is missed by 0.19·d·Δu, a jump of curvature by Δκ·d²/12.
    const double by_turn = chord > 0 ? 8 * tol / chord : kUnlimitedTrim;
    const double by_bend = bend > 0 ? std::sqrt(24 * tol / bend) : kUnlimitedTrim;
    return std::min(by_turn, by_bend);
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
    std::vector<bool> stays(end - begin + 1, false);  // good, and nothing around has changed since
    for (int round = 0; round < kChainRounds; ++round) {
      const CornerChain chain(path_, from, to, trim_);
      std::vector<std::size_t> shortened;
      for (std::size_t i = begin; i <= end; ++i) {
        const double tol = kChainShare * node_tolerance(i);
        if (stays[i - begin] || chain.offset(i) <= tol) continue;
        const double off = chain.pass(i).deviation;
        if (off <= tol) continue;
        trim_[i] *= std::min(kShorter, tol / off);
        shortened.push_back(i);
      }
      if (shortened.empty()) return round == 0;
      stays.assign(stays.size(), true);
      for (const std::size_t i : shortened) {
        for (std::size_t k = i - std::min(i - begin, kTrimReach); k <= std::min(end, i + kTrimReach); ++k) {
          stays[k - begin] = false;
        }
      }
    }
    return false;
  }
  double node_tolerance(std::size_t i) const { return std::min(tolerance_at(i - 1), tolerance_at(i)); }

  const Path& path_;
  const Moves& moves_;
  const Rounding& options_;
  const std::vector<double>& merge_error_;
  std::vector<double> trim_;   // of each node
  std::vector<bool> chained_;  // segments that link their two nodes into one spline
  std::size_t stops_ = 0;
};

}  // namespace toolpace
