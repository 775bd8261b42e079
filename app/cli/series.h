#pragma once
/// A command over many programs: once for each, side by side, as one table.
///
/// A command joins in with a line (Command::programs()) that names its columns: what stands in them is looked up in the JSON that it
/// prints for one program. What it does for one is not told again here: it runs through run_words(), as it was typed.

#include <cstdint>
#include <string>
#include <vector>

#include "failure.h"
#include "toolpace/io/output_guard.h"

namespace toolpace::cli {

enum class CellKind : std::uint8_t { number, text, count };  ///< count: how many a list has

/// A column of the table.
struct SeriesColumn {
  const char* name;   ///< in .csv and JSON: "cycle_time_s"
  const char* title;  ///< above the table for people: "cycle time s"
  std::vector<const char*>
      paths;  ///< where it stands in the command's JSON ("best.contour_um"): the first that is there
  CellKind kind = CellKind::number;
  int decimals = 3;  ///< of a number, for people
  bool is_summed = false;
};

/// Programs as they were typed, and the flags of a series.
struct SeriesFlags {
  std::vector<std::string> names;  ///< files and folders
  std::string list, results, csv;
  std::uint64_t jobs = 0;  ///< 0 = as many as the command likes best
  std::vector<SeriesColumn> columns;
  bool fills_cores =
      false;  ///< the command alone does: its programs are run one after the other, unless --jobs says otherwise

  /// Whether it takes more than the command itself to do what was typed.
  bool are_many() const;
};

/// A flag that was given besides those of the series.
struct GivenFlag {
  std::string name;                          ///< "--am"
  std::string value;                         ///< empty for a toggle
  bool is_input = false, is_output = false;  ///< whether it names a file
};

struct Series {
  std::string command;
  const SeriesFlags& flags;
  std::vector<GivenFlag> given;
  std::vector<FileRole> inputs;  ///< files besides the programs that all of them are run with
  bool json = false;
};

/// Runs it. What is told of a program goes to stderr when it is done. The exit code is the largest of its rows.
/// Errors: usage (no programs, outputs that are one file, a results file of other columns), and what is wrong with flags and files
/// that all programs share; io; cancelled: the results file then keeps what is done.
Done run_series(const Series& series);

}  // namespace toolpace::cli
