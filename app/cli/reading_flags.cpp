#include "reading_flags.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "console.h"
#include "interrupt.h"
#include "report.h"
#include "toolpace/base/file_error.h"
#include "toolpace/limits/travel.h"

namespace toolpace::cli {
namespace {

constexpr char kProgram[] = "NC program (.ngc, .nc, .tap, .gcode …) or polyline (.csv); - = either on standard input";
constexpr double kWidestArcTolerance = 1000.0;  // [mm]
constexpr double kFarthestOrigin = 1e9;         // [mm, deg]

std::string dialect_names() {
  std::string names;
  for (const Dialect dialect : all_dialects())
    names += (names.empty() ? "" : ", ") + std::string(dialect_name(dialect));
  return names;
}

std::optional<IntegerWords> integers_named(const std::string& name) {
  if (name == "auto") return IntegerWords::automatic;
  if (name == "lengths") return IntegerWords::lengths;
  if (name == "increments") return IntegerWords::increments;
  return std::nullopt;
}

// "G54=10,20,-5"
std::optional<WorkOffset> work_offset(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return std::nullopt;
  const auto system = work_system_named(std::string_view(text).substr(0, equals));
  if (!system) return std::nullopt;
  WorkOffset offset{*system, {}};
  const char* at = text.data() + equals + 1;
  const char* const end = text.data() + text.size();
  for (double& value : offset.origin) {
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc() || !(std::fabs(value) <= kFarthestOrigin)) return std::nullopt;
    at = read.ptr;
    if (at == end) return offset;
    if (*at++ != ',') return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

void ReadingFlags::add_to(Command& command) {
  command.argument("PROGRAM", program, "the program", kProgram);
  add_options_to(command);
}

void ReadingFlags::add_to(Command& command, std::vector<SeriesColumn> columns, bool fills_cores) {
  command.programs(program, std::string(kProgram) + ";\nseveral, or a folder of them: a table", std::move(columns),
                   fills_cores);
  add_options_to(command);
}

void ReadingFlags::add_options_to(Command& command) {
  files_ = &command.files();
  Flags flags = command.titled("Reading the program");
  flags.word("--dialect NAME", dialect, "One of " + dialect_names() + "; auto (default) finds it in the text");
  flags.number(
      "--arc-tolerance-mm T", arc_tolerance,
      "How far an arc may end off its radius; less is mended with a warning, more refused; default by dialect");
  flags.word(
      "--integers HOW", integers,
      "Coordinates without a point of Fanuc's kind: lengths, increments or auto (default), as the text suggests");
  flags.toggle("--tcp", about_tip,
               "X Y Z tell where the tool's tip is in the workpiece, all along; needs --machine with [kinematics]");
  flags.word("--orientation HOW", orientation,
             "Between blocks about the tip: axes = the rotary axes turn evenly (default), plane = the tool does, on a "
             "great circle; overrides [kinematics]");
  flags.toggle("--strict", strict, "Treat every warning as an error");
  flags.toggle("--block-delete", block_delete, "Skip lines that start with '/'");
  flags.input("--tools FILE", tools, "the tool table", "Tool table, as LinuxCNC writes it");
  flags.input("--parameters FILE", parameters, "the parameter file", "Numbered parameters, as LinuxCNC writes them");
  flags.words("--sub-path DIR", sub_paths, "Folder with sub-programs; may be given more than once");
  flags.words(
      "--work-offset G54=X,Y,Z", work_offsets,
      "Where a work coordinate system lies in the machine, mm and deg (A, B, C follow); may be given more than once");
  const auto add_bound = [&](const char* flag, std::uint64_t& target, const std::string& what) {
    flags.count(flag, target, what + "; default " + std::to_string(target));
  };
  add_bound("--max-blocks N", limits.blocks, "Most motion blocks, besides one a line");
  add_bound("--max-lines N", limits.lines, "Most lines that loops and calls run again");
  add_bound("--max-loop-turns N", limits.loop_turns, "Most turns of all loops together");
  add_bound("--max-call-depth N", limits.call_depth, "Most calls within each other");
}

ReadingFlags ReadingFlags::on(const Setup& setup) const {
  ReadingFlags flags = *this;
  flags.kinematics = setup.kinematics;
  if (const auto how = orientation_named(orientation)) flags.kinematics.chain.orientation = *how;
  flags.travel = rotary_travel(setup.machine);
  return flags;
}

ReadOptions ReadingFlags::options() const {
  ReadOptions options;
  options.kinematics = kinematics;
  options.travel = travel;
  options.about_tip = about_tip;
  options.dialect = dialect_named(dialect).value_or(Dialect::automatic);
  options.arc_tolerance = arc_tolerance;
  options.integers = integers_named(integers).value_or(IntegerWords::automatic);
  options.strict = strict;
  options.block_delete = block_delete;
  options.tools = tools;
  options.parameters = parameters;
  options.limits = limits;
  for (const std::string& text : work_offsets) options.work_offsets.push_back(work_offset(text).value_or(WorkOffset{}));
  options.sub_paths.assign(sub_paths.begin(), sub_paths.end());
  return options;
}

tl::expected<void, Failure> ReadingFlags::check() const {
  if (!dialect_named(dialect)) {
    return tl::unexpected<Failure>(
        usage_error("bad-flag", "--dialect does not know '" + dialect + "'", "give one of " + dialect_names()));
  }
  if (!integers_named(integers)) {
    return tl::unexpected<Failure>(usage_error("bad-flag", "--integers does not know '" + integers + "'",
                                               "give one of auto, lengths, increments"));
  }
  if (!orientation.empty() && !orientation_named(orientation)) {
    return tl::unexpected<Failure>(
        usage_error("bad-flag", "--orientation does not know '" + orientation + "'", "give axes or plane"));
  }
  if (arc_tolerance && !(*arc_tolerance >= 0.0 && *arc_tolerance <= kWidestArcTolerance)) {
    return tl::unexpected<Failure>(
        usage_error("bad-flag", "--arc-tolerance-mm is out of range", "give a number from 0 to 1000"));
  }
  for (const std::string& folder : sub_paths) {
    if (folder.empty()) {
      return tl::unexpected<Failure>(usage_error("bad-flag", "--sub-path is empty", "give the name of a folder"));
    }
    std::error_code trouble;
    if (!std::filesystem::is_directory(folder, trouble)) {
      return tl::unexpected<Failure>(file_error(trouble ? trouble.value() : ENOTDIR, folder, "search"));
    }
  }
  for (const std::string& text : work_offsets) {
    if (!work_offset(text)) {
      return tl::unexpected<Failure>(
          usage_error("bad-flag", "--work-offset does not understand '" + text + "'",
                      "give G54=X,Y,Z, such as G54=100,50,-20; also G55 to G59.3, G54.1P1 to G54.1P300"));
    }
  }
  return {};
}

tl::expected<Reading, Failure> ReadingFlags::read() const {
  if (auto checked = check(); !checked) return tl::unexpected(std::move(checked.error()));
  return told(read_file(program, options(), terminal_monitor("reading")));
}

tl::expected<Reading, Failure> ReadingFlags::read(std::string_view text) const {
  if (auto checked = check(); !checked) return tl::unexpected(std::move(checked.error()));
  return told(read_text(text, program, options(), terminal_monitor("reading")));
}

tl::expected<Reading, Failure> ReadingFlags::told(Result<Reading> reading) const {
  end_progress();
  if (!reading) return tl::unexpected<Failure>(std::move(reading.error()));
  const auto& texts = reading->moves.files;
  if (auto apart = files_->check({texts.begin() + 1, texts.end()}); !apart) {
    return tl::unexpected<Failure>(std::move(apart.error()));
  }
  report(reading->diagnostics);
  if (Console* other = console()) other->has_read(*reading);
  return std::move(*reading);
}

tl::expected<Reading, Failure> ReadingFlags::read_accepted() const { return accepted(read()); }

tl::expected<Reading, Failure> ReadingFlags::read_accepted(std::string_view text) const { return accepted(read(text)); }

tl::expected<Reading, Failure> ReadingFlags::accepted(tl::expected<Reading, Failure> reading) const {
  if (!reading || !reading->refused) return reading;
  Error refused{ErrorKind::input,     "program-refused", "the program has errors",
                "correct them first", {program, 0, 0},   {}};
  return tl::unexpected(Failure(std::move(refused), std::move(reading->diagnostics)));
}

}  // namespace toolpace::cli
