#include "toolpace/rewrite/rewrite.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "toolpace/nc/reader.h"
#include "toolpace/nc/state.h"
#include "toolpace/rewrite/proof.h"

namespace toolpace {
namespace {

using namespace detail::rewrite;

constexpr int kRounds = 12;               // of writing and proving
constexpr double kFinePerTolerance = 20;  // steps of I J K in a tolerance, at least
constexpr double kMargin = 0.998;         // of the tolerance is used, so that rounding does not break it

int decimals_for(double tolerance, double unit) {
  const double digits = std::ceil(std::log10(kFinePerTolerance * unit / tolerance));
  return static_cast<int>(std::clamp(digits, unit > 1.0 ? 4.0 : 3.0, 9.0));
}

/// What controllers of a dialect make of arcs.
ArcRules arc_rules(Dialect dialect) {
  ArcRules rules;
  switch (dialect) {
    case Dialect::linuxcnc: rules.may_turn_on = true; break;
    case Dialect::grbl: rules.most_radius = 1000; break;  // it counts in floats
    case Dialect::marlin:                                 // Klipper turns the other way in G18
      rules.most_radius = 1000;
      rules.any_plane = false;
      break;
    case Dialect::fanuc_lathe:
    case Dialect::fanuc_lathe_b: rules.any_plane = false; break;
    default: break;
  }
  return rules;
}

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
        monitor_(monitor) {}

  Result<Rewritten> run() {
    if (!fit()) return tl::unexpected(cancelled_error());
    for (int round = 0; round < kRounds && has_edits(); ++round) {
      const Composed composed = compose(lines_, reading_.moves, edits_, counts_integers(reading_.dialect));
      auto after = read_text(composed.text, name_, read_options_, {monitor_.stop, {}});
      if (!after && after.error().kind == ErrorKind::cancelled) return tl::unexpected(after.error());
      if (!after) break;
      const auto proof = prove(reading_, *after, composed, edits_, options_.tolerance, monitor_);
      if (!proof) return tl::unexpected(proof.error());
      if (proof->holds()) return finish(composed.text, std::move(*after), proof->deviation);
      if (!proof->holds_outside) break;
      for (const std::size_t k : proof->wrong) drop(k);
    }
    for (std::size_t k = 0; k < edits_.size(); ++k) drop(k);
    return finish(std::string(text_), reading_, 0.0);
  }

 private:
  bool fit() {
    const std::vector<Run> runs = find_runs(lines_, reading_);
    Curve curve;
    for (const Run& run : runs) {
      if (monitor_.is_cancelled()) return false;
      monitor_.report(0.5 * static_cast<double>(run.line) / static_cast<double>(lines_.count()));
      edits_.push_back({run, {}});
      FitRules rules{kMargin * options_.tolerance, options_.has_arcs, arc_rules(reading_.dialect)};
      if (reading_.dialect == Dialect::marlin && run.plane != 17) rules.has_arcs = false;
      const int decimals = edits_.back().decimals = decimals_for(options_.tolerance, run.unit);
      rules.arc.centre_step = run.unit * std::pow(10.0, -decimals);
      make_curve(reading_.moves, run, options_.tolerance, curve);
      std::vector<Span> spans = fit_run(curve, rules, run.plane);
      if (spans.size() < run.count) edits_.back().spans = std::move(spans);
    }
    return true;
  }

  bool has_edits() const {
    return std::any_of(edits_.begin(), edits_.end(), [](const Edit& e) { return !e.spans.empty(); });
  }

  void drop(std::size_t k) {
    unproven_ += edits_[k].spans.empty() ? 0 : 1;
    edits_[k].spans.clear();
  }

  Rewritten finish(std::string text, Reading after, double deviation) const {
    Rewritten result{std::move(text), std::move(after), edits_.size(), 0, unproven_, deviation};
    for (const Edit& edit : edits_) result.replaced += edit.spans.empty() ? 0 : 1;
    return result;
  }

  ProgramLines lines_;
  std::string_view text_;
  const std::string& name_;
  const Reading& reading_;
  const ReadOptions& read_options_;
  const RewriteOptions& options_;
  const Monitor& monitor_;
  std::vector<Edit> edits_;
  std::size_t unproven_ = 0;
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
