#include "command_line.h"

#include <CLI/CLI.hpp>
#include <charconv>

#include "usage_error.h"

namespace toolpace::cli {
namespace {

constexpr std::uint64_t kMostCounted = 1'000'000'000'000'000;  ///< sums of counts stay far from wrapping round
constexpr char kNumber[] = "a number between -1.8e308 and 1.8e308, or inf";
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

void Flags::add(const std::string& flag, const std::string& text, const char* what, Need need, Take take) {
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
  add(flag, text, kNumber, Need::optional, [&target](const std::string& word) {
    double value = 0;
    if (!read_whole(word, value)) return false;
    target = value;
    return true;
  });
}

void Flags::number(const std::string& flag, double& target, const std::string& text, Need need) {
  add(flag, text, kNumber, need, [&target](const std::string& word) { return read_whole(word, target); });
}

void Flags::count(const std::string& flag, std::uint64_t& target, const std::string& text, Need need) {
  add(flag, text, "a whole number from 0 to 1000000000000000", need,
      [&target](const std::string& word) { return read_whole(word, target) && target <= kMostCounted; });
}

void Flags::word(const std::string& flag, std::string& target, const std::string& text, Need need) {
  add(flag, text, "a name", need, [&target](const std::string& word) {
    target = word;
    return !word.empty();
  });
}

void Flags::input(const std::string& flag, std::string& target, const std::string& what, const std::string& text,
                  Need need) {
  files_->reads(what, target);
  word(flag, target, text, need);
}

void Flags::output(const std::string& flag, std::string& target, const std::string& text) {
  const std::string name = name_and_unit(flag).first;
  files_->writes(name.substr(name.find("--")), target);
  word(flag, target, text);
}

void Flags::words(const std::string& flag, std::vector<std::string>& target, const std::string& text) {
  const auto [name, unit] = name_and_unit(flag);
  put_below(app_->add_option(name, target, text)->type_name(unit)->allow_extra_args(false), title_);
}

void Flags::toggle(const std::string& flag, bool& target, const std::string& text) {
  put_below(app_->add_flag(flag, target, text), title_);
}

void Command::argument(const std::string& name, std::string& target, const std::string& what, const std::string& text) {
  files_->reads(what, target);
  app_->add_option(name, target, text)->type_name("")->required();
}

void Command::json(bool& target, const std::string& text) {
  files_->prints_json(target);
  toggle("--json", target, text);
}

void Command::footer(const std::string& text) { app_->footer(text); }

CommandLine::CommandLine()
    : app_(std::make_unique<CLI::App>("Plans the motion of CNC machines: NC programs in, proven setpoints out.",
                                      "toolpace")) {
  app_->set_version_flag("--version", "toolpace " TOOLPACE_VERSION, "Print the version and exit");
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
  Entry& entry = *entries_.emplace_back(std::make_unique<Entry>(Entry{std::move(action), {}}));
  command->callback([this, &entry] { chosen_ = &entry; });
  return Command(*command, entry.files);
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
  if (auto apart = chosen_->files.check(); !apart) return tl::unexpected(std::move(apart.error()));
  return chosen_->action;
}

}  // namespace toolpace::cli
