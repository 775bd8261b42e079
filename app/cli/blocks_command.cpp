/// toolpace blocks: what the interpreter understood of a program.

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "commands.h"
#include "reading_flags.h"
#include "report.h"
#include "toolpace/io/block_writer.h"

namespace toolpace::cli {
namespace {

struct BlocksFlags {
  ReadingFlags reading;
  std::string csv;
  bool json = false;
};

const char* dialect_text(Dialect dialect) {
  switch (dialect) {
    case Dialect::fanuc: return "fanuc";
    case Dialect::grbl: return "grbl";
    case Dialect::linuxcnc:
    case Dialect::automatic: break;
  }
  return "linuxcnc";
}

const char* severity_text(Severity severity) {
  switch (severity) {
    case Severity::note: return "note";
    case Severity::warning: return "warning";
    case Severity::error: break;
  }
  return "error";
}

nlohmann::ordered_json to_json(const BlocksFlags& flags, const Reading& reading) {
  nlohmann::ordered_json diagnostics = nlohmann::ordered_json::array();
  for (const auto& d : reading.diagnostics) {
    diagnostics.push_back({{"severity", severity_text(d.severity)},
                           {"code", d.code},
                           {"file", d.where.file},
                           {"line", d.where.line},
                           {"column", d.where.column},
                           {"message", d.message},
                           {"excerpt", d.excerpt},
                           {"remedy", d.remedy}});
  }
  std::size_t motion = 0;
  for (const MoveKind kind : reading.moves.kind) motion += is_motion(kind) ? 1 : 0;
  return {{"program", flags.reading.program},
          {"dialect", dialect_text(reading.dialect)},
          {"refused", reading.refused},
          {"rows", reading.moves.size()},
          {"motion_blocks", motion},
          {"csv", flags.csv.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(flags.csv)},
          {"diagnostics", std::move(diagnostics)}};
}

int run_blocks(const BlocksFlags& flags) {
  const auto reading = flags.reading.read();
  if (!reading) return report(reading.error());
  const std::string target = flags.csv.empty() && !flags.json ? "-" : flags.csv;
  if (!target.empty()) {
    if (const auto written = write_blocks(target, *reading); !written) return report(written.error());
  }
  if (flags.json) {
    // Comments may hold any bytes; JSON is UTF-8.
    const auto text = to_json(flags, *reading).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    std::printf("%s\n", text.c_str());
  }
  return reading->refused ? kBadInput : kFine;
}

}  // namespace

void add_blocks_command(CLI::App& app, Action& action) {
  auto flags = std::make_shared<BlocksFlags>();
  CLI::App& command = *app.add_subcommand("blocks", "Writes what was understood of a program, one motion block a row.");
  flags->reading.add_to(command);
  command.add_option("--csv", flags->csv, "table to write; - = standard output, also without --csv and --json");
  command.add_flag("--json", flags->json, "print counts and diagnostics as JSON");
  command.callback([flags, &action] { action = [flags] { return run_blocks(*flags); }; });
}

}  // namespace toolpace::cli
