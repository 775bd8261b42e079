#include "usage_error.h"

#include <fmt/format.h>

#include "report.h"
#include "toolpace/pipeline/setup_keys.h"

namespace toolpace::cli {
namespace {

std::vector<std::string> flags_of(const CLI::App& command) {
  std::vector<std::string> flags;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
  }
  return flags;
}

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// The one that begins with the word, else the nearest.
std::string meant(const std::string& word, const std::vector<std::string>& candidates) {
  for (const std::string& candidate : candidates) {
    if (candidate.rfind(word, 0) == 0) return candidate;
  }
  return nearest_word(word, candidates);
}

Error usage_error(const char* code, std::string what, std::string remedy) {
  return {ErrorKind::usage, code, std::move(what), std::move(remedy), {}, {}};
}

Error unexpected(const CLI::App& app, const std::string& word) {
  const auto running = app.get_subcommands();
  const CLI::App& command = running.empty() ? app : *running.front();
  if (word.size() > 1 && word.front() == '-') {
    const std::string flag = word.substr(0, word.find('='));
    return usage_error("flag-unknown", fmt::format("there is no flag {}", flag),
                       fmt::format("did you mean {}?", meant(flag, flags_of(command))));
  }
  if (running.empty()) {
    return usage_error("command-unknown", fmt::format("there is no command '{}'", word),
                       fmt::format("did you mean {}?", meant(word, commands_of(app))));
  }
  return usage_error("argument-unexpected", fmt::format("'{}' is one argument too many", word),
                     fmt::format("toolpace {} --help tells which it takes", command.get_name()));
}

}  // namespace

int report_usage(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error) == 0 ? kFine : kBadUsage;
  const auto extras = app.remaining(true);
  const bool about_extras = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                            dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (about_extras && !extras.empty()) return report(unexpected(app, extras.front()));
  return report(usage_error("usage", error.what(), "run with --help for more information"));
}

}  // namespace toolpace::cli
