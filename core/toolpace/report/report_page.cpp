#include "toolpace/report/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "toolpace/bound/lower_bound.h"
#include "toolpace/law/law_table.h"
#include "toolpace/pipeline/follow.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/pipeline/sampled.h"
#include "toolpace/report/page_parts.h"
#include "toolpace/report/report_plots.h"
#include "toolpace/sample/sampler.h"

namespace toolpace {
namespace {

using page::escaped;

std::string row(std::string_view name, std::string_view value) {
  return fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escaped(name), escaped(value));
}

const char* corner_title(CornerRule rule) {
  switch (rule) {
    case CornerRule::stop: return "stop";
    case CornerRule::servo: return "servo (a·Ts and angle)";
    case CornerRule::junction: return "junction deviation";
    case CornerRule::blend: return "corner curves";
    case CornerRule::smooth: return "smoothed through the tolerance";
  }
  return "";
}

std::string corners(const CornerOptions& corner) {
  if (corner.step) return fmt::format("a speed step of {:.6g} mm/s", *corner.step);
  const std::string rule = corner_title(corner.rule);
  if (corner.rule == CornerRule::junction) return rule + fmt::format(", {:.6g} mm", corner.junction_deviation);
  const bool rounds = corner.rule == CornerRule::blend || corner.rule == CornerRule::smooth;
  return rounds ? rule + fmt::format(", {:.6g} mm", corner.tolerance) : rule;
}

std::string limit(double value, const char* unit) {
  return std::isfinite(value) ? fmt::format("{:.6g} {}", value, unit) : std::string("no limit");
}

std::string peaks(const Peaks& peaks, const char* unit) {
  return fmt::format("{:.6g} {}/s, {:.6g} {}/s², {}", peaks.speed, unit, peaks.acceleration, unit,
                     std::isfinite(peaks.jerk) ? fmt::format("{:.6g} {}/s³", peaks.jerk, unit) : "jerk unbounded");
}

std::string overview(const Outcome& o, double bound) {
  const Summary& s = o.summary;
  const PlanOptions& options = o.ran;
  const PathLimits& path = o.job->machine.path;
  std::string html = "<table>\n";
  html += row("program", o.job->program_name);
  html += row("machine", o.job->machine.name.empty() ? "limits along the path" : o.job->machine.name);
  html += row("law", std::string(law_row(options.law).title));
  html += row("ramps", options.ramps == Ramps::span ? "across blocks" : "inside blocks");
  html += row("look-ahead", options.lookahead ? fmt::format("{} blocks", *options.lookahead) : "all blocks");
  html += row("corners", corners(options.corner));
  html += row("limits along the path", fmt::format("{}, {}, {}", limit(path.speed, "mm/s"),
                                                   limit(path.acceleration, "mm/s²"), limit(path.jerk, "mm/s³")));
  html += row("blocks", fmt::format("{}, {:.3f} mm", s.blocks, s.path_length));
  html += row("cycle time", fmt::format("{:.4f} s", setpoints_duration(o)));
  if (options.shaper != ShaperKind::none) html += row("shaper", std::string(shaper_name(options.shaper)));
  html += row("lower bound of the cycle time", fmt::format("{:.4f} s", bound));
  html +=
      row("feed, rapid, dwell", fmt::format("{:.4f} s, {:.4f} s, {:.4f} s", s.feed_time, s.rapid_time, s.dwell_time));
  if (s.peaks.speed > 0 || s.rotary_peaks.speed == 0) html += row("peaks along the path", peaks(s.peaks, "mm"));
  if (s.rotary_peaks.speed > 0) html += row("peaks of rotary axes alone", peaks(s.rotary_peaks, "deg"));
  html += row("setpoints", fmt::format("{}, every {:.6g} ms", row_count(setpoints_duration(o), o.job->machine.period),
                                       1e3 * o.job->machine.period));
  return html + "</table>\n";
}

std::string causes(const Summary& s) {
  std::string html = "<table>\n<tr><th>what holds the speed down</th><th>time</th><th>share</th><th></th></tr>\n";
  for (std::size_t i = 0; i < s.time_by_cause.size(); ++i) {
    if (s.time_by_cause[i] <= 0) continue;
    const double share = s.cycle_time > 0 ? s.time_by_cause[i] / s.cycle_time : 0;
    html += fmt::format(
        "<tr><td>{}</td><td>{:.4f} s</td><td>{:.1f} %</td><td style='text-align:left;width:40%'><span class='bar' "
        "style='width:{:.1f}%'></span></td></tr>\n",
        escaped(cause_name(static_cast<Cause>(i))), s.time_by_cause[i], 100 * share, 100 * share);
  }
  return html + "</table>\n";
}

std::string bound(double value) { return value < 10 ? fmt::format("{:.2g}", value) : fmt::format("{:.0f}", value); }

/// How much of a limit is left. Travel has no margin in percent.
std::string margin(const Check& c) {
  const bool travel = c.kind == CheckKind::travel_min || c.kind == CheckKind::travel_max;
  if (!std::isfinite(c.limit) || c.limit <= 0 || travel || c.kind == CheckKind::follows_path) return "";
  return fmt::format("{:.1f} %", 100 * (1 - c.value / c.limit));
}

std::string limits_table(const VerifyReport& report) {
  std::string html =
      "<table>\n<tr><th>check of the "
      "setpoints</th><th>worst</th><th>limit</th><th></th><th>margin</th><th>at</th><th>line</th></tr>\n";
  for (const Check& c : report.checks) {
    const CheckUnit u = check_unit(c);
    html += fmt::format(
        "<tr{}><td>{}</td><td>{:.6g}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.3f} s</td><td>{}</td></tr>\n",
        c.broken ? " class='broken'" : "", check_title(c), c.value / u.size,
        std::isfinite(c.limit) && c.limit != 0 ? fmt::format("{:.6g}", c.limit / u.size)
        : c.limit == 0                         ? bound(c.bound / u.size)
                                               : std::string("–"),
        u.symbol, margin(c), c.time, c.line == 0 ? std::string("–") : std::to_string(c.line));
  }
  html += "</table>\n";
  if (report.chord_error)
    html += fmt::format("<p>Chord error between setpoints: {:.3g} mm.</p>\n", *report.chord_error);
  if (report.exempt_corners > 0) {
    html += fmt::format(
        "<p>{} corners are passed with a speed step, the largest {:.4g} mm/s, as the corner rule allows.</p>\n",
        report.exempt_corners, report.largest_corner_step);
  }
  for (const auto& note : report.notes) html += "<p>" + escaped(note) + "</p>\n";
  return html;
}

std::string warnings(const Diagnostics& diagnostics) {
  if (diagnostics.empty()) return "";
  std::string html = "<h2>Warnings</h2>\n<table>\n<tr><th>message</th><th>line</th></tr>\n";
  for (const auto& d : diagnostics)
    html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escaped(d.message), d.where.line);
  return html + "</table>\n";
}

/// Largest side of the box around its nodes in X, Y, Z [mm].
double extent_of(const Path& path) {
  if (path.node.empty()) return 0.0;
  AxisVector low = path.node.front(), high = low;
  for (const AxisVector& node : path.node) {
    low = low.cwiseMin(node);
    high = high.cwiseMax(node);
  }
  double extent = (high - low).head<3>().maxCoeff();
  for (const ArcCurve& arc : path.arcs) extent = std::max(extent, arc.start_radius);
  return extent;
}

/// What one pass over the simulated setpoints gathers.
struct Pictures {
  Pictures(std::size_t rows, const Outcome& o)
      : speed(rows),
        acceleration(rows),
        jerk(rows),
        contour_error(rows),
        contour(extent_of(*o.path), std::max(o.summary.peaks.speed, o.summary.rotary_peaks.speed)) {}
  Envelope speed, acceleration, jerk, contour_error;
  ContourPicture contour;

  void take(const Setpoints& s, const ServoTrace& trace, std::size_t rows) {
    for (std::size_t k = 0; k < rows; ++k) {
      const std::size_t at = s.first_row + k;
      speed.add(at, s.speed[k]);
      acceleration.add(at, s.acceleration[k]);
      jerk.add(at, s.jerk[k]);
      contour_error.add(at, 1000 * trace.contour_error[k]);
      contour.add({s.position[0][k], s.position[1][k], s.position[2][k]}, s.speed[k]);
    }
  }
};

}  // namespace

Result<std::string> report_page(const Outcome& outcome, const Monitor& monitor) {
  const double period = outcome.job->machine.period;
  Pictures pictures(row_count(setpoints_duration(outcome), period), outcome);
  const auto take = [&](const Setpoints& s, const ServoTrace& t, std::size_t rows) -> Result<void> {
    pictures.take(s, t, rows);
    return {};
  };
  const auto servo = follow(outcome, take, {monitor.stop, {}});
  if (!servo) return tl::unexpected(servo.error());
  monitor.report(0.5);
  const auto proof = prove(outcome, {monitor.stop, {}});
  if (!proof) return tl::unexpected(proof.error());
  const auto bound = lower_bound(outcome, {monitor.stop, {}});
  if (!bound) return tl::unexpected(bound.error());
  monitor.report(1.0);

  const double duration = setpoints_duration(outcome);
  std::string html = proof->passes() ? "<p class='good'>Verified: every limit holds.</p>\n"
                                     : "<p class='broken'>Verified: limits are broken, see below.</p>\n";
  html += overview(outcome, *bound) + "<h2>Where the time goes</h2>\n" + causes(outcome.summary);
  html += "<h2>Motion</h2>\n" + plot_svg(pictures.speed, duration, {"speed", "mm/s"}) +
          plot_svg(pictures.acceleration, duration, {"acceleration", "mm/s²"}) +
          plot_svg(pictures.jerk, duration, {"jerk", "mm/s³"}) +
          plot_svg(pictures.contour_error, duration, {"contour error of the simulated drives", "µm"}) +
          "<p class='legend'>time in s</p>\n";
  html += fmt::format(
      "<p>Contour error of the simulated drives at most {:.4g} mm, at {:.3f} s in line {}; RMS {:.4g} mm. Lag at most "
      "{:.4g} mm.</p>\n",
      servo->max_contour_error, servo->worst_time, servo->worst_line, servo->rms_contour_error, servo->max_lag);
  html += "<h2>Contour</h2>\n" + pictures.contour.svg(0, 1) + pictures.contour.svg(0, 2);
  html += "<h2>Limits</h2>\n" + limits_table(*proof) + warnings(outcome.warnings);
  return page::whole(outcome.job->program_name, html);
}

}  // namespace toolpace
