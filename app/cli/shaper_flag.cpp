#include "shaper_flag.h"

#include <algorithm>

#include "failure.h"
#include "toolpace/machine/setup_keys.h"
#include "toolpace/pipeline/sampled.h"

namespace toolpace::cli {
namespace {

std::string names() {
  std::string all;
  for (const auto& known : shaper_names()) all += (all.empty() ? "" : ", ") + std::string(known.name);
  return all;
}

}  // namespace

void ShaperFlag::add_to(Command& command) {
  command.word(
      "--shaper KIND", name,
      names() +
          ": shape the setpoints of all axes for every mode of every\naxis ([servo.X] resonance_hz, "
          "[[servo.X.modes]]), so "
          "that they come to rest without vibration; corners and\ncurves are rounded, which --verify judges; default: "
          "that of the machine file, else none");
}

Result<void> ShaperFlag::apply_to(Setup& setup) const {
  const auto& known = shaper_names();
  const auto named = std::find_if(known.begin(), known.end(), [&](const auto& k) { return k.name == name; });
  if (!name.empty() && named == known.end()) {
    return tl::unexpected(usage_error("bad-flag", "--shaper does not know '" + name + "'", "give one of " + names()));
  }
  if (!name.empty()) setup.options.shaper = named->value;
  if (setup.options.shaper == ShaperKind::none) return {};
  if (shaped_modes(setup.machine.servo).empty()) {
    return tl::unexpected(usage_error(
        "shaper-no-resonance",
        (name.empty() ? "the shaper of the machine file" : "--shaper") +
            std::string(" has nothing to do: no axis of the machine has a resonance"),
        "give resonance_hz of the axis that shakes in [servo.X] of the machine file; 'toolpace identify' finds it in a "
        "trace"));
  }
  return {};
}

void add_shaper(Json& json, const Outcome& outcome) {
  const Impulses impulses = impulses_of(outcome);
  json["shaper"] = nullptr;
  if (impulses.size() == 1) return;
  Json list = Json::array();
  for (const Impulse& i : impulses) list.push_back({{"t_s", i.time}, {"share", i.share}});
  Json modes = Json::array();
  for (const AxisMode& m : shaped_modes(outcome.job->machine.servo))
    modes.push_back({{"frequency_hz", m.frequency}, {"damping", m.damping}});
  json["shaper"] = {{"kind", shaper_name(outcome.job->options.shaper)},
                    {"time_s", duration_of(impulses)},
                    {"modes", std::move(modes)},
                    {"impulses", std::move(list)}};
  json["cycle_time_s"] = setpoints_duration(outcome);
  json["time_by_limit_s"]["shaper"] = duration_of(impulses);
}

}  // namespace toolpace::cli
