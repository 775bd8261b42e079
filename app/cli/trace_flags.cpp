#include "trace_flags.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "interrupt.h"
#include "planned_program.h"
#include "report.h"
#include "toolpace/base/axis_unit.h"
#include "toolpace/base/input_file.h"
#include "toolpace/io/setpoint_format.h"
#include "toolpace/pipeline/sampled.h"

namespace toolpace::cli {
namespace {

constexpr double kSlowestTrace = 1e4;  // [ms] from row to row, as periods of setpoints

/// Setpoints are told by their name, or, of .csv, which may be a polyline, too, by their header.
bool is_setpoint_file(const std::string& name) {
  const SetpointFormat* format = format_of(name);
  if (!format || !std::filesystem::path(name).has_extension()) return false;
  if (format->suffix != ".csv") return true;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(name, ignored)) return false;
  const auto file = InputFile::open(name);
  std::array<char, 256> begin = {};
  const auto count = file ? static_cast<std::size_t>(std::min<std::uint64_t>(begin.size(), file->size())) : 0;
  if (!file || !file->read(0, begin.data(), count)) return false;
  std::string_view header(begin.data(), count);
  header = header.substr(0, header.find('\n'));
  return header.find("t_s") != header.npos || header.find("v_mm_s") != header.npos ||
         header.find("line") != header.npos;
}

tl::expected<CommandedRows, Failure> planned_rows(const ReadingFlags& reading, const Setup& setup) {
  const auto outcome = plan_program(reading, setup);
  if (!outcome) return tl::unexpected(outcome.error());
  const Monitor monitor = terminal_monitor("setpoints");
  Sampler sampler = sampler_of(*outcome);
  CommandedRows commanded;
  for (Setpoints chunk; sampler.next(chunk);) {
    if (monitor.is_cancelled()) return tl::unexpected<Failure>(cancelled_error());
    commanded.append(chunk);
  }
  end_progress();
  if (commanded.size() < 2) {
    return tl::unexpected<Failure>(Error{ErrorKind::input,
                                         "setpoints-empty",
                                         "the program moves no axis",
                                         "give the program that was run",
                                         {reading.program, 0, 0},
                                         {}});
  }
  return commanded;
}

const char* role_name(TraceRole role) {
  switch (role) {
    case TraceRole::time: return "time";
    case TraceRole::sample: return "sample";
    case TraceRole::commanded: return "commanded";
    case TraceRole::actual:
    case TraceRole::position: return "actual";
    case TraceRole::ignored: break;
  }
  return "nothing";
}

}  // namespace

void TraceFlags::add_to(Command& command, Need arguments) {
  command.argument(
      "SETPOINTS", reading.program, "the setpoints",
      "What was commanded: a setpoint file (" + setpoint_suffixes() + "), or the program, which is planned", arguments);
  command.argument(
      "TRACE", trace, "the trace",
      "What was measured: a table of times and positions with names above (any separator, decimal\npoint or "
      "comma), TwinCAT Scope's export, halsampler's columns; - = standard input",
      arguments);
  Flags flags = command.titled("Reading the trace");
  flags.word(
      "--columns t=…,x=…", columns,
      "Which columns are the time and the axes, by name or number from 1, with a unit in\nbrackets where the name "
      "tells none: t=1[ms],x=ActPos[um],commanded_x=3; default: by their names");
  flags.number("--trace-period-ms MS", trace_period_ms, "From row to row, of a trace without times");
  job.add_to(command);
  reading.add_options_to(command);
}

Result<std::optional<double>> TraceFlags::step() const {
  if (!trace_period_ms) return std::nullopt;
  if (*trace_period_ms > 0 && *trace_period_ms <= kSlowestTrace) return *trace_period_ms * 1e-3;
  return tl::unexpected(usage_error(
      "bad-flag", fmt::format("--trace-period-ms is {}, but it must be above 0 and at most 1e4", *trace_period_ms),
      "give milliseconds"));
}

tl::expected<TracePair, Failure> TraceFlags::read() const {
  auto setup = job.setup();
  if (!setup) return tl::unexpected<Failure>(setup.error());
  TraceOptions options;
  auto mapping = parse_trace_mapping(columns);
  if (!mapping) return tl::unexpected<Failure>(mapping.error());
  options.columns = std::move(*mapping);
  const auto told = step();
  if (!told) return tl::unexpected<Failure>(told.error());
  options.step = *told;
  auto measured = read_trace(trace, options, terminal_monitor("reading"));
  end_progress();
  if (!measured) return tl::unexpected<Failure>(measured.error());
  tl::expected<CommandedRows, Failure> commanded;
  if (is_setpoint_file(reading.program)) {
    auto rows = read_commanded(reading.program, setup->machine.period, terminal_monitor("reading"));
    end_progress();
    if (!rows) return tl::unexpected<Failure>(rows.error());
    commanded = std::move(*rows);
  } else {
    commanded = planned_rows(reading, *setup);
    if (!commanded) return tl::unexpected(commanded.error());
  }
  return TracePair{std::move(*commanded), std::move(*measured), std::move(*setup)};
}

Json columns_json(const Trace& trace) {
  Json list = Json::array();
  for (const TraceColumn& c : trace.columns) {
    const bool is_axis = c.role == TraceRole::actual || c.role == TraceRole::commanded;
    list.push_back(
        {{"name", c.name},
         {"taken_for", is_axis ? std::string(role_name(c.role)) + " " + kAxisNames[c.axis] : role_name(c.role)},
         {"unit", c.role == TraceRole::ignored     ? ""
                  : c.unit_name.empty() && is_axis ? axis_unit(c.axis).symbol[0]
                                                   : c.unit_name}});
  }
  return list;
}

Json alignment_json(const Alignment& a) {
  return {{"offset_s", a.clock_offset()},
          {"offset_error_s", a.offset_error},
          {"drift_ppm", a.drift * 1e6},
          {"correlation", a.correlation},
          {"by", a.by_commanded ? "commanded" : "actual"},
          {"ambiguous", a.is_ambiguous}};
}

void print_alignment(const Trace& trace, const Alignment& a) {
  fmt::print("  trace        {} rows every {:.6g} ms\n", trace.size(), trace.step * 1e3);
  fmt::print("  aligned      program starts at {:.6f} s of the trace, correlation {:.4f}, by {} positions\n",
             std::round(a.clock_offset() * 1e6) * 1e-6 + 0.0, a.correlation, a.by_commanded ? "commanded" : "actual");
  if (a.drift != 0) fmt::print("  clocks       drift {:.2f} ppm\n", a.drift * 1e6);
}

void warn_of_alignment(const Trace& trace, const Alignment& a) {
  constexpr double kMostDrift = 1e-3;  // of clocks; more is another motion
  if (std::abs(a.drift) > kMostDrift) {
    report(Diagnostic{Severity::warning,
                      "trace-drift",
                      fmt::format("the trace runs {:.2g} % {} than the setpoints, which no clock does",
                                  std::abs(a.drift) * 100, a.drift > 0 ? "slower" : "faster"),
                      "compare it with the setpoints that were run, or plan with the settings of that time",
                      {trace.name, 0, 0},
                      {}});
  }
  if (!a.is_ambiguous) return;
  report(Diagnostic{Severity::warning,
                    "trace-ambiguous",
                    "the trace fits at another place of the program nearly as well",
                    "record the program from its start",
                    {trace.name, 0, 0},
                    {}});
}

}  // namespace toolpace::cli
