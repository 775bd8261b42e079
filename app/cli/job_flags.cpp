#include "job_flags.h"

#include <charconv>
#include <utility>

#include "toolpace/base/numbers.h"
#include "toolpace/law/law_table.h"
#include "toolpace/pipeline/setup_keys.h"

namespace toolpace::cli {
namespace {

Error bad_flag(const std::string& flag, const std::string& value, const std::string& choices) {
  return {ErrorKind::usage, "bad-flag", flag + " does not know '" + value + "'", "give one of " + choices, {}, {}};
}

template <class T>
Result<void> pick(const std::string& flag, const std::string& word, const std::vector<Named<T>>& names, T& target) {
  if (word.empty()) return {};
  std::string choices;
  for (const auto& n : names) {
    if (n.name == word) {
      target = n.value;
      return {};
    }
    choices += (choices.empty() ? "" : ", ") + std::string(n.name);
  }
  return tl::unexpected(bad_flag(flag, word, choices));
}

Result<void> set_lookahead(const std::string& text, std::optional<std::size_t>& lookahead) {
  if (text.empty()) return {};
  if (text == "all") {
    lookahead.reset();
    return {};
  }
  std::size_t blocks = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), blocks);
  if (error != std::errc() || end != text.data() + text.size() || blocks < 1) {
    return tl::unexpected(bad_flag("--lookahead", text, "a whole number of blocks ≥ 1, all"));
  }
  lookahead = blocks;
  return {};
}

void set(const std::optional<double>& flag, double& target, double unit = 1.0) {
  if (flag) target = *flag * unit;
}

/// Names the flag whose number makes no sense on its own; check_setup() judges the whole.
Result<void> check_positive(const JobFlags& f) {
  const std::pair<const char*, std::optional<double>> flags[] = {{"--tacc-ms", f.tacc_ms},
                                                                 {"--tdec-ms", f.tdec_ms},
                                                                 {"--am", f.am},
                                                                 {"--dm", f.dm},
                                                                 {"--jm", f.jm},
                                                                 {"--jd", f.jd},
                                                                 {"--vmax", f.vmax},
                                                                 {"--corner-step-mm-s", f.corner_step},
                                                                 {"--tolerance-mm", f.tolerance},
                                                                 {"--junction-deviation-mm", f.junction_deviation},
                                                                 {"--override-percent", f.override_percent},
                                                                 {"--rapid-percent", f.rapid_percent},
                                                                 {"--period-ms", f.period_ms}};
  for (const auto& [name, value] : flags) {
    if (!value || *value > 0) continue;
    return tl::unexpected(Error{ErrorKind::usage,
                                "bad-limit",
                                std::string(name) + " " + to_text(*value) + " makes no sense",
                                "give a value above 0",
                                {},
                                {}});
  }
  return {};
}

/// dm and jd follow am and jm where only those are given.
void set_path_limits(const JobFlags& f, PathLimits& path) {
  set(f.vmax, path.speed);
  set(f.am, path.acceleration);
  set(f.am, path.deceleration);
  set(f.dm, path.deceleration);
  set(f.jm, path.jerk);
  set(f.jm, path.jerk_deceleration);
  set(f.jd, path.jerk_deceleration);
}

}  // namespace

void JobFlags::add_to(CLI::App& c) {
  c.add_option("--machine", machine, "Machine file (TOML)");
  c.add_option("--law", law, "Velocity law: " + law_ids());
  c.add_option("--tacc-ms", tacc_ms, "Duration of a ramp up, five-phase-time [ms]");
  c.add_option("--tdec-ms", tdec_ms, "Duration of a ramp down, five-phase-time [ms]");
  c.add_option("--am", am, "Acceleration along the path [mm/s²]");
  c.add_option("--dm", dm, "Deceleration along the path [mm/s²]; default am");
  c.add_option("--jm", jm, "Jerk along the path [mm/s³]");
  c.add_option("--jd", jd, "Jerk while slowing down [mm/s³]; default jm");
  c.add_option("--vmax", vmax, "Top speed along the path [mm/s]");
  c.add_option("--lookahead", lookahead, "Look-ahead depth in blocks, or all; 1 = full stop at every node");
  c.add_option("--ramps", ramps, "block: ramps end inside their block; span: ramps run across blocks");
  c.add_option("--corner", corner, "Corner rule: stop, servo, junction, blend or smooth");
  c.add_option("--corner-step-mm-s", corner_step, "Instead of --corner: largest step of the velocity vector [mm/s]");
  c.add_option("--tolerance-mm", tolerance, "Tolerance of blend and smooth [mm]");
  c.add_option("--junction-deviation-mm", junction_deviation, "Junction deviation [mm]");
  c.add_option("--override-percent", override_percent, "Feed override [%], up to 200");
  c.add_option("--rapid-percent", rapid_percent, "Rapid override [%], up to 100");
  c.add_option("--period-ms", period_ms, "Interpolation period [ms]");
  c.add_option("--hold-at-s", hold_at, "Feed hold at this time [s]: a jerk-limited stop on the path, then a resume");
}

Result<Setup> JobFlags::setup() const {
  auto setup = machine.empty() ? Result<Setup>(default_setup()) : read_setup(machine);
  if (!setup) return setup;
  PlanOptions& options = setup->options;
  if (!law.empty()) {
    const auto kind = find_law(law);
    if (!kind) return tl::unexpected(bad_flag("--law", law, law_ids()));
    options.law = *kind;
  }
  for (const auto& done :
       {pick("--ramps", ramps, ramps_names(), options.ramps),
        pick("--corner", corner, corner_names(), options.corner.rule), set_lookahead(lookahead, options.lookahead)}) {
    if (!done) return tl::unexpected(done.error());
  }
  if (auto checked = check_positive(*this); !checked) return tl::unexpected(checked.error());
  set_path_limits(*this, setup->machine.path);
  set(tacc_ms, options.t_acc, 1e-3);
  set(tdec_ms, options.t_dec, 1e-3);
  if (corner_step) options.corner.step = corner_step;
  set(tolerance, options.corner.tolerance);
  set(junction_deviation, options.corner.junction_deviation);
  set(override_percent, options.feed_override, 1e-2);
  set(rapid_percent, options.rapid_override, 1e-2);
  set(period_ms, setup->machine.period, 1e-3);
  if (hold_at) options.hold_at = hold_at;
  if (auto checked = check_setup(setup->machine, options); !checked) return tl::unexpected(checked.error());
  return setup;
}

}  // namespace toolpace::cli
