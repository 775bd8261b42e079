#include "toolpace/base/descriptor.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <string>
#include <utility>

#include "toolpace/base/file_error.h"
#include "toolpace/base/file_identity.h"

namespace toolpace {
namespace {

namespace fs = std::filesystem;

constexpr int kPatience = 100;  // [ms] between looks at the stop token

bool wait_for(int descriptor, short events) {
  pollfd ready{descriptor, events, 0};
  return ::poll(&ready, 1, kPatience) > 0;
}

/// N of ".../N" in the folder of this process' descriptors.
std::optional<int> descriptor_in_folder(const fs::path& file) {
  const std::string name = file.filename().string();
  int number = 0;
  const auto [end, trouble] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (trouble != std::errc() || end != name.data() + name.size() || number < 0) return {};
  std::error_code ec;
  const fs::path folder = fs::canonical(file.parent_path(), ec);
  if (ec || folder != "/proc/" + std::to_string(::getpid()) + "/fd") return {};
  if (::fcntl(number, F_GETFD) < 0) return {};
  return number;
}

/// After a call that took `n` bytes or failed: 0 = go on with what is left, else the errno to give up for.
int after_write(ssize_t n, int descriptor) {
  if (n > 0) return 0;
  if (n == 0) return EIO;
  if (errno == EAGAIN) {
    wait_to_write(descriptor);
    return 0;
  }
  return errno == EINTR ? 0 : errno;
}

}  // namespace

Descriptor::Descriptor(Descriptor&& other) noexcept
    : value_(std::exchange(other.value_, -1)), is_owned_(std::exchange(other.is_owned_, false)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  if (this == &other) return *this;
  close();
  value_ = std::exchange(other.value_, -1);
  is_owned_ = std::exchange(other.is_owned_, false);
  return *this;
}

int Descriptor::close() {
  const int value = std::exchange(value_, -1);
  if (value < 0 || !std::exchange(is_owned_, false)) return 0;
  return ::close(value) == 0 || errno == EINTR ? 0 : errno;
}

std::optional<int> named_descriptor(const fs::path& file) {
  fs::path at = file;
  for (int i = 0; i < kMostLinks; ++i) {
    if (const auto found = descriptor_in_folder(at)) return found;
    std::error_code ec;
    const fs::path next = fs::read_symlink(at, ec);
    if (ec) return {};
    at = next.is_absolute() ? next : at.parent_path() / next;
  }
  return {};
}

bool is_standard_output(const fs::path& file) { return file == "-" || named_descriptor(file) == STDOUT_FILENO; }

Result<Descriptor> open_for_reading(const fs::path& file) {
  if (file == "-") return Descriptor::lent(STDIN_FILENO);
  if (const auto named = named_descriptor(file)) return Descriptor::lent(*named);
  for (;;) {
    const int value = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (value >= 0) return Descriptor::owned(value);
    if (errno != EINTR) return tl::unexpected(file_error(errno, file, "open"));
  }
}

Result<Descriptor> open_for_writing(const fs::path& file, const std::stop_token& stop) {
  if (file == "-") return Descriptor::lent(STDOUT_FILENO);
  if (const auto named = named_descriptor(file)) {
    const int mode = ::fcntl(*named, F_GETFL);
    if (mode < 0 || (mode & O_ACCMODE) == O_RDONLY) return tl::unexpected(file_error(EBADF, file, "write"));
    return Descriptor::lent(*named);
  }
  for (;;) {
    const int value = ::open(file.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (value >= 0) return Descriptor::owned(value);
    const int number = errno;
    if (stop.stop_requested()) return tl::unexpected(file_error(ECANCELED, file, "open"));
    struct stat info {};
    const bool lacks_reader = number == ENXIO && ::stat(file.c_str(), &info) == 0 && S_ISFIFO(info.st_mode);
    if (lacks_reader) {
      ::poll(nullptr, 0, kPatience);
    } else if (number != EINTR) {
      return tl::unexpected(file_error(number, file, "open"));
    }
  }
}

bool wait_to_read(int descriptor) { return wait_for(descriptor, POLLIN); }
bool wait_to_write(int descriptor) { return wait_for(descriptor, POLLOUT); }

int write_fully(int descriptor, std::string_view bytes, const std::stop_token& stop) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
    if (const int trouble = after_write(n, descriptor)) return trouble;
    if (n > 0) bytes.remove_prefix(static_cast<std::size_t>(n));
    if (stop.stop_requested()) return ECANCELED;
  }
  return 0;
}

int write_fully_at(int descriptor, std::string_view bytes, std::uint64_t offset, const std::stop_token& stop) {
  while (!bytes.empty()) {
    const ssize_t n = ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (const int trouble = after_write(n, descriptor)) return trouble;
    if (n > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(n));
      offset += static_cast<std::uint64_t>(n);
    }
    if (stop.stop_requested()) return ECANCELED;
  }
  return 0;
}

}  // namespace toolpace
