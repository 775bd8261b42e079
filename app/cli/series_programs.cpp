#include "series_programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <unordered_set>

#include "interrupt.h"
#include "toolpace/base/file_error.h"
#include "toolpace/base/file_name.h"
#include "toolpace/base/input_file.h"

namespace toolpace::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 13> kEndings = {".ngc", ".nc",  ".tap", ".gcode", ".gco", ".g",  ".cnc",
                                                       ".mpf", ".ncc", ".iso", ".din",   ".eia", ".min"};

bool is_folder(const std::string& name) {
  std::error_code none;
  return fs::is_directory(name, none);
}

Result<std::vector<std::string>> programs_in(const std::string& folder) {
  std::vector<std::string> found;
  std::error_code trouble;
  for (fs::directory_iterator at(folder, trouble), end; !trouble && at != end; at.increment(trouble)) {
    const std::string ending = extension_of(at->path());
    const bool is_program = std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
    std::error_code none;
    if (is_program && at->is_regular_file(none)) found.push_back(at->path().string());
  }
  if (trouble) return tl::unexpected(file_error(trouble.value(), folder, "read"));
  std::sort(found.begin(), found.end());
  return found;
}

/// A line each; those that are empty or begin with # count for nothing.
Result<std::vector<std::string>> programs_listed(const std::string& list) {
  const auto content = read_whole_file(list, terminal_monitor("reading"));
  if (!content) return tl::unexpected(content.error());
  std::vector<std::string> found;
  const std::string_view text = content->bytes();
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (!line.empty() && line.front() != '#') found.emplace_back(line);
    at = end + 1;
  }
  return found;
}

}  // namespace

bool SeriesFlags::are_many() const {
  return names.size() != 1 || !list.empty() || !results.empty() || !csv.empty() || is_folder(names.front());
}

Result<std::vector<std::string>> programs_of(const SeriesFlags& flags) {
  std::vector<std::string> named = flags.names;
  if (!flags.list.empty()) {
    const auto listed = programs_listed(flags.list);
    if (!listed) return tl::unexpected(listed.error());
    named.insert(named.end(), listed->begin(), listed->end());
  }
  std::vector<std::string> programs;
  std::unordered_set<std::string> known;
  const auto take = [&](const std::string& program) {
    if (known.insert(fs::path(program).lexically_normal().string()).second) programs.push_back(program);
  };
  for (const std::string& name : named) {
    if (name == "-" || name.empty()) {
      return tl::unexpected(usage_error("series-stdin", "of several programs none can be standard input",
                                        "give names of files; --programs - reads names from it"));
    }
    if (!is_folder(name)) {
      take(name);
      continue;
    }
    const auto inside = programs_in(name);
    if (!inside) return tl::unexpected(inside.error());
    std::for_each(inside->begin(), inside->end(), take);
  }
  if (programs.empty()) {
    const std::string where = named.empty() ? flags.list : named.front();
    return tl::unexpected(Error{ErrorKind::io,
                                "series-empty",
                                fmt::format("{} names no program", where),
                                "of folders NC programs are taken by their endings (.ngc, .nc, .tap …), not those of "
                                "folders within; --programs takes any list",
                                {where, 0, 0},
                                {}});
  }
  return programs;
}

std::string filled(const std::string& pattern, const std::string& program) {
  std::string name = pattern;
  const std::string stem = fs::path(program).stem().string();
  for (std::size_t at = name.find("{}"); at != std::string::npos; at = name.find("{}", at + stem.size()))
    name.replace(at, 2, stem);
  return name;
}

Result<void> check_series_outputs(const Series& series, const std::vector<std::string>& programs) {
  std::vector<FileRole> inputs = series.inputs, outputs;
  if (!series.flags.list.empty()) inputs.push_back({"the list of programs", series.flags.list});
  for (const std::string& program : programs) inputs.push_back({"the program " + program, program});
  for (const GivenFlag& flag : series.given) {
    if (!flag.is_output) continue;
    if (programs.size() > 1 && flag.value.find("{}") == std::string::npos) {
      return tl::unexpected(usage_error("series-output", flag.name + " names one file for several programs",
                                        "put {} where the name of each program is to stand: " + flag.name + " 'out/{}" +
                                            fs::path(flag.value).extension().string() + "'"));
    }
    for (const std::string& program : programs)
      outputs.push_back({flag.name + " of " + program, filled(flag.value, program)});
  }
  if (!series.flags.results.empty()) outputs.push_back({"--results", series.flags.results});
  if (!series.flags.csv.empty()) outputs.push_back({"--csv", series.flags.csv});
  return check_outputs(outputs, inputs);
}

}  // namespace toolpace::cli
