
#include "commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "console.h"
#include "interrupt.h"
#include "job_flags.h"
#include "outcome_json.h"
#include "planned_program.h"
#include "reading_flags.h"
#include "report.h"
#include "servo_json.h"
#include "setpoint_pass.h"
#include "shaper_flag.h"
#include "toolpace/base/axis_unit.h"
#include "toolpace/base/descriptor.h"
#include "toolpace/bound/lower_bound.h"
#include "toolpace/io/program_pulse_writer.h"
#include "toolpace/io/setpoint_format.h"
#include "toolpace/io/setpoint_writer.h"
#include "toolpace/law/law_table.h"
#include "toolpace/pipeline/follow.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/pipeline/sampled.h"
#include "toolpace/sample/program_pulses.h"
#include "toolpace/servo/vibration.h"
#include "verification.h"

namespace toolpace::cli {
namespace {

struct PlanFlags {
  ReadingFlags reading;
  JobFlags job;
  std::string setpoints;
  bool axis_derivatives = false, decimal_comma = false, tip = false;
  bool json = false, bound = false, verify = false, servo = false;
  std::optional<double> timer_hz;
  ShaperFlag shaper;
};

/// The file that --setpoints names, opened before anything is planned: what cannot be written is known at once.
struct Target {
  std::unique_ptr<SetpointWriter> setpoints;
  std::optional<ProgramPulseWriter> pulses;
};

/// Where --tip is given.
Result<std::optional<Chain>> tip_chain(const PlanFlags& flags, const Kinematics& kinematics) {
  if (!flags.tip) return std::nullopt;
  if (kinematics.chain.is_identity()) {
    return tl::unexpected(usage_error("kinematics-missing", "--tip needs a machine file with [kinematics]",
                                      "name it with --machine, or add rotary = [...] to it"));
  }
  return kinematics.chain;
}

/// The length of a tool that a head swings is told by the machine, or by a program about its tip.
Result<void> check_tool_length(const PlanFlags& flags, const Kinematics& kinematics, const Moves& moves) {
  if (!flags.tip || !kinematics.chain.swings_tool() || kinematics.tells_tool_length || moves.has_tip()) return {};
  return tl::unexpected(usage_error("tool-length-missing", "--tip needs the length of the tool, which a head swings",
                                    "add tool_mm to [kinematics]"));
}

Result<Target> open_target(const PlanFlags& flags, const std::optional<Chain>& tip_of) {
  Target target;
  if (flags.setpoints.empty()) return target;
  if (is_pulse_file(flags.setpoints)) {
    if (!flags.timer_hz) {
      return tl::unexpected(usage_error("timer-value", "--timer-hz is not given, and step pulses are told in its ticks",
                                        "give a clock between 1 Hz and 1e12 Hz, such as --timer-hz 1000000"));
    }
    if (auto fine = check_timer(*flags.timer_hz); !fine) return tl::unexpected(std::move(fine.error()));
    auto pulses = ProgramPulseWriter::create(flags.setpoints, terminal_monitor("writing"));
    if (!pulses) return tl::unexpected(pulses.error());
    target.pulses.emplace(std::move(*pulses));
    return target;
  }
  SetpointFileOptions options;
  options.axis_derivatives = flags.axis_derivatives;
  options.decimal_comma = flags.decimal_comma;
  options.program_name = flags.reading.program;
  options.tip_of = tip_of;
  auto setpoints = open_setpoint_writer(flags.setpoints, options, terminal_monitor("writing"));
  if (!setpoints) return tl::unexpected(setpoints.error());
  target.setpoints = std::move(*setpoints);
  return target;
}

/// The step pulses of the plan.
Result<void> write_pulses(const Outcome& outcome, double timer_hz, ProgramPulseWriter& writer, const Monitor& monitor) {
  const TimedMotion motion{*outcome.path, outcome.plan, outcome.node_time};
  const auto take = [&](const std::vector<Pulse>& pulses) { return writer.write(pulses); };
  const auto counts = program_pulses(motion, outcome.job->machine, timer_hz, take, monitor);
  if (!counts) return tl::unexpected(counts.error());
  return writer.finish();
}

/// Proves the file that was written; what cannot be read back (no file, a pipe, pulses) is proven before it is written.
Result<VerifyReport> prove_plan(const Outcome& outcome, const PlanFlags& flags) {
  std::error_code ignored;
  const bool is_setpoint_file = !is_pulse_file(flags.setpoints) && flags.setpoints != "-" &&
                                !named_descriptor(flags.setpoints) &&
                                std::filesystem::is_regular_file(flags.setpoints, ignored);
  auto proof = is_setpoint_file ? prove(flags.setpoints, outcome, terminal_monitor("verifying"))
                                : prove(outcome, terminal_monitor("verifying"));
  end_progress();
  return proof;
}

void add_verification(Json& json, const std::optional<VerifyReport>& proof) {
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

void print_proof(std::FILE* out, const VerifyReport& proof) {
  fmt::print(out, "  verified     {}\n", proof.passes() ? "every limit holds" : "LIMITS ARE BROKEN");
  for (const Check& c : proof.checks) {
    if (!c.broken) continue;
    const CheckUnit unit = check_unit(c);
    fmt::print(out, "    {}: {:.6g} {} where {:.6g} is allowed, at {:.3f} s, line {}\n", check_title(c),
               c.value / unit.size, unit.symbol, c.limit / unit.size, c.time, c.line);
  }
}

void print_peaks(const Peaks& peaks, const char* unit) {
  fmt::print("  peaks        {:.3f} {}/s, {:.1f} {}/s², {}\n", peaks.speed, unit, peaks.acceleration, unit,
             peaks.jerk < kUnlimited ? fmt::format("{:.4g} {}/s³", peaks.jerk, unit) : "jerk unbounded");
}

void print_summary(const Outcome& outcome, std::optional<double> bound, const SetpointPass& pass,
                   const PlanFlags& flags) {
  const Summary& s = outcome.summary;
  fmt::print("{}\n", outcome.job->program_name);
  const PlanOptions& ran = outcome.ran;
  fmt::print("  law          {}, look-ahead {} blocks\n", law_row(ran.law).id,
             ran.lookahead ? std::to_string(*ran.lookahead) : "all");
  for (const std::string& flag : flags.job.ignored_in(outcome)) {
    fmt::print("  not used     {}: it changes nothing in this plan\n", flag);
  }
  fmt::print("  path         {} blocks, {:.3f} mm\n", s.blocks, s.path_length);
  const double shaping_time = setpoints_duration(outcome) - s.cycle_time;
  fmt::print("  cycle time   {:.4f} s  (feed {:.4f}, rapid {:.4f}, dwell {:.4f}{})\n", s.cycle_time + shaping_time,
             s.feed_time, s.rapid_time, s.dwell_time,
             shaping_time > 0 ? fmt::format(", shaper {:.4f}", shaping_time) : "");
  if (bound) {
    const CornerOptions& corner = outcome.job->options.corner;
    const bool through_tube = corner.rule == CornerRule::smooth && !corner.step;
    fmt::print("  lower bound  {:.4f} s  ({:.2f} % above it{})\n", *bound,
               *bound > 0 ? 100 * (s.cycle_time / *bound - 1) : 0.0,
               through_tube ? "; it counts lengths, feeds and rests, not corners" : "");
  }
  if (s.peaks.speed > 0 || s.rotary_peaks.speed == 0) print_peaks(s.peaks, "mm");
  if (s.rotary_peaks.speed > 0) print_peaks(s.rotary_peaks, "deg");
  for (std::size_t i = 0; i < s.time_by_cause.size(); ++i) {
    if (s.time_by_cause[i] > 0) {
      fmt::print("  {:<13} {:.4f} s  ({:.1f} %)\n", cause_name(static_cast<Cause>(i)), s.time_by_cause[i],
                 100 * s.time_by_cause[i] / s.cycle_time);
    }
  }
  if (!flags.setpoints.empty()) {
    fmt::print("  setpoints    {} rows every {:.6g} ms -> {}\n", pass.rows, outcome.job->machine.period * 1e3,
               flags.setpoints);
  }
}

/// Of axes with modes; the first one under the names of a resonance.
Json vibration_json(const Vibration& vibration) {
  Json json = Json::object();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!vibration[axis]) continue;
    const AxisVibration& v = *vibration[axis];
    const double thousandth = axis_unit(axis).size * 1e-3;
    const std::string unit = is_rotary(axis) ? "mdeg" : "um";
    Json modes = Json::array();
    for (const ModeVibration& m : v.modes) {
      Json mode = mode_json(m.mode);
      mode["residual_" + unit] = m.residual / thousandth;
      modes.push_back(std::move(mode));
    }
    json[std::string(1, kAxisNames[axis])] = {{"resonance_hz", v.modes.front().mode.frequency},
                                              {"damping", v.modes.front().mode.damping},
                                              {"peak_" + unit, v.peak / thousandth},
                                              {"residual_" + unit, v.residual / thousandth},
                                              {"peak_t_s", v.peak_time},
                                              {"residual_t_s", v.residual_time},
                                              {"modes", std::move(modes)}};
  }
  return json;
}

/// Where only --verify can tell whether the tolerance is kept.
void warn_of_shaping(const Outcome& outcome, double offset) {
  const CornerOptions& corner = outcome.job->options.corner;
  const bool may_leave = offset > corner.tolerance || (outcome.ran.corner.rule != CornerRule::stop && offset > 0);
  if (outcome.job->options.shaper == ShaperKind::none || !may_leave) return;
  report(Diagnostic{
      Severity::warning,
      "shaper-tolerance",
      fmt::format("shaping takes the setpoints up to {:.3g} mm off the planned way; the tolerance is {:.3g} mm", offset,
                  corner.tolerance),
      "--verify tells how far they are from the program; a longer tolerance or less acceleration helps",
      {},
      {}});
}

Json plan_json(const Outcome& outcome, const SetpointPass& pass, const std::optional<VerifyReport>& proof) {
  Json json = outcome_json(outcome);
  json["axes"] = axes_json(pass.peaks);
  json["setpoints"] = pass.rows;
  // Off the path only verification, which follows it, can tell.
  const bool is_on_path = outcome.plan.splines.empty() && outcome.job->options.shaper == ShaperKind::none;
  json["max_chord_error_mm"] = is_on_path ? Json(pass.chord_error) : Json(nullptr);
  add_shaper(json, outcome);
  if (outcome.job->options.shaper != ShaperKind::none) json["shaper"]["max_offset_mm"] = pass.shaping;
  add_verification(json, proof);
  return json;
}

Done run_plan(const PlanFlags& flags) {
  const auto begin = std::chrono::steady_clock::now();
  const bool to_stdout = is_standard_output(flags.setpoints);
  auto setup = flags.job.setup();
  if (!setup) return tl::unexpected(setup.error());
  if (auto shaped = flags.shaper.apply_to(*setup); !shaped) return tl::unexpected(shaped.error());
  if (setup->options.shaper != ShaperKind::none && is_pulse_file(flags.setpoints)) {
    return tl::unexpected(usage_error("shaper-pulses",
                                      "step pulses are those of the plan: --shaper does not shape them",
                                      "write setpoints, or leave out --shaper"));
  }
  const auto tip_of = tip_chain(flags, setup->kinematics);
  if (!tip_of) return tl::unexpected(tip_of.error());
  auto target = open_target(flags, *tip_of);
  if (!target) return tl::unexpected(target.error());
  auto outcome = plan_program(flags.reading, *setup);
  if (!outcome) return tl::unexpected(outcome.error());
  if (auto told = check_tool_length(flags, setup->kinematics, outcome->job->program->moves); !told)
    return tl::unexpected(told.error());
  std::optional<double> bound;
  if (flags.bound) {
    const auto found = lower_bound(*outcome, terminal_monitor("bound"));
    end_progress();
    if (!found) return tl::unexpected(found.error());
    bound = *found;
  }

  const auto pass = pass_over_setpoints(*outcome, target->setpoints.get(), flags.json, terminal_monitor("setpoints"));
  end_progress();
  if (!pass) return tl::unexpected(pass.error());
  if (target->pulses) {
    const auto written =
        write_pulses(*outcome, flags.timer_hz.value_or(0), *target->pulses, terminal_monitor("pulses"));
    end_progress();
    if (!written) return tl::unexpected(written.error());
  }
  if (!flags.verify) warn_of_shaping(*outcome, pass->shaping);
  std::optional<VerifyReport> proof;
  if (flags.verify) {
    auto verified = prove_plan(*outcome, flags);
    if (!verified) return tl::unexpected(verified.error());
    proof = std::move(*verified);
  }
  if (flags.json) {
    Json json = plan_json(*outcome, *pass, proof);
    if (bound) json["bound_s"] = *bound;
    json["ignored"] = flags.job.ignored_in(*outcome);
    const auto shaken = vibration(*outcome->path, outcome->plan, outcome->node_time, outcome->job->machine.servo,
                                  impulses_of(*outcome), terminal_monitor("vibration"));
    end_progress();
    if (!shaken) return tl::unexpected(shaken.error());
    json["vibration"] = vibration_json(*shaken);
    json["servo"] = nullptr;
    if (flags.servo) {
      const auto servo = follow(*outcome, {}, terminal_monitor("simulating"));
      end_progress();
      if (!servo) return tl::unexpected(servo.error());
      json["servo"] = servo_json(*servo, outcome->job->machine);
    }
    json["plan_wall_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    print_json(json);
  } else {
    if (!to_stdout) print_summary(*outcome, bound, *pass, flags);
    if (proof) print_proof(to_stdout ? stderr : stdout, *proof);
  }
  if (console()) console()->planned(std::move(*outcome), *tip_of);
  return proof && !proof->passes() ? kLimitBroken : kFine;
}

}  // namespace

void add_plan_command(CommandLine& line) {
  auto flags = std::make_shared<PlanFlags>();
  Command command =
      line.add("plan", "Plan a program: cycle time, peaks, setpoints", [flags] { return run_plan(*flags); });
  command.output("--setpoints FILE", flags->setpoints,
                 "Write setpoints: " + setpoint_suffixes() +
                     "\n(none = .csv), or step pulses: .pulses.csv; - = csv to standard output");
  command.toggle("--verify", flags->verify, "Read the setpoints back and prove that they keep every limit");
  command.toggle("--bound", flags->bound, "Compute a lower bound of the cycle time");
  command.json(flags->json, "Print one JSON object");
  command.toggle("--servo", flags->servo, "Simulate the drives too, and add what simulate --json tells of them");
  command.toggle("--axis-derivatives", flags->axis_derivatives, "Add speed, acceleration and jerk of each axis");
  command.toggle("--tip", flags->tip, "Add where the tool's tip is in the workpiece, by [kinematics] of the machine");
  command.toggle("--decimal-comma", flags->decimal_comma, "Decimal commas in .semicolon.csv");
  flags->shaper.add_to(command);
  command.number("--timer-hz HZ", flags->timer_hz, "Clock of the pulse timer, for .pulses.csv");
  flags->job.add_to(command);
  flags->reading.add_to(command, {{"blocks", "blocks", {"blocks"}, CellKind::number, 0, true},
                                  {"path_length_mm", "path mm", {"path_length_mm"}, CellKind::number, 1, true},
                                  {"cycle_time_s", "cycle time s", {"cycle_time_s"}, CellKind::number, 4, true},
                                  {"feed_time_s", "feed s", {"feed_time_s"}, CellKind::number, 4, true},
                                  {"rapid_time_s", "rapid s", {"rapid_time_s"}, CellKind::number, 4, true},
                                  {"dwell_time_s", "dwell s", {"dwell_time_s"}, CellKind::number, 4, true},
                                  {"bound_s", "bound s", {"bound_s"}, CellKind::number, 4},
                                  {"violations", "violations", {"violations"}, CellKind::number, 0, true},
                                  {"warnings", "warnings", {"warnings"}, CellKind::count, 0, true}});
  command.footer(
      "Exit codes: 0 fine; 1 --verify found a broken limit; 2 bad usage; 3 bad input; 4 file trouble; 130 "
      "interrupted.\n\n"
      "Examples:\n"
      "  toolpace plan part.ngc\n"
      "  toolpace plan part.ngc --machine mill.toml --setpoints part.csv --verify\n"
      "  toolpace plan part.ngc --law seven-phase --ramps span --corner blend --tolerance-mm 0.02 --bound\n"
      "  toolpace plan - --vmax 50 --am 500 --jm 2e4 --json < part.ngc\n"
      "  toolpace plan parts --machine mill.toml --results parts.csv --setpoints 'out/{}.npz'");
}

}  // namespace toolpace::cli
