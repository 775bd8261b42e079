#include "tune_controller.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "interrupt.h"
#include "json.h"
#include "report.h"
#include "toolpace/base/descriptor.h"
#include "toolpace/base/input_file.h"
#include "toolpace/io/output_file.h"
#include "toolpace/machine/edit_settings.h"
#include "toolpace/tune/tune_settings.h"

namespace toolpace::cli {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    if (!lines.back().empty() && lines.back().back() == '\r') lines.back().pop_back();
    at = end + 1;
  }
  return lines;
}

/// The controller's own text with the changes, and the lines in which it differs.
struct GivenBack {
  std::string text;
  std::vector<std::string> lines;
};

Result<GivenBack> give_back(const ControllerFlags& flags, const TunedSettings& tuned) {
  const auto was = read_settings_text(flags.settings, terminal_monitor("reading"));
  if (!was) return tl::unexpected(was.error());
  GivenBack back{*was, {}};
  for (const SettingChange& c : tuned.changes) {
    auto changed = edit_controller_setting(back.text, flags.settings, tuned.settings.controller, c.setting, c.to);
    if (!changed) return tl::unexpected(changed.error());
    back.text = std::move(*changed);
  }
  std::vector<std::string> before = lines_of(*was);
  std::sort(before.begin(), before.end());
  for (const std::string& line : lines_of(back.text)) {
    if (!std::binary_search(before.begin(), before.end(), line)) back.lines.push_back(line);
  }
  return back;
}

/// The keys of "$110,$120", as they are listed or without the section in which they stand ("max_accel").
Result<std::vector<std::string>> turned_of(const std::string& list, const ControllerSettings& settings) {
  std::vector<std::string> turned;
  if (list.empty()) return turned;
  const std::vector<std::string> known = tunable_settings(settings);
  std::string names;
  for (const std::string& key : known) names += (names.empty() ? "" : ", ") + key;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string name = list.substr(begin, end - begin);
    bool is_known = false;
    for (const std::string& key : known) {
      if (key != name && !key.ends_with("] " + name)) continue;
      turned.push_back(key);
      is_known = true;
    }
    if (!is_known)
      return tl::unexpected(usage_error("bad-flag", "--vary does not know '" + name + "' of these settings",
                                        "give some of " + names + ", with commas between"));
    begin = end + 1;
  }
  return turned;
}

Json controller_json(const TuneControllerFlags& flags, const TunedSettings& tuned, const GivenBack& back) {
  Json changes = Json::array(), lines = Json::array();
  for (const SettingChange& c : tuned.changes)
    changes.push_back({{"setting", c.setting}, {"title", c.title}, {"unit", c.unit}, {"from", c.from}, {"to", c.to}});
  for (const std::string& line : back.lines) lines.push_back(line);
  return {{"program", flags.reading.program},
          {"controller", std::string(controller_name(tuned.settings.controller))},
          {"settings", flags.controller.settings},
          {"machine", flags.job.machine.empty() ? Json(nullptr) : Json(flags.job.machine)},
          {"predictions", tuned.predictions},
          {"cycle_time_before_s", tuned.before},
          {"cycle_time_after_s", tuned.after},
          {"changes", std::move(changes)},
          {"lines", std::move(lines)},
          {"output", flags.output.empty() ? Json(nullptr) : Json(flags.output)}};
}

void print_controller(const TuneControllerFlags& flags, const TunedSettings& tuned, const GivenBack& back) {
  fmt::print("{}\n  controller  {}, {}\n", flags.reading.program, controller_title(tuned.settings.controller),
             flags.controller.settings);
  fmt::print("  cycle time  {:.4f} s now, {:.4f} s at best, by its model ({} predictions)\n", tuned.before, tuned.after,
             tuned.predictions);
  if (tuned.changes.empty()) return fmt::print("  nothing to change: no setting that may be changed helps\n");
  for (const SettingChange& c : tuned.changes) {
    fmt::print("  {:<11} {} ({}) {:.6g} -> {:.6g} {}\n", &c == &tuned.changes.front() ? "change" : "", c.setting,
               c.title, c.from, c.to, c.unit == "1" ? "" : c.unit);
  }
  for (const std::string& line : back.lines) fmt::print("{}\n", line);
}

}  // namespace

Done tune_controller(TuneControllerFlags flags) {
  const auto settings = flags.controller.read_settings();
  if (!settings) return tl::unexpected(settings.error());
  SettingsSearch search;
  search.predictions = flags.plans;
  auto turned = turned_of(flags.vary, *settings);
  if (!turned) return tl::unexpected(turned.error());
  search.turned = std::move(*turned);
  auto options = flags.controller.options();
  if (!options) return tl::unexpected(options.error());
  search.predict = *options;
  if (!flags.job.machine.empty()) {
    auto setup = flags.job.setup();
    if (!setup) return tl::unexpected(setup.error());
    search.allowed = std::move(*setup);
  }
  if (flags.reading.dialect == "auto")
    flags.reading.dialect = std::string(dialect_name(dialect_of(settings->controller)));
  const auto content = read_whole_file(flags.reading.program, terminal_monitor("reading"));
  if (!content) return tl::unexpected(content.error());
  auto reading = flags.reading.read_accepted(content->bytes());
  if (!reading) return tl::unexpected(std::move(reading.error()));
  const auto tuned =
      tune_settings(*reading, scan_program(content->bytes()), *settings, search, terminal_monitor("tuning"));
  end_progress();
  if (!tuned) return tl::unexpected(tuned.error());
  const auto back = give_back(flags.controller, *tuned);
  if (!back) return tl::unexpected(back.error());
  if (!flags.output.empty()) {
    if (auto done = write_whole_file(flags.output, back->text, terminal_monitor("writing")); !done)
      return tl::unexpected(done.error());
  }
  report(settings->warnings);
  if (flags.json) {
    print_json(controller_json(flags, *tuned, *back));
  } else if (!is_standard_output(flags.output)) {
    print_controller(flags, *tuned, *back);
  }
  return kFine;
}

}  // namespace toolpace::cli
