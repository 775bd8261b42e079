/// toolpace simulate: where the machine really goes.

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "advice.h"
#include "commands.h"
#include "interrupt.h"
#include "job_flags.h"
#include "planned_program.h"
#include "report.h"
#include "servo_json.h"
#include "shaper_flag.h"
#include "toolpace/base/axis_unit.h"
#include "toolpace/base/descriptor.h"
#include "toolpace/base/file_name.h"
#include "toolpace/base/numbers.h"
#include "toolpace/io/output_file.h"
#include "toolpace/io/setpoint_table.h"
#include "toolpace/machine/setup_keys.h"
#include "toolpace/pipeline/follow.h"
#include "toolpace/pipeline/sampled.h"

namespace toolpace::cli {
namespace {

struct SimulateFlags {
  ReadingFlags reading;
  JobFlags job;
  std::optional<double> kv, velocity_feed_forward, acceleration_feed_forward;
  std::string trace;
  ShaperFlag shaper;
  AdviceFlags advice;
  bool json = false;
};

/// The commanded and the actual path as a table, row by row.
class TraceFile {
 public:
  static Result<TraceFile> create(const std::string& name) {
    auto file = OutputFile::create(name, OutputFile::Access::forward, terminal_monitor("writing"));
    if (!file) return tl::unexpected(file.error());
    return TraceFile(std::move(*file));
  }

  Result<void> write(const Setpoints& commanded, const ServoTrace& trace, std::size_t rows) {
    constexpr std::string_view kAxes = "xyzabc";
    const RowClock clock(commanded.period);
    std::string text;
    if (commanded.first_row == 0) {
      text = "t_s";
      for (const char* kind : {"", "actual_"}) {
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
          if (commanded.position[axis].empty()) continue;
          text += std::string(",") + kind + kAxes[axis] + "_" + axis_unit(axis).key[0];
        }
      }
      text += ",lag_mm,contour_error_mm,line\n";
    }
    for (std::size_t k = 0; k < rows; ++k) {
      append_text(text, clock.time(commanded.first_row + k));
      for (const auto* columns : {&commanded.position, &trace.actual}) {
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
          if ((*columns)[axis].empty()) continue;
          text += ',';
          append_text(text, (*columns)[axis][k] / axis_unit(axis).size);
        }
      }
      text += ',';
      append_text(text, trace.lag[k]);
      text += ',';
      append_text(text, trace.contour_error[k]);
      text += ',' + std::to_string(commanded.line[k]) + '\n';
    }
    return file_.write(text);
  }

  Result<void> finish() { return file_.commit(); }

 private:
  explicit TraceFile(OutputFile file) : file_(std::move(file)) {}
  OutputFile file_;
};

/// Opened before anything is planned: what cannot be written is known at once. Nothing without a name.
Result<std::optional<TraceFile>> open_trace(const std::string& name) {
  if (name.empty()) return std::nullopt;
  const std::string extension = extension_of(name);
  if (!extension.empty() && extension != ".csv") {
    return tl::unexpected(usage_error("trace-format", "a trace is written as .csv", "give it this ending"));
  }
  auto file = TraceFile::create(name);
  if (!file) return tl::unexpected(file.error());
  return std::move(*file);
}

Result<ServoSummary> simulate(const Outcome& outcome, std::optional<TraceFile>& file) {
  if (!file) return follow(outcome, {}, terminal_monitor("simulating"));
  const auto write = [&](const Setpoints& s, const ServoTrace& t, std::size_t rows) { return file->write(s, t, rows); };
  auto summary = follow(outcome, write, terminal_monitor("simulating"));
  if (!summary) return summary;
  if (auto done = file->finish(); !done) return tl::unexpected(done.error());
  return summary;
}

/// Stores a flag for the drives of all axes.
Result<void> set_all(Setup& setup, const char* flag, const std::optional<double>& value, const char* key) {
  for (const char axis : kAxisNames) {
    if (auto done = set_flag(setup, flag, value, std::string("servo.") + axis, key); !done) return done;
  }
  return {};
}

Result<Setup> setup_of(const SimulateFlags& flags) {
  auto setup = flags.job.setup();
  if (!setup) return setup;
  for (const auto& done :
       {set_all(*setup, "--kv-1-s", flags.kv, "kv_1_s"),
        set_all(*setup, "--velocity-feed-forward", flags.velocity_feed_forward, "velocity_feed_forward"),
        set_all(*setup, "--acceleration-feed-forward", flags.acceleration_feed_forward, "acceleration_feed_forward"),
        flags.shaper.apply_to(*setup)}) {
    if (!done) return tl::unexpected(done.error());
  }
  return setup;
}

void print(const Outcome& outcome, const ServoSummary& s) {
  fmt::print("{}\n  cycle time      {:.4f} s\n", outcome.job->program_name, setpoints_duration(outcome));
  fmt::print("  contour error   {:.6f} mm at most, at {:.3f} s, line {}; {:.6f} mm RMS\n", s.max_contour_error,
             s.worst_time, s.worst_line, s.rms_contour_error);
  fmt::print("  lag             {:.6f} mm at most; {:.6f} mm RMS\n", s.max_lag, s.rms_lag);
  fmt::print("  settled         {:.3f} s after the last setpoint\n", s.settling_time);
}

Done run_simulate(const SimulateFlags& flags) {
  const auto setup = setup_of(flags);
  if (!setup) return tl::unexpected(setup.error());
  if (auto fine = flags.advice.check(); !fine) return tl::unexpected(fine.error());
  auto trace = open_trace(flags.trace);
  if (!trace) return tl::unexpected(trace.error());
  const auto outcome = plan_program(flags.reading, *setup);
  if (!outcome) return tl::unexpected(outcome.error());
  const auto summary = simulate(*outcome, *trace);
  end_progress();
  if (!summary) return tl::unexpected(summary.error());
  const auto advice = flags.advice.take(*outcome);
  if (!advice) return tl::unexpected(advice.error());
  if (flags.json) {
    print_json({{"program", flags.reading.program},
                {"cycle_time_s", setpoints_duration(*outcome)},
                {"period_ms", setup->machine.period * 1e3},
                {"servo", servo_json(*summary, setup->machine)},
                {"advice", *advice ? advice_json(**advice, flags.advice, flags.job, *setup) : Json(nullptr)}});
  } else if (!is_standard_output(flags.trace)) {
    print(*outcome, *summary);
    if (*advice) print_advice(**advice, flags.advice, flags.job, *setup);
  }
  return kFine;
}

Json drives_json(const Machine& machine) {
  constexpr std::string_view kPrefix = "servo.";
  Json drives;
  Setup setup{machine, {}};
  for (const SetupSection& section : setup_sections(setup)) {
    if (section.name.rfind(kPrefix, 0) != 0) continue;
    for (const NumberKey& key : section.numbers)
      drives[section.name.substr(kPrefix.size())][key.name] = *key.value / key.unit;
    Json& modes = drives[section.name.substr(kPrefix.size())][kModesKey] = Json::array();
    for (const AxisMode& mode : machine.servo[axis_of_section(section.name)].modes) modes.push_back(mode_json(mode));
  }
  return drives;
}

}  // namespace

Json mode_json(const AxisMode& mode) {
  Json json;
  AxisMode copy = mode;
  for (const NumberKey& key : mode_keys(copy)) json[key.name] = *key.value / key.unit;
  return json;
}

Json servo_json(const ServoSummary& s, const Machine& machine) {
  return {{"max_contour_error_mm", s.max_contour_error},
          {"rms_contour_error_mm", s.rms_contour_error},
          {"worst_t_s", s.worst_time},
          {"worst_line", s.worst_line},
          {"max_lag_mm", s.max_lag},
          {"rms_lag_mm", s.rms_lag},
          {"settling_time_s", s.settling_time},
          {"rows", s.rows},
          {"drives", drives_json(machine)}};
}

void add_simulate_command(CommandLine& line) {
  auto flags = std::make_shared<SimulateFlags>();
  Command command = line.add("simulate", "Simulate the drives: lag and contour error of a program",
                             [flags] { return run_simulate(*flags); });
  command.output("--trace FILE", flags->trace, "Write commanded and actual positions, lag, contour error (.csv)");
  command.json(flags->json, "Print one JSON object");
  Flags drives = command.titled("Drives (they override the machine file's [servo])");
  drives.number("--kv-1-s KV", flags->kv, "Position gain of every axis [1/s]");
  drives.number("--velocity-feed-forward SHARE", flags->velocity_feed_forward, "Share of the speed fed forward, 0 … 1");
  drives.number("--acceleration-feed-forward SHARE", flags->acceleration_feed_forward,
                "Share of the drive's lag made up, 0 … 1");
  flags->shaper.add_to(command);
  flags->advice.add_to(command);
  flags->job.add_to(command);
  flags->reading.add_to(
      command, {{"cycle_time_s", "cycle time s", {"cycle_time_s"}, CellKind::number, 4, true},
                {"max_contour_error_mm", "contour error mm", {"servo.max_contour_error_mm"}, CellKind::number, 6},
                {"rms_contour_error_mm", "RMS mm", {"servo.rms_contour_error_mm"}, CellKind::number, 6},
                {"worst_line", "at line", {"servo.worst_line"}, CellKind::number, 0},
                {"max_lag_mm", "lag mm", {"servo.max_lag_mm"}, CellKind::number, 6}});
  command.footer(
      "Contour error: distance from the actual point to the commanded path. Lag: distance from the commanded point.\n\n"
      "Examples:\n"
      "  toolpace simulate part.ngc --machine mill.toml\n"
      "  toolpace simulate part.ngc --machine mill.toml --advice --vibration-um 5\n"
      "  toolpace simulate part.ngc --kv-1-s 80 --velocity-feed-forward 0.9 --trace trace.csv");
}

}  // namespace toolpace::cli
