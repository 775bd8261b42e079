#include "shaper_flag.h"

#include <algorithm>

#include "failure.h"
#include "toolpace/pipeline/sampled.h"

namespace toolpace::cli {
namespace {

std::string names() {
  std::string all;
  for (const ShaperKind kind : kShaperKinds) all += (all.empty() ? "" : ", ") + std::string(shaper_name(kind));
  return all;
}

/// A step of speed at a corner would have echoes, each of them too much for the axes.
void leave_out_steps(Setup& setup) {
  CornerOptions& corner = setup.options.corner;
  const bool has_steps = corner.step || corner.rule == CornerRule::servo || corner.rule == CornerRule::junction;
  if (!has_steps) return;
  corner.rule = CornerRule::stop;
  corner.step.reset();
  setup.warnings.push_back(
      {Severity::warning,
       "shaper-stops",
       "shaped setpoints stop at corners: the steps of speed that the corner rule allows cannot be shaped",
       "--corner blend or smooth rounds them; --verify tells how far the shaped path is from the program",
       {},
       {}});
}

}  // namespace

void ShaperFlag::add_to(Command& command) {
  command.word(
      "--shaper KIND", name,
      names() +
          ": shape the setpoints of all axes, so that axes with a\nresonance ([servo.X] resonance_hz) "
          "come to rest without vibration; corners and curves are\nrounded, which --verify judges; default none");
}

Result<void> ShaperFlag::apply_to(Setup& setup) const {
  if (name.empty()) return {};
  const auto* const kind = std::find_if(std::begin(kShaperKinds), std::end(kShaperKinds),
                                        [&](ShaperKind k) { return shaper_name(k) == name; });
  if (kind == std::end(kShaperKinds)) {
    return tl::unexpected(usage_error("bad-flag", "--shaper does not know '" + name + "'", "give one of " + names()));
  }
  if (*kind != ShaperKind::none && shaping(*kind, setup.machine.servo).size() == 1) {
    return tl::unexpected(usage_error("shaper-no-resonance",
                                      "--shaper has nothing to do: no axis of the machine has a resonance",
                                      "give resonance_hz of the axis that shakes in [servo.X] of the machine file; "
                                      "'toolpace identify' finds it in a trace"));
  }
  setup.options.shaper = *kind;
  if (*kind != ShaperKind::none) leave_out_steps(setup);
  return {};
}

double setpoints_duration(const Outcome& outcome) {
  return outcome.summary.cycle_time + duration_of(impulses_of(outcome));
}

void add_shaper(Json& json, const Outcome& outcome) {
  const Impulses impulses = impulses_of(outcome);
  json["shaper"] = nullptr;
  if (impulses.size() == 1) return;
  Json list = Json::array();
  for (const Impulse& i : impulses) list.push_back({{"t_s", i.time}, {"share", i.share}});
  json["shaper"] = {{"kind", shaper_name(outcome.job->options.shaper)},
                    {"time_s", duration_of(impulses)},
                    {"impulses", std::move(list)}};
  json["cycle_time_s"] = setpoints_duration(outcome);
  json["time_by_limit_s"]["shaper"] = duration_of(impulses);
}

}  // namespace toolpace::cli
