#include "toolpace/nc/flow/program_files.h"

#include <algorithm>
#include <system_error>

#include "toolpace/base/file_identity.h"
#include "toolpace/base/file_name.h"
#include "toolpace/base/input_file.h"

namespace toolpace::nc {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestSubProgram = std::uintmax_t{256} << 20;
constexpr std::size_t kMostFiles = 1000;

// A label may only be the plain name of a file: no folders, nothing hidden.
bool is_plain_name(const std::string& label) {
  if (label.empty() || label.size() > 200 || label.front() == '.') return false;
  for (const char c : label) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '/' || c == '\\' || c == ':' || byte < 0x20) return false;
  }
  return true;
}

std::vector<std::string> file_names(const std::string& label, bool fanuc) {
  std::vector<std::string> names = {label + ".ngc"};
  if (!fanuc) {
    names.push_back(label + ".nc");
    return names;
  }
  std::string padded = label;
  while (padded.size() < 4) padded.insert(padded.begin(), '0');
  for (const std::string& stem : {"O" + padded, "o" + padded, "O" + label, "o" + label, label}) {
    for (const char* ending : {"", ".nc", ".ngc", ".tap", ".txt"}) names.push_back(stem + ending);
  }
  return names;
}

/// The name with its extension in small letters, by which names that differ in that alone are one.
std::string with_small_extension(const std::string& name) {
  const fs::path path(name);
  return path.stem().string() + extension_of(path);
}

bool is_there(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error);
}

}  // namespace

ProgramFiles::ProgramFiles(std::string_view text, std::string name, std::vector<fs::path> folders,
                           const Monitor& monitor)
    : folders_(std::move(folders)), monitor_{monitor.stop, {}} {
  files_.push_back(std::make_unique<ProgramText>());
  files_.front()->name = std::move(name);
  files_.front()->text = text;
}

std::size_t ProgramFiles::work() {
  std::size_t all = 0;
  for (const auto& file : files_) {
    if (!file->work) {
      const auto lines = static_cast<std::size_t>(std::count(file->text.begin(), file->text.end(), '\n')) + 1;
      file->work = lines + file->text.size() / kLengthOfALine;
    }
    all += *file->work;
  }
  return all;
}

const FoundFile& ProgramFiles::find(const std::string& label, bool fanuc) {
  const auto known = known_.find(label);
  return known != known_.end() ? known->second : known_.emplace(label, search(label, fanuc)).first->second;
}

/// The first file that can be taken; else the first one that cannot.
FoundFile ProgramFiles::search(const std::string& label, bool fanuc) {
  FoundFile refused;
  if (!is_plain_name(label)) return refused;
  const auto names = file_names(label, fanuc);
  for (const auto& folder : folders_) {
    const auto place = place_of(folder, names);
    if (!place) continue;
    FoundFile found = open(*place);
    if (found.index) return found;
    if (refused.trouble.empty()) refused = std::move(found);
  }
  return refused;
}

/// The names as they are, in order; failing them, with an extension in other letters.
std::optional<fs::path> ProgramFiles::place_of(const fs::path& folder, const std::vector<std::string>& names) {
  for (const auto& name : names) {
    if (is_there(folder / name)) return folder / name;
  }
  for (const auto& name : names) {
    const auto& others = names_in(folder);
    const auto other = others.find(name);
    if (other != others.end() && is_there(folder / other->second)) return folder / other->second;
  }
  return std::nullopt;
}

const ProgramFiles::NamesBySmall& ProgramFiles::names_in(const fs::path& folder) {
  const auto [at, is_new] = listings_.try_emplace(folder.string());
  if (!is_new) return at->second;
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    names.push_back(entry->path().filename().string());
  }
  std::sort(names.begin(), names.end());  // so that the same one is taken everywhere
  for (const auto& name : names) at->second.try_emplace(with_small_extension(name), name);
  return at->second;
}

/// Whether the file, links resolved, lies in one of the folders.
bool ProgramFiles::lies_within(const fs::path& file) const {
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(file, error).parent_path();
  if (error) return false;
  return std::any_of(folders_.begin(), folders_.end(), [&](const fs::path& allowed) {
    const fs::path real = fs::weakly_canonical(allowed, error);
    return !error && real == folder;
  });
}

FoundFile ProgramFiles::open(const fs::path& path) {
  if (!lies_within(path)) {
    return {{},
            "its file " + path.string() + " is a link that leads outside, to " + follow_links(path).string(),
            "put the file itself there, or give the folder it lies in with --sub-path"};
  }
  if (files_.size() >= kMostFiles) {
    return {{}, "the program calls more than " + std::to_string(kMostFiles) + " files", "call fewer files"};
  }
  std::error_code error;
  if (fs::file_size(path, error) > kLargestSubProgram && !error) {
    return {{}, "its file " + path.string() + " is larger than 256 MiB", "split it"};
  }
  auto content = read_whole_file(path, monitor_);
  if (!content) {
    if (!failure_) failure_ = content.error();
    return {{}, "its file cannot be read", ""};
  }
  auto file = std::make_unique<ProgramText>();
  file->name = path.string();
  file->storage = content->bytes();
  file->text = file->storage;
  files_.push_back(std::move(file));
  return {files_.size() - 1, {}, {}};
}

}  // namespace toolpace::nc
