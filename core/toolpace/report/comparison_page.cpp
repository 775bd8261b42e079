#include "toolpace/report/comparison_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "toolpace/pipeline/follow.h"
#include "toolpace/pipeline/sampled.h"
#include "toolpace/report/page_parts.h"
#include "toolpace/report/report_plots.h"
#include "toolpace/servo/vibration.h"

namespace toolpace {
namespace {

/// What is told of one of them.
struct Measured {
  const Outcome& outcome;
  ServoSummary servo;
  std::optional<double> residual;  ///< [mm, deg]
  double duration;                 ///< [s]
  Envelope speed;
};

/// @param longest  [s] of the axis of time of both
Result<Measured> measure(const Outcome& outcome, double longest, const Monitor& monitor) {
  Measured m{outcome, {}, {}, setpoints_duration(outcome), Envelope(row_count(longest, outcome.job->machine.period))};
  const auto take = [&](const Setpoints& s, const ServoTrace&, std::size_t rows) -> Result<void> {
    for (std::size_t k = 0; k < rows; ++k) m.speed.add(s.first_row + k, s.speed[k]);
    return {};
  };
  const auto servo = follow(outcome, take, monitor);
  if (!servo) return tl::unexpected(servo.error());
  m.servo = *servo;
  const double period = outcome.job->machine.period;
  for (std::size_t row = row_count(m.duration, period); row < row_count(longest, period); ++row) m.speed.add(row, 0);
  const auto shaken = vibration(*outcome.path, outcome.plan, outcome.node_time, outcome.job->machine.servo,
                                impulses_of(outcome), monitor);
  if (!shaken) return tl::unexpected(shaken.error());
  m.residual = largest_residual(*shaken);
  return m;
}

std::string figure_row(std::string_view name, const std::string& before, const std::string& after) {
  return fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", page::escaped(name), page::escaped(before),
                     page::escaped(after));
}

std::string figures(const Measured& a, const Measured& b) {
  std::string html = "<table>\n<tr><th></th><th>before</th><th>after</th></tr>\n";
  const auto add = [&](std::string_view name, const char* format, double of_a, double of_b) {
    html += figure_row(name, fmt::format(fmt::runtime(format), of_a), fmt::format(fmt::runtime(format), of_b));
  };
  add("cycle time", "{:.4f} s", a.duration, b.duration);
  add("largest contour error of the drives", "{:.4g} µm", 1e3 * a.servo.max_contour_error,
      1e3 * b.servo.max_contour_error);
  if (a.residual || b.residual)
    add("largest vibration after a stop", "{:.4g} µm", 1e3 * a.residual.value_or(0), 1e3 * b.residual.value_or(0));
  const Peaks &of_a = a.outcome.summary.peaks, &of_b = b.outcome.summary.peaks;
  add("largest speed along the path", "{:.6g} mm/s", of_a.speed, of_b.speed);
  add("largest acceleration along the path", "{:.6g} mm/s²", of_a.acceleration, of_b.acceleration);
  return html + "</table>\n";
}

std::string changes(const std::vector<ChangedSetting>& changed) {
  if (changed.empty()) return "<p>Nothing was changed.</p>\n";
  std::string html = "<table>\n<tr><th>setting</th><th>before</th><th>after</th></tr>\n";
  for (const ChangedSetting& c : changed) html += figure_row(c.title, c.before, c.after);
  return html + "</table>\n";
}

std::string time_by_cause(const Summary& a, const Summary& b) {
  std::string html = "<table>\n<tr><th>what holds the speed down</th><th>before</th><th>after</th></tr>\n";
  for (std::size_t i = 0; i < kCauseCount; ++i) {
    if (a.time_by_cause[i] <= 0 && b.time_by_cause[i] <= 0) continue;
    html += figure_row(cause_name(static_cast<Cause>(i)), fmt::format("{:.4f} s", a.time_by_cause[i]),
                       fmt::format("{:.4f} s", b.time_by_cause[i]));
  }
  return html + "</table>\n";
}

}  // namespace

Result<std::string> comparison_page(const Outcome& before, const Outcome& after,
                                    const std::vector<ChangedSetting>& changed, const Monitor& monitor) {
  const double longest = std::max(setpoints_duration(before), setpoints_duration(after));
  const auto a = measure(before, longest, {monitor.stop, {}});
  if (!a) return tl::unexpected(a.error());
  monitor.report(0.5);
  const auto b = measure(after, longest, {monitor.stop, {}});
  if (!b) return tl::unexpected(b.error());
  monitor.report(1.0);
  const double saved = a->duration - b->duration;
  std::string body =
      fmt::format("<p class='{}'>{:.4f} s {}, {:.1f} %.</p>\n", saved >= 0 ? "good" : "broken", std::abs(saved),
                  saved >= 0 ? "saved" : "lost", a->duration > 0 ? 100 * std::abs(saved) / a->duration : 0.0);
  body += figures(*a, *b) + "<h2>What was changed</h2>\n" + changes(changed);
  body += "<h2>Where the time goes</h2>\n" + time_by_cause(before.summary, after.summary);
  body += "<h2>Speed</h2>\n" + plot_svg(a->speed, longest, {"before", "mm/s"}) +
          plot_svg(b->speed, longest, {"after", "mm/s"}) + "<p class='legend'>time in s</p>\n";
  return page::whole(before.job->program_name, body);
}

}  // namespace toolpace
