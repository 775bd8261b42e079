/// toolpace blocks: what the interpreter understood of a program.

#include <memory>
#include <string>
#include "json.h"

#include "commands.h"
#include "interrupt.h"
#include "reading_flags.h"
#include "report.h"
#include "toolpace/io/block_writer.h"
#include "toolpace/machine/read_machine.h"

namespace toolpace::cli {
namespace {

struct BlocksFlags {
  ReadingFlags reading;
  std::string csv, machine;
  bool json = false;
};

Json blocks_json(const BlocksFlags& flags, const Reading& reading) {
  std::size_t motion = 0;
  for (const MoveKind kind : reading.moves.kind) motion += is_motion(kind) ? 1 : 0;
  return {{"program", flags.reading.program},
          {"dialect", std::string(dialect_name(reading.dialect))},
          {"dialect_reasons", reading.dialect_reasons},
          {"refused", reading.refused},
          {"rows", reading.moves.size()},
          {"motion_blocks", motion},
          {"csv", flags.csv.empty() ? Json() : Json(flags.csv)},
          {"diagnostics", to_json(reading.diagnostics)}};
}

Done run_blocks(const BlocksFlags& flags) {
  const std::string target = flags.csv.empty() && !flags.json ? "-" : flags.csv;
  Setup setup = default_setup();
  if (!flags.machine.empty()) {
    auto read = read_machine(flags.machine, terminal_monitor("reading"));
    end_progress();
    if (!read) return tl::unexpected(std::move(read.error()));
    setup = std::move(*read);
  }
  const auto reading = flags.reading.on(setup).read();
  if (!reading) return tl::unexpected(reading.error());
  if (!target.empty()) {
    if (const auto written = write_blocks(target, *reading, terminal_monitor("writing")); !written)
      return tl::unexpected(written.error());
  }
  if (flags.json) print_json(blocks_json(flags, *reading));
  return reading->refused ? kBadInput : kFine;
}

}  // namespace

void add_blocks_command(CommandLine& line) {
  auto flags = std::make_shared<BlocksFlags>();
  Command command = line.add("blocks", "Write what was understood of a program, one motion block a row",
                             [flags] { return run_blocks(*flags); });
  command.output("--csv FILE", flags->csv, "Table to write; - = standard output, also without --csv and --json");
  command.input("--machine FILE", flags->machine, "the machine file",
                "Machine file (TOML), whose [kinematics] programs about the tool's tip need");
  command.json(flags->json, "Print one JSON object: counts and diagnostics");
  flags->reading.add_to(command);
  command.footer(
      "Rows in machine coordinates, about the tool's tip in those of the workpiece, lengths in mm, angles in deg, "
      "feeds in mm/min. A program with errors is written up "
      "to\n"
      "the first one, then the error, and the exit code is 3.\n\n"
      "Examples:\n"
      "  toolpace blocks part.ngc\n"
      "  toolpace blocks part.nc --dialect fanuc --csv part.csv\n"
      "  toolpace blocks part.ngc --json");
}

}  // namespace toolpace::cli
