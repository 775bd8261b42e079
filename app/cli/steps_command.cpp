/// toolpace steps: pulse tables of stepper moves.

#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>

#include "commands.h"
#include "console.h"
#include "flag_names.h"
#include "interrupt.h"
#include "report.h"
#include "toolpace/io/pulse_writer.h"
#include "toolpace/sample/pulse_table.h"

namespace toolpace::cli {
namespace {

constexpr double kSecondsPerMillisecond = 1e-3;
constexpr double kShortestTime = 1e-27, kLongestTime = 1e30;  // [ms] what PulseTable takes

struct StepsFlags {
  StepperMove move;
  double tacc_ms = 0.0, tdec_ms = 0.0;
  std::string format = "csv";
  std::string output;
  bool json = false;
};

Result<void> write_table(const std::string& target, const StepsFlags& flags, const PulseTable& table) {
  const PulseFormat format = flags.format == "c" ? PulseFormat::c_header : PulseFormat::csv;
  auto written = write_pulses(target, table, format, terminal_monitor("writing"));
  end_progress();
  return written;
}

Json steps_json(const PulseTable& table) {
  return {{"steps", table.move().steps},
          {"reaches_speed", table.reaches_speed()},
          {"peak_speed_step_s", table.peak_speed()},
          {"t_total_s", table.total_time()},
          {"timer_hz", table.move().timer_hz},
          {"ticks", table.total_ticks()}};
}

Done run_steps(const StepsFlags& flags) {
  if (flags.format != "csv" && flags.format != "c") {
    return tl::unexpected(
        usage_error("bad-flag", "--format does not know '" + flags.format + "'", "give one of csv, c"));
  }
  for (const auto& [flag, time] : {std::pair{"--tacc-ms", flags.tacc_ms}, std::pair{"--tdec-ms", flags.tdec_ms}}) {
    if (time >= kShortestTime && time <= kLongestTime) continue;
    return tl::unexpected(usage_error("bad-limit", fmt::format("{} {} makes no sense", flag, time),
                                      fmt::format("give a time between {} and {} ms", kShortestTime, kLongestTime)));
  }
  StepperMove move = flags.move;
  move.t_acc = flags.tacc_ms * kSecondsPerMillisecond;
  move.t_dec = flags.tdec_ms * kSecondsPerMillisecond;
  const auto table = PulseTable::create(move);
  if (!table) {
    constexpr FlagName kFlags[] = {
        {"the number of steps", "--steps"}, {"the top speed", "--speed"}, {"the timer clock", "--timer-hz"}};
    Error error = with_flag(table.error(), kFlags);
    if (error.code.starts_with("timer-too-")) {  // any of the flags may be the one that is wrong
      error.message += fmt::format(" (--steps {}, --speed {}, --tacc-ms {}, --tdec-ms {})", move.steps, move.speed,
                                   flags.tacc_ms, flags.tdec_ms);
    }
    return tl::unexpected(std::move(error));
  }
  if (const std::string target = flags.output.empty() && !flags.json ? "-" : flags.output; !target.empty()) {
    const auto written = write_table(target, flags, *table);
    if (!written) return tl::unexpected(written.error());
  }
  if (flags.json) print_json(steps_json(*table));
  if (console()) console()->pulsed(*table);
  return kFine;
}

}  // namespace

void add_steps_command(CommandLine& line) {
  auto flags = std::make_shared<StepsFlags>();
  Command command = line.add("steps", "Write the timer intervals of a stepper move, from rest to rest",
                             [flags] { return run_steps(*flags); });
  command.count("--steps N", flags->move.steps, "Number of pulses", Need::required);
  command.number("--speed STEP/S", flags->move.speed, "Top speed", Need::required);
  command.number("--tacc-ms MS", flags->tacc_ms, "Acceleration time", Need::required);
  command.number("--tdec-ms MS", flags->tdec_ms, "Deceleration time", Need::required);
  command.number("--timer-hz HZ", flags->move.timer_hz, "Clock of the timer", Need::required);
  command.word("--format NAME", flags->format,
               "csv (default): rows pulse,ticks; c: a header with an array of uint32_t");
  command.output("-o,--output FILE", flags->output, "File to write; - = standard output, also without -o and --json");
  command.json(flags->json, "Print one JSON object: the move as it is run, without its pulses");
  command.footer(
      "Each interval is the number of timer ticks before that pulse, after which the motor has made one more step. No "
      "pulse\n"
      "is further than half a tick from its exact time, and the sum of all is the time of the move.\n\n"
      "Examples:\n"
      "  toolpace steps --steps 1000 --speed 2000 --tacc-ms 100 --tdec-ms 100 --timer-hz 1e6\n"
      "  toolpace steps --steps 1000 --speed 2000 --tacc-ms 100 --tdec-ms 50 --timer-hz 1e6 --format c -o ramp.h");
}

}  // namespace toolpace::cli
