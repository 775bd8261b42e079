#include "results_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "failure.h"
#include "toolpace/base/file_error.h"

namespace toolpace::cli {
namespace {

constexpr mode_t kReadable = 0666;
constexpr useconds_t kPatience = 20'000;  // [µs] between tries for the lock

/// Lets others in again.
class Unlock {
 public:
  explicit Unlock(int descriptor) : descriptor_(descriptor) {}
  ~Unlock() { ::flock(descriptor_, LOCK_UN); }
  Unlock(const Unlock&) = delete;
  Unlock& operator=(const Unlock&) = delete;

 private:
  int descriptor_;
};

}  // namespace

Result<ResultsFile> ResultsFile::open(const std::filesystem::path& file, std::stop_token stop) {
  const auto no_file = [&] {
    return usage_error("results-no-file",
                       "--results " + file.string() + " is no regular file, in which what is done could be kept",
                       "give the name of a file; --csv - prints the table");
  };
  struct stat info {};
  const bool is_there = ::stat(file.c_str(), &info) == 0;
  if (file == "-" || (is_there && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode))) return tl::unexpected(no_file());
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, kReadable);
  if (descriptor < 0) return tl::unexpected(file_error(errno, file, "open"));
  return ResultsFile(file, Descriptor::owned(descriptor), std::move(stop));
}

Result<void> ResultsFile::lock() const {
  while (::flock(descriptor_.value(), LOCK_EX | LOCK_NB) != 0) {
    if (stop_.stop_requested()) return tl::unexpected(cancelled_error());
    if (errno != EWOULDBLOCK && errno != EINTR) return tl::unexpected(file_error(errno, name_, "lock"));
    ::usleep(kPatience);
  }
  return {};
}

Result<std::string> ResultsFile::content() const {
  struct stat info {};
  if (::fstat(descriptor_.value(), &info) != 0) return tl::unexpected(file_error(errno, name_, "read"));
  std::string text(static_cast<std::size_t>(info.st_size), '\0');
  std::size_t taken = 0;
  while (taken < text.size()) {
    const ssize_t n = ::pread(descriptor_.value(), text.data() + taken, text.size() - taken, static_cast<off_t>(taken));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return tl::unexpected(file_error(errno, name_, "read"));
    if (n == 0) break;
    taken += static_cast<std::size_t>(n);
  }
  text.resize(taken);
  return text;
}

Result<std::vector<std::string>> ResultsFile::lines() const {
  if (auto locked = lock(); !locked) return tl::unexpected(locked.error());
  const Unlock behind(descriptor_.value());
  const auto text = content();
  if (!text) return tl::unexpected(text.error());
  std::vector<std::string> lines;
  for (std::size_t at = 0, end = text->find('\n'); end != std::string::npos; at = end + 1, end = text->find('\n', at))
    lines.push_back(text->substr(at, end - at));
  return lines;
}

/// Cuts off what follows the last end of a line. @return the size that is left
Result<off_t> ResultsFile::cut_to_whole() const {
  struct stat info {};
  if (::fstat(descriptor_.value(), &info) != 0) return tl::unexpected(file_error(errno, name_, "read"));
  char last = '\n';
  if (info.st_size == 0 || (::pread(descriptor_.value(), &last, 1, info.st_size - 1) == 1 && last == '\n'))
    return info.st_size;
  const auto text = content();
  if (!text) return tl::unexpected(text.error());
  const std::size_t end = text->rfind('\n');
  const auto whole = static_cast<off_t>(end == std::string::npos ? 0 : end + 1);
  if (::ftruncate(descriptor_.value(), whole) != 0) return tl::unexpected(file_error(errno, name_, "write"));
  return whole;
}

Result<void> ResultsFile::append(std::string_view header, std::string_view line) {
  if (auto locked = lock(); !locked) return locked;
  const Unlock behind(descriptor_.value());
  const auto whole = cut_to_whole();
  if (!whole) return tl::unexpected(whole.error());
  const std::string bytes = (*whole == 0 ? std::string(header) : std::string()) + std::string(line);
  const int trouble = write_fully(descriptor_.value(), bytes, stop_);
  if (trouble == 0) return {};
  if (::ftruncate(descriptor_.value(), *whole) != 0) return tl::unexpected(file_error(errno, name_, "write"));
  return tl::unexpected(file_error(trouble, name_, "write"));
}

}  // namespace toolpace::cli
