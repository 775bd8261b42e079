#include "toolpace/base/file_identity.h"

#include <sys/stat.h>

#include <cerrno>

namespace toolpace {
namespace {

namespace fs = std::filesystem;

FileIdentity numbers_of(const struct stat& info, std::string name = {}) {
  return {static_cast<std::uint64_t>(info.st_dev), static_cast<std::uint64_t>(info.st_ino), std::move(name)};
}

std::optional<FileIdentity> identity_of(const struct stat& info) {
  if (S_ISREG(info.st_mode) || S_ISBLK(info.st_mode)) return numbers_of(info);
  return {};
}

}  // namespace

std::optional<FileIdentity> identity_of(const fs::path& file) {
  struct stat info {};
  if (::stat(file.c_str(), &info) == 0) return identity_of(info);
  if (errno != ENOENT) return {};
  const fs::path target = follow_links(file);
  if (::stat(folder_of(target).c_str(), &info) != 0) return {};
  return numbers_of(info, target.filename().string());
}

std::optional<FileIdentity> identity_of(int descriptor) {
  struct stat info {};
  if (::fstat(descriptor, &info) != 0) return {};
  return identity_of(info);
}

fs::path follow_links(fs::path file) {
  std::error_code ec;
  for (int i = 0; i < kMostLinks; ++i) {
    const fs::path next = fs::read_symlink(file, ec);
    if (ec) break;
    file = next.is_absolute() ? next : file.parent_path() / next;
  }
  return file;
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

}  // namespace toolpace
