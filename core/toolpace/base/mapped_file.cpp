#include "toolpace/base/mapped_file.h"

#include <fcntl.h>
#include <poll.h>
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

constexpr std::size_t kMostStreamed = std::size_t{1} << 30;  ///< bytes; an endless device must not fill the memory
constexpr int kPatience = 100;                               ///< [ms] between looks at the monitor

class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (value_ > STDERR_FILENO) ::close(value_);
  }
  int value() const { return value_; }

 private:
  int value_;
};

/// Reads what has no size of its own (pipe, terminal, device) to its end.
Result<void> read_stream(int descriptor, const std::filesystem::path& file, const Monitor& monitor, std::string& out) {
  std::array<char, 65536> piece;
  for (;;) {
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    pollfd ready{descriptor, POLLIN, 0};
    if (::poll(&ready, 1, kPatience) == 0) continue;
    const ssize_t count = ::read(descriptor, piece.data(), piece.size());
    if (count == 0) return {};
    if (count < 0) {
      if (errno == EINTR) continue;
      return tl::unexpected(file_error(errno, file, "read"));
    }
    out.append(piece.data(), static_cast<std::size_t>(count));
    if (out.size() > kMostStreamed) {
      return tl::unexpected(Error{ErrorKind::io,
                                  "stream-too-long",
                                  "more than 1 GiB came and no end",
                                  "write it to a file and read that",
                                  {file.string(), 0, 0},
                                  {}});
    }
  }
}

}  // namespace

Result<MappedFile> MappedFile::open(const std::filesystem::path& file, const Monitor& monitor) {
  const Descriptor descriptor(file == "-" ? STDIN_FILENO : ::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (descriptor.value() < 0) return tl::unexpected(file_error(errno, file, "open"));
  struct stat info {};
  if (::fstat(descriptor.value(), &info) != 0) return tl::unexpected(file_error(errno, file, "read"));
  if (S_ISDIR(info.st_mode)) return tl::unexpected(file_error(EISDIR, file, "read"));
  MappedFile mapped;
  if (S_ISREG(info.st_mode) && info.st_size > 0) {
    mapped.size_ = static_cast<std::size_t>(info.st_size);
    void* const at = ::mmap(nullptr, mapped.size_, PROT_READ, MAP_PRIVATE, descriptor.value(), 0);
    if (at != MAP_FAILED) {
      mapped.mapping_ = static_cast<char*>(at);
      ::madvise(at, mapped.size_, MADV_SEQUENTIAL);
      return mapped;
    }
  }
  if (auto read = read_stream(descriptor.value(), file, monitor, mapped.copy_); !read) {
    return tl::unexpected(std::move(read.error()));
  }
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
