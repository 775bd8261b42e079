#include "usage_error.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>

#include "failure.h"
#include "toolpace/base/nearest_word.h"

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

/// The one that begins with the word, else the nearest one if it is near.
std::optional<std::string> meant(const std::string& word, const std::vector<std::string>& candidates) {
  for (const std::string& candidate : candidates) {
    if (candidate.rfind(word, 0) == 0) return candidate;
  }
  const std::size_t letters = std::count_if(word.begin(), word.end(), [](char c) { return c != '-'; });
  std::string nearest = nearest_word(word, candidates);
  if (edit_distance(word, nearest) > 1 + letters / 3) return std::nullopt;
  return nearest;
}

std::string suggestion(const std::optional<std::string>& meant, const std::string& otherwise) {
  return meant ? "did you mean " + *meant + "?" : otherwise;
}

/// The command that was being read, or the program itself.
const CLI::App& running(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : *commands.front();
}

std::string help_of(const CLI::App& command) {
  return fmt::format("{}{} --help lists {}", command.get_parent() ? "toolpace " : "", command.get_name(),
                     command.get_parent() ? "what it takes" : "the commands");
}

Error unexpected(const CLI::App& app, const std::string& word) {
  const CLI::App& command = running(app);
  const std::string flag = word.substr(0, word.find('='));
  const auto flags = flags_of(command);
  const bool is_behind_dashes =
      std::find(flags.begin(), flags.end(), flag) != flags.end();  // "--": no flags from here on
  if (word.size() > 1 && word.front() == '-' && !is_behind_dashes) {
    return usage_error("flag-unknown", fmt::format("there is no flag {}", flag),
                       suggestion(meant(flag, flags), help_of(command)));
  }
  if (&command == &app) {
    return usage_error("command-unknown", fmt::format("there is no command '{}'", word),
                       suggestion(meant(word, commands_of(app)), help_of(command)));
  }
  return usage_error("argument-unexpected", fmt::format("'{}' is one argument too many", word), help_of(command));
}

/// A flag that was given twice, or without its value.
Error mismatch(const CLI::App& command, const std::string& otherwise) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_items_expected_max() == 1 && option->results().size() > 1) {
      return usage_error("flag-twice", option->get_name() + " is given more than once", "give it once");
    }
  }
  return usage_error("flag-value", otherwise, help_of(command));
}

/// "--am: 1 required MM/S2 missing" -> "--am needs a value"
std::string without_value(const std::string& what) { return what.substr(0, what.find(':')) + " needs a value"; }

}  // namespace

Error explain_usage(const CLI::App& app, const CLI::ParseError& error) {
  const auto extras = app.remaining(true);
  const bool required = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if ((required || dynamic_cast<const CLI::ExtrasError*>(&error)) && !extras.empty()) {
    return unexpected(app, extras.front());
  }
  const CLI::App& command = running(app);
  if (required && &command == &app) return usage_error("command-missing", "there is no command", help_of(app));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) return mismatch(command, without_value(error.what()));
  return usage_error("usage", error.what(), help_of(command));
}

}  // namespace toolpace::cli
