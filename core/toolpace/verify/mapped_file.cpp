#include "toolpace/verify/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include "toolpace/base/file_error.h"

namespace toolpace {
namespace {

/// @return 0 or errno
int read_all(int descriptor, std::string& out) {
  std::array<char, 65536> piece;
  for (;;) {
    const ssize_t n = ::read(descriptor, piece.data(), piece.size());
    if (n == 0) return 0;
    if (n > 0) {
      out.append(piece.data(), static_cast<std::size_t>(n));
    } else if (errno != EINTR) {
      return errno;
    }
  }
}

}  // namespace

Result<MappedFile> MappedFile::open(const std::filesystem::path& file) {
  MappedFile mapped;
  const bool standard_input = file == "-";
  const int descriptor = standard_input ? STDIN_FILENO : ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return tl::unexpected(file_error(errno, file, "open"));
  struct stat info {};
  int trouble = ::fstat(descriptor, &info) == 0 ? 0 : errno;
  if (trouble == 0 && S_ISDIR(info.st_mode)) trouble = EISDIR;
  if (trouble == 0 && S_ISREG(info.st_mode) && info.st_size > 0) {
    mapped.size_ = static_cast<std::size_t>(info.st_size);
    void* const at = ::mmap(nullptr, mapped.size_, PROT_READ, MAP_PRIVATE, descriptor, 0);
    if (at != MAP_FAILED) {
      mapped.mapping_ = static_cast<char*>(at);
      ::madvise(at, mapped.size_, MADV_SEQUENTIAL);
    }
  }
  if (trouble == 0 && mapped.mapping_ == nullptr) trouble = read_all(descriptor, mapped.copy_);
  if (!standard_input) ::close(descriptor);
  if (trouble != 0) return tl::unexpected(file_error(trouble, file, "read"));
  return mapped;
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : mapping_(std::exchange(other.mapping_, nullptr)), size_(other.size_), copy_(std::move(other.copy_)) {}

void MappedFile::release_before(std::size_t offset) const {
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const std::size_t bytes = std::min(offset, size_) / page * page;
  if (mapping_ != nullptr && bytes > 0) ::madvise(mapping_, bytes, MADV_DONTNEED);
}

MappedFile::~MappedFile() {
  if (mapping_ != nullptr) ::munmap(mapping_, size_);
}

}  // namespace toolpace
