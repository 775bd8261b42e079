#include "toolpace/rewrite/fit_run.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "toolpace/rewrite/fit_line.h"

namespace toolpace::detail::rewrite {
namespace {

/// Within which share of the tolerance so many rows become one block; more of them do within all of it.
constexpr std::array<double, 4> kWorthIt = {0.0, 0.0, 0.3, 1.0};

constexpr double kWholeTurn = 6.283185307179586;
constexpr double kNearlyRound = 0.9;        // of a turn, behind which its end is looked for
constexpr std::size_t kMostToClose = 1024;  // rows further on

/// The farthest end up to `limit` that `fits`, looked for in doubling steps from `from`, which does.
template <class Fits>
std::size_t farthest(std::size_t from, std::size_t limit, const Fits& fits) {
  std::size_t step = 1;
  while (from + step <= limit && fits(from + step)) {
    from += step;
    step *= 2;
  }
  for (step /= 2; step > 0; step /= 2) {
    while (from + step <= limit && fits(from + step)) from += step;
  }
  return from;
}

class RunFitter {
 public:
  RunFitter(const Curve& curve, const FitRules& rules, int plane)
      : curve_(curve),
        rules_(rules),
        tolerance_(rules.tolerance - curve.sagitta),
        arcs_(curve, rules.arc, tolerance_),
        planes_{plane, plane == 17 ? 18 : 17, plane == 19 ? 18 : 19} {}

  std::vector<Span> fit() {
    std::vector<Span> spans;
    for (std::size_t at = 0; at < curve_.rows();) {
      const Span span = longest(at, next_barrier(at));
      at = span.last;
      spans.push_back(span);
    }
    return spans;
  }

 private:
  std::size_t next_barrier(std::size_t vertex) {
    if (barrier_ <= vertex) {
      barrier_ = vertex + 1;
      while (curve_.barrier[barrier_] == 0) ++barrier_;
    }
    return barrier_;
  }

  static Span span(Span::Kind kind, std::size_t first, std::size_t last) {
    return {kind, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last), {}};
  }

  Span longest(std::size_t first, std::size_t limit) {
    Span best =
        span(Span::Kind::line, first,
             farthest(first + 1, limit, [&](std::size_t last) { return fits_line(curve_, first, last, tolerance_); }));
    const std::size_t planes = !rules_.has_arcs ? 0 : rules_.arc.any_plane ? planes_.size() : 1;
    for (std::size_t k = 0; k < planes && best.last < limit; ++k) try_arcs(planes_[k], limit, best);
    return is_worth_it(best) ? best : span(Span::Kind::kept, first, first + std::size_t{1});
  }

  /// Replaces `best` by an arc of this plane that reaches farther.
  void try_arcs(int plane, std::size_t limit, Span& best) {
    const std::size_t first = best.first;
    FittedArc found;
    const auto fits = [&](std::size_t last) {
      const auto arc = arcs_.fit(plane, first, last);
      if (arc) found = *arc;
      return arc.has_value();
    };
    const std::size_t begin = best.last;
    std::size_t last = farthest(begin, limit, fits);
    if (last == begin) return;
    // Close to a whole turn only its very end will do.
    while (const std::size_t closing = closing_vertex(plane, first, last, limit, found.sweep)) {
      if (!fits(closing)) break;
      last = farthest(closing, limit, fits);
    }
    best = span(Span::Kind::arc, first, last);
    best.arc = found;
  }

  /// The vertex a little further on where the chain comes back to the start, seen along the plane's normal; 0 = none.
  std::size_t closing_vertex(int plane, std::size_t first, std::size_t last, std::size_t limit, double sweep) const {
    const double turns = sweep / kWholeTurn;
    if (turns - std::floor(turns) < kNearlyRound) return 0;
    const Eigen::Index normal = plane == 17 ? 2 : plane == 18 ? 1 : 0;
    for (std::size_t k = last + 1; k <= std::min(limit, last + kMostToClose); ++k) {
      const Eigen::Vector3d way = curve_.at(k) - curve_.at(first);
      if (way[(normal + 1) % 3] == 0.0 && way[(normal + 2) % 3] == 0.0) return k;
    }
    return 0;
  }

  bool is_worth_it(const Span& span) {
    const std::size_t rows = span.last - span.first;
    if (rows >= kWorthIt.size()) return true;
    if (rows < 2) return false;
    const double tolerance = kWorthIt[rows] * tolerance_;
    if (span.kind == Span::Kind::line) return fits_line(curve_, span.first, span.last, tolerance);
    return ArcFitter(curve_, rules_.arc, tolerance).fit(span.arc.plane, span.first, span.last).has_value();
  }

  const Curve& curve_;
  const FitRules& rules_;
  double tolerance_;
  ArcFitter arcs_;
  std::array<int, 3> planes_;
  std::size_t barrier_ = 0;
};

}  // namespace

std::vector<Span> fit_run(const Curve& curve, const FitRules& rules, int plane) {
  return RunFitter(curve, rules, plane).fit();
}

}  // namespace toolpace::detail::rewrite
