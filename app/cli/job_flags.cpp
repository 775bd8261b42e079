#include "job_flags.h"

#include <charconv>
#include <utility>

#include "interrupt.h"
#include "toolpace/base/numbers.h"
#include "toolpace/law/law_table.h"
#include "toolpace/machine/setup_keys.h"

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
    return tl::unexpected(bad_flag("--lookahead", text, "1, 2, 3 … (blocks), all"));
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

void JobFlags::add_to(Command& command) {
  Flags limits = command.titled("Machine and limits along the path (they override the machine file's)");
  limits.input("--machine FILE", machine, "the machine file",
               "Machine file (TOML); without one 100 mm/s, 3000 mm/s², 1e6 mm/s³, 1 ms");
  limits.number("--vmax MM/S", vmax, "Top speed");
  limits.number("--am MM/S2", am, "Acceleration");
  limits.number("--dm MM/S2", dm, "Deceleration; default am");
  limits.number("--jm MM/S3", jm, "Jerk");
  limits.number("--jd MM/S3", jd, "Jerk while slowing down; default jm");
  limits.number("--override-percent PERCENT", override_percent, "Feed override, up to 200; default 100");
  limits.number("--rapid-percent PERCENT", rapid_percent, "Rapid override, up to 100; default 100");
  limits.number("--period-ms MS", period_ms, "Interpolation period; default 1");

  Flags laws = command.titled("Law and look-ahead");
  laws.word("--law LAW", law, law_ids() + "; default quintic");
  laws.number("--tacc-ms MS", tacc_ms, "five-phase-time: least duration of a ramp up; default 50");
  laws.number("--tdec-ms MS", tdec_ms, "five-phase-time: least duration of a ramp down; default 50");
  laws.word("--lookahead N", lookahead, "Depth in blocks, or all (default); 1 = full stop at every node");
  laws.word("--ramps KIND", ramps, "block (default): ramps end inside their block; span: they run across blocks");
  laws.number("--hold-at-s S", hold_at, "Feed hold at this time: a jerk-limited stop on the path, then a resume");

  Flags corners = command.titled("Corners");
  corners.word("--corner RULE", corner,
               "stop; servo (default): speed steps that a servo follows within a period; junction: by\n"
               "junction deviation; blend: corner curves; smooth: optimised through the tolerance tube");
  corners.number("--corner-step-mm-s MM/S", corner_step, "Instead of --corner: largest step of the velocity vector");
  corners.number("--tolerance-mm MM", tolerance, "Largest distance from the path for blend and smooth; default 0.01");
  corners.number("--junction-deviation-mm MM", junction_deviation, "Junction deviation; default 0.01");
}

Result<Setup> JobFlags::setup() const {
  auto setup = machine.empty() ? Result<Setup>(default_setup()) : read_setup(machine, terminal_monitor("reading"));
  end_progress();
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
