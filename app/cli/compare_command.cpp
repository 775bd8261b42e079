/// toolpace compare: a measured trace beside what was commanded.

#include <fmt/format.h>

#include <algorithm>

#include "commands.h"
#include "interrupt.h"
#include "report.h"
#include "toolpace/base/axis_unit.h"
#include "toolpace/trace/compare.h"
#include "trace_flags.h"

namespace toolpace::cli {
namespace {

constexpr std::size_t kShownLines = 8;

struct CompareFlags {
  TraceFlags trace;
  bool json = false;
};

/// "max_following_error_mm"
std::string with_unit(const char* key, std::size_t axis) { return std::string(key) + '_' + axis_unit(axis).key[0]; }

Json axes_json(const Comparison& c) {
  Json axes = Json::object();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const AxisComparison& a = c.axis[axis];
    if (!a.is_measured) continue;
    const double size = axis_unit(axis).size;
    axes[std::string(1, kAxisNames[axis])] = {{"lag_ms", a.lag * 1e3},
                                              {with_unit("max_following_error", axis), a.max_error / size},
                                              {with_unit("rms_following_error", axis), a.rms_error / size},
                                              {"worst_t_s", a.worst_time},
                                              {"worst_line", a.worst_line},
                                              {with_unit("zero", axis), a.shift / size}};
  }
  return axes;
}

Json lines_json(const Comparison& c) {
  Json lines = Json::array();
  for (const LineComparison& l : c.lines) {
    lines.push_back({{"line", l.line},
                     {"t_s", l.begin},
                     {"rows", l.rows},
                     {"max_contour_error_mm", l.max_contour},
                     {"rms_contour_error_mm", l.rms_contour},
                     {"max_following_error_mm", l.max_following},
                     {"rms_following_error_mm", l.rms_following}});
  }
  return lines;
}

Json compare_json(const CompareFlags& flags, const Trace& trace, const Comparison& c) {
  return {{"setpoints", flags.trace.reading.program},
          {"trace", flags.trace.trace},
          {"rows", c.rows},
          {"rows_outside", c.outside},
          {"trace_period_ms", trace.step * 1e3},
          {"alignment", alignment_json(c.alignment)},
          {"axes", axes_json(c)},
          {"unmeasured_axes", c.unmeasured},
          {"max_contour_error_mm", c.max_contour},
          {"rms_contour_error_mm", c.rms_contour},
          {"worst_t_s", c.worst_time},
          {"worst_line", c.worst_line},
          {"max_following_error_mm", c.max_following},
          {"rms_following_error_mm", c.rms_following},
          {"lines", lines_json(c)},
          {"columns", columns_json(trace)}};
}

void print_axes(const Comparison& c) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const AxisComparison& a = c.axis[axis];
    if (!a.is_measured) continue;
    const AxisUnit& unit = axis_unit(axis);
    fmt::print(
        "  axis {}       lag {:.3f} ms, following error {:.6f} {} at most, at {:.3f} s, line {}; {:.6f} {} RMS\n",
        kAxisNames[axis], a.lag * 1e3, a.max_error / unit.size, unit.symbol[0], a.worst_time, a.worst_line,
        a.rms_error / unit.size, unit.symbol[0]);
    if (a.shift != 0)
      fmt::print("               its zero lies {:.6g} {} off, which is left out\n", a.shift / unit.size,
                 unit.symbol[0]);
  }
  for (const std::string& axis : c.unmeasured) fmt::print("  axis {}       moves, and is not in the trace\n", axis);
}

void print_lines(const Comparison& c) {
  std::vector<LineComparison> worst = c.lines;
  std::sort(worst.begin(), worst.end(),
            [](const LineComparison& a, const LineComparison& b) { return a.max_contour > b.max_contour; });
  worst.resize(std::min(worst.size(), kShownLines));
  for (const LineComparison& l : worst) {
    fmt::print("  {:<12} line {}: contour error {:.6f} mm at most, {:.6f} mm RMS; following error {:.6f} mm\n",
               &l == worst.data() ? "worst" : "", l.line, l.max_contour, l.rms_contour, l.max_following);
  }
}

Done run_compare(const CompareFlags& flags) {
  const auto pair = flags.trace.read();
  if (!pair) return tl::unexpected(pair.error());
  const auto compared = compare(pair->commanded, pair->trace, nullptr, terminal_monitor("comparing"));
  end_progress();
  if (!compared) return tl::unexpected(compared.error());
  warn_of_alignment(pair->trace, compared->alignment);
  if (flags.json) {
    print_json(compare_json(flags, pair->trace, *compared));
    return kFine;
  }
  fmt::print("{}\n", flags.trace.trace);
  print_alignment(pair->trace, compared->alignment);
  fmt::print("  contour      {:.6f} mm at most, at {:.3f} s, line {}; {:.6f} mm RMS\n", compared->max_contour,
             compared->worst_time, compared->worst_line, compared->rms_contour);
  print_axes(*compared);
  print_lines(*compared);
  return kFine;
}

}  // namespace

void add_compare_command(CommandLine& line) {
  auto flags = std::make_shared<CompareFlags>();
  Command command =
      line.add("compare", "Compare a measured trace with what was commanded: lag and errors by axis and line",
               [flags] { return run_compare(*flags); });
  command.json(flags->json, "Print one JSON object");
  flags->trace.add_to(command);
  command.footer(
      "The trace is laid in time by the correlation of speeds, by its own commanded positions where it has them: lags "
      "are\n"
      "then those of the drives. Else the common lag of the axes is in the offset. A trace of another program is "
      "refused.\n\n"
      "Examples:\n"
      "  toolpace simulate part.ngc --machine mill.toml --trace trace.csv\n"
      "  toolpace compare part.csv trace.csv\n"
      "  toolpace compare part.ngc scope.csv --machine mill.toml --columns \"t=1[ms],x=Axis 1.ActPos,y=Axis 2.ActPos\" "
      "--json");
}

}  // namespace toolpace::cli
