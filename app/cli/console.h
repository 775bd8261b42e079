#pragma once
/// Who hears what a command says, and who may stop it: the terminal, or a program that runs commands within itself.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "failure.h"
#include "json.h"
#include "toolpace/base/monitor.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/sample/pulse_table.h"

namespace toolpace::cli {

/// Takes the place of the terminal in one thread, see run_words(). Called on that thread alone.
class Console {
 public:
  virtual ~Console() = default;

  /// What people are told besides the result: warnings, line by line.
  virtual void tell(std::string_view text) = 0;
  /// The JSON object of the command.
  virtual void answer(const Json& json) = 0;
  /// Hears of progress, and stops the command. @param what  such as "planning"
  virtual Monitor monitor(const char* what) = 0;

  /// A program that was read, refused or not.
  virtual void has_read(const Reading& reading) { static_cast<void>(reading); }

  /// The plan from which to plan again, or null: a program that was read from the same file is not read once more.
  virtual const Outcome* before() const = 0;
  /// What was planned, as a value, and whose tip its setpoints tell (--tip); and the pulses that were made.
  virtual void planned(Outcome outcome, const std::optional<Chain>& tip_of) = 0;
  virtual void pulsed(const PulseTable& table) = 0;
};

/// The console of this thread; null = the terminal.
Console* console();

/// Runs a command as the command line would, with `console` in the place of the terminal. Throws nothing.
/// @param words  the command, its flags and arguments, as typed behind "toolpace"
Done run_words(const std::vector<std::string>& words, Console& console);

}  // namespace toolpace::cli
