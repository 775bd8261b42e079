#include "toolpace/rewrite/rewrite.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "toolpace/nc/reader.h"
#include "toolpace/rewrite/fit_program.h"
#include "toolpace/rewrite/proof.h"

namespace toolpace {
namespace {

using namespace detail::rewrite;

constexpr int kProofRounds = 12;    // of writing and proving
constexpr int kFits = 3;            // smooth, with arcs, with lines
constexpr int kTimeRounds = 8;      // of timing
constexpr double kSameTime = 1e-9;  // relative
constexpr double kPatience =
    0.01;  // relative: a stretch may take so much longer as long as the program does not, at first
constexpr double kWorthTime = 0.005;  // relative: what is gained by less is rather shorter

class Rewriter {
 public:
  Rewriter(std::string_view text, const std::string& name, const Reading& reading, const ReadOptions& read_options,
           const RewriteOptions& options, const Monitor& monitor)
      : lines_(text),
        text_(text),
        name_(name),
        reading_(reading),
        read_options_(read_options),
        options_(options),
        monitor_(monitor),
        fitter_(lines_, reading, options.tolerance, options.has_arcs) {}

  Result<Rewritten> run() {
    auto edits = fitter_.fit(monitor_);
    if (!edits) return tl::unexpected(edits.error());
    edits_ = std::move(*edits);
    auto rewritten = options_.timer ? fastest() : settled();
    if (!rewritten || !options_.feeds) return rewritten;
    return with_planned_feeds(std::move(*rewritten));
  }

 private:
  /// The same with lower feeds where the program's cannot be held; as it was where that does not pass the proof.
  Result<Rewritten> with_planned_feeds(Rewritten rewritten) {
    if (!best_edits_.empty()) edits_ = best_edits_;
    for (Edit& edit : edits_) {
      if (edit.stretches.empty()) edit.stretches = fitter_.as_it_is(edit.run);
    }
    plan_feeds(reading_, *options_.feeds, edits_);
    auto planned = settled();
    if (!planned) return planned;
    if (!has_edits()) return rewritten;
    planned->time_before = rewritten.time_before;
    if (!options_.timer) return planned;
    const auto after = options_.timer(planned->reading, planned->text);
    if (!after) return tl::unexpected(after.error());
    planned->time_after = after->total;
    return planned;
  }

  /// The program with the present edits, less what does not pass the proof.
  Result<Rewritten> settled() {
    for (int round = 0; round < kProofRounds && has_edits(); ++round) {
      const Composed composed = compose(lines_, reading_.moves, edits_, counts_integers(reading_.dialect));
      auto after = read_text(composed.text, name_, read_options_, {monitor_.stop, {}});
      if (!after && after.error().kind == ErrorKind::cancelled) return tl::unexpected(after.error());
      if (!after) break;
      auto proof = prove(reading_, *after, composed, edits_, options_.tolerance, monitor_);
      if (!proof) return tl::unexpected(proof.error());
      rows_ = std::move(proof->rows);
      if (proof->holds()) return result(composed.text, std::move(*after), proof->deviation);
      if (!proof->holds_outside) break;
      take_back(std::move(proof->wrong));
    }
    for (Edit& edit : edits_) edit.stretches.clear();
    return result(std::string(text_), reading_, 0.0);
  }

  /// From the back on, so that places stay what they are.
  void take_back(std::vector<SpanPlace> places) {
    const auto key = [](const SpanPlace& p) { return std::tuple(p.edit, p.stretch, p.span); };
    std::sort(places.begin(), places.end(), [&](const auto& p, const auto& q) { return key(p) > key(q); });
    for (const SpanPlace& p : places) {
      Edit& edit = edits_[p.edit];
      if (keep_span(edit.stretches[p.stretch], p.span)) {
        ++unproven_;
      } else {  // a line that was copied does not mean what it did: the whole run is left
        edit.stretches.clear();
        while (!places.empty() && places.back().edit != p.edit) places.pop_back();
        return;
      }
    }
  }

  /// Measures the program with all stretches smooth, then with arcs, then with lines; takes of each stretch the best of these, and
  /// keeps as it was, with ever less patience, what still takes longer than before. The best of all that came up is returned.
  Result<Rewritten> fastest() {
    const auto before = options_.timer(reading_, text_);
    if (!before) return tl::unexpected(before.error());
    std::vector<Measured> fits;
    for (int k = 0; k < kFits; ++k) {
      auto measured = measure(before->total);
      if (!measured) return tl::unexpected(measured.error());
      fits.push_back(std::move(*measured));
      for (Edit& edit : edits_) {
        for (Stretch& stretch : edit.stretches) fitter_.fit_simpler(edit, stretch);
      }
    }
    mix(fits);
    for (int round = 0; round < kTimeRounds; ++round) {
      const auto measured = measure(before->total);
      if (!measured) return tl::unexpected(measured.error());
      const double patience = kPatience * (kTimeRounds - 2 - round) / kTimeRounds;
      if (!keep_slower(*before, measured->time, std::max(patience, kSameTime))) break;
    }
    if (best_) return std::move(*best_);
    for (const Edit& edit : edits_) slower_ += edit.stretches.empty() ? 0 : edit.run.count;
    for (Edit& edit : edits_) edit.stretches.clear();
    Rewritten as_it_was = result(std::string(text_), reading_, 0.0);
    as_it_was.time_before = as_it_was.time_after = before->total;
    return as_it_was;
  }

  /// Edits as they were settled, and how long each of their stretches takes.
  struct Measured {
    std::vector<Edit> edits;
    std::vector<std::vector<double>> time;  // [s]
  };

  Result<Measured> measure(double before) {
    auto candidate = settled();
    if (!candidate) return tl::unexpected(candidate.error());
    const auto after = options_.timer(candidate->reading, candidate->text);
    if (!after) return tl::unexpected(after.error());
    Measured measured{edits_, std::vector<std::vector<double>>(edits_.size())};
    for (std::size_t k = 0; k < edits_.size(); ++k) {
      for (std::size_t s = 0; s < edits_[k].stretches.size(); ++s)
        measured.time[k].push_back(sum(*after, rows_[k][s].first, rows_[k][s].last));
    }
    candidate->time_before = before;
    candidate->time_after = after->total;
    if (after->total <= before * (1 + kSameTime) && (!best_ || is_better(*candidate, *best_))) {
      best_ = std::move(*candidate);
      best_edits_ = edits_;
    }
    return measured;
  }

  static double sum(const ProgramTime& time, std::size_t first, std::size_t last) {
    double total = 0.0;
    for (std::size_t row = first; row < std::min(last, time.row.size()); ++row) total += time.row[row];
    return total;
  }

  /// Of each stretch the fastest fit; of those about as fast the first.
  void mix(const std::vector<Measured>& fits) {
    edits_ = fits.front().edits;
    for (std::size_t k = 0; k < edits_.size(); ++k) {
      for (std::size_t s = 0; s < edits_[k].stretches.size(); ++s) {
        double least = fits.front().time[k][s];
        for (const Measured& fit : fits) {
          if (fit.edits[k].stretches.empty() || fit.time[k][s] >= least * (1 - kWorthTime)) continue;
          least = fit.time[k][s];
          edits_[k].stretches[s] = fit.edits[k].stretches[s];
        }
      }
    }
  }

  /// Faster by what is worth it, or else shorter.
  static bool is_better(const Rewritten& a, const Rewritten& b) {
    const double saved = *b.time_after - *a.time_after;
    if (std::fabs(saved) > kWorthTime * *b.time_after) return saved > 0.0;
    return a.reading.moves.size() < b.reading.moves.size();
  }

  /// @param patience  relative
  /// @return whether there was anything to keep, now or with less patience
  bool keep_slower(const ProgramTime& before, const std::vector<std::vector<double>>& after, double patience) {
    bool any = false;
    for (std::size_t k = 0; k < edits_.size(); ++k) {
      Edit& edit = edits_[k];
      for (std::size_t s = 0; s < edit.stretches.size(); ++s) {
        Stretch& stretch = edit.stretches[s];
        if (stretch.fit <= Stretch::Fit::kept) continue;
        const double old = sum(before, edit.run.row + stretch.first, edit.run.row + stretch.last);
        any = any || after[k][s] > old * (1 + kSameTime);
        if (after[k][s] > old * (1 + patience)) keep(stretch, Stretch::Fit::kept);
      }
    }
    return any;
  }

  bool has_edits() const {
    return std::any_of(edits_.begin(), edits_.end(), [](const Edit& e) { return !e.stretches.empty(); });
  }

  Rewritten result(std::string text, Reading after, double deviation) const {
    Rewritten result{std::move(text), std::move(after), deviation, 0, unproven_, slower_, {}, {}, {}};
    for (std::size_t k = 0; k < edits_.size(); ++k) {
      const Edit& edit = edits_[k];
      for (std::size_t s = 0; s < edit.stretches.size(); ++s) {
        const Stretch& stretch = edit.stretches[s];
        const bool is_new = std::any_of(stretch.spans.begin(), stretch.spans.end(),
                                        [](const Span& span) { return span.kind != Span::Kind::kept; });
        if (is_new) {
          const Rows& rows = rows_[k][s];
          result.parts.push_back({edit.run.row + stretch.first, edit.run.row + stretch.last, rows.first, rows.last});
        }
        if (stretch.fit == Stretch::Fit::kept) result.slower += stretch.last - stretch.first;
        for (const Span& span : stretch.spans) result.replaced += span.kind == Span::Kind::kept ? 0 : 1;
      }
    }
    return result;
  }

  ProgramLines lines_;
  std::string_view text_;
  const std::string& name_;
  const Reading& reading_;
  const ReadOptions& read_options_;
  const RewriteOptions& options_;
  const Monitor& monitor_;
  ProgramFitter fitter_;
  std::vector<Edit> edits_;
  std::optional<Rewritten> best_;
  std::vector<Edit> best_edits_;
  std::vector<std::vector<Rows>> rows_;  // of stretches in the program written last
  std::size_t unproven_ = 0, slower_ = 0;
};

}  // namespace

Result<Rewritten> rewrite(std::string_view text, const std::string& name, const Reading& reading,
                          const ReadOptions& read_options, const RewriteOptions& options, const Monitor& monitor) {
  if (reading.refused) {
    return tl::unexpected(
        Error{ErrorKind::input, "program-refused", "the program has errors", "correct them first", {name, 0, 0}, {}});
  }
  return Rewriter(text, name, reading, read_options, options, monitor).run();
}

}  // namespace toolpace
