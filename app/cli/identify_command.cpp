/// toolpace identify: the drives of a machine, from what it was commanded and what it did.

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "accelerometer.h"
#include "commands.h"
#include "interrupt.h"
#include "report.h"
#include "toolpace/base/axis_unit.h"
#include "toolpace/base/descriptor.h"
#include "toolpace/base/numbers.h"
#include "toolpace/io/output_file.h"
#include "toolpace/machine/setup_keys.h"
#include "toolpace/trace/identify.h"
#include "trace_flags.h"

namespace toolpace::cli {
namespace {

struct IdentifyFlags {
  TraceFlags trace;
  std::string output, accelerometer;
  bool json = false;
};

/// Keys of [servo.X] in the order of AxisIdentification::values.
std::vector<NumberKey> keys_of(Setup& setup, std::size_t axis) {
  const std::string name = std::string("servo.") + kAxisNames[axis];
  for (const SetupSection& section : setup_sections(setup)) {
    if (section.name == name) return section.numbers;
  }
  return {};
}

double rounded(double value) { return parse_number(fmt::format("{:.6g}", value)).value_or(value); }

/// What is written into: the file of that name if there is one, else the machine file, else nothing.
Result<std::string> base_text(const IdentifyFlags& flags) {
  std::error_code ignored;
  const bool exists = !is_standard_output(flags.output) && std::filesystem::is_regular_file(flags.output, ignored);
  const std::string& from = exists ? flags.output : flags.trace.job.machine;
  if (from.empty()) return std::string();
  return read_settings_text(from, terminal_monitor("reading"));
}

/// The values that the trace tells, as a machine file; all else of it stays.
Result<std::string> servo_text(const IdentifyFlags& flags, const std::string& base, const Identification& found) {
  auto setup = parse_setup(base, flags.output, UnknownKeys::pass_over);
  if (!setup) return tl::unexpected(setup.error());
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!found.axis[axis]) continue;
    ServoAxis servo = found.axis[axis]->axis;
    servo.modes = setup->machine.servo[axis].modes;
    setup->machine.servo[axis] = servo;
    for (const NumberKey& key : keys_of(*setup, axis)) *key.value = rounded(*key.value / key.unit) * key.unit;
  }
  return edit_setup(base, flags.output, *setup);
}

Json values_json(const AxisIdentification& found, std::size_t axis) {
  Setup any = default_setup();
  const auto keys = keys_of(any, axis);
  Json values;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const IdentifiedValue& v = found.values[i];
    values[kIdentifiedNames[i]] = {{"key", keys[i].name},
                                   {"value", v.is_told ? Json(v.value / keys[i].unit) : Json(nullptr)},
                                   {"standard_error", v.is_told ? Json(v.error / keys[i].unit) : Json(nullptr)},
                                   {"unit", keys[i].range.unit},
                                   {"told", v.is_told},
                                   {"verdict", v.verdict}};
  }
  const AxisUnit& unit = axis_unit(axis);
  values[std::string("residual_rms_") + unit.key[0]] = found.noise / unit.size;
  values[std::string("residual_max_") + unit.key[0]] = found.largest / unit.size;
  values["rows"] = found.rows;
  return values;
}

Json identify_json(const IdentifyFlags& flags, const Trace& trace, const Identification& found) {
  Json axes = Json::object(), warnings = Json::array();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (found.axis[axis]) axes[std::string(1, kAxisNames[axis])] = values_json(*found.axis[axis], axis);
    if (found.refused[axis])
      warnings.push_back({{"code", found.refused[axis]->code}, {"message", found.refused[axis]->message}});
  }
  return {{"setpoints", flags.trace.reading.program},
          {"trace", flags.trace.trace},
          {"output", flags.output.empty() ? Json(nullptr) : Json(flags.output)},
          {"trace_period_ms", trace.step * 1e3},
          {"alignment", alignment_json(found.alignment)},
          {"same_clock", found.is_same_clock},
          {"axes", std::move(axes)},
          {"columns", columns_json(trace)},
          {"warnings", std::move(warnings)}};
}

void print_axis(const AxisIdentification& found, std::size_t axis) {
  Setup any = default_setup();
  const auto keys = keys_of(any, axis);
  fmt::print("  axis {}\n", kAxisNames[axis]);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const IdentifiedValue& v = found.values[i];
    if (v.is_told) {
      fmt::print("    {:<26} {:.6g} ± {:.2g}\n", keys[i].name, v.value / keys[i].unit, v.error / keys[i].unit);
    } else {
      fmt::print("    {:<26} not told: {}\n", keys[i].name, v.verdict);
    }
  }
  const AxisUnit& unit = axis_unit(axis);
  fmt::print("    left over                  {:.6f} {} RMS, {:.6f} {} at most\n", found.noise / unit.size,
             unit.symbol[0], found.largest / unit.size, unit.symbol[0]);
}

/// --accelerometer: modes instead of drives.
Done run_accelerometer(const IdentifyFlags& flags, const std::string& base) {
  if (!flags.trace.reading.program.empty()) {
    return tl::unexpected(
        usage_error("bad-usage", "--accelerometer is given, and SETPOINTS and TRACE too", "give either of them"));
  }
  const auto step = flags.trace.step();
  if (!step) return tl::unexpected(step.error());
  const auto record = read_acceleration(flags.accelerometer, {flags.trace.columns, *step}, terminal_monitor("reading"));
  end_progress();
  if (!record) return tl::unexpected(record.error());
  auto setup = base.empty() ? flags.trace.job.setup() : parse_setup(base, flags.output, UnknownKeys::pass_over);
  if (!setup) return tl::unexpected(setup.error());
  const auto shaken = find_shaken_axes(*record, setup->machine.servo);
  if (!shaken) return tl::unexpected(shaken.error());
  for (const Diagnostic& d : shaken->warnings) report(d);
  if (!flags.output.empty()) {
    for (std::size_t axis = 0; axis < shaken->axis.size(); ++axis) {
      if (shaken->axis[axis]) setup->machine.servo[axis].modes = shaken->axis[axis]->kept;
    }
    const auto text = edit_setup(base, flags.output, *setup);
    if (!text) return tl::unexpected(text.error());
    if (auto done = write_whole_file(flags.output, *text, terminal_monitor("writing")); !done)
      return tl::unexpected(done.error());
  }
  if (flags.json) {
    print_json(accelerometer_json(*record, *shaken, flags.output));
  } else if (!is_standard_output(flags.output)) {
    print_accelerometer(*record, *shaken);
  }
  return kFine;
}

Done run_identify(const IdentifyFlags& flags) {
  std::string base;
  if (!flags.output.empty()) {
    auto text = base_text(flags);
    if (!text) return tl::unexpected(text.error());
    if (auto fine = parse_setup(*text, flags.output, UnknownKeys::pass_over); !fine)
      return tl::unexpected(fine.error());
    base = std::move(*text);
  }
  if (!flags.accelerometer.empty()) return run_accelerometer(flags, base);
  if (flags.trace.trace.empty()) {
    return tl::unexpected(usage_error("bad-usage", "SETPOINTS and TRACE are missing",
                                      "give what was commanded and what was measured, or --accelerometer FILE"));
  }
  const auto pair = flags.trace.read();
  if (!pair) return tl::unexpected(pair.error());
  const auto found = identify(pair->commanded, pair->trace, pair->setup.machine.servo, terminal_monitor("identifying"));
  end_progress();
  if (!found) return tl::unexpected(found.error());
  warn_of_alignment(pair->trace, found->alignment);
  for (const auto& refused : found->refused) {
    if (refused)
      report(Diagnostic{Severity::warning, refused->code, refused->message, refused->remedy, refused->where, {}});
  }
  if (!flags.output.empty()) {
    const auto text = servo_text(flags, base, *found);
    if (!text) return tl::unexpected(text.error());
    if (auto done = write_whole_file(flags.output, *text, terminal_monitor("writing")); !done)
      return tl::unexpected(done.error());
  }
  if (flags.json) {
    print_json(identify_json(flags, pair->trace, *found));
  } else if (!is_standard_output(flags.output)) {
    fmt::print("{}\n", flags.trace.trace);
    print_alignment(pair->trace, found->alignment);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (found->axis[axis]) print_axis(*found->axis[axis], axis);
    }
  }
  return kFine;
}

}  // namespace

void add_identify_command(CommandLine& line) {
  auto flags = std::make_shared<IdentifyFlags>();
  Command command = line.add("identify", "Identify the drives of a machine from a measured trace, for its machine file",
                             [flags] { return run_identify(*flags); });
  command.output(
      "-o,--output FILE", flags->output,
      "Write what was found into [servo] of this machine file; comments and all else of it stay.\nWhere there is "
      "none, of a copy of --machine, or alone");
  command.json(flags->json, "Print one JSON object");
  command.input(
      "--accelerometer FILE", flags->accelerometer, "the accelerometer's recording",
      "Instead of SETPOINTS and TRACE: what an accelerometer on the axis felt while it was shaken or tapped,\n"
      "Klipper's raw format or a table of times and accelerations (g, mg, m/s², mm/s²); its modes are found and\n"
      "written as [[servo.X.modes]]");
  flags->trace.add_to(command, Need::optional);
  command.footer(
      "Fitted are gain, feed-forwards, bandwidth, damping, backlash, resonance and its damping of each axis, with "
      "standard\n"
      "errors. What the trace cannot tell is said and left as it is: without a reversal no backlash, without a "
      "vibration no\n"
      "resonance.\n\n"
      "Examples:\n"
      "  toolpace identify part.csv scope.csv -o mill.toml\n"
      "  toolpace identify part.ngc scope.csv --machine mill.toml -o measured.toml --json\n"
      "  toolpace identify --accelerometer raw_data_x.csv -o mill.toml");
}

}  // namespace toolpace::cli
