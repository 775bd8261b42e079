#include "toolpace/rewrite/fit_program.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "toolpace/rewrite/fit_smooth.h"

namespace toolpace::detail::rewrite {
namespace {

constexpr double kFinePerTolerance = 20;    // steps of I J K in a tolerance, at least
constexpr double kMargin = 0.998;           // of the tolerance is used, so that rounding does not break it
constexpr double kLeastGain = 0.15;         // of its rows that a stretch has to lose, or it stays as it is
constexpr std::size_t kRowsOfStretch = 64;  // at least
constexpr double kFloatRadius = 1000;       // [mm] up to which arcs are fine on controllers that count in floats

int decimals_for(double tolerance, double unit) {
  const double digits = std::ceil(std::log10(kFinePerTolerance * unit / tolerance));
  return static_cast<int>(std::clamp(digits, unit > 1.0 ? 4.0 : 3.0, 9.0));
}

/// What controllers of a dialect make of arcs.
ArcRules arc_rules(Dialect dialect) {
  ArcRules rules;
  switch (dialect) {
    case Dialect::linuxcnc: rules.may_turn_on = true; break;
    case Dialect::grbl: rules.most_radius = kFloatRadius; break;
    case Dialect::marlin:  // Klipper turns the other way in G18
      rules.most_radius = kFloatRadius;
      rules.any_plane = false;
      break;
    case Dialect::fanuc_lathe:
    case Dialect::fanuc_lathe_b: rules.any_plane = false; break;
    default: break;
  }
  return rules;
}

Span kept(std::size_t row) {
  return {Span::Kind::kept, static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(row + 1), {}, {}, {}};
}

std::vector<Span> kept_rows(std::size_t first, std::size_t last) {
  std::vector<Span> spans;
  for (std::size_t row = first; row < last; ++row) spans.push_back(kept(row));
  return spans;
}

std::vector<Stretch> stretches_of(const std::vector<Span>& spans, Stretch::Fit fit) {
  std::vector<Stretch> stretches;
  for (const Span& span : spans) {
    if (stretches.empty() || stretches.back().last - stretches.back().first >= kRowsOfStretch) {
      stretches.push_back({span.first, span.first, fit, {}});
    }
    stretches.back().spans.push_back(span);
    stretches.back().last = span.last;
  }
  return stretches;
}

/// Whether a stretch loses enough of its rows.
bool gains(const Stretch& stretch) {
  std::size_t blocks = 0;
  for (const Span& span : stretch.spans) blocks += span.kind == Span::Kind::biarc ? 2 : 1;
  const std::size_t rows = stretch.last - stretch.first;
  return static_cast<double>(rows - blocks) >= kLeastGain * static_cast<double>(rows);
}

}  // namespace

ProgramFitter::ProgramFitter(const ProgramLines& lines, const Reading& reading, double tolerance, bool has_arcs)
    : lines_(lines), reading_(reading), tolerance_(tolerance), has_arcs_(has_arcs) {}

FitRules ProgramFitter::rules_for(const Run& run) const {
  FitRules rules;
  rules.tolerance = kMargin * tolerance_;
  rules.has_arcs = has_arcs_;
  rules.arc = arc_rules(reading_.dialect);
  if (reading_.dialect == Dialect::marlin && run.plane != 17) rules.has_arcs = false;
  rules.arc.centre_step = rules.grid.step = run.unit * std::pow(10.0, -decimals_for(tolerance_, run.unit));
  rules.grid.offset = run.offset;
  rules.named = run.named;
  return rules;
}

Result<std::vector<Edit>> ProgramFitter::fit(const Monitor& monitor) {
  std::vector<Edit> edits;
  // The progress of a part of a run as that of the program.
  const auto within_run = [&](const Run& run, double begin, double share) {
    Monitor part{monitor.stop, {}};
    if (!monitor.progress) return part;
    part.progress = [&monitor, &run, begin, share, lines = lines_.count()](double fraction) {
      const double rows = static_cast<double>(run.count) * (begin + share * fraction);
      monitor.report(std::min(1.0, (static_cast<double>(run.line) + rows) / static_cast<double>(lines)));
    };
    return part;
  };
  for (const Run& run : find_runs(lines_, reading_)) {
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    edits.push_back({run, {}, decimals_for(tolerance_, run.unit)});
    make_curve(reading_.moves, run, tolerance_, curve_);
    const FitRules rules = rules_for(run);
    const double share = rules.has_arcs ? 0.5 : 1.0;  // of the work on a run
    std::vector<Span> spans = fit_run(curve_, rules, run.plane, within_run(run, 0.0, share));
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    if (rules.has_arcs) spans = fit_smooth(curve_, rules, run.plane, spans, within_run(run, share, share));
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    std::vector<Stretch> stretches = stretches_of(spans, rules.has_arcs ? Stretch::Fit::smooth : Stretch::Fit::lines);
    std::size_t gaining = 0;
    for (Stretch& stretch : stretches) {
      if (gains(stretch)) {
        ++gaining;
      } else {
        keep(stretch, Stretch::Fit::idle);
      }
    }
    if (gaining > 0) edits.back().stretches = std::move(stretches);
  }
  return edits;
}

std::vector<Stretch> ProgramFitter::as_it_is(const Run& run) {
  return stretches_of(kept_rows(0, run.count), Stretch::Fit::idle);
}

void ProgramFitter::fit_simpler(const Edit& edit, Stretch& stretch) {
  if (stretch.fit <= Stretch::Fit::lines) return;
  const Run part{edit.run.line + stretch.first,
                 stretch.last - stretch.first,
                 edit.run.row + stretch.first,
                 edit.run.plane,
                 edit.run.unit,
                 edit.run.offset,
                 {}};
  make_curve(reading_.moves, part, tolerance_, curve_);
  FitRules rules = rules_for(part);
  const bool has_arcs = stretch.fit == Stretch::Fit::smooth;
  rules.has_arcs = rules.has_arcs && has_arcs;
  stretch.spans = fit_run(curve_, rules, part.plane);
  for (Span& span : stretch.spans) {
    span.first += stretch.first;
    span.last += stretch.first;
  }
  stretch.fit = has_arcs ? Stretch::Fit::arcs : Stretch::Fit::lines;
}

void keep(Stretch& stretch, Stretch::Fit why) {
  stretch.spans = kept_rows(stretch.first, stretch.last);
  stretch.fit = why;
}

bool keep_span(Stretch& stretch, std::size_t span) {
  const Span old = stretch.spans[span];
  if (old.kind == Span::Kind::kept) return false;
  std::vector<Span> rows = kept_rows(old.first, old.last);
  for (Span& row : rows) row.feed = old.feed, row.programmed = old.programmed;
  const auto at = stretch.spans.erase(stretch.spans.begin() + static_cast<std::ptrdiff_t>(span));
  stretch.spans.insert(at, rows.begin(), rows.end());
  return true;
}

}  // namespace toolpace::detail::rewrite
