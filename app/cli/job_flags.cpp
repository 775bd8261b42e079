#include "job_flags.h"

#include <charconv>
#include <utility>

#include "interrupt.h"
#include "toolpace/base/numbers.h"
#include "toolpace/law/law_table.h"
#include "toolpace/machine/read_machine.h"

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
  if (error != std::errc() || end != text.data() + text.size() || blocks < 1 || blocks > kDeepestLookahead) {
    return tl::unexpected(bad_flag("--lookahead", text, "1, 2, 3 … 1000000000 (blocks), all"));
  }
  lookahead = blocks;
  return {};
}

/// The values of flags, in the order in which they are set: dm and jd follow am and jm where only those are given.
Result<void> set_numbers(const JobFlags& f, Setup& setup) {
  struct Entry {
    const char* flag;
    std::optional<double> value;
    const char *section, *key;
  };
  const Entry entries[] = {{"--tacc-ms", f.tacc_ms, "law", "tacc_ms"},
                           {"--tdec-ms", f.tdec_ms, "law", "tdec_ms"},
                           {"--vmax", f.vmax, "path", "max_speed_mm_s"},
                           {"--am", f.am, "path", "max_acceleration_mm_s2"},
                           {"--am", f.am, "path", "max_deceleration_mm_s2"},
                           {"--dm", f.dm, "path", "max_deceleration_mm_s2"},
                           {"--jm", f.jm, "path", "max_jerk_mm_s3"},
                           {"--jm", f.jm, "path", "max_jerk_deceleration_mm_s3"},
                           {"--jd", f.jd, "path", "max_jerk_deceleration_mm_s3"},
                           {"--corner-step-mm-s", f.corner_step, "", "corner_step_mm_s"},
                           {"--tolerance-mm", f.tolerance, "lookahead", "tolerance_mm"},
                           {"--junction-deviation-mm", f.junction_deviation, "lookahead", "junction_deviation_mm"},
                           {"--override-percent", f.override_percent, "", "override_percent"},
                           {"--rapid-percent", f.rapid_percent, "", "rapid_percent"},
                           {"--period-ms", f.period_ms, "machine", "period_ms"},
                           {"--hold-at-s", f.hold_at, "", "hold_at_s"}};
  if (f.corner_step) setup.options.corner.step = 0.0;
  if (f.hold_at) setup.options.hold_at = 0.0;
  for (const Entry& e : entries) {
    if (auto done = set_flag(setup, e.flag, e.value, e.section, e.key); !done) return done;
  }
  return {};
}

}  // namespace

Result<void> pick_law(const std::string& word, LawKind& law) {
  if (word.empty()) return {};
  const auto kind = find_law(word);
  if (!kind) return tl::unexpected(bad_flag("--law", word, law_ids()));
  law = *kind;
  return {};
}

Result<void> pick_corner(const std::string& word, CornerRule& rule) {
  return pick("--corner", word, corner_names(), rule);
}

Result<void> set_flag(Setup& setup, const char* flag, const std::optional<double>& value, const std::string& section,
                      const char* key) {
  if (!value) return {};
  const NumberKey number = find_number(setup, section, key);
  if (!is_in_range(*value, number.range)) {
    return tl::unexpected(
        Error{ErrorKind::usage,
              "bad-limit",
              std::string(flag) + " is " + to_text(*value) + ", but must be " + range_text(number.range),
              "",
              {},
              {}});
  }
  *number.value = *value * number.unit;
  return {};
}

std::vector<std::string> JobFlags::ignored_in(const Outcome& outcome) const {
  struct Entry {
    const char* flag;
    bool is_given;
    Setting setting;
  };
  const Entry entries[] = {{"--law", !law.empty(), Setting::law},
                           {"--tacc-ms", tacc_ms.has_value(), Setting::t_acc},
                           {"--tdec-ms", tdec_ms.has_value(), Setting::t_dec},
                           {"--jm", jm.has_value(), Setting::jerk},
                           {"--jd", jd.has_value(), Setting::jerk},
                           {"--lookahead", !lookahead.empty(), Setting::lookahead},
                           {"--ramps", !ramps.empty(), Setting::ramps},
                           {"--corner", !corner.empty(), Setting::corner},
                           {"--tolerance-mm", tolerance.has_value(), Setting::tolerance},
                           {"--junction-deviation-mm", junction_deviation.has_value(), Setting::junction_deviation}};
  std::vector<std::string> ignored;
  for (const Entry& e : entries) {
    if (e.is_given && outcome.ignored.has(e.setting)) ignored.emplace_back(e.flag);
  }
  return ignored;
}

void JobFlags::add_to(Command& command) {
  Flags limits = command.titled("Machine and limits along the path (they override the machine file's)");
  limits.input(
      "--machine FILE", machine, "the machine file",
      "Machine file (TOML), LinuxCNC .ini or grbl's answer to $$;\nwithout one 100 mm/s, 3000 mm/s², 1e6 mm/s³, 1 ms");
  limits.number("--vmax MM/S", vmax, "Top speed");
  limits.number(
      "--am MM/S2", am,
      "Acceleration, along the path; on curves also of each linear axis, whatever its own limit\n(turning and "
      "changing speed together), and of a rotary one that has none");
  limits.number("--dm MM/S2", dm, "Deceleration; default am");
  limits.number("--jm MM/S3", jm,
                "Jerk, along the path and of axes on curves as --am; not kept by laws without a jerk limit");
  limits.number("--jd MM/S3", jd, "Jerk while slowing down; default jm");
  limits.number("--override-percent PERCENT", override_percent, "Feed override, up to 200; default 100");
  limits.number("--rapid-percent PERCENT", rapid_percent, "Rapid override, up to 100; default 100");
  limits.number("--period-ms MS", period_ms, "Interpolation period; default 1");

  Flags laws = command.titled("Law and look-ahead");
  laws.word("--law LAW", law, law_ids() + "; default quintic");
  laws.number("--tacc-ms MS", tacc_ms,
              "five-phase-time: least duration of a ramp up; default 50; a longer one\nis slower, "
              "much so in blocks that are too short for it: then a warning");
  laws.number("--tdec-ms MS", tdec_ms, "five-phase-time: least duration of a ramp down; default 50");
  laws.word("--lookahead N", lookahead, "Depth in blocks, or all (default); 1 = full stop at every node");
  laws.word(
      "--ramps KIND", ramps,
      "block (default): ramps end inside their block; span: they run across\nblocks, seven-phase and time-optimal "
      "ones turn back without losing their acceleration,\nand paths with curves are timed as fast as the axes "
      "allow");
  laws.number("--hold-at-s S", hold_at, "Feed hold at this time: a jerk-limited stop on the path, then a resume");

  Flags corners = command.titled("Corners");
  corners.word("--corner RULE", corner,
               "stop; servo (default): speed steps that a servo follows within a period; junction: by\n"
               "junction deviation; blend: rounded, quickly; smooth: optimised through the tolerance tube");
  corners.number("--corner-step-mm-s MM/S", corner_step, "Instead of --corner: largest step of the velocity vector");
  corners.number("--tolerance-mm MM", tolerance, "Largest distance from the path for blend and smooth; default 0.01");
  corners.number("--junction-deviation-mm MM", junction_deviation, "Junction deviation; default 0.01");
}

Result<Setup> JobFlags::setup() const {
  auto setup = machine.empty() ? Result<Setup>(default_setup()) : read_machine(machine, terminal_monitor("reading"));
  end_progress();
  if (!setup) return setup;
  PlanOptions& options = setup->options;
  for (const auto& done : {pick_law(law, options.law), pick("--ramps", ramps, ramps_names(), options.ramps),
                           pick_corner(corner, options.corner.rule), set_lookahead(lookahead, options.lookahead)}) {
    if (!done) return tl::unexpected(done.error());
  }
  if (auto done = set_numbers(*this, *setup); !done) return tl::unexpected(done.error());
  if (auto checked = check_setup(setup->machine, options); !checked) return tl::unexpected(checked.error());
  return setup;
}

}  // namespace toolpace::cli
