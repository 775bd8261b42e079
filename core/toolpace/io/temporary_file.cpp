#include "toolpace/io/temporary_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <string>
#include <string_view>

#include "toolpace/base/file_error.h"
#include "toolpace/base/file_identity.h"

namespace toolpace {
namespace {

namespace fs = std::filesystem;

constexpr int kMostAttempts = 1000;      // names to try
constexpr std::size_t kNameBytes = 180;  // of the target's name kept in the temporary's, below NAME_MAX
constexpr std::string_view kMark = ".toolpace-";
constexpr std::string_view kEnding = ".tmp";

/// ".out.csv.toolpace-4711-0.tmp"
std::string temporary_name(const fs::path& target, int attempt) {
  std::string name = std::string(1, '.').append(target.filename().string(), 0, kNameBytes).append(kMark);
  return name + std::to_string(::getpid()) + "-" + std::to_string(attempt) + std::string(kEnding);
}

bool is_number(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_temporary_name(std::string_view name) {
  const std::size_t mark = name.rfind(kMark);
  if (name.front() != '.' || mark == std::string_view::npos || mark == 0 || !name.ends_with(kEnding)) return false;
  const std::size_t begin = mark + kMark.size();
  if (begin + kEnding.size() > name.size()) return false;
  const std::string_view numbers = name.substr(begin, name.size() - kEnding.size() - begin);
  const std::size_t dash = numbers.find('-');
  return dash != std::string_view::npos && is_number(numbers.substr(0, dash)) && is_number(numbers.substr(dash + 1));
}

/// Whether the path still leads to the open file.
bool leads_to(const fs::path& file, int descriptor) {
  const auto named = identity_of(file);
  return named && named == identity_of(descriptor);
}

/// Removes the file if nobody holds it.
void sweep(const fs::path& file) {
  const int value = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (value < 0) return;
  const Descriptor descriptor = Descriptor::owned(value);
  if (::flock(value, LOCK_EX | LOCK_NB) == 0 && leads_to(file, value)) ::unlink(file.c_str());
}

/// By the system's calls: the standard library's iterator ends the program where there is no memory.
void sweep_folder(const fs::path& folder) {
  const std::unique_ptr<DIR, int (*)(DIR*)> listing(::opendir(folder.c_str()), &::closedir);
  if (!listing) return;
  while (const dirent* const entry = ::readdir(listing.get())) {
    if (is_temporary_name(entry->d_name)) sweep(folder / entry->d_name);
  }
}

}  // namespace

Result<TemporaryFile> TemporaryFile::create_beside(const fs::path& target) {
  const fs::path folder = folder_of(target);
  sweep_folder(folder);
  int number = EEXIST;
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    TemporaryFile file{folder / temporary_name(target, attempt), {}};
    const int value = ::open(file.name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    number = errno;
    if (value < 0) {
      if (number == EEXIST || number == EINTR) continue;
      break;
    }
    file.descriptor = Descriptor::owned(value);
    // Where nothing can be locked nothing is swept either. Another process may have swept it before it was locked.
    while (::flock(value, LOCK_EX) != 0 && errno == EINTR) {
    }
    if (leads_to(file.name, value)) return file;
    number = EEXIST;
  }
  return tl::unexpected(file_error(number, target, "write"));
}

}  // namespace toolpace
