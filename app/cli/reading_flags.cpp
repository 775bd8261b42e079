#include "reading_flags.h"

#include <map>

#include "interrupt.h"
#include "report.h"

namespace toolpace::cli {
namespace {

const std::map<std::string, Dialect> kDialects = {
    {"auto", Dialect::automatic}, {"linuxcnc", Dialect::linuxcnc}, {"fanuc", Dialect::fanuc}, {"grbl", Dialect::grbl}};

}  // namespace

void ReadingFlags::add_to(CLI::App& command) {
  command
      .add_option("PROGRAM", program, "NC program (.ngc, .nc, .tap, .gcode …) or polyline (.csv); - = standard input")
      ->required();
  add_options_to(command);
}

void ReadingFlags::add_options_to(CLI::App& command) {
  command.add_option("--dialect", dialect, "auto, linuxcnc, fanuc or grbl")
      ->check(CLI::IsMember({"auto", "linuxcnc", "fanuc", "grbl"}));
  command.add_flag("--strict", strict, "Treat every warning as an error");
  command.add_flag("--block-delete", block_delete, "Skip lines that start with '/'");
  command.add_option("--tools", tools, "Tool table");
  command.add_option("--parameters", parameters, "File of numbered parameters");
  command.add_option("--sub-path", sub_paths, "Folder with sub-programs; may be given more than once")
      ->check(CLI::ExistingDirectory);
  command.add_option("--max-blocks", limits.blocks, "Most motion blocks, besides one a line")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_option("--max-lines", limits.lines, "Most lines that loops and calls run again")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_option("--max-loop-turns", limits.loop_turns, "Most turns of all loops together")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_option("--max-call-depth", limits.call_depth, "Most calls within each other")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

ReadOptions ReadingFlags::options() const {
  ReadOptions options;
  options.dialect = kDialects.at(dialect);
  options.strict = strict;
  options.block_delete = block_delete;
  options.tools = tools;
  options.parameters = parameters;
  options.limits = limits;
  options.sub_paths.assign(sub_paths.begin(), sub_paths.end());
  return options;
}

Result<Reading> ReadingFlags::read() const {
  auto reading = read_file(program, options(), terminal_monitor("reading"));
  end_progress();
  if (reading) report(reading->diagnostics);
  return reading;
}

}  // namespace toolpace::cli
