#include "toolpace/io/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

#include "toolpace/base/file_error.h"
#include "toolpace/base/file_identity.h"
#include "toolpace/io/temporary_file.h"

namespace toolpace {
namespace {

namespace fs = std::filesystem;

void sync_directory(const fs::path& directory) {
  const int d = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (d < 0) return;
  ::fsync(d);  // best effort: some file systems cannot, and the file itself is durable
  ::close(d);
}

}  // namespace

Error OutputFile::error(int number, std::string_view action) const { return file_error(number, target_, action); }

Result<OutputFile> OutputFile::create(const fs::path& target, Access access, const Monitor& monitor) {
  OutputFile file;
  file.target_ = target;
  file.stop_ = monitor.stop;
  struct stat info {};
  bool is_direct = target == "-" || named_descriptor(target);
  if (!is_direct && ::stat(target.c_str(), &info) == 0) {
    if (S_ISDIR(info.st_mode)) return tl::unexpected(file.error(EISDIR, "write"));
    // Links of /proc lead to files that have no name any more, too.
    is_direct = !S_ISREG(info.st_mode) || identity_of(follow_links(target)) != identity_of(target);
  } else if (!is_direct && errno != ENOENT) {
    return tl::unexpected(file.error(errno, "write"));
  }
  auto opened = is_direct ? file.open_direct(access) : file.open_beside(follow_links(target));
  if (!opened) return tl::unexpected(std::move(opened.error()));
  return file;
}

Result<void> OutputFile::open_direct(Access access) {
  auto opened = open_for_writing(target_, stop_);
  if (!opened) return tl::unexpected(std::move(opened.error()));
  descriptor_ = std::move(*opened);
  if (access == Access::forward) return {};
  auto spool = SpoolFile::create_anywhere();
  if (!spool) return tl::unexpected(std::move(spool.error()));
  spool_.emplace(std::move(*spool));
  return {};
}

Result<void> OutputFile::open_beside(const fs::path& real) {
  struct stat info {};
  const bool exists = ::stat(real.c_str(), &info) == 0;
  // A rename would replace a file that its owner made read-only.
  if (exists && ::access(real.c_str(), W_OK) != 0) return tl::unexpected(error(errno, "write"));
  auto file = TemporaryFile::create_beside(real);
  if (!file) {
    file.error().where.file = target_.string();
    return tl::unexpected(std::move(file.error()));
  }
  real_ = real;
  temporary_ = std::move(file->name);
  descriptor_ = std::move(file->descriptor);
  if (exists) ::fchmod(descriptor_.value(), info.st_mode & 07777);
  return {};
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : target_(std::move(other.target_)),
      real_(std::move(other.real_)),
      temporary_(std::exchange(other.temporary_, {})),
      spool_(std::move(other.spool_)),
      stop_(std::move(other.stop_)),
      descriptor_(std::move(other.descriptor_)),
      size_(other.size_),
      buffer_(std::move(other.buffer_)) {}

OutputFile::~OutputFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

Result<void> OutputFile::write(std::string_view bytes) {
  size_ += bytes.size();
  if (spool_) return spool_->write(bytes);
  if (bytes.size() < kBufferBytes) {
    buffer_.append(bytes);
    return buffer_.size() >= kBufferBytes ? flush() : Result<void>{};
  }
  if (auto done = flush(); !done) return done;
  if (const int e = write_fully(descriptor_.value(), bytes, stop_)) return tl::unexpected(error(e, "write"));
  return {};
}

Result<void> OutputFile::flush() {
  const int e = write_fully(descriptor_.value(), buffer_, stop_);
  buffer_.clear();
  if (e) return tl::unexpected(error(e, "write"));
  return {};
}

Result<void> OutputFile::overwrite(std::uint64_t offset, std::string_view bytes) {
  if (spool_) return spool_->overwrite(offset, bytes);
  if (auto done = flush(); !done) return done;
  const int e = write_fully_at(descriptor_.value(), bytes, offset, stop_);
  if (e) return tl::unexpected(error(e, "write"));
  return {};
}

Result<void> OutputFile::commit() {
  if (spool_) {
    auto sent = spool_->replay([this](std::string_view piece) -> Result<void> {
      if (const int e = write_fully(descriptor_.value(), piece, stop_)) return tl::unexpected(error(e, "write"));
      return {};
    });
    if (!sent) return sent;
  }
  if (auto done = flush(); !done) return done;
  if (temporary_.empty()) return {};
  return put_in_place();
}

Result<void> OutputFile::put_in_place() {
  while (::fsync(descriptor_.value()) != 0) {
    if (errno != EINTR) return tl::unexpected(error(errno, "write"));
    if (stop_.stop_requested()) return tl::unexpected(error(ECANCELED, "write"));
  }
  // Some file systems report a full disk only when a descriptor is closed. The lock stays with the first one until the
  // file has its name, so that nobody sweeps it away.
  if (const int copy = ::dup(descriptor_.value()); copy >= 0) {
    if (::close(copy) != 0 && errno != EINTR) return tl::unexpected(error(errno, "write"));
  }
  if (std::rename(temporary_.c_str(), real_.c_str()) != 0) return tl::unexpected(error(errno, "replace"));
  temporary_.clear();
  descriptor_.close();
  sync_directory(folder_of(real_));
  return {};
}

Result<void> write_whole_file(const fs::path& target, std::string_view bytes, const Monitor& monitor) {
  auto file = OutputFile::create(target, OutputFile::Access::forward, monitor);
  if (!file) return tl::unexpected(std::move(file.error()));
  if (auto done = file->write(bytes); !done) return done;
  return file->commit();
}

}  // namespace toolpace
