/// toolpace steps: pulse tables of stepper moves.

#include <map>
#include <memory>
#include <string>

#include "commands.h"
#include "interrupt.h"
#include "report.h"
#include "toolpace/io/pulse_writer.h"
#include "toolpace/sample/pulse_table.h"

namespace toolpace::cli {
namespace {

constexpr double kSecondsPerMillisecond = 1e-3;

struct StepsFlags {
  StepperMove move;
  double tacc_ms = 0.0, tdec_ms = 0.0;
  PulseFormat format = PulseFormat::csv;
  std::string output = "-";
};

int run_steps(const StepsFlags& flags) {
  StepperMove move = flags.move;
  move.t_acc = flags.tacc_ms * kSecondsPerMillisecond;
  move.t_dec = flags.tdec_ms * kSecondsPerMillisecond;
  const auto table = PulseTable::create(move);
  if (!table) return report(table.error());
  const auto written = write_pulses(flags.output, *table, flags.format, terminal_monitor("writing"));
  end_progress();
  return written ? kFine : report(written.error());
}

}  // namespace

void add_steps_command(CLI::App& app, Action& action) {
  auto flags = std::make_shared<StepsFlags>();
  CLI::App& command = *app.add_subcommand("steps", "Writes the timer intervals of a stepper move, from rest to rest.");
  command.add_option("--steps", flags->move.steps, "number of pulses")->check(CLI::NonNegativeNumber)->required();
  command.add_option("--speed", flags->move.speed, "top speed in step/s")->required();
  command.add_option("--tacc-ms", flags->tacc_ms, "acceleration time in ms")->required();
  command.add_option("--tdec-ms", flags->tdec_ms, "deceleration time in ms")->required();
  command.add_option("--timer-hz", flags->move.timer_hz, "timer clock in Hz")->required();
  const std::map<std::string, PulseFormat> formats{{"csv", PulseFormat::csv}, {"c", PulseFormat::c_header}};
  command.add_option("--format", flags->format, "csv: rows pulse,ticks; c: a header with a uint32_t array")
      ->transform(CLI::CheckedTransformer(formats))
      ->default_str("csv");
  command.add_option("-o,--output", flags->output, "file to write; - = standard output")->capture_default_str();
  command.callback([flags, &action] { action = [flags] { return run_steps(*flags); }; });
}

}  // namespace toolpace::cli
