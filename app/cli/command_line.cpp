#include "command_line.h"

#include <CLI/CLI.hpp>
#include <charconv>

#include "usage_error.h"
#include "version.h"

namespace toolpace::cli {
namespace {

constexpr std::uint64_t kMostCounted = 1'000'000'000'000'000;  ///< sums of counts stay far from wrapping round
constexpr char kNumber[] = "a number between -1.8e308 and 1.8e308, or inf";
constexpr char kSeriesTitle[] = "Many programs (several, folders, a list): one table";
constexpr int kFlagColumns = 34;  ///< width of the flags in --help

template <class T>
bool read_whole(const std::string& text, T& value) {
  const bool has_plus = text.size() > 1 && text.front() == '+' && text[1] != '-';
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + (has_plus ? 1 : 0), end, value);
  return error == std::errc() && stop == end;
}

/// "--name" and "UNIT" of "--name UNIT".
std::pair<std::string, std::string> name_and_unit(const std::string& flag) {
  const std::size_t blank = flag.find(' ');
  return {flag.substr(0, blank), blank == std::string::npos ? "" : flag.substr(blank + 1)};
}

/// The first flag with an = and nothing behind it, as a script's unset variable leaves it. CLI11 would give it the next word.
std::optional<std::string> find_valueless(int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--") break;
    if (word.size() > 3 && word.rfind("--", 0) == 0 && word.find('=') == word.size() - 1) {
      return word.substr(0, word.size() - 1);
    }
  }
  return std::nullopt;
}

void put_below(CLI::Option* option, const std::string& title) {
  if (!title.empty()) option->group(title);
}

}  // namespace

void Flags::note(const std::string& flag, const char* kind, const std::string& text, Need need) {
  const auto [names, unit] = name_and_unit(flag);
  const std::size_t comma = names.find(',');
  const bool has_letter = comma != std::string::npos;
  taken_->flags.push_back({has_letter ? names.substr(comma + 1) : names, has_letter ? names.substr(0, comma) : "", unit,
                           kind, title_, text, need == Need::required});
}

void Flags::add(const std::string& flag, const char* kind, const std::string& text, const char* what, Need need,
                Take take) {
  note(flag, kind, text, need);
  const auto [name, unit] = name_and_unit(flag);
  const auto read = [name = name, what, take = std::move(take)](const std::string& word) {
    if (take(word)) return;
    throw CLI::ValidationError(
        name, word.empty() ? "is empty; it takes " + std::string(what) : "'" + word + "' is not " + what);
  };
  CLI::Option* option = app_->add_option_function<std::string>(name, read, text)->type_name(unit);
  put_below(option, title_);
  if (need == Need::required) option->required();
}

void Flags::number(const std::string& flag, std::optional<double>& target, const std::string& text) {
  add(flag, "number", text, kNumber, Need::optional, [&target](const std::string& word) {
    double value = 0;
    if (!read_whole(word, value)) return false;
    target = value;
    return true;
  });
}

void Flags::number(const std::string& flag, double& target, const std::string& text, Need need) {
  add(flag, "number", text, kNumber, need, [&target](const std::string& word) { return read_whole(word, target); });
}

void Flags::count(const std::string& flag, std::uint64_t& target, const std::string& text, Need need) {
  add(flag, "count", text, "a whole number from 0 to 1000000000000000", need,
      [&target](const std::string& word) { return read_whole(word, target) && target <= kMostCounted; });
}

void Flags::add_word(const std::string& flag, const char* kind, std::string& target, const std::string& text,
                     Need need) {
  add(flag, kind, text, "a name", need, [&target](const std::string& word) {
    target = word;
    return !word.empty();
  });
}

void Flags::word(const std::string& flag, std::string& target, const std::string& text, Need need) {
  add_word(flag, "word", target, text, need);
}

void Flags::input(const std::string& flag, std::string& target, const std::string& what, const std::string& text,
                  Need need) {
  taken_->files.reads(what, target);
  add_word(flag, "input", target, text, need);
}

void Flags::output(const std::string& flag, std::string& target, const std::string& text) {
  const std::string name = name_and_unit(flag).first;
  taken_->files.writes(name.substr(name.find("--")), target);
  add_word(flag, "output", target, text, Need::optional);
}

void Flags::words(const std::string& flag, std::vector<std::string>& target, const std::string& text) {
  note(flag, "words", text, Need::optional);
  const auto [name, unit] = name_and_unit(flag);
  put_below(app_->add_option(name, target, text)->type_name(unit)->allow_extra_args(false), title_);
}

void Flags::toggle(const std::string& flag, bool& target, const std::string& text) {
  note(flag, "toggle", text, Need::optional);
  put_below(app_->add_flag(flag, target, text), title_);
}

void Command::argument(const std::string& name, std::string& target, const std::string& what, const std::string& text,
                       Need need) {
  note(name, "argument", text, need);
  taken_->files.reads(what, target);
  app_->add_option(name, target, text)->type_name("")->required(need == Need::required);
}

void Command::programs(std::string& target, const std::string& text, std::vector<SeriesColumn> columns,
                       bool fills_cores) {
  SeriesFlags& series = taken_->series.emplace();
  series.columns = std::move(columns);
  series.fills_cores = fills_cores;
  taken_->program = &target;
  taken_->files.reads("the program", target);
  note("PROGRAM", "arguments", text, Need::required);
  app_->add_option("PROGRAM", series.names, text)->type_name("")->expected(-1);
  Flags many = titled(kSeriesTitle);
  many.input("--programs FILE", series.list, "the list of programs",
             "More programs, a line each (# = a remark); - = standard input");
  many.output(
      "--results FILE", series.results,
      "Append what is done, a row a program (.csv), and go on from there: a row is made again where the program,\n"
      "another file or a flag has changed, or where it failed; several processes may share it");
  many.output("--csv FILE", series.csv, "Write the table (.csv); - = standard output");
  many.count("--jobs N", series.jobs,
             fills_cores ? "Programs side by side; default 1, as one uses all cores"
                         : "Programs side by side; default: as many as cores");
}

void Command::json(bool& target, const std::string& text) {
  taken_->json = &target;
  taken_->files.prints_json(target);
  toggle("--json", target, text);
}

void Command::footer(const std::string& text) { app_->footer(text); }

CommandLine::CommandLine()
    : app_(std::make_unique<CLI::App>("Plans the motion of CNC machines: NC programs in, proven setpoints out.",
                                      "toolpace")) {
  app_->set_version_flag("--version", std::string("toolpace ") + version(), "Print the version and exit");
  app_->add_flag_callback(
      "--grammar", [this] { throw CLI::CallForVersion(grammar().text(), 0); },
      "Print all commands and flags as JSON and exit");
  app_->set_help_flag("-h,--help", "Print this help and exit");
  app_->get_formatter()->column_width(kFlagColumns);
  app_->get_formatter()->label("SUBCOMMAND", "COMMAND");
  app_->get_formatter()->label("Subcommands", "Commands");
  app_->get_formatter()->label("Positionals", "Arguments");
  app_->require_subcommand(1);
  app_->footer(
      "toolpace COMMAND --help lists the flags of a command, with examples.\n"
      "Exit codes: 0 fine; 1 a limit check failed; 2 bad usage; 3 bad input; 4 a file could not be read or written;\n"
      "130 interrupted. Results go to standard output, everything else to standard error.");
}

CommandLine::~CommandLine() = default;

Command CommandLine::add(const std::string& name, const std::string& summary, Action action) {
  CLI::App* command = app_->add_subcommand(name, summary);
  Entry& entry = *entries_.emplace_back(std::make_unique<Entry>(Entry{name, summary, std::move(action), {}, command}));
  command->callback([this, &entry] { chosen_ = &entry; });
  return Command(*command, entry.taken);
}

Json CommandLine::grammar() const {
  Json commands = Json::array();
  for (const auto& entry : entries_) {
    Json flags = Json::array();
    for (const FlagRow& row : entry->taken.flags) {
      flags.push_back({{"name", row.name},
                       {"letter", row.letter},
                       {"unit", row.unit},
                       {"kind", row.kind},
                       {"title", row.title},
                       {"text", row.text},
                       {"required", row.is_required}});
    }
    commands.push_back({{"name", entry->name},
                        {"summary", entry->summary},
                        {"footer", entry->app->get_footer()},
                        {"flags", std::move(flags)}});
  }
  return {{"version", version()},
          {"summary", app_->get_description()},
          {"footer", app_->get_footer()},
          {"commands", std::move(commands)}};
}

Result<Action> CommandLine::parse(int argc, const char* const* argv) {
  if (const auto flag = find_valueless(argc, argv)) {
    return tl::unexpected(usage_error("flag-value", *flag + " is empty: nothing stands behind its =",
                                      "write its value right behind the =, without a blank, or leave out both"));
  }
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() != 0) return tl::unexpected(explain_usage(*app_, e));
    app_->exit(e);  // help or version
    return Action([] { return Done(kFine); });
  }
  return chosen_action();
}

/// The flags as they were typed, but those of a series and --json.
std::vector<GivenFlag> CommandLine::given_flags(const Entry& entry) {
  std::vector<GivenFlag> given;
  for (const FlagRow& row : entry.taken.flags) {
    if (row.title == kSeriesTitle || row.name == "--json" || row.name.rfind("--", 0) != 0) continue;
    const CLI::Option* option = entry.app->get_option(row.name);
    const std::string_view kind = row.kind;
    for (const std::string& value : option->results())
      given.push_back({row.name, kind == "toggle" ? "" : value, kind == "input", kind == "output"});
  }
  return given;
}

Result<Action> CommandLine::chosen_action() const {
  Taken& taken = chosen_->taken;
  if (taken.series && taken.series->names.empty() && taken.series->list.empty()) {
    return tl::unexpected(
        usage_error("usage", "PROGRAM is required", "toolpace " + chosen_->name + " --help lists what it takes"));
  }
  const bool are_many = taken.series && taken.series->are_many();
  if (taken.series && !are_many) *taken.program = taken.series->names.front();
  if (auto apart = taken.files.check(); !apart) return tl::unexpected(std::move(apart.error()));
  if (!are_many) return chosen_->action;
  Series series{chosen_->name, *taken.series, given_flags(*chosen_), {}, taken.json && *taken.json};
  for (const GivenFlag& flag : series.given) {
    if (flag.is_input) series.inputs.push_back({flag.name, flag.value});
  }
  return Action([series] { return run_series(series); });
}

}  // namespace toolpace::cli
