/// toolpace verify: an independent proof of a setpoint file.

#include <fmt/format.h>

#include <optional>

#include "commands.h"
#include "interrupt.h"
#include "reading_flags.h"
#include "report.h"
#include "toolpace/path/build_path.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/pipeline/setup.h"
#include "verification.h"

namespace toolpace::cli {
namespace {

struct VerifyFlags {
  std::string setpoints, machine;
  ReadingFlags reading;
  std::optional<double> tolerance_mm, period_ms;
  bool json = false;
};

Result<VerifyReport> judge(const VerifyFlags& flags) {
  auto setup = read_setup(flags.machine);
  if (!setup) return tl::unexpected(setup.error());
  if (flags.period_ms) setup->machine.period = *flags.period_ms * 1e-3;
  if (flags.tolerance_mm && !(*flags.tolerance_mm >= 0)) {
    return tl::unexpected(
        Error{ErrorKind::usage, "bad-flag", "--tolerance-mm is negative", "give a distance in mm", {}, {}});
  }
  if (auto fine = check_setup(setup->machine, setup->options); !fine) return tl::unexpected(fine.error());
  auto file = open_setpoint_file(flags.setpoints);
  if (!file) return tl::unexpected(file.error());
  const Machine machine = judged_machine(setup->machine, setup->options);
  if (flags.reading.program.empty()) return verify(**file, machine, nullptr, terminal_monitor("verifying"));
  const auto reading = flags.reading.read();
  if (!reading) return tl::unexpected(reading.error());
  if (reading->refused) {
    return tl::unexpected(Error{ErrorKind::input,
                                "program-refused",
                                "the program has errors, so there is no path to compare with",
                                "correct it first",
                                {flags.reading.program, 0, 0},
                                {}});
  }
  const auto path = build_path(reading->moves, machine.tool_change);
  if (!path) return tl::unexpected(path.error());
  const ProgrammedPath program{*path, reading->moves, flags.tolerance_mm};
  return verify(**file, machine, &program, terminal_monitor("verifying"));
}

int run_verify(const VerifyFlags& flags) {
  const auto found = judge(flags);
  end_progress();
  if (!found) {
    Error error = found.error();
    if (error.where.file.empty()) error.where.file = flags.setpoints;
    return report(error);
  }
  if (flags.json) {
    fmt::print("{}\n", verification_json(*found).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    print_verification(*found);
  }
  return found->passes() ? kFine : kLimitBroken;
}

}  // namespace

void add_verify_command(CLI::App& app, Action& action) {
  auto flags = std::make_shared<VerifyFlags>();
  CLI::App* const command = app.add_subcommand("verify", "Prove that a setpoint file keeps a machine's limits");
  command
      ->add_option("SETPOINTS", flags->setpoints, "Setpoint file: .csv, .npy, .npz or .halstream; - = standard input")
      ->required();
  command->add_option("--machine", flags->machine, "Machine file (TOML)")->required();
  command->add_option("--program", flags->reading.program, "Program that the setpoints run: path, corners, lines, end");
  flags->reading.add_options_to(*command);
  command->add_option("--tolerance-mm", flags->tolerance_mm,
                      "Largest deviation from the program [mm]; without it, reported only");
  command->add_option("--period-ms", flags->period_ms, "Period of files without a time column [ms]");
  command->add_flag("--json", flags->json, "Print one JSON object");
  command->callback([flags, &action] { action = [flags] { return run_verify(*flags); }; });
}

}  // namespace toolpace::cli
