/// toolpace predict: how long a real controller takes for a program, why, and what its settings would give.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include "json.h"

#include "commands.h"
#include "controller_flags.h"
#include "interrupt.h"
#include "outcome_json.h"
#include "reading_flags.h"
#include "report.h"
#include "toolpace/base/axis_unit.h"
#include "toolpace/base/input_file.h"
#include "toolpace/base/numbers.h"
#include "toolpace/controller/prediction.h"
#include "toolpace/controller/refusals.h"
#include "toolpace/pipeline/run_on_controller.h"
#include "toolpace/tune/what_if.h"

namespace toolpace::cli {
namespace {

constexpr std::size_t kShownRows = 8;
constexpr const char* kAsSetpoints = "Toolpace's setpoints on the same limits";

struct PredictFlags {
  ReadingFlags reading;
  ControllerFlags controller;
  bool json = false, no_what_if = false;
};

/// All that is printed.
struct Told {
  Prediction prediction;
  std::vector<WhatIf> rows;
  std::optional<double> as_setpoints;             ///< [s]
  std::optional<std::vector<AxisExcess>> excess;  ///< nothing where its motion is not known
  Diagnostics warnings;
};

Json what_if_json(const Told& told) {
  Json list = Json::array();
  for (const WhatIf& row : told.rows) {
    list.push_back({{"setting", row.setting},
                    {"title", row.title},
                    {"unit", row.unit},
                    {"from", row.from},
                    {"to", row.to},
                    {"cycle_time_s", row.cycle_time}});
  }
  if (told.as_setpoints) {
    list.push_back({{"setting", kAsSetpoints},
                    {"title", kAsSetpoints},
                    {"unit", ""},
                    {"from", nullptr},
                    {"to", nullptr},
                    {"cycle_time_s", *told.as_setpoints}});
  }
  return list;
}

struct ExcessText {
  const char *quantity, *unit;
  double value, limit;
};

ExcessText text_of(const AxisExcess& e) {
  const AxisUnit& unit = axis_unit(e.axis);
  const bool is_speed = e.of == AxisExcess::Of::speed;
  return {is_speed ? "speed" : "acceleration", unit.symbol[is_speed ? 1 : 2], e.value / unit.size, e.limit / unit.size};
}

Json excess_json(const Told& told) {
  if (!told.excess) return nullptr;
  Json list = Json::array();
  for (const AxisExcess& e : *told.excess) {
    const ExcessText text = text_of(e);
    list.push_back({{"axis", std::string(1, kAxisNames[e.axis])},
                    {"quantity", text.quantity},
                    {"value", text.value},
                    {"limit", text.limit},
                    {"unit", text.unit},
                    {"line", e.line},
                    {"time_s", e.time}});
  }
  return list;
}

Json refusals_json(const std::vector<Refusal>& list) {
  Json json = Json::array();
  for (const Refusal& r : list) json.push_back({{"line", r.line}, {"code", r.code()}, {"message", r.message}});
  return json;
}

Json predict_json(const PredictFlags& flags, const Reading& reading, const ControllerSettings& settings,
                  const Told& told) {
  const Prediction& p = told.prediction;
  Json limits = Json::object();
  for (std::size_t i = 0; i < kTimeLimitCount; ++i) {
    if (p.time_by_limit[i] != 0) limits[std::string(time_limit_name(static_cast<TimeLimit>(i)))] = p.time_by_limit[i];
  }
  return {{"program", flags.reading.program},
          {"dialect", std::string(dialect_name(reading.dialect))},
          {"controller", std::string(controller_name(p.controller))},
          {"refused", reading.refused},
          {"cycle_time_s", p.cycle_time},
          {"feed_time_s", p.feed_time},
          {"rapid_time_s", p.rapid_time},
          {"dwell_time_s", p.dwell_time},
          {"blocks", p.blocks},
          {"baud", Json(flags.controller.baud)},
          {"starved_s", p.starved},
          {"time_by_limit_s", std::move(limits)},
          {"what_if", what_if_json(told)},
          {"over_limits", excess_json(told)},
          {"settings",
           {{"file", flags.controller.settings},
            {"used", settings.used},
            {"unused", settings.unused},
            {"unknown", settings.unknown},
            {"defaulted", settings.defaulted}}},
          {"refusals", refusals_json(refusals(p.controller, reading))},
          {"warnings", diagnostics_json(told.warnings)}};
}

void print_rows(const Told& told) {
  const double now = told.prediction.cycle_time;
  std::size_t shown = 0;
  for (const WhatIf& row : told.rows) {
    if (row.cycle_time >= now * (1 - 1e-6) || shown++ == kShownRows) break;
    fmt::print("  {:<13} {} ({}) {:.6g} -> {:.6g}{}: {:.4f} s, saves {:.4f} s\n", shown == 1 ? "what if" : "",
               row.setting, row.title, row.from, row.to, row.unit == "1" || row.unit.empty() ? "" : " " + row.unit,
               row.cycle_time, now - row.cycle_time);
  }
  if (told.as_setpoints) fmt::print("  as setpoints {:.4f} s: this planner on the same limits\n", *told.as_setpoints);
}

void print_excess(const Told& told) {
  if (!told.excess) return;
  for (std::size_t i = 0; i < told.excess->size(); ++i) {
    const AxisExcess& e = (*told.excess)[i];
    const ExcessText text = text_of(e);
    fmt::print("  {:<13}{} {} up to {:.4g} {}, {:.3g} times its limit, at line {}\n", i == 0 ? "over limits" : "",
               kAxisNames[e.axis], text.quantity, text.value, text.unit, text.value / text.limit, e.line);
  }
}

void print_refusals(const std::vector<Refusal>& list, std::string_view title) {
  for (std::size_t i = 0; i < std::min(list.size(), kShownRows); ++i) {
    fmt::print("  {:<13}line {}: {} ({})\n", i == 0 ? "refused" : "", list[i].line, list[i].code(), list[i].message);
  }
  if (list.size() > kShownRows)
    fmt::print("  {:<13}and {} more lines that {} refuses\n", "", list.size() - kShownRows, title);
}

void print_prediction(const PredictFlags& flags, const Reading& reading, const ControllerSettings& settings,
                      const Told& told) {
  const Prediction& p = told.prediction;
  fmt::print("{}\n  controller   {}, {}\n", flags.reading.program, controller_title(settings.controller),
             flags.controller.settings);
  fmt::print("  path         {} blocks\n", p.blocks);
  fmt::print("  cycle time   {:.4f} s  (feed {:.4f}, rapid {:.4f}, dwell {:.4f})\n", p.cycle_time, p.feed_time,
             p.rapid_time, p.dwell_time);
  if (flags.controller.baud || flags.controller.block_time_ms)
    fmt::print("  starved      {:.4f} s  (blocks did not arrive in time)\n", p.starved);
  for (std::size_t i = 0; i < kTimeLimitCount; ++i) {
    if (p.time_by_limit[i] > 0) {
      fmt::print("  {:<13} {:.4f} s  ({:.1f} %)\n", time_limit_name(static_cast<TimeLimit>(i)), p.time_by_limit[i],
                 100 * p.time_by_limit[i] / p.cycle_time);
    }
  }
  print_refusals(refusals(p.controller, reading), controller_title(p.controller));
  print_excess(told);
  print_rows(told);
}

/// What no model counts, said once.
void warn_of_what_is_left_out(const PredictFlags& flags, const ProgramText& text, const ControllerSettings& settings,
                              Diagnostics& warnings) {
  const auto warn = [&](const char* code, std::string message) {
    warnings.push_back({Severity::warning, code, std::move(message), "", {flags.reading.program, 0, 0}, {}});
  };
  const Diagnostics left_out = not_counted(text, settings, flags.reading.program);
  warnings.insert(warnings.end(), left_out.begin(), left_out.end());
  if (reads_own_disk(settings.controller) && flags.controller.baud) {
    warn("link-not-used", fmt::format("{} reads programs from its own disk: --baud changes nothing",
                                      controller_title(settings.controller)));
  }
}

/// Nothing where the controller's motion is not known, or the program has none.
Result<std::optional<std::vector<AxisExcess>>> excess_of(const ControllerRun& run) {
  const Monitor monitor = terminal_monitor("motion");
  const auto driven = run_on_controller(run, monitor);
  end_progress();
  if (!driven && driven.error().kind == ErrorKind::cancelled) return tl::unexpected(driven.error());
  if (!driven) return std::nullopt;
  auto excess = axes_over_limits(driven->outcome, {monitor.stop, {}});
  if (!excess) return tl::unexpected(excess.error());
  return std::optional(std::move(*excess));
}

tl::expected<Told, Failure> told_of(const PredictFlags& flags, const std::shared_ptr<const Reading>& reading,
                                    const ProgramText& text, const ControllerSettings& settings) {
  auto options = flags.controller.options();
  if (!options) return tl::unexpected<Failure>(options.error());
  auto prediction = predict(*reading, text, settings, *options, terminal_monitor("predicting"));
  end_progress();
  if (!prediction) return tl::unexpected<Failure>(Failure(prediction.error(), reading->diagnostics));
  Told told{std::move(*prediction), {}, {}, {}, settings.warnings};
  warn_of_what_is_left_out(flags, text, settings, told.warnings);
  told.warnings.insert(told.warnings.end(), told.prediction.warnings.begin(), told.prediction.warnings.end());
  if (flags.no_what_if) return told;
  auto rows = what_if(*reading, text, settings, *options, terminal_monitor("what if"));
  end_progress();
  if (!rows) return tl::unexpected<Failure>(rows.error());
  told.rows = std::move(*rows);
  auto excess = excess_of({reading, flags.reading.program, text, settings, *options});
  if (!excess) return tl::unexpected<Failure>(excess.error());
  told.excess = std::move(*excess);
  const bool refined = told.prediction.cycle_time < kLongestRefined;
  const auto planned =
      cycle_time_as_setpoints(reading, settings, kToleranceOfSetpoints, refined, terminal_monitor("planning"));
  end_progress();
  if (planned) {
    told.as_setpoints = *planned;
  } else if (planned.error().kind == ErrorKind::cancelled) {
    return tl::unexpected<Failure>(planned.error());
  } else {
    told.warnings.push_back({Severity::warning,
                             planned.error().code,
                             "no setpoints to compare with: " + planned.error().message,
                             planned.error().remedy,
                             planned.error().where,
                             {}});
  }
  return told;
}

Done run_predict(PredictFlags flags) {
  const auto settings = flags.controller.read_settings();
  if (!settings) return tl::unexpected(settings.error());
  if (auto options = flags.controller.options(); !options) return tl::unexpected(options.error());
  if (flags.reading.dialect == "auto")
    flags.reading.dialect = std::string(dialect_name(dialect_of(settings->controller)));
  const auto content = read_whole_file(flags.reading.program, terminal_monitor("reading"));
  if (!content) return tl::unexpected(content.error());
  auto read = flags.reading.read(content->bytes());
  if (!read) return tl::unexpected(read.error());
  const auto reading = std::make_shared<const Reading>(std::move(*read));
  const auto told = told_of(flags, reading, scan_program(content->bytes()), *settings);
  if (!told) return tl::unexpected(told.error());
  report(told->warnings);
  if (flags.json) {
    Told with_reading = *told;
    with_reading.warnings.insert(with_reading.warnings.begin(), reading->diagnostics.begin(),
                                 reading->diagnostics.end());
    print_json(predict_json(flags, *reading, *settings, with_reading));
  } else {
    print_prediction(flags, *reading, *settings, *told);
  }
  return reading->refused ? kBadInput : kFine;
}

}  // namespace

void add_predict_command(CommandLine& line) {
  auto flags = std::make_shared<PredictFlags>();
  Command command =
      line.add("predict", "Predict how long a real controller takes for a program, and what its settings would give",
               [flags] { return run_predict(*flags); });
  flags->controller.add_to(command, Need::required);
  command.toggle("--no-what-if", flags->no_what_if, "Leave out what other settings would give");
  command.json(flags->json, "Print one JSON object");
  flags->reading.add_to(command, {{"blocks", "blocks", {"blocks"}, CellKind::number, 0, true},
                                  {"cycle_time_s", "cycle time s", {"cycle_time_s"}, CellKind::number, 4, true},
                                  {"feed_time_s", "feed s", {"feed_time_s"}, CellKind::number, 4, true},
                                  {"rapid_time_s", "rapid s", {"rapid_time_s"}, CellKind::number, 4, true},
                                  {"dwell_time_s", "dwell s", {"dwell_time_s"}, CellKind::number, 4, true},
                                  {"starved_s", "starved s", {"starved_s"}, CellKind::number, 4, true},
                                  {"warnings", "warnings", {"warnings"}, CellKind::count, 0, true}});
  command.footer(
      "A program is read in the controller's dialect where --dialect names no other. One with errors is predicted up "
      "to the\n"
      "first one, and the exit code is 3.\n\n"
      "Examples:\n"
      "  toolpace predict part.ngc --settings mill-settings.txt\n"
      "  toolpace predict part.nc --controller grblhal --settings dump.txt --baud 115200\n"
      "  toolpace predict part.gcode --settings printer.cfg --json");
}

}  // namespace toolpace::cli
