#include "toolpace/io/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

#include "toolpace/base/file_error.h"

namespace toolpace {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;
constexpr int kMostLinks = 40;           // as the kernel itself follows
constexpr int kMostAttempts = 1000;      // names of temporaries to try
constexpr std::size_t kNameBytes = 180;  // of the target's name kept in the temporary's, below NAME_MAX

/// The file behind symbolic links, also when the last link points at nothing yet.
fs::path follow_links(fs::path file) {
  std::error_code ec;
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(file, ec)); ++i) {
    const fs::path next = fs::read_symlink(file, ec);
    if (ec) break;
    file = next.is_absolute() ? next : file.parent_path() / next;
  }
  return file;
}

fs::path directory_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

void sync_directory(const fs::path& directory) {
  const int d = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (d < 0) return;
  ::fsync(d);  // best effort: some file systems cannot, and the file itself is durable
  ::close(d);
}

}  // namespace

Error OutputFile::error(int number, std::string_view action) const { return file_error(number, target_, action); }

Result<OutputFile> OutputFile::create(const fs::path& target, Access access) {
  OutputFile file;
  file.target_ = target;
  file.real_ = follow_links(target);
  struct stat info {};
  const bool exists = target != "-" && ::stat(file.real_.c_str(), &info) == 0;
  if (exists && S_ISDIR(info.st_mode)) return tl::unexpected(file.error(EISDIR, "write"));
  if (target == "-" || (exists && !S_ISREG(info.st_mode))) {
    if (auto opened = file.open_direct(access); !opened) return tl::unexpected(opened.error());
    return file;
  }
  // A rename would replace a file that its owner made read-only.
  if (exists && ::access(file.real_.c_str(), W_OK) != 0) return tl::unexpected(file.error(errno, "write"));
  if (auto opened = file.open_temporary(); !opened) return tl::unexpected(opened.error());
  if (exists) ::fchmod(file.descriptor_, info.st_mode & 07777);
  return file;
}

Result<void> OutputFile::open_direct(Access access) {
  if (target_ == "-") {
    descriptor_ = STDOUT_FILENO;
    owns_descriptor_ = false;
  } else {
    descriptor_ = ::open(real_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) return tl::unexpected(error(errno, "open"));
  }
  if (access == Access::forward) return {};
  auto spool = SpoolFile::create(fs::temp_directory_path());
  if (!spool) return tl::unexpected(spool.error());
  spool_.emplace(std::move(*spool));
  return {};
}

Result<void> OutputFile::open_temporary() {
  const std::string stem = std::string(1, '.').append(real_.filename().string(), 0, kNameBytes).append(1, '.');
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    temporary_ = directory_of(real_) / (stem + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp");
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) return {};
    if (errno != EEXIST) break;
  }
  const int number = errno;
  temporary_.clear();
  return tl::unexpected(error(number, "write"));
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : target_(std::move(other.target_)),
      real_(std::move(other.real_)),
      temporary_(std::exchange(other.temporary_, {})),
      spool_(std::move(other.spool_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      owns_descriptor_(other.owns_descriptor_),
      size_(other.size_),
      buffer_(std::move(other.buffer_)) {}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0 && owns_descriptor_) ::close(descriptor_);
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
  if (const int e = write_fully(descriptor_, bytes)) return tl::unexpected(error(e, "write"));
  return {};
}

Result<void> OutputFile::flush() {
  const int e = write_fully(descriptor_, buffer_);
  buffer_.clear();
  if (e) return tl::unexpected(error(e, "write"));
  return {};
}

Result<void> OutputFile::overwrite(std::uint64_t offset, std::string_view bytes) {
  if (spool_) return spool_->overwrite(offset, bytes);
  if (auto done = flush(); !done) return done;
  if (const int e = write_fully_at(descriptor_, bytes, offset)) return tl::unexpected(error(e, "write"));
  return {};
}

Result<void> OutputFile::commit() {
  if (spool_) {
    auto sent = spool_->replay([this](std::string_view piece) -> Result<void> {
      if (const int e = write_fully(descriptor_, piece)) return tl::unexpected(error(e, "write"));
      return {};
    });
    if (!sent) return sent;
  }
  if (auto done = flush(); !done) return done;
  return temporary_.empty() ? Result<void>{} : put_in_place();
}

Result<void> OutputFile::put_in_place() {
  if (::fsync(descriptor_) != 0) return tl::unexpected(error(errno, "write"));
  // Some file systems report a full disk only here.
  if (::close(std::exchange(descriptor_, -1)) != 0) return tl::unexpected(error(errno, "write"));
  if (std::rename(temporary_.c_str(), real_.c_str()) != 0) return tl::unexpected(error(errno, "replace"));
  temporary_.clear();
  sync_directory(directory_of(real_));
  return {};
}

Result<void> write_whole_file(const fs::path& target, std::string_view bytes) {
  auto file = OutputFile::create(target);
  if (!file) return tl::unexpected(file.error());
  if (auto done = file->write(bytes); !done) return done;
  return file->commit();
}

}  // namespace toolpace
