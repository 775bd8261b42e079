/// toolpace move: one move under one law, in any consistent units (mm and s, pulse and cycle, …).

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <string>
#include "json.h"

#include "commands.h"
#include "flag_names.h"
#include "report.h"
#include "toolpace/law/single_move.h"

namespace toolpace::cli {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

constexpr FlagName kFlags[] = {{"the length", "--length"},          {"the feed", "--feed"},
                               {"the start speed", "--start"},      {"the end speed", "--end"},
                               {"the acceleration limit", "--am"},  {"the deceleration limit", "--dm"},
                               {"the jerk limit", "--jm"},          {"the jerk limit while slowing down", "--jd"},
                               {"the acceleration time", "--tacc"}, {"the deceleration time", "--tdec"}};

struct MoveFlags {
  std::string law = "quintic";
  MoveRequest move;
  std::optional<double> tacc, tdec, am, dm, jm, jd;
  bool json = false;
};

/// What the law has to be told, and was not.
std::optional<Error> find_missing(const LawRow& law, const MoveFlags& flags) {
  const auto missing = [&](const char* what, const char* flag) {
    return usage_error("limit-missing", fmt::format("{} needs {}", law.id, what), fmt::format("add {}", flag));
  };
  if (law.uses_time && !flags.tacc) return missing("a ramp time", "--tacc, and --tdec where it differs");
  if (law.needs_acceleration && !flags.am) return missing("an acceleration limit", "--am");
  if (law.needs_jerk && !flags.jm) return missing("a jerk limit", "--jm");
  const auto is_zero = [](const std::optional<double>& time) { return time && *time == 0; };
  if (law.uses_time && (is_zero(flags.tacc) || is_zero(flags.tdec))) {
    return usage_error("number-out-of-range", "a ramp time is 0, which takes an unbounded acceleration",
                       "give --tacc and --tdec above 0, or use --law trapezoid");
  }
  return std::nullopt;
}

/// Limits that were given although the law does not look at them are worth a word: the move may break them.
void mention_unused(const LawRow& law, const MoveFlags& flags) {
  const auto mention = [&](const char* names) { tell(fmt::format("note: {} does not use {}\n", law.id, names)); };
  if (law.uses_time && (flags.am || flags.dm || flags.jm || flags.jd)) mention("--am, --dm, --jm, --jd");
  if (!law.uses_time && (flags.tacc || flags.tdec)) mention("--tacc, --tdec");
  if (!law.bounds_jerk && (flags.jm || flags.jd)) mention("--jm, --jd");
}

/// All that was given, whether the law uses it or not.
Dynamics given_dynamics(const MoveFlags& flags) {
  const double am = flags.am.value_or(kUnbounded), jm = flags.jm.value_or(kUnbounded), tacc = flags.tacc.value_or(0);
  return {{am, jm, tacc}, {flags.dm.value_or(am), flags.jd.value_or(jm), flags.tdec.value_or(tacc)}};
}

Dynamics dynamics_of(const LawRow& law, const MoveFlags& flags) {
  Dynamics used = given_dynamics(flags);
  for (RampLimits* limits : {&used.up, &used.down}) {
    if (law.uses_time) {
      limits->acceleration = limits->jerk = kUnbounded;
    } else {
      limits->time = 0.0;
    }
  }
  return used;
}

/// A number that makes no sense is none under a law that would not look at it either.
std::optional<Error> find_senseless(LawKind law, const MoveFlags& flags) {
  auto error = check_move(law, flags.move, given_dynamics(flags));
  return error && error->code == "number-out-of-range" ? error : std::nullopt;
}

Json move_json(const LawRow& law, const SingleMove& move) {
  Json phases = Json::array();
  for (const Phase& p : move.phases) {
    const PhaseState first = evaluate(p, 0.0), last = evaluate(p, p.duration);
    phases.push_back({{"begin", p.begin},
                      {"duration", p.duration},
                      {"distance", p.distance},
                      {"v_begin", first.speed},
                      {"v_end", last.speed},
                      {"a_begin", first.acceleration},
                      {"a_end", last.acceleration},
                      {"shape", shape_name(p.shape)}});
  }
  return {{"law", law.id},
          {"reaches_feed", move.reaches_feed},
          {"fmax", move.peak},
          {"sa", move.up.length},
          {"sb", move.down.length},
          {"t_acc", move.up.time},
          {"t_cruise", move.cruise_time},
          {"t_dec", move.down.time},
          {"t_total", move.total_time()},
          {"j_acc", move.up.peak_jerk},
          {"j_dec", move.down.peak_jerk},
          {"a_peak", move.up.peak_acceleration},
          {"d_peak", move.down.peak_acceleration},
          {"phases", phases}};
}

void print_table(const LawRow& law, const SingleMove& move) {
  const auto text = [](double value) {
    return std::isinf(value) ? std::string("unbounded") : fmt::format("{:.9g}", value);
  };
  fmt::print("{}: {}\n", law.title, move.reaches_feed ? "reaches the feed" : "does not reach the feed");
  fmt::print("peak speed            {}\n", text(move.peak));
  fmt::print("                      {:>16} {:>16} {:>16}\n", "speeding up", "cruise", "slowing down");
  fmt::print("time                  {:>16} {:>16} {:>16}\n", text(move.up.time), text(move.cruise_time),
             text(move.down.time));
  const double end = move.phases.empty() ? 0.0 : evaluate(move.phases.back(), move.phases.back().duration).distance;
  fmt::print("length                {:>16} {:>16} {:>16}\n", text(move.up.length),
             text(move.cruise_time > 0 ? end - move.up.length - move.down.length : 0.0), text(move.down.length));
  fmt::print("peak acceleration     {:>16} {:>16} {:>16}\n", text(move.up.peak_acceleration), "0",
             text(move.down.peak_acceleration));
  fmt::print("peak jerk             {:>16} {:>16} {:>16}\n", text(move.up.peak_jerk), "0", text(move.down.peak_jerk));
  fmt::print("total time            {}\n", text(move.total_time()));
}

Done run_move(const MoveFlags& flags) {
  const auto kind = find_law(flags.law);
  if (!kind) {
    return tl::unexpected(
        usage_error("law-unknown", "--law: there is no law called " + flags.law, "take one of " + law_ids()));
  }
  const LawRow& law = law_row(*kind);
  if (auto error = find_missing(law, flags)) return tl::unexpected(std::move(*error));
  if (const auto error = find_senseless(*kind, flags)) return tl::unexpected(with_flag(*error, kFlags));
  const auto move = single_move(*kind, flags.move, dynamics_of(law, flags));
  if (!move) return tl::unexpected(with_flag(move.error(), kFlags));
  mention_unused(law, flags);
  if (flags.json) {
    print_json(move_json(law, *move));
  } else {
    print_table(law, *move);
  }
  return kFine;
}

}  // namespace

void add_move_command(CommandLine& line) {
  auto flags = std::make_shared<MoveFlags>();
  Command command = line.add("move", "Compute one move: ramp, cruise, ramp, in any consistent units",
                             [flags] { return run_move(*flags); });
  command.word("--law LAW", flags->law, law_ids(), Need::required);
  command.number("--length L", flags->move.length, "Length of the move", Need::required);
  command.number("--feed F", flags->move.feed, "Top speed", Need::required);
  command.number("--start FS", flags->move.start, "Speed at the start; default 0");
  command.number("--end FE", flags->move.end, "Speed at the end; default 0");
  command.number("--tacc TA", flags->tacc, "Acceleration time, five-phase-time");
  command.number("--tdec TD", flags->tdec, "Deceleration time, five-phase-time; default tacc");
  command.number("--am A", flags->am, "Acceleration limit");
  command.number("--dm D", flags->dm, "Deceleration limit; default am");
  command.number("--jm J", flags->jm, "Jerk limit");
  command.number("--jd JD", flags->jd, "Jerk limit while slowing down; default jm");
  command.json(flags->json, "Print one JSON object");
  command.footer(
      "Any units that fit together do: mm and s, pulse and cycle. An end speed that the length does not allow is an "
      "error\n"
      "(exit code 3), which tells the nearest speed and the least length that would do.\n\n"
      "Examples:\n"
      "  toolpace move --law quintic --length 10 --feed 100 --am 3000 --jm 1e6\n"
      "  toolpace move --law five-phase-time --length 4000 --feed 100 --start 10 --end 20 --tacc 35 --tdec 20 --json");
}

}  // namespace toolpace::cli
