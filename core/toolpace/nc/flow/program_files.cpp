#include "toolpace/nc/flow/program_files.h"

#include <algorithm>
#include <fstream>
#include <system_error>

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
    for (const char* ending : {"", ".nc", ".ngc", ".tap", ".txt", ".NC"}) names.push_back(stem + ending);
  }
  return names;
}

// True if `file`, links resolved, still lies in `folder`.
bool lies_within(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path real_file = fs::weakly_canonical(file, error);
  if (error) return false;
  const fs::path real_folder = fs::weakly_canonical(folder, error);
  return !error && real_file.parent_path() == real_folder;
}

}  // namespace

ProgramFiles::ProgramFiles(std::string_view text, std::string name, std::vector<fs::path> folders)
    : folders_(std::move(folders)) {
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

std::optional<std::size_t> ProgramFiles::find(const std::string& label, bool fanuc) {
  if (const auto known = known_.find(label); known != known_.end()) return known->second;
  std::optional<std::size_t> found;
  if (is_plain_name(label) && files_.size() < kMostFiles) {
    for (const auto& folder : folders_) {
      for (const auto& name : file_names(label, fanuc)) {
        if (!found) found = open(folder, name);
      }
    }
  }
  known_.emplace(label, found);
  return found;
}

std::optional<std::size_t> ProgramFiles::open(const fs::path& folder, const std::string& name) {
  const fs::path path = folder / name;
  std::error_code error;
  if (!fs::is_regular_file(path, error) || error || !lies_within(path, folder)) return std::nullopt;
  const auto size = fs::file_size(path, error);
  if (error || size > kLargestSubProgram) return std::nullopt;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  auto file = std::make_unique<ProgramText>();
  file->name = path.string();
  file->storage.resize(static_cast<std::size_t>(size));
  stream.read(file->storage.data(), static_cast<std::streamsize>(size));
  file->storage.resize(static_cast<std::size_t>(stream.gcount()));
  file->text = file->storage;
  files_.push_back(std::move(file));
  return files_.size() - 1;
}

}  // namespace toolpace::nc
