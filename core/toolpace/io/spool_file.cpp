#include "toolpace/io/spool_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <utility>

#include "toolpace/base/file_error.h"

namespace toolpace {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;

}  // namespace

int write_fully(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
    if (n > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(n));
    } else if (n < 0 && errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

int write_fully_at(int descriptor, std::string_view bytes, std::uint64_t offset) {
  while (!bytes.empty()) {
    const ssize_t n = ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (n > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(n));
      offset += static_cast<std::uint64_t>(n);
    } else if (n < 0 && errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

Result<SpoolFile> SpoolFile::create(const std::filesystem::path& directory) {
  SpoolFile spool(directory.empty() ? std::filesystem::path(".") : directory);
  std::string name = (spool.directory_ / ".toolpace-spool-XXXXXX").string();
  spool.descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (spool.descriptor_ < 0) return tl::unexpected(file_error(errno, spool.directory_, "create a temporary file for"));
  ::unlink(name.c_str());
  return spool;
}

SpoolFile::SpoolFile(SpoolFile&& other) noexcept
    : directory_(std::move(other.directory_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      buffer_(std::move(other.buffer_)) {}

SpoolFile::~SpoolFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<void> SpoolFile::write(std::string_view bytes) {
  buffer_.append(bytes);
  return buffer_.size() >= kBufferBytes ? flush() : Result<void>{};
}

Result<void> SpoolFile::overwrite(std::uint64_t offset, std::string_view bytes) {
  if (auto done = flush(); !done) return done;
  if (const int e = write_fully_at(descriptor_, bytes, offset))
    return tl::unexpected(file_error(e, directory_, "write"));
  return {};
}

Result<void> SpoolFile::flush() {
  const int e = write_fully(descriptor_, buffer_);
  buffer_.clear();
  if (e) return tl::unexpected(file_error(e, directory_, "write a temporary file beside"));
  return {};
}

Result<void> SpoolFile::replay(const std::function<Result<void>(std::string_view)>& sink) {
  if (auto done = flush(); !done) return done;
  std::string piece(kBufferBytes, '\0');
  for (off_t offset = 0;;) {
    const ssize_t n = ::pread(descriptor_, piece.data(), piece.size(), offset);
    if (n == 0) return {};
    if (n < 0) {
      if (errno == EINTR) continue;
      return tl::unexpected(file_error(errno, directory_, "read a temporary file beside"));
    }
    offset += n;
    if (auto done = sink(std::string_view(piece).substr(0, static_cast<std::size_t>(n))); !done) return done;
  }
}

}  // namespace toolpace
