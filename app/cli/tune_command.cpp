/// toolpace tune: the best settings for a program on a machine.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include "commands.h"
#include "interrupt.h"
#include "job_flags.h"
#include "reading_flags.h"
#include "report.h"
#include "setting_flags.h"
#include "shaper_flag.h"
#include "toolpace/base/descriptor.h"
#include "toolpace/base/numbers.h"
#include "toolpace/io/output_file.h"
#include "toolpace/machine/read_machine.h"
#include "toolpace/report/comparison_page.h"
#include "toolpace/tune/tune.h"
#include "tune_controller.h"

namespace toolpace::cli {
namespace {

constexpr std::uint64_t kDefaultPlans = 200, kMostPlans = 1'000'000, kDefaultPredictions = 400;
constexpr std::uint64_t kNotGiven = ~std::uint64_t{0};
constexpr double kMicro = 1e-3;        // [mm]
constexpr double kLargestError = 1e6;  // [µm]
constexpr double kMostSeconds = 1e7;
constexpr std::size_t kShownPoints = 12;

struct TuneFlags {
  ReadingFlags reading;
  JobFlags job;
  ControllerFlags controller;
  std::string vary, output, report;
  std::optional<double> contour_um, vibration_um, seconds;
  std::uint64_t plans = kNotGiven;
  bool json = false;
};

/// The knobs of "am,jm,law"; all without a list.
Result<std::vector<Knob>> knobs_of(const std::string& list) {
  std::vector<Knob> knobs;
  if (list.empty()) return std::vector<Knob>(kAllKnobs.begin(), kAllKnobs.end());
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string name = list.substr(begin, end - begin);
    const auto knob = knob_named(name);
    if (!knob)
      return tl::unexpected(usage_error("bad-flag", "--vary does not know '" + name + "'",
                                        "give some of " + knob_names() + ", with commas between"));
    knobs.push_back(*knob);
    begin = end + 1;
  }
  return knobs;
}

Result<void> check_number(const char* flag, const std::optional<double>& value, double most, const char* unit) {
  if (!value || (*value > 0 && *value <= most)) return {};
  return tl::unexpected(usage_error("bad-flag",
                                    fmt::format("{} is {}, but it must be above 0 and at most {} {}", flag,
                                                toolpace::to_text(*value), toolpace::to_text(most), unit),
                                    ""));
}

Result<TuneOptions> options_of(const TuneFlags& flags) {
  auto knobs = knobs_of(flags.vary);
  if (!knobs) return tl::unexpected(knobs.error());
  for (const auto& fine : {check_number("--contour-um", flags.contour_um, kLargestError, "µm"),
                           check_number("--vibration-um", flags.vibration_um, kLargestError, "µm"),
                           check_number("--seconds", flags.seconds, kMostSeconds, "s")}) {
    if (!fine) return tl::unexpected(fine.error());
  }
  TuneOptions options;
  options.turned = std::move(*knobs);
  if (flags.contour_um) options.contour = *flags.contour_um * kMicro;
  if (flags.vibration_um) options.vibration = *flags.vibration_um * kMicro;
  const std::uint64_t plans = flags.plans;
  const bool is_given = plans != kNotGiven;
  if (is_given && (plans == 0 || plans > kMostPlans)) {
    return tl::unexpected(
        usage_error("bad-flag", fmt::format("--plans is {}, but must be 1 to {}", plans, kMostPlans), ""));
  }
  options.plans = is_given ? plans : flags.seconds ? kMostPlans : kDefaultPlans;
  if (flags.seconds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(*flags.seconds);
    options.is_over = [end] { return std::chrono::steady_clock::now() >= end; };
  }
  return options;
}

Setup setup_of(const Job& job) { return {job.machine, job.options}; }

/// The machine file with other settings, its comments kept; a new one where it was none of ours.
Result<std::string> machine_text(const TuneFlags& flags, const Setup& setup) {
  if (flags.job.machine.empty() || flags.job.machine == "-") return format_setup(setup);
  const auto text = read_settings_text(flags.job.machine, terminal_monitor("reading"));
  if (!text) return tl::unexpected(text.error());
  if (machine_format(flags.job.machine, *text) != MachineFormat::toml) return format_setup(setup);
  return edit_setup(*text, flags.job.machine, setup);
}

/// What was found, with what it takes to tell it.
struct Found {
  const TuneFlags& flags;
  Setup setup;
  TuneResult tuning;

  std::vector<SettingFlag> settings(const Tuned& tuned) const {
    return setting_flags(flags.job, setup, setup_of(*tuned.job));
  }
};

Json in_micro(const std::optional<double>& value) { return value ? Json(*value / kMicro) : Json(nullptr); }

Json point_json(const Found& found, const Tuned& tuned) {
  return {{"cycle_time_s", tuned.objectives.cycle_time},
          {"contour_um", tuned.objectives.contour / kMicro},
          {"vibration_um", in_micro(tuned.objectives.vibration)},
          {"settings", to_json(found.settings(tuned))}};
}

Json tune_json(const Found& found, const Diagnostics& warnings) {
  const TuneResult& t = found.tuning;
  Json front = Json::array(), told = Json::array();
  for (const Tuned& point : t.front) front.push_back(point_json(found, point));
  for (const Diagnostic& w : warnings)
    told.push_back({{"line", w.where.line}, {"column", w.where.column}, {"code", w.code}, {"message", w.message}});
  return {{"program", found.flags.reading.program},
          {"machine", found.flags.job.machine.empty() ? Json(nullptr) : Json(found.flags.job.machine)},
          {"plans_evaluated", t.plans},
          {"present", point_json(found, t.present)},
          {"front", std::move(front)},
          {"knee", point_json(found, t.front[t.knee])},
          {"contour_limit_um", t.limits.contour / kMicro},
          {"vibration_limit_um", t.present.objectives.vibration ? Json(t.limits.vibration / kMicro) : Json(nullptr)},
          {"best", t.best ? point_json(found, t.front[*t.best]) : Json(nullptr)},
          {"warnings", std::move(told)}};
}

void print_point(const Found& found, const char* title, const Tuned& point) {
  const std::string settings = to_text(found.settings(point));
  const auto& shaking = point.objectives.vibration;
  fmt::print("  {:<11} {:>11.4f} s {:>10.3f} µm {} {}\n", title, point.objectives.cycle_time,
             point.objectives.contour / kMicro, shaking ? fmt::format("{:>10.3f} µm ", *shaking / kMicro) : "",
             settings.empty() ? "as it is" : settings);
}

void print_found(const Found& found) {
  const TuneResult& t = found.tuning;
  fmt::print("{}\n  plans       {}\n", found.flags.reading.program, t.plans);
  fmt::print("  {:<11} {:>13} {:>13} {} settings\n", "", "cycle time", "contour error",
             t.present.objectives.vibration ? "    vibration" : "");
  print_point(found, "now", t.present);
  const std::size_t shown = std::min(kShownPoints, t.front.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t row = shown < 2 ? 0 : i * (t.front.size() - 1) / (shown - 1);
    print_point(found, i == 0 ? "front" : "", t.front[row]);
  }
  print_point(found, "knee", t.front[t.knee]);
  if (t.best) {
    print_point(found, "best", t.front[*t.best]);
  } else {
    fmt::print("  best        none keeps {:.6g} µm of contour error", t.limits.contour / kMicro);
    if (t.present.objectives.vibration) fmt::print(" and {:.6g} µm of vibration", t.limits.vibration / kMicro);
    fmt::print("\n");
  }
}

/// Before and after, planned once more.
Result<void> write_report(const Found& found, OutputFile& file) {
  const TuneResult& t = found.tuning;
  const Tuned& after = t.best ? t.front[*t.best] : t.front[t.knee];
  const Monitor monitor = terminal_monitor("report");
  const auto planned = run(t.present.job, {monitor.stop, {}});
  if (!planned) return tl::unexpected(planned.error());
  const auto better = run(after.job, {monitor.stop, {}});
  if (!better) return tl::unexpected(better.error());
  std::vector<ChangedSetting> changed;
  const Setup to = setup_of(*after.job);
  const auto back = setting_flags({}, to, found.setup);
  for (const SettingFlag& f : setting_flags({}, found.setup, to)) {
    const auto before = std::find_if(back.begin(), back.end(), [&](const SettingFlag& b) { return b.flag == f.flag; });
    changed.push_back({f.flag.substr(2), before == back.end() ? "" : before->text, f.text});
  }
  const auto page = comparison_page(*planned, *better, changed, monitor);
  end_progress();
  if (!page) return tl::unexpected(page.error());
  if (auto written = file.write(*page); !written) return written;
  return file.commit();
}

/// Opened before anything is planned: what cannot be written is known at once.
Result<std::optional<OutputFile>> open_output(const std::string& name) {
  if (name.empty()) return std::nullopt;
  auto opened = OutputFile::create(name, OutputFile::Access::forward, terminal_monitor("writing"));
  if (!opened) return tl::unexpected(opened.error());
  return std::optional<OutputFile>(std::move(*opened));
}

Result<void> check_settings_flags(const TuneFlags& flags) {
  const bool is_alone = flags.controller.is_given();
  const bool has_others = flags.contour_um || flags.vibration_um || flags.seconds || !flags.report.empty();
  if (!is_alone || !has_others) return {};
  return tl::unexpected(usage_error("bad-flag",
                                    "--settings tunes a controller, which knows none of --contour-um, "
                                    "--vibration-um, --seconds and --report",
                                    "leave them out"));
}

Done run_tune(const TuneFlags& flags) {
  TuneFlags own = flags;
  if (flags.controller.is_given()) own.vary.clear();  // names settings of the controller
  const auto options = options_of(own);
  if (!options) return tl::unexpected(options.error());
  if (auto fine = check_settings_flags(flags); !fine) return tl::unexpected(fine.error());
  if (flags.controller.is_given()) {
    const std::size_t predictions = flags.plans == kNotGiven ? kDefaultPredictions : options->plans;
    return tune_controller(
        {flags.reading, flags.job, flags.controller, flags.vary, flags.output, predictions, flags.json});
  }
  auto setup = flags.job.setup();
  if (!setup) return tl::unexpected(setup.error());
  if (auto shaped = ShaperFlag{}.apply_to(*setup); !shaped) return tl::unexpected(shaped.error());
  auto output = open_output(flags.output), page = open_output(flags.report);
  if (!output) return tl::unexpected(output.error());
  if (!page) return tl::unexpected(page.error());
  std::optional<OutputFile>& file = *output;
  auto reading = flags.reading.on(*setup).read_accepted();
  if (!reading) return tl::unexpected(std::move(reading.error()));
  Diagnostics warnings = reading->diagnostics;
  warnings.insert(warnings.end(), setup->warnings.begin(), setup->warnings.end());
  report(setup->warnings);
  auto job = std::make_shared<Job>();
  job->program_name = flags.reading.program;
  job->program = std::make_shared<const Reading>(std::move(*reading));
  job->machine = setup->machine;
  job->options = setup->options;
  auto tuning = tune(job, *options, terminal_monitor("tuning"));
  end_progress();
  if (!tuning) return tl::unexpected(tuning.error());
  const Found found{flags, *setup, std::move(*tuning)};
  const auto& best = found.tuning.best;
  if (file && best) {
    const auto text = machine_text(flags, setup_of(*found.tuning.front[*best].job));
    if (!text) return tl::unexpected(text.error());
    if (auto written = file->write(*text); !written) return tl::unexpected(written.error());
    if (auto done = file->commit(); !done) return tl::unexpected(done.error());
  }
  if (*page) {
    if (auto done = write_report(found, **page); !done) return tl::unexpected(done.error());
  }
  if (flags.json) {
    print_json(tune_json(found, warnings));
  } else if (!is_standard_output(flags.output) && !is_standard_output(flags.report)) {
    print_found(found);
  }
  return best ? kFine : kLimitBroken;
}

/// Of many programs; where a controller is tuned, its own words.
std::vector<SeriesColumn> table_columns() {
  return {{"now_s", "now s", {"present.cycle_time_s", "cycle_time_before_s"}, CellKind::number, 4, true},
          {"now_contour_um", "now contour µm", {"present.contour_um"}},
          {"now_vibration_um", "now vibration µm", {"present.vibration_um"}},
          {"best_s", "best s", {"best.cycle_time_s", "cycle_time_after_s"}, CellKind::number, 4, true},
          {"best_contour_um", "best contour µm", {"best.contour_um"}},
          {"best_vibration_um", "best vibration µm", {"best.vibration_um"}},
          {"settings", "settings", {"best.settings", "lines"}, CellKind::text}};
}

}  // namespace

void add_tune_command(CommandLine& line) {
  auto flags = std::make_shared<TuneFlags>();
  Command command = line.add("tune", "Find the best settings: cycle time against contour error and vibration",
                             [flags] { return run_tune(*flags); });
  command.word("--vary LIST", flags->vary,
               "What may be changed, with commas between: " + knob_names() +
                   "; with --settings keys of the controller ($120,$121 or max_accel); default all");
  command.number(
      "--contour-um UM", flags->contour_um,
      "Largest contour error through the drives that the best may have; default: that of the settings as they are");
  command.number(
      "--vibration-um UM", flags->vibration_um,
      "Largest residual vibration of an axis after a stop that the best may have (a rotary axis: in thousandths of a "
      "degree); default: that of the settings as they are");
  command.count("--plans N", flags->plans, "Plans that may be made, from 1; default 200");
  command.number("--seconds S", flags->seconds, "Or the time that may be spent: looked at between plans");
  command.output("-o,--output FILE", flags->output,
                 "Write the machine file with the best settings, its comments kept (.toml); - = standard output");
  command.output("--report FILE", flags->report, "Write a page (.html): the best settings beside those as they are");
  command.json(flags->json, "Print one JSON object");
  flags->controller.add_to(command, Need::optional);
  flags->job.add_to(command);
  flags->reading.add_to(command, table_columns(), true);
  command.footer(
      "Each point of the front is what plan and simulate print with its flags beside those that were given. "
      "Acceleration, jerk,\n"
      "tolerance, junction deviation and look-ahead are limits: never above what machine file and flags say. Contour "
      "error is\n"
      "that of the drives ([servo]) from the commanded path; vibration is that of axes with a resonance, after stops.\n"
      "With --settings the controller's own model is the judge, and what is best comes back as its own lines ($ of "
      "grbl, printer.cfg, "
      "M codes,\n.ini): with --machine no setting goes beyond that, else beyond what it has. --plans are predictions "
      "then, default 400; "
      "-o writes the\nwhole of its settings.\n"
      "Exit codes: 0 fine; 1 no settings keep the limits; 2 bad usage; 3 bad input; 4 file trouble; 130 "
      "interrupted.\n\n"
      "Examples:\n"
      "  toolpace tune part.ngc --machine mill.toml\n"
      "  toolpace tune part.ngc --machine mill.toml --contour-um 20 --vibration-um 5 -o best.toml\n"
      "  toolpace tune part.ngc --settings grbl.txt --machine mill.toml -o better.txt\n"
      "  toolpace tune part.ngc --machine mill.toml --report better.html\n"
      "  toolpace tune parts --machine mill.toml --contour-um 20 --results tuned.csv\n"
      "  toolpace tune part.ngc --machine mill.toml --vary am,jm,law --plans 100 --json");
}

}  // namespace toolpace::cli
