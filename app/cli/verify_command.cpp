/// toolpace verify: an independent proof of a setpoint file.

#include <fmt/format.h>

#include <optional>

#include "commands.h"
#include "interrupt.h"
#include "job_flags.h"
#include "reading_flags.h"
#include "report.h"
#include "toolpace/io/setpoint_format.h"
#include "toolpace/io/setpoint_reader.h"
#include "toolpace/law/law_table.h"
#include "toolpace/machine/read_machine.h"
#include "toolpace/path/build_path.h"
#include "toolpace/pipeline/prove.h"
#include "verification.h"

namespace toolpace::cli {
namespace {

struct VerifyFlags {
  std::string setpoints, machine;
  ReadingFlags reading;
  std::string law, corner;
  std::optional<double> tolerance_mm, period_ms, corner_step, junction_deviation;
  bool no_jerk_limit = false, json = false;
};

/// How the setpoints were planned: as flags say, else as the file does, else, for the law, as the machine's jobs are.
Result<void> set_origin(const VerifyFlags& flags, const SetpointOrigin& origin, Setup& setup) {
  if (auto law = origin.law.empty() ? std::nullopt : find_law(origin.law)) setup.options.law = *law;
  if (origin.corner) setup.options.corner = *origin.corner;
  if (flags.corner_step) setup.options.corner.step = 0.0;
  if (!flags.corner.empty()) setup.options.corner.step.reset();
  for (const auto& done :
       {pick_law(flags.law, setup.options.law), pick_corner(flags.corner, setup.options.corner.rule),
        set_flag(setup, "--corner-step-mm-s", flags.corner_step, "", "corner_step_mm_s"),
        set_flag(setup, "--junction-deviation-mm", flags.junction_deviation, "lookahead", "junction_deviation_mm"),
        set_flag(setup, "--period-ms", flags.period_ms, "machine", "period_ms")}) {
    if (!done) return done;
  }
  return check_setup(setup.machine, setup.options);
}

Machine judged_by(const VerifyFlags& flags, const Setup& setup) {
  if (!flags.no_jerk_limit) return judged_machine(setup.machine, setup.options);
  PlanOptions options = setup.options;
  options.law = LawKind::trapezoid;
  return judged_machine(setup.machine, options);
}

/// What was found, and by what the setpoints were shaped as their file tells; empty where it tells none.
struct Judgement {
  VerifyReport report;
  std::string shaper;
};

/// The tolerance is checked first: a proof may take minutes.
tl::expected<Judgement, Failure> judge(const VerifyFlags& flags) {
  if (flags.tolerance_mm && !(*flags.tolerance_mm >= 0)) {
    return tl::unexpected<Failure>(usage_error(
        "bad-limit", fmt::format("--tolerance-mm is {}, but must be 0 mm or more", *flags.tolerance_mm), ""));
  }
  auto setup = read_machine(flags.machine, terminal_monitor("reading"));
  end_progress();
  if (!setup) return tl::unexpected<Failure>(setup.error());
  report(setup->warnings);
  auto file = open_setpoint_file(flags.setpoints, terminal_monitor("reading"));
  if (!file) return tl::unexpected<Failure>(file.error());
  if (auto fine = set_origin(flags, (*file)->origin(), *setup); !fine) return tl::unexpected<Failure>(fine.error());
  const Machine machine = judged_by(flags, *setup);
  VerifyOptions options;
  options.monitor = terminal_monitor("verifying");
  if (flags.corner_step || !flags.corner.empty()) options.corner = setup->options.corner;
  const auto prove = [&](const ProgrammedPath* program) -> tl::expected<Judgement, Failure> {
    auto found = verify(**file, machine, program, options);
    end_progress();
    if (found) return Judgement{std::move(*found), (*file)->origin().shaper};
    if (found.error().where.file.empty()) found.error().where.file = flags.setpoints;
    return tl::unexpected<Failure>(std::move(found.error()));
  };
  if (flags.reading.program.empty() && flags.reading.about_tip) options.tip_of = setup->kinematics.chain;
  if (flags.reading.program.empty()) return prove(nullptr);
  const auto reading = flags.reading.on(*setup).read_accepted();
  if (!reading) return tl::unexpected(reading.error());
  const auto path = build_path(reading->moves, machine.tool_change);
  if (!path) return tl::unexpected<Failure>(path.error());
  const ProgrammedPath program{*path, reading->moves, flags.tolerance_mm};
  return prove(&program);
}

Done run_verify(const VerifyFlags& flags) {
  const auto found = judge(flags);
  if (!found) return tl::unexpected(found.error());
  if (flags.json) {
    Json json = verification_json(found->report);
    json["shaper"] = found->shaper.empty() ? Json(nullptr) : Json(found->shaper);
    print_json(json);
  } else {
    print_verification(found->report);
    if (!found->shaper.empty()) fmt::print("  shaped       by {}\n", found->shaper);
  }
  return found->report.passes() ? kFine : kLimitBroken;
}

}  // namespace

void add_verify_command(CommandLine& line) {
  auto flags = std::make_shared<VerifyFlags>();
  Command command =
      line.add("verify", "Prove that a setpoint file keeps a machine's limits", [flags] { return run_verify(*flags); });
  command.argument("SETPOINTS", flags->setpoints, "the setpoint file",
                   "Setpoint file: " + setpoint_suffixes() + "; - = standard input");
  command.input("--machine FILE", flags->machine, "the machine file",
                "Machine file (TOML), LinuxCNC .ini or grbl's answer to $$", Need::required);
  command.input("--program FILE", flags->reading.program, "the program",
                "Program that the setpoints run: path, corners, lines, end");
  command.number("--tolerance-mm MM", flags->tolerance_mm,
                 "Largest deviation from the program; without it, reported only");
  command.word(
      "--law LAW", flags->law,
      "Law of the plan: one without a jerk limit is not judged by jerk; default that of the\nfile (.npz tells it), "
      "else of the machine file");
  command.toggle("--no-jerk-limit", flags->no_jerk_limit, "Do not judge jerk");
  command.word(
      "--corner RULE", flags->corner,
      "Corner rule of the plan, up to which steps of speed are exempt; default that of the\nfile (.npz tells it); "
      "not known: any step at a turn up to 90 deg, that of the servo rule beyond");
  command.number("--corner-step-mm-s MM/S", flags->corner_step, "Largest exempt step of the velocity vector");
  command.number("--junction-deviation-mm MM", flags->junction_deviation,
                 "Of --corner junction; default the machine's");
  command.number("--period-ms MS", flags->period_ms, "Period of files without a time column; default the machine's");
  command.json(flags->json, "Print one JSON object");
  flags->reading.add_options_to(command);
  command.footer(
      "Speed, acceleration and jerk come from differences of the positions, with bounds for their rounding: what "
      "passes is\n"
      "proven, what fails is real. Exit code 0: every limit holds; 1: a limit is broken.\n\n"
      "Examples:\n"
      "  toolpace verify part.csv --machine mill.toml\n"
      "  toolpace verify part.npy --machine mill.toml --program part.ngc --tolerance-mm 0.01 --json");
}

}  // namespace toolpace::cli
