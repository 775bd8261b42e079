#include "toolpace/rewrite/proof.h"

#include <algorithm>

#include "toolpace/rewrite/same_rows.h"
#include "toolpace/rewrite/walk.h"

namespace toolpace::detail::rewrite {
namespace {

constexpr std::size_t kWalkedAtOnce = 32;  // spans

class Prover {
 public:
  Prover(const Reading& before, const Reading& after, const Composed& composed, const std::vector<Edit>& edits,
         double tolerance, const Monitor& monitor)
      : before_(before),
        after_(after),
        a_(before.moves),
        b_(after.moves),
        composed_(composed),
        edits_(edits),
        meter_(tolerance),
        monitor_(monitor) {
    for (std::size_t k = 0; k < edits.size(); ++k) {
      if (!edits[k].stretches.empty()) by_row_.push_back(k);
    }
    std::sort(by_row_.begin(), by_row_.end(),
              [&](std::size_t p, std::size_t q) { return edits_[p].run.row < edits_[q].run.row; });
    proof_.rows.resize(edits.size());
  }

  Result<Proof> prove() {
    if (after_.refused) {
      blame_first_error();
      return proof_;
    }
    proof_.holds_outside = before_.dialect == after_.dialect && follow_rows() && same_modal();
    if (is_cancelled_) return tl::unexpected(cancelled_error());
    if (any_walked_) proof_.deviation = meter_.largest();
    return proof_;
  }

 private:
  /// Of a line that belongs to an edit; else null.
  const Origin* edited(std::size_t line) const {
    if (line == 0 || line > composed_.origin.size() || composed_.origin[line - 1].line != 0) return nullptr;
    return &composed_.origin[line - 1];
  }

  void blame_first_error() {
    for (const Diagnostic& d : after_.diagnostics) {
      if (d.severity != Severity::error) continue;
      if (const Origin* const origin = edited(d.where.line)) {
        proof_.holds_outside = true;
        proof_.wrong = {{origin->edit, origin->stretch, origin->span}};
      }
      return;
    }
  }

  /// Goes through the rows of both.
  bool follow_rows() {
    std::size_t next = 0;
    while (i_ < a_.size()) {
      if (i_ % kReportEvery == 0 && monitor_.is_cancelled()) return !(is_cancelled_ = true);
      if (next < by_row_.size() && edits_[by_row_[next]].run.row == i_) {
        if (!follow_edit(by_row_[next++])) return false;
        continue;
      }
      if (j_ >= b_.size() || !same_row(a_, i_, b_, j_) || !same_line()) return false;
      ++i_, ++j_;
    }
    return j_ == b_.size();
  }

  bool same_line() const {
    const std::size_t line = b_.line[j_];
    if (b_.file[j_] != 0) return line == a_.line[i_];
    if (line == 0 || line > composed_.origin.size()) return true;  // the end of the text itself
    return composed_.origin[line - 1].line == a_.line[i_];
  }

  bool follow_edit(std::size_t number) {
    const std::vector<Stretch>& stretches = edits_[number].stretches;
    for (std::size_t s = 0; s < stretches.size(); ++s) {
      const std::size_t begin = j_;
      for (std::size_t k = 0; k < stretches[s].spans.size(); ++k) {
        if (!follow_span({number, s, k}, stretches[s].spans[k])) return false;
      }
      walk_pending();
      proof_.rows[number].push_back({begin, j_});
    }
    skip_standing(number);
    return true;
  }

  /// A motion code alone, which restores what is modal, is a row that goes nowhere.
  void skip_standing(std::size_t number) {
    while (j_ < b_.size() && b_.file[j_] == 0 && b_.kind[j_] == MoveKind::feed && b_.end[j_] == b_.begin_of(j_)) {
      const Origin* const origin = edited(b_.line[j_]);
      if (!origin || origin->edit != number) return;
      ++j_;
    }
  }

  /// @return false where the rows no longer stand side by side
  bool follow_span(const SpanPlace& place, const Span& span) {
    const std::size_t rows = span.last - span.first, begin = j_;
    for (; j_ < b_.size() && b_.file[j_] == 0; ++j_) {
      const Origin* const origin = edited(b_.line[j_]);
      if (!origin || origin->edit != place.edit || origin->stretch != place.stretch || origin->span != place.span)
        break;
    }
    if (j_ == begin) return false;
    const Pending pending{place, {i_, i_ + rows}, {begin, j_}};
    i_ += rows;
    if (!begins_and_ends_alike(pending) || !says_the_same(pending, span.feed > 0.0)) {
      proof_.wrong.push_back(place);
    } else if (span.kind != Span::Kind::kept) {
      pending_.push_back(pending);
      if (pending_.size() < kWalkedAtOnce) return true;
      walk_pending();
    } else {
      walk_pending();
      if (j_ != begin + 1 || a_.kind[i_ - 1] != b_.kind[begin]) proof_.wrong.push_back(place);
    }
    return true;
  }

  struct Pending {
    SpanPlace place;
    Rows before, after;
  };

  bool begins_and_ends_alike(const Pending& p) const {
    return a_.begin_of(p.before.first) == b_.begin_of(p.after.first) &&
           a_.end[p.before.last - 1] == b_.end[p.after.last - 1];
  }

  /// As fast, or slower where that is planned, and under the same modes but for the plane.
  bool says_the_same(const Pending& p, bool may_be_slower) const {
    const std::size_t first = p.before.first;
    for (std::size_t row = first; row < p.before.last; ++row) {
      if (a_.feed[row] != a_.feed[first]) return false;
    }
    for (std::size_t row = p.after.first; row < p.after.last; ++row) {
      MoveMode mode = b_.modes[b_.mode[row]];
      mode.plane = a_.modes[a_.mode[first]].plane;
      const bool feeds = b_.kind[row] == MoveKind::feed || b_.kind[row] == MoveKind::arc;
      if (!feeds || (may_be_slower ? b_.feed[row] > a_.feed[first] : b_.feed[row] != a_.feed[first]) ||
          !(mode == a_.modes[a_.mode[first]]))
        return false;
    }
    return true;
  }

  /// All at once, and only where that does not hold one by one.
  void walk_pending() {
    if (pending_.empty()) return;
    any_walked_ = true;
    const Pending &first = pending_.front(), &last = pending_.back();
    const bool adjacent = last.before.last - first.before.first == total(&Pending::before) &&
                          last.after.last - first.after.first == total(&Pending::after);
    if (!adjacent ||
        !meter_.take({a_, first.before.first, last.before.last}, {b_, first.after.first, last.after.last})) {
      for (const Pending& p : pending_) {
        if (!meter_.take({a_, p.before.first, p.before.last}, {b_, p.after.first, p.after.last}))
          proof_.wrong.push_back(p.place);
      }
    }
    pending_.clear();
  }

  std::size_t total(Rows Pending::*rows) const {
    std::size_t sum = 0;
    for (const Pending& p : pending_) sum += (p.*rows).last - (p.*rows).first;
    return sum;
  }

  /// At the lines that stayed; the modal motion may differ where the next move names its own.
  bool same_modal() const {
    if (!is_in_order(a_)) return true;  // rows alone tell, then
    std::size_t last = 0;
    for (std::size_t k = 0; k < composed_.origin.size(); ++k) {
      const std::size_t line = composed_.origin[k].line;
      const bool is_behind_edit = line != 0 && line != last + 1;  // elsewhere lines follow their neighbours
      last = line;
      if (!is_behind_edit) continue;
      auto a = before_.modal.at(line), b = after_.modal.at(k + 1);
      if (a.has_value() != b.has_value()) return false;
      if (!a) continue;
      a->motion = b->motion = 0;
      if (!(*a == *b)) return false;
    }
    return true;
  }

  const Reading &before_, &after_;
  const Moves &a_, &b_;
  const Composed& composed_;
  const std::vector<Edit>& edits_;
  WalkMeter meter_;
  const Monitor& monitor_;
  std::vector<std::size_t> by_row_;
  std::size_t i_ = 0, j_ = 0;  // rows of both that come next
  std::vector<Pending> pending_;
  bool any_walked_ = false, is_cancelled_ = false;
  Proof proof_;
};

}  // namespace

Result<Proof> prove(const Reading& before, const Reading& after, const Composed& composed,
                    const std::vector<Edit>& edits, double tolerance, const Monitor& monitor) {
  return Prover(before, after, composed, edits, tolerance, monitor).prove();
}

}  // namespace toolpace::detail::rewrite
