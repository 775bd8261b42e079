#include "toolpace/nc/mapped_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

namespace toolpace::nc {
namespace {

Error io_error(const std::filesystem::path& path, const char* code, std::string what, std::string remedy) {
  return {ErrorKind::io, code, std::move(what), std::move(remedy), {path.string(), 0, 0}, {}};
}

constexpr std::size_t kMostStreamed = std::size_t{1}
                                      << 30;  ///< bytes; an endless pipe or device must not fill the memory
constexpr int kPatience = 100;                ///< [ms] between looks at the monitor

/// Reads what has no size of its own (pipe, terminal, device) to its end. Nothing on success.
std::optional<Error> read_stream(int descriptor, const std::filesystem::path& path, std::string& text,
                                 const Monitor& monitor) {
  std::array<char, 65536> buffer;
  for (;;) {
    if (monitor.is_cancelled()) return cancelled_error();
    pollfd ready{descriptor, POLLIN, 0};
    if (::poll(&ready, 1, kPatience) == 0) continue;
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      return io_error(path, "file-not-read", fmt::format("reading failed: {}", std::strerror(errno)), "check the disk");
    }
    if (count == 0) return {};
    text.append(buffer.data(), static_cast<std::size_t>(count));
    if (text.size() > kMostStreamed) {
      return io_error(path, "stream-too-long", "more than 1 GiB came and no end", "write it to a file and read that");
    }
  }
}

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

}  // namespace

Result<MappedFile> MappedFile::open(const std::filesystem::path& path, const Monitor& monitor) {
  const bool standard_input = path == "-";
  const Descriptor file(standard_input ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.value() < 0) {
    const int reason = errno;
    if (reason == ENOENT)
      return tl::unexpected(io_error(path, "file-missing", "there is no such file", "check the name"));
    return tl::unexpected(io_error(path, "file-not-opened",
                                   fmt::format("the file cannot be opened: {}", std::strerror(reason)),
                                   "check its permissions"));
  }
  struct stat status {};
  if (::fstat(file.value(), &status) != 0) {
    return tl::unexpected(io_error(path, "file-not-opened", "the file cannot be read", "check it"));
  }
  if (S_ISDIR(status.st_mode))
    return tl::unexpected(io_error(path, "file-is-directory", "this is a directory", "name a file in it"));
  MappedFile result;
  if (S_ISREG(status.st_mode) && status.st_size > 0) {
    const auto size = static_cast<std::size_t>(status.st_size);
    void* const mapping = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.value(), 0);
    if (mapping != MAP_FAILED) {
      ::madvise(mapping, size, MADV_SEQUENTIAL);
      result.mapping_ = static_cast<const char*>(mapping);
      result.size_ = size;
      return result;
    }
  }
  if (auto error = read_stream(file.value(), path, result.storage_, monitor)) return tl::unexpected(std::move(*error));
  return result;
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : mapping_(std::exchange(other.mapping_, nullptr)),
      size_(std::exchange(other.size_, 0)),
      storage_(std::move(other.storage_)) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
  if (this != &other) {
    release();
    mapping_ = std::exchange(other.mapping_, nullptr);
    size_ = std::exchange(other.size_, 0);
    storage_ = std::move(other.storage_);
  }
  return *this;
}

MappedFile::~MappedFile() { release(); }

void MappedFile::release() {
  if (mapping_) ::munmap(const_cast<char*>(mapping_), size_);
  mapping_ = nullptr;
}

}  // namespace toolpace::nc
