#include "toolpace/rewrite/fit_run.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "toolpace/rewrite/fit_line.h"
#include "toolpace/rewrite/longest.h"

namespace toolpace::detail::rewrite {
namespace {

/// Within which share of the tolerance so many rows become one block; more of them do within all of it. Arcs among them were
/// rather fitted before than cut from a curve.
constexpr std::array<double, 4> kWorthIt = {0.0, 0.0, 0.8, 1.0};
constexpr std::array<double, 6> kArcsWorthIt = {0.0, 0.0, 0.1, 0.3, 0.5, 1.0};

constexpr double kWholeTurn = 6.283185307179586;
constexpr double kNearlyRound = 0.9;        // of a turn, behind which its end is looked for
constexpr std::size_t kMostToClose = 1024;  // rows further on

}  // namespace

RunFitter::RunFitter(const Curve& curve, const FitRules& rules, int plane)
    : curve_(curve),
      rules_(rules),
      tolerance_(rules.tolerance - curve.sagitta),
      arcs_(curve, rules.arc, tolerance_),
      planes_{plane, plane == 17 ? 18 : 17, plane == 19 ? 18 : 19} {}

std::size_t RunFitter::next_barrier(std::size_t vertex) {
  if (barrier_ <= vertex) {
    barrier_ = vertex + 1;
    while (curve_.barrier[barrier_] == 0) ++barrier_;
  }
  return barrier_;
}

Span RunFitter::longest(std::size_t first, std::size_t limit) {
  Span best =
      span(Span::Kind::line, first,
           farthest(first + 1, limit, [&](std::size_t last) { return fits_line(curve_, first, last, tolerance_); }));
  const std::size_t planes = !rules_.has_arcs ? 0 : rules_.arc.any_plane ? planes_.size() : 1;
  for (std::size_t k = 0; k < planes && best.last < limit; ++k) {
    const Span arc =
        longest_arc(planes_[k], first, best.last, limit, [](const FittedArc&, std::size_t) { return true; });
    if (arc.last > best.last) best = arc;
  }
  return is_worth_it(best) ? best : span(Span::Kind::kept, first, first + 1);
}

/// The vertex a little further on where the chain comes back to the start, seen along the plane's normal; 0 = none.
std::size_t RunFitter::closing_vertex(int plane, const Span& found, std::size_t limit) const {
  const double turns = found.arc.sweep / kWholeTurn;
  if (turns - std::floor(turns) < kNearlyRound) return 0;
  const PlaneOfArcs axes(plane);
  for (std::size_t k = found.last + 1; k <= std::min(limit, found.last + kMostToClose); ++k) {
    const Flat way = axes.flat(curve_.at(k) - curve_.at(found.first));
    if (way.u == 0.0 && way.v == 0.0) return k;
  }
  return 0;
}

bool RunFitter::is_worth_it(const Span& span) const {
  const std::size_t rows = span.last - span.first;
  const bool has_arcs = std::find(curve_.is_arc.begin() + span.first, curve_.is_arc.begin() + span.last, 1) !=
                        curve_.is_arc.begin() + span.last;
  if (rows >= (has_arcs ? kArcsWorthIt.size() : kWorthIt.size())) return true;
  if (rows < 2) return false;
  const double tolerance = (has_arcs ? kArcsWorthIt[rows] : kWorthIt[rows]) * tolerance_;
  if (tolerance >= tolerance_) return true;
  if (span.kind == Span::Kind::line) return fits_line(curve_, span.first, span.last, tolerance);
  return ArcFitter(curve_, rules_.arc, tolerance).fit(span.arc.plane, span.first, span.last).has_value();
}

std::vector<Span> fit_run(const Curve& curve, const FitRules& rules, int plane, const Monitor& monitor) {
  RunFitter fitter(curve, rules, plane);
  std::vector<Span> spans;
  for (std::size_t at = 0; at < curve.rows() && !monitor.is_cancelled();) {
    if (spans.size() % kSpansAReport == 0) monitor.report(static_cast<double>(at) / static_cast<double>(curve.rows()));
    spans.push_back(fitter.longest(at, fitter.next_barrier(at)));
    at = spans.back().last;
  }
  return spans;
}

}  // namespace toolpace::detail::rewrite
