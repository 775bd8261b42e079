#include "toolpace/machine/settings_includes.h"

#include <fnmatch.h>

#include <algorithm>

#include "toolpace/machine/setup.h"

namespace toolpace {
namespace {

bool is_pattern(const std::string& name) { return name.find_first_of("*?[") != std::string::npos; }

std::vector<std::filesystem::path> files_that_fit(const std::filesystem::path& pattern) {
  std::vector<std::filesystem::path> files;
  std::error_code ignored;
  const std::filesystem::path folder = pattern.has_parent_path() ? pattern.parent_path() : ".";
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (!entry.is_regular_file(ignored)) continue;
    const std::filesystem::path name = entry.path().filename();
    if (::fnmatch(pattern.filename().c_str(), name.c_str(), FNM_PERIOD) == 0) files.push_back(folder / name);
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

ReadIncluded IncludedFiles::reader() {
  return [this](std::string_view name) { return read(name); };
}

std::vector<std::string> IncludedFiles::read(std::string_view name) {
  const std::filesystem::path path = folder_ / std::filesystem::path(std::string(name));
  // A pattern may fit nothing; a name that fits nothing is a mistake.
  const auto files =
      is_pattern(path.filename().string()) ? files_that_fit(path) : std::vector<std::filesystem::path>{path};
  std::vector<std::string> texts;
  for (const auto& file : files) {
    auto text = read_settings_text(file, monitor_);
    if (text) {
      texts.push_back(std::move(*text));
    } else if (!error_) {
      error_ = text.error();
    }
  }
  return texts;
}

}  // namespace toolpace
