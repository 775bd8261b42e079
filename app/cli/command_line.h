#pragma once
/// The grammar of the command line: commands, and the flags and arguments that each takes.
///
/// The parser behind it stays in command_line.cpp and usage_error.cpp: its header takes longer to compile than a command.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "failure.h"
#include "file_use.h"
#include "json.h"
#include "series.h"

namespace CLI {
class App;
}

namespace toolpace::cli {

using Action = std::function<Done()>;

/// One flag or argument, as help, shells and other languages have to know it.
struct FlagRow {
  std::string name;    ///< "--vmax"; an argument's has no dashes: "PROGRAM"
  std::string letter;  ///< "-o", or empty
  std::string unit;    ///< what --help shows for its value: "MM/S"; empty for toggles and arguments
  const char* kind;    ///< number, count, word, words, toggle, input, output, argument, arguments
  std::string title;   ///< under which --help lists it; empty = without
  std::string text;
  bool is_required;
};

/// What one command takes: its flags, and the files that they name.
struct Taken {
  std::vector<FlagRow> flags;
  FileUse files;
  std::optional<SeriesFlags> series;  ///< of a command that runs over many programs, too
  std::string* program = nullptr;     ///< what it is told where it is one
  const bool* json = nullptr;
};

enum class Need : bool { optional, required };

/// Flags of one command that stand under one title in its --help. Values are read to the last letter, never wrapped
/// round, cut short or empty. Each goes into `target`, which has to live as long as the command line; what that holds
/// before is the default.
///
/// @param flag  with the unit that --help shows for its value behind a blank: "--vmax MM/S"
/// @param text  what it is for, and its default
class Flags {
 public:
  /// @param title  empty = where flags stand without a title of their own
  explicit Flags(CLI::App& app, Taken& taken, std::string title = {})
      : app_(&app), taken_(&taken), title_(std::move(title)) {}

  /// A number, such as 3000, 1e6 or inf.
  void number(const std::string& flag, std::optional<double>& target, const std::string& text);
  void number(const std::string& flag, double& target, const std::string& text, Need need = Need::optional);

  /// A whole number from 0 to 1e15.
  void count(const std::string& flag, std::uint64_t& target, const std::string& text, Need need = Need::optional);

  /// A word. An empty one, as a script's unset variable leaves it, is refused.
  void word(const std::string& flag, std::string& target, const std::string& text, Need need = Need::optional);

  /// The name of a file that is read; "-" = standard input.
  /// @param what  the file as messages name it: "the machine file"
  void input(const std::string& flag, std::string& target, const std::string& what, const std::string& text,
             Need need = Need::optional);
  /// The name of a file that is written; "-" = standard output. It is none of those that the command reads.
  void output(const std::string& flag, std::string& target, const std::string& text);

  /// A word that may be given more than once.
  void words(const std::string& flag, std::vector<std::string>& target, const std::string& text);

  /// A flag without a value.
  void toggle(const std::string& flag, bool& target, const std::string& text);

 protected:
  /// Takes down a flag that a kind of its own adds.
  void note(const std::string& flag, const char* kind, const std::string& text, Need need);

  CLI::App* app_;
  Taken* taken_;

 private:
  using Take = std::function<bool(const std::string& text)>;
  void add(const std::string& flag, const char* kind, const std::string& text, const char* what, Need need, Take take);
  void add_word(const std::string& flag, const char* kind, std::string& target, const std::string& text, Need need);

  std::string title_;
};

/// What one command takes.
class Command : public Flags {
 public:
  using Flags::Flags;

  Flags titled(std::string title) const { return Flags(*app_, *taken_, std::move(title)); }

  /// The name of a file that is read, without a flag.
  /// @param what  the file as messages name it: "the program"
  void argument(const std::string& name, std::string& target, const std::string& what, const std::string& text,
                Need need = Need::required);

  /// PROGRAM, one or many, and the flags of a series (series.h): the command itself hears of one alone.
  /// @param columns      of the table of many
  /// @param fills_cores  whether the command for one program uses all cores
  void programs(std::string& target, const std::string& text, std::vector<SeriesColumn> columns,
                bool fills_cores = false);

  /// --json: standard output is one JSON object.
  void json(bool& target, const std::string& text);

  /// The files of all its flags, for as long as the command line lives.
  const FileUse& files() const { return taken_->files; }

  /// What --help says below the flags.
  void footer(const std::string& text);
};

/// All commands, and the one that a person typed.
class CommandLine {
 public:
  CommandLine();
  ~CommandLine();

  /// @param action  what the command does once its flags are read
  Command add(const std::string& name, const std::string& summary, Action action);

  /// The action of the command that was named. For --help and --version they are printed, and there is nothing left to
  /// do. Errors: usage: with the nearest thing that would have been right; outputs that are inputs (FileUse).
  Result<Action> parse(int argc, const char* const* argv);

  /// All that can be typed: {"version", "summary", "footer", "commands": [{"name", "summary", "footer", "flags": [{"name",
  /// "letter", "unit", "kind", "title", "text", "required"}]}]}. From it come the completion of shells, the manual's pages and
  /// the functions of the Python module.
  Json grammar() const;

 private:
  struct Entry {
    std::string name, summary;
    Action action;
    Taken taken;
    const CLI::App* app;
  };
  std::unique_ptr<CLI::App> app_;
  std::vector<std::unique_ptr<Entry>> entries_;
  Result<Action> chosen_action() const;
  static std::vector<GivenFlag> given_flags(const Entry& entry);

  Entry* chosen_ = nullptr;
};

}  // namespace toolpace::cli
