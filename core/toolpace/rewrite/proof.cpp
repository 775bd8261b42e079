#include "toolpace/rewrite/proof.h"

#include <algorithm>

#include "toolpace/rewrite/walk.h"

namespace toolpace::detail::rewrite {
namespace {

class Prover {
 public:
  Prover(const Reading& before, const Reading& after, const Composed& composed, const std::vector<Edit>& edits,
         double tolerance, const Monitor& monitor)
      : before_(before), after_(after), composed_(composed), edits_(edits), meter_(tolerance), monitor_(monitor) {
    for (std::size_t k = 0; k < edits.size(); ++k) {
      if (!edits[k].spans.empty()) by_row_.push_back(k);
    }
    const auto row_of = [&](std::size_t k) { return edits_[k].run.row; };
    std::sort(by_row_.begin(), by_row_.end(), [&](std::size_t a, std::size_t b) { return row_of(a) < row_of(b); });
  }

  Result<Proof> prove() {
    if (after_.refused) {
      blame_first_error();
      return proof_;
    }
    proof_.holds_outside = before_.dialect == after_.dialect && follow_rows() && same_modal();
    if (is_cancelled_) return tl::unexpected(cancelled_error());
    proof_.deviation = by_row_.empty() ? 0.0 : meter_.largest();
    return proof_;
  }

 private:
  /// The edit that a line of the new program belongs to, or none.
  std::optional<std::size_t> edit_at(std::size_t line) const {
    if (line == 0 || line > composed_.origin.size() || composed_.origin[line - 1] > 0) return std::nullopt;
    return static_cast<std::size_t>(-composed_.origin[line - 1] - 1);
  }

  void blame_first_error() {
    for (const Diagnostic& d : after_.diagnostics) {
      if (d.severity != Severity::error) continue;
      if (const auto edit = edit_at(d.where.line)) {
        proof_.holds_outside = true;
        proof_.wrong = {*edit};
      }
      return;
    }
  }

  /// Goes through the rows of both; replaced runs are measured as wholes.
  bool follow_rows() {
    const Moves &a = before_.moves, &b = after_.moves;
    std::size_t i = 0, j = 0, next = 0;
    while (i < a.size()) {
      if (monitor_.is_cancelled()) return !(is_cancelled_ = true);
      if (next < by_row_.size() && edits_[by_row_[next]].run.row == i) {
        const std::size_t edit = by_row_[next++], begin = j;
        while (j < b.size() && b.file[j] == 0 && edit_at(b.line[j]) == edit) ++j;
        measure(edit, {a, i, i + edits_[edit].run.count}, {b, begin, j});
        i += edits_[edit].run.count;
        continue;
      }
      if (j >= b.size() || !same_row(i, j)) return false;
      ++i, ++j;
    }
    return j == b.size();
  }

  void measure(std::size_t edit, const Stretch& before, const Stretch& after) {
    const Moves& b = after.moves;
    bool fine = after.last > after.first && b.end[after.last - 1] == before.moves.end[before.last - 1] &&
                b.begin_of(after.first) == before.moves.begin_of(before.first);
    for (std::size_t row = after.first; fine && row < after.last; ++row) {
      const bool feeds = b.kind[row] == MoveKind::feed || b.kind[row] == MoveKind::arc;
      MoveMode mode = b.modes[b.mode[row]];  // but for the plane, of what the lines were under
      mode.plane = static_cast<std::uint8_t>(edits_[edit].run.plane);
      fine = feeds && mode == before.moves.modes[before.moves.mode[before.first]];
    }
    fine = fine && same_feeds(edit, before, after) && meter_.take(before, after);
    if (!fine) proof_.wrong.push_back(edit);
  }

  /// Whether each block is as fast as all of the rows that it stands for.
  bool same_feeds(std::size_t edit, const Stretch& before, const Stretch& after) const {
    const std::vector<Span>& spans = edits_[edit].spans;
    if (spans.size() != after.last - after.first) return false;
    for (std::size_t k = 0; k < spans.size(); ++k) {
      for (std::size_t row = spans[k].first; row < spans[k].last; ++row) {
        if (before.moves.feed[before.first + row] != after.moves.feed[after.first + k]) return false;
      }
    }
    return true;
  }

  bool same_row(std::size_t i, std::size_t j) const {
    const Moves &a = before_.moves, &b = after_.moves;
    if (a.kind[i] != b.kind[j] || a.end[i] != b.end[j] || a.feed[i] != b.feed[j] || a.file[i] != b.file[j])
      return false;
    if (!(a.modes[a.mode[i]] == b.modes[b.mode[j]])) return false;
    if (b.file[j] != 0) return a.line[i] == b.line[j] && same_detail(i, j);
    const std::size_t line = b.line[j];
    const bool same_line = line >= 1 && line <= composed_.origin.size()
                               ? composed_.origin[line - 1] == static_cast<std::int64_t>(a.line[i])
                               : line == composed_.origin.size() + 1 || line == 0;  // the end of the text itself
    return same_line && same_detail(i, j);
  }

  bool same_detail(std::size_t i, std::size_t j) const {
    const Moves &a = before_.moves, &b = after_.moves;
    const std::uint32_t p = a.detail[i], q = b.detail[j];
    if (p >= kTapReturn || q >= kTapReturn) return p == q;
    switch (a.kind[i]) {
      case MoveKind::arc: {
        const ArcDetail &x = a.arcs[p], &y = b.arcs[q];
        const Eigen::Vector3d n = x.normal, m = y.normal;
        return x.centre == y.centre && n == m && x.sweep == y.sweep;
      }
      case MoveKind::spline:
        return a.splines[p].points == b.splines[q].points && a.splines[p].knots == b.splines[q].knots;
      case MoveKind::dwell: return a.dwells[p] == b.dwells[q];
      case MoveKind::tool:
      case MoveKind::stop:
      case MoveKind::end: return a.notes[p] == b.notes[q];
      default: return p == q;
    }
  }

  /// At the lines that stayed; the modal motion may differ where the next move names its own.
  bool same_modal() {
    if (!is_in_order(before_.moves)) return true;  // rows alone tell, then
    for (std::size_t k = 0; k < composed_.origin.size(); ++k) {
      if (composed_.origin[k] <= 0) continue;
      if (k > 0 && composed_.origin[k - 1] == composed_.origin[k] - 1) continue;  // as its neighbour, which was seen
      auto a = before_.modal.at(static_cast<std::size_t>(composed_.origin[k])), b = after_.modal.at(k + 1);
      if (a.has_value() != b.has_value()) return false;
      if (!a) continue;
      a->motion = b->motion = 0;
      if (!(*a == *b)) return false;
    }
    return true;
  }

  const Reading &before_, &after_;
  const Composed& composed_;
  const std::vector<Edit>& edits_;
  WalkMeter meter_;
  const Monitor& monitor_;
  std::vector<std::size_t> by_row_;
  bool is_cancelled_ = false;
  Proof proof_;
};

}  // namespace

Result<Proof> prove(const Reading& before, const Reading& after, const Composed& composed,
                    const std::vector<Edit>& edits, double tolerance, const Monitor& monitor) {
  return Prover(before, after, composed, edits, tolerance, monitor).prove();
}

}  // namespace toolpace::detail::rewrite
