#include "toolpace/io/spool_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <utility>

#include "toolpace/base/descriptor.h"
#include "toolpace/base/file_error.h"
#include "toolpace/io/output_file.h"

namespace toolpace {
namespace {}  // namespace

Result<SpoolFile> SpoolFile::create_anywhere() {
  std::error_code trouble;
  const auto folder = std::filesystem::temp_directory_path(trouble);
  if (!trouble) return create(folder);
  const char* const named = std::getenv("TMPDIR");
  return tl::unexpected(
      file_error(trouble.value(), named != nullptr ? named : "/tmp", "create a temporary file in TMPDIR,"));
}

Result<SpoolFile> SpoolFile::create(const std::filesystem::path& directory) {
  SpoolFile spool(directory.empty() ? std::filesystem::path(".") : directory);
  std::string name;
  do {
    name = (spool.directory_ / ".toolpace-spool-XXXXXX").string();
    spool.descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
  } while (spool.descriptor_ < 0 && errno == EINTR);
  if (spool.descriptor_ < 0) return tl::unexpected(file_error(errno, spool.directory_, "create a temporary file for"));
  ::unlink(name.c_str());
  return spool;
}

SpoolFile::SpoolFile(SpoolFile&& other) noexcept
    : directory_(std::move(other.directory_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_),
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
  if (const int e = write_fully_at(descriptor_, bytes, offset, {})) {
    return tl::unexpected(file_error(e, directory_, "write a temporary file beside"));
  }
  return {};
}

Result<void> SpoolFile::flush() {
  const int e = write_fully(descriptor_, buffer_, {});
  size_ += buffer_.size();
  buffer_.clear();
  if (e) return tl::unexpected(file_error(e, directory_, "write a temporary file beside"));
  return {};
}

Result<std::size_t> SpoolFile::read(std::uint64_t offset, char* out, std::size_t count) {
  if (auto done = flush(); !done) return tl::unexpected(std::move(done.error()));
  for (;;) {
    const ssize_t n = ::pread(descriptor_, out, count, static_cast<off_t>(offset));
    if (n >= 0) return static_cast<std::size_t>(n);
    if (errno != EINTR) return tl::unexpected(file_error(errno, directory_, "read a temporary file beside"));
  }
}

Result<void> SpoolFile::replay(const std::function<Result<void>(std::string_view)>& sink) {
  std::string piece(kBufferBytes, '\0');
  for (std::uint64_t offset = 0;;) {
    const auto n = read(offset, piece.data(), piece.size());
    if (!n) return tl::unexpected(n.error());
    if (*n == 0) return {};
    offset += *n;
    if (auto done = sink(std::string_view(piece).substr(0, *n)); !done) return done;
  }
}

}  // namespace toolpace
