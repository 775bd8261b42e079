#include "toolpace/rewrite/rewrite.h"

#include <algorithm>
#include <utility>

#include "toolpace/nc/reader.h"
#include "toolpace/rewrite/fit_program.h"
#include "toolpace/rewrite/proof.h"

namespace toolpace {
namespace {

using namespace detail::rewrite;

constexpr int kProofRounds = 12;    // of writing and proving
constexpr int kTimeRounds = 8;      // of timing
constexpr double kSameTime = 1e-9;  // relative

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
    if (!options_.timer) return settled();
    return fastest();
  }

 private:
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

  /// The fastest of the programs that come up while what takes longer than before is fitted with less, stretch by stretch.
  Result<Rewritten> fastest() {
    const auto before = options_.timer(reading_, text_);
    if (!before) return tl::unexpected(before.error());
    std::optional<Rewritten> best;
    for (int round = 0; round < kTimeRounds; ++round) {
      auto candidate = settled();
      if (!candidate) return candidate;
      const auto after = options_.timer(candidate->reading, candidate->text);
      if (!after) return tl::unexpected(after.error());
      candidate->time_before = before->total;
      candidate->time_after = after->total;
      const double most = best ? *best->time_after : before->total;
      if (after->total <= most * (1 + kSameTime)) best = std::move(*candidate);
      if (!simplify_slower(*before, *after)) break;
    }
    if (best && *best->time_after <= before->total * (1 + kSameTime)) return std::move(*best);
    for (Edit& edit : edits_) slower_ += edit.stretches.empty() ? 0 : edit.run.count;
    for (Edit& edit : edits_) edit.stretches.clear();
    Rewritten as_it_was = result(std::string(text_), reading_, 0.0);
    as_it_was.time_before = as_it_was.time_after = before->total;
    return as_it_was;
  }

  /// @return whether there was any
  bool simplify_slower(const ProgramTime& before, const ProgramTime& after) {
    const auto sum = [](const ProgramTime& time, std::size_t first, std::size_t last) {
      double total = 0.0;
      for (std::size_t row = first; row < last && row < time.row.size(); ++row) total += time.row[row];
      return total;
    };
    bool any = false;
    for (std::size_t k = 0; k < edits_.size(); ++k) {
      Edit& edit = edits_[k];
      for (std::size_t s = 0; s < edit.stretches.size(); ++s) {
        Stretch& stretch = edit.stretches[s];
        if (stretch.fit == Stretch::Fit::kept) continue;
        const double old = sum(before, edit.run.row + stretch.first, edit.run.row + stretch.last);
        if (sum(after, rows_[k][s].first, rows_[k][s].last) <= old * (1 + kSameTime)) continue;
        fitter_.fit_simpler(edit, stretch);
        any = true;
      }
    }
    return any;
  }

  bool has_edits() const {
    return std::any_of(edits_.begin(), edits_.end(), [](const Edit& e) { return !e.stretches.empty(); });
  }

  Rewritten result(std::string text, Reading after, double deviation) const {
    Rewritten result{std::move(text), std::move(after), deviation, 0, unproven_, slower_, {}, {}};
    for (const Edit& edit : edits_) {
      for (const Stretch& stretch : edit.stretches) {
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
