#include "toolpace/rewrite/same_rows.h"

namespace toolpace::detail::rewrite {
namespace {

bool same_detail(const Moves& a, std::size_t i, const Moves& b, std::size_t j) {
  const std::uint32_t p = a.detail[i], q = b.detail[j];
  if (p >= kTapReturn || q >= kTapReturn) return p == q;
  switch (a.kind[i]) {
    case MoveKind::arc: {
      const ArcDetail &x = a.arcs[p], &y = b.arcs[q];
      const Eigen::Vector3d n = x.normal, m = y.normal;
      return x.centre == y.centre && n == m && x.sweep == y.sweep;
    }
    case MoveKind::spline: {
      const SplineDetail &x = a.splines[p], &y = b.splines[q];
      return x.degree == y.degree && x.points == y.points && x.weights == y.weights && x.knots == y.knots;
    }
    case MoveKind::dwell: return a.dwells[p] == b.dwells[q];
    default: return a.notes[p] == b.notes[q];
  }
}

}  // namespace

bool same_row(const Moves& a, std::size_t i, const Moves& b, std::size_t j) {
  return a.kind[i] == b.kind[j] && a.end[i] == b.end[j] && a.feed[i] == b.feed[j] && a.file[i] == b.file[j] &&
         a.modes[a.mode[i]] == b.modes[b.mode[j]] &&
         a.ceilings[a.modes[a.mode[i]].ceiling] == b.ceilings[b.modes[b.mode[j]].ceiling] && same_detail(a, i, b, j);
}

}  // namespace toolpace::detail::rewrite
