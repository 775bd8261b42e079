#pragma once
/// The flags of every command that reads a program.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "command_line.h"
#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"

namespace toolpace::cli {

struct ReadingFlags {
  std::string program;
  std::string dialect = "auto", integers = "auto", orientation;
  bool strict = false;
  bool block_delete = false;
  std::string tools, parameters;
  std::vector<std::string> sub_paths, work_offsets;
  std::optional<double> arc_tolerance;  ///< [mm]
  ReadLimits limits = {};
  bool about_tip = false;
  Kinematics kinematics = {};  ///< not a flag: see on()
  RotaryTravel travel = RotaryTravel::unbounded();

  /// Adds PROGRAM and the reading flags to a command.
  void add_to(Command& command);
  /// The same for a command that runs over many programs, too: see Command::programs().
  void add_to(Command& command, std::vector<SeriesColumn> columns, bool fills_cores = false);
  /// Adds the reading flags alone.
  void add_options_to(Command& command);

  /// The same flags on a machine, whose rotary axes carry what programs about the tool's tip tell.
  ReadingFlags on(const Setup& setup) const;

  /// @pre the flags have been checked
  ReadOptions options() const;

  /// Reads the program and prints its diagnostics to stderr. A sub-program that it called and that the command would
  /// write over is a Failure.
  tl::expected<Reading, Failure> read() const;
  /// The same of a text that was read from it already.
  tl::expected<Reading, Failure> read(std::string_view text) const;

  /// The same, for commands that make nothing of a program with errors: it is a Failure.
  tl::expected<Reading, Failure> read_accepted() const;
  /// The same of a text that was read from it already.
  tl::expected<Reading, Failure> read_accepted(std::string_view text) const;

 private:
  tl::expected<void, Failure> check() const;
  tl::expected<Reading, Failure> accepted(tl::expected<Reading, Failure> reading) const;
  tl::expected<Reading, Failure> told(Result<Reading> reading) const;

  const FileUse* files_ = nullptr;
};

}  // namespace toolpace::cli
