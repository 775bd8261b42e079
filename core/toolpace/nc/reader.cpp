#include "toolpace/nc/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "toolpace/base/file_name.h"
#include "toolpace/base/input_file.h"
#include "toolpace/base/part_monitor.h"
#include "toolpace/nc/coordinates.h"
#include "toolpace/nc/dialects/detect.h"
#include "toolpace/nc/dialects/foreign.h"
#include "toolpace/nc/dialects/integers.h"
#include "toolpace/nc/interpreter.h"
#include "toolpace/nc/parameter_file.h"
#include "toolpace/nc/polyline.h"
#include "toolpace/nc/tool_table.h"
#include "toolpace/nc/tool_tip.h"

namespace toolpace {
namespace {

constexpr std::size_t kBinaryCheck = std::size_t{64} * 1024;
constexpr double kShareOfTheDisk = 0.1;  // of the time that reading takes, where a file is in the system's cache
constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

Error input_error(const std::string& name, const char* code, std::string what, std::string remedy) {
  return {ErrorKind::input, code, std::move(what), std::move(remedy), {name, 0, 0}, {}};
}

bool is_polyline(const std::string& name) { return extension_of(name) == ".csv"; }

/// Standard input has no extension; what begins with the title of a polyline's column is one. No NC line has an underscore
/// in its second place.
bool begins_with_column(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return false;
  const std::string_view title = text.substr(first, text.find_first_of(" \t\r\n,;", first) - first);
  static constexpr std::string_view kTitles[] = {"x_mm", "y_mm", "z_mm", "a_deg", "b_deg", "c_deg", "feed_mm_min"};
  return std::find(std::begin(kTitles), std::end(kTitles), title) != std::end(kTitles);
}

std::size_t count_lines(std::string_view text) {
  std::size_t count = 1;
  for (const char* p = text.data();
       (p = static_cast<const char*>(std::memchr(p, '\n', static_cast<std::size_t>(text.data() + text.size() - p)))) !=
       nullptr;
       ++p) {
    ++count;
  }
  return count;
}

void reserve(Moves& moves, std::size_t rows) {
  moves.kind.reserve(rows);
  moves.line.reserve(rows);
  moves.file.reserve(rows);
  moves.mode.reserve(rows);
  moves.detail.reserve(rows);
  moves.end.reserve(rows);
  moves.feed.reserve(rows);
}

// Reads a file that goes with the program (tools, parameters); its faults join the program's.
template <class ReadContent>
Result<void> read_beside(const std::filesystem::path& path, nc::Interpreter& interpreter, const Monitor& monitor,
                         ReadContent read_content) {
  if (path.empty()) return {};
  const auto file = read_whole_file(path, {monitor.stop, {}});
  if (!file) return tl::unexpected(file.error());
  read_content(file->bytes(), [&](std::size_t line, nc::Fault fault) {
    interpreter.log().add(std::move(fault), path.string(), line, {});
  });
  return {};
}

std::vector<std::filesystem::path> program_folders(const std::string& name, const ReadOptions& options) {
  std::vector<std::filesystem::path> folders;
  if (!name.empty() && name != "-") {
    const auto parent = std::filesystem::path(name).parent_path();
    folders.push_back(parent.empty() ? std::filesystem::path(".") : parent);
  }
  folders.insert(folders.end(), options.sub_paths.begin(), options.sub_paths.end());
  return folders;
}

nc::Fault uncertain_dialect(const nc::DialectGuess& guess) {
  return {
      "dialect-uncertain",
      fmt::format("this is read as a program of the dialect {}; it may be one of {}", dialect_name(guess.dialect),
                  dialect_name(guess.other)),
      fmt::format("choose with --dialect {} or --dialect {}", dialect_name(guess.dialect), dialect_name(guess.other)),
      0, Severity::warning};
}

/// Whether a program for another controller is about the tool's tip.
bool is_about_tip(std::string_view text) {
  constexpr std::string_view kWords[] = {"TRAORI", "M128", "TCPM"};
  return std::any_of(std::begin(kWords), std::end(kWords),
                     [&](std::string_view word) { return text.find(word) != std::string_view::npos; });
}

Error foreign_error(const std::string& name, std::string_view text, const nc::ForeignLanguage& language) {
  const char* const remedy =
      is_about_tip(text)
          ? "post the program as G-code with G43.4 H or G43.5 H (Fanuc), or with the tool's tip in X Y Z "
            "throughout, which --tcp reads"
          : "post the program as G-code (RS-274) for LinuxCNC, Fanuc, Haas, Mach3, grbl or Marlin; "
            "polylines are read as CSV";
  Error error =
      input_error(name, "language-unsupported", fmt::format("this is {}, and no G-code", language.name), remedy);
  error.where.line = language.line;
  error.where.column = language.column;
  return error;
}

// Controllers differ in what a coordinate without a point is: the reading that the text suggests, and a warning.
std::optional<nc::Fault> choose_integers(std::string_view text, const nc::DialectRules& rules, ReadOptions& options,
                                         std::size_t& line) {
  if (!rules.integers_may_count || options.integers != IntegerWords::automatic) return std::nullopt;
  const nc::IntegerUse use = nc::look_at_integers(text);
  options.integers = use.are_increments ? IntegerWords::increments : IntegerWords::lengths;
  line = use.line;
  if (line == 0) return std::nullopt;
  if (use.are_increments) {
    return nc::Fault{
        "integers-are-increments",
        "coordinates without a decimal point are read in least increments, X1000 as 1 mm; controllers with "
        "calculator-type input read lengths",
        "write decimal points; --integers lengths reads them as lengths", 0, Severity::warning};
  }
  return nc::Fault{
      "integers-are-lengths",
      "coordinates without a decimal point are read as lengths; controllers set to least increments move a "
      "thousandth of them",
      "write decimal points; --integers increments reads them so", 0, Severity::warning};
}

Result<Reading> read_program(std::string_view text, const std::string& name, const ReadOptions& given,
                             const Monitor& monitor) {
  ReadOptions options = given;
  if (options.dialect == Dialect::automatic) {
    if (const auto language = nc::find_foreign_language(text))
      return tl::unexpected(foreign_error(name, text, *language));
  }
  Reading reading;
  nc::DialectGuess guess{options.dialect, {}};
  if (options.dialect == Dialect::automatic) guess = nc::detect_dialect(text, name);
  reading.dialect = guess.dialect;
  reading.dialect_reasons = guess.reasons;
  const nc::DialectRules& rules = guess.marked ? nc::rules_of(reading.dialect) : nc::rules_of_unmarked_text();
  reading.moves.files = {name};
  const std::size_t lines = count_lines(text);
  reserve(reading.moves, lines);
  std::size_t integer_line = 0;
  auto integers = choose_integers(text, rules, options, integer_line);
  nc::ProgramFiles files(text, name, program_folders(name, options), monitor);
  nc::Interpreter interpreter(files, options, rules, options.limits.blocks + lines, reading);
  const auto tools =
      read_beside(options.tools, interpreter, monitor, [&](std::string_view content, const auto& on_fault) {
        nc::read_tool_table(content, interpreter.state(), on_fault);
      });
  if (!tools) return tl::unexpected(tools.error());
  const auto parameters =
      read_beside(options.parameters, interpreter, monitor, [&](std::string_view content, const auto& on_fault) {
        nc::read_parameter_file(content, interpreter.parameters(), on_fault);
        nc::adopt_parameters(interpreter.context());
      });
  if (!parameters) return tl::unexpected(parameters.error());
  if (!options.work_offsets.empty()) {
    nc::set_work_offsets(interpreter.context(), options.work_offsets);
    nc::adopt_parameters(interpreter.context());
  }
  if (options.about_tip && !nc::begin_tip_everywhere(interpreter.context())) {
    // What else there is to say of the program is said, too.
    for (nc::Fault& fault : interpreter.context().faults.list()) interpreter.log().add(std::move(fault), name, 1, {});
    interpreter.context().faults.clear();
    interpreter.context().out.stop();
  }
  if (guess.other != Dialect::automatic) interpreter.log().add(uncertain_dialect(guess), name, 1, {});
  if (integers) interpreter.log().add(std::move(*integers), name, integer_line, {});
  if (!interpreter.run(monitor)) return tl::unexpected(cancelled_error());
  if (files.failure()) return tl::unexpected(*files.failure());
  return reading;
}

// Tapes begin and end with a length without holes.
std::string_view without_leaders(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of('\0'), text.size()));
  return text.substr(0, text.find_last_not_of('\0') + 1);
}

// Old Macintosh files end their lines with a return alone; columns stay what they are.
bool has_bare_returns(std::string_view text) {
  return text.substr(0, kBinaryCheck).find('\n') == std::string_view::npos &&
         text.substr(0, kBinaryCheck).find('\r') != std::string_view::npos && text.find('\n') == std::string_view::npos;
}

}  // namespace

Result<Reading> read_text(std::string_view text, const std::string& name, const ReadOptions& options,
                          const Monitor& monitor) {
  if (text.substr(0, kUtf8Mark.size()) == kUtf8Mark) text.remove_prefix(kUtf8Mark.size());
  text = without_leaders(text);
  if (has_bare_returns(text)) {
    std::string lines(text);
    std::replace(lines.begin(), lines.end(), '\r', '\n');
    return read_text(lines, name, options, monitor);
  }
  if (text.rfind("\xFF\xFE", 0) == 0 || text.rfind("\xFE\xFF", 0) == 0) {
    return tl::unexpected(input_error(name, "text-utf-16", "this text is UTF-16", "save it as UTF-8"));
  }
  if (std::memchr(text.data(), '\0', std::min(text.size(), kBinaryCheck)) != nullptr) {
    return tl::unexpected(input_error(name, "not-text", "this is no text file",
                                      "give an NC program or a CSV polyline, as UTF-8 or an 8-bit text"));
  }
  if (text.find_first_not_of(" \t\r\n\v\f") == std::string_view::npos) {
    return tl::unexpected(input_error(name, "empty-program", "the program is empty", "give a file with motion in it"));
  }
  if (!is_polyline(name) && !(name == "-" && begins_with_column(text)))
    return read_program(text, name, options, monitor);
  Reading reading;
  reading.moves.files = {name};
  reserve(reading.moves, count_lines(text));
  if (!nc::read_polyline(text, name, options, monitor, reading)) return tl::unexpected(cancelled_error());
  return reading;
}

Result<Reading> read_file(const std::filesystem::path& file, const ReadOptions& options, const Monitor& monitor) {
  const auto content = read_whole_file(file, part_of(monitor, 0, kShareOfTheDisk));
  if (!content) return tl::unexpected(content.error());
  return read_text(content->bytes(), file.string(), options, part_of(monitor, kShareOfTheDisk, 1));
}

}  // namespace toolpace
