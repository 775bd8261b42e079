
#include "commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include "interrupt.h"
#include "job_flags.h"
#include "outcome_json.h"
#include "reading_flags.h"
#include "report.h"
#include "servo_json.h"
#include "toolpace/io/program_pulse_writer.h"
#include "toolpace/io/setpoint_writer.h"
#include "toolpace/law/law_table.h"
#include "toolpace/pipeline/follow.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/sample/program_pulses.h"
#include "toolpace/sample/sampler.h"

namespace toolpace::cli {
namespace {

struct PlanFlags {
  ReadingFlags reading;
  JobFlags job;
  std::string setpoints;
  bool axis_derivatives = false, decimal_comma = false;
  bool json = false, bound = false, verify = false;
  std::optional<double> timer_hz;
};

/// What one pass over the setpoints finds out.
struct SetpointPass {
  std::size_t rows = 0;
  AxisPeakMeter peaks;
  double chord_error = 0.0;  ///< [mm]
};

/// Samples the plan once: measures, and writes the file where one is wanted.
Result<SetpointPass> pass_over_setpoints(const Outcome& outcome, const PlanFlags& flags, const Monitor& monitor) {
  std::unique_ptr<SetpointWriter> writer;
  if (!flags.setpoints.empty() && !is_pulse_file(flags.setpoints)) {
    SetpointFileOptions options;
    options.axis_derivatives = flags.axis_derivatives;
    options.decimal_comma = flags.decimal_comma;
    options.program_name = outcome.job->program_name;
    auto opened = open_setpoint_writer(flags.setpoints, options);
    if (!opened) return tl::unexpected(opened.error());
    writer = std::move(*opened);
  }
  SetpointPass pass;
  Sampler sampler(*outcome.path, outcome.plan, outcome.job->program->moves, outcome.job->machine.period);
  pass.rows = sampler.rows();
  sampler.measure_chords();
  for (Setpoints chunk; sampler.next(chunk);) {
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    pass.peaks.add(chunk);
    if (writer) {
      if (auto written = writer->write(chunk); !written) return tl::unexpected(written.error());
    }
    monitor.report(static_cast<double>(chunk.first_row + chunk.size()) / static_cast<double>(pass.rows));
  }
  pass.chord_error = sampler.largest_chord_error();
  if (writer) {
    if (auto finished = writer->finish(); !finished) return tl::unexpected(finished.error());
  }
  return pass;
}

/// The step pulses of the plan as a file.
Result<void> write_pulses(const Outcome& outcome, const PlanFlags& flags, const Monitor& monitor) {
  auto writer = ProgramPulseWriter::create(flags.setpoints);
  if (!writer) return tl::unexpected(writer.error());
  const TimedMotion motion{*outcome.path, outcome.plan, outcome.node_time};
  const auto take = [&](const std::vector<Pulse>& pulses) { return writer->write(pulses); };
  const auto counts = program_pulses(motion, outcome.job->machine, flags.timer_hz.value_or(0), take, monitor);
  if (!counts) return tl::unexpected(counts.error());
  return writer->finish();
}

void add_verification(nlohmann::json& json, const std::optional<VerifyReport>& proof) {
  json["violations"] = nullptr;
  json["max_path_deviation_mm"] = nullptr;
  if (!proof) return;
  json["violations"] =
      std::count_if(proof->checks.begin(), proof->checks.end(), [](const Check& c) { return c.broken; });
  for (const Check& check : proof->checks) {
    if (check.kind == CheckKind::deviation) json["max_path_deviation_mm"] = check.value;
  }
  if (proof->chord_error) json["max_chord_error_mm"] = *proof->chord_error;
  json["exempt_corners"] = proof->exempt_corners;
}

void print_verification(const VerifyReport& proof) {
  fmt::print("  verified     {}\n", proof.passes() ? "every limit holds" : "LIMITS ARE BROKEN");
  for (const Check& c : proof.checks) {
    if (!c.broken) continue;
    fmt::print("    {}{} {:.6g} > {:.6g} at {:.3f} s, line {}\n", key_of(c.kind),
               c.axis ? std::string(" ") + kAxisNames[*c.axis] : "", c.value, c.limit, c.time, c.line);
  }
}

void print_summary(const Outcome& outcome, const SetpointPass& pass, const PlanFlags& flags) {
  const Summary& s = outcome.summary;
  fmt::print("{}\n", outcome.job->program_name);
  fmt::print("  law          {}, look-ahead {} blocks\n", law_row(outcome.job->options.law).id,
             outcome.job->options.lookahead ? std::to_string(*outcome.job->options.lookahead) : "all");
  fmt::print("  path         {} blocks, {:.3f} mm\n", s.blocks, s.path_length);
  fmt::print("  cycle time   {:.4f} s  (feed {:.4f}, rapid {:.4f}, dwell {:.4f})\n", s.cycle_time, s.feed_time,
             s.rapid_time, s.dwell_time);
  if (s.bound) {
    fmt::print("  lower bound  {:.4f} s  ({:.2f} % above it)\n", *s.bound,
               *s.bound > 0 ? 100 * (s.cycle_time / *s.bound - 1) : 0.0);
  }
  fmt::print("  peaks        {:.3f} mm/s, {:.1f} mm/s², {}\n", s.max_speed, s.max_acceleration,
             s.max_jerk < kUnlimited ? fmt::format("{:.4g} mm/s³", s.max_jerk) : "jerk unbounded");
  for (std::size_t i = 0; i < s.time_by_cause.size(); ++i) {
    if (s.time_by_cause[i] > 0) {
      fmt::print("  {:<12} {:.4f} s  ({:.1f} %)\n", cause_name(static_cast<Cause>(i)), s.time_by_cause[i],
                 100 * s.time_by_cause[i] / s.cycle_time);
    }
  }
  if (!flags.setpoints.empty()) {
    fmt::print("  setpoints    {} rows every {} ms -> {}\n", pass.rows, outcome.job->machine.period * 1e3,
               flags.setpoints);
  }
}

int run_plan(const PlanFlags& flags) {
  const auto begin = std::chrono::steady_clock::now();
  if (flags.json && flags.setpoints == "-") {
    return report(Error{ErrorKind::usage,
                        "two-outputs",
                        "--json and --setpoints - both want standard output",
                        "write the setpoints to a file",
                        {},
                        {}});
  }
  if (flags.verify && (flags.setpoints.empty() || flags.setpoints == "-")) {
    return report(Error{ErrorKind::usage,
                        "verify-what",
                        "--verify reads back the setpoint file, and there is none",
                        "add --setpoints FILE",
                        {},
                        {}});
  }
  const auto setup = flags.job.setup();
  if (!setup) return report(setup.error());
  auto reading = flags.reading.read();
  if (!reading) return report(reading.error());
  if (reading->refused) return kBadInput;

  auto job = std::make_shared<Job>();
  job->program_name = flags.reading.program;
  job->program = std::make_shared<const Reading>(std::move(*reading));
  job->machine = setup->machine;
  job->options = setup->options;
  job->bound = flags.bound;
  const auto outcome = run(job, terminal_monitor("planning"));
  end_progress();
  if (!outcome) return report(outcome.error());
  report(outcome->warnings);
  const std::chrono::duration<double> planned = std::chrono::steady_clock::now() - begin;

  const auto pass = pass_over_setpoints(*outcome, flags, terminal_monitor("setpoints"));
  end_progress();
  if (!pass) return report(pass.error());
  const bool pulses = is_pulse_file(flags.setpoints);
  if (pulses) {
    const auto written = write_pulses(*outcome, flags, terminal_monitor("pulses"));
    end_progress();
    if (!written) return report(written.error());
  }
  std::optional<VerifyReport> proof;
  if (flags.verify) {
    auto verified = pulses ? prove(*outcome, terminal_monitor("verifying"))
                           : prove(flags.setpoints, *outcome, terminal_monitor("verifying"));
    end_progress();
    if (!verified) return report(verified.error());
    proof = std::move(*verified);
  }
  if (flags.json) {
    nlohmann::json json = outcome_json(*outcome);
    json["axes"] = axes_json(pass->peaks);
    json["setpoints"] = pass->rows;
    json["max_chord_error_mm"] = pass->chord_error;
    add_verification(json, proof);
    const auto servo = follow(*outcome, {}, terminal_monitor("simulating"));
    end_progress();
    if (!servo && servo.error().kind == ErrorKind::cancelled) return report(servo.error());
    json["servo"] = servo ? nlohmann::json(servo_json(*servo, outcome->job->machine)) : nlohmann::json(nullptr);
    json["plan_wall_s"] = planned.count();
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else if (flags.setpoints != "-") {
    print_summary(*outcome, *pass, flags);
    if (proof) print_verification(*proof);
  }
  return proof && !proof->passes() ? kLimitBroken : kFine;
}

}  // namespace

void add_plan_command(CLI::App& app, Action& action) {
  auto flags = std::make_shared<PlanFlags>();
  CLI::App* command = app.add_subcommand("plan", "Plan a program: cycle time, peaks, setpoints");
  flags->reading.add_to(*command);
  flags->job.add_to(*command);
  command->add_option("--setpoints", flags->setpoints,
                      "Write setpoints: .csv, .npy, .npz, .halstream, .semicolon.csv, or step pulses: .pulses.csv; - = "
                      "standard output");
  command->add_option("--timer-hz", flags->timer_hz, "Clock of the pulse timer [Hz], for OUT.pulses.csv");
  command->add_flag("--axis-derivatives", flags->axis_derivatives, "Add speed, acceleration and jerk of each axis");
  command->add_flag("--decimal-comma", flags->decimal_comma, "Decimal commas in .semicolon.csv");
  command->add_flag("--verify", flags->verify, "Read the setpoint file back and prove that it keeps every limit");
  command->add_flag("--json", flags->json, "Print one JSON object");
  command->add_flag("--bound", flags->bound, "Compute a lower bound of the cycle time");
  command->callback([flags, &action] { action = [flags] { return run_plan(*flags); }; });
}

}  // namespace toolpace::cli
