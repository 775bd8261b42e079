#include "toolpace/base/input_file.h"

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

constexpr std::size_t kMostStreamed = std::size_t{1} << 30;  // bytes; an endless device must not fill the memory
constexpr std::size_t kPieceBytes = std::size_t{1}
                                    << 20;  // stays in the cache between the system's copy and a look at it

/// Asks for the memory of a piece at once: a fault for each of its pages takes longer than to fill it. Best effort.
void prepare(char* begin, std::size_t count) {
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const auto first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) / page * page;
  const auto last = (reinterpret_cast<std::uintptr_t>(begin) + count) / page * page;
  if (last > first) ::madvise(reinterpret_cast<void*>(first), last - first, MADV_POPULATE_WRITE);
}

/// Reads what has no size of its own (pipe, terminal, device) to its end.
Result<void> read_stream(int descriptor, const std::filesystem::path& file, const Monitor& monitor, std::string& out) {
  std::array<char, 65536> piece;
  for (;;) {
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    if (!wait_to_read(descriptor)) continue;
    const ssize_t count = ::read(descriptor, piece.data(), piece.size());
    if (count == 0) return {};
    if (count < 0) {
      if (errno == EINTR || errno == EAGAIN) continue;
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

Result<InputFile> InputFile::open(const std::filesystem::path& file, const Monitor& monitor) {
  auto descriptor = open_for_reading(file);
  if (!descriptor) return tl::unexpected(std::move(descriptor.error()));
  struct stat info {};
  if (::fstat(descriptor->value(), &info) != 0) return tl::unexpected(file_error(errno, file, "read"));
  if (S_ISDIR(info.st_mode)) return tl::unexpected(file_error(EISDIR, file, "read"));
  InputFile input;
  input.name_ = file;
  input.stop_ = monitor.stop;
  // Files of /proc say that they are regular and empty, and are not.
  if (!S_ISREG(info.st_mode) || info.st_size == 0) {
    if (auto read = read_stream(descriptor->value(), file, monitor, input.taken_); !read) {
      return tl::unexpected(std::move(read.error()));
    }
    input.size_ = input.taken_.size();
    return input;
  }
  const auto here = std::max<off_t>(0, ::lseek(descriptor->value(), 0, SEEK_CUR));
  input.begin_ = static_cast<std::uint64_t>(here);
  input.size_ = static_cast<std::uint64_t>(std::max<off_t>(0, info.st_size - here));
  input.seconds_ = info.st_mtim.tv_sec;
  input.nanoseconds_ = info.st_mtim.tv_nsec;
  input.descriptor_ = std::move(*descriptor);
  return input;
}

Error InputFile::changed() const {
  return {ErrorKind::io,
          "file-changed",
          "this file was changed while it was read",
          "try again when it is written",
          {name_.string(), 0, 0},
          {}};
}

Result<void> InputFile::read(std::uint64_t offset, char* out, std::size_t count) const {
  if (is_taken()) {
    std::copy_n(taken_.data() + offset, count, out);
    return {};
  }
  while (count > 0) {
    const ssize_t n = ::pread(descriptor_.value(), out, count, static_cast<off_t>(begin_ + offset));
    if (n == 0) return tl::unexpected(changed());
    if (n < 0 && errno != EINTR && errno != EAGAIN) return tl::unexpected(file_error(errno, name_, "read"));
    if (stop_.stop_requested()) return tl::unexpected(cancelled_error());
    if (n < 0) continue;
    out += n;
    count -= static_cast<std::size_t>(n);
    offset += static_cast<std::uint64_t>(n);
  }
  return {};
}

Result<void> InputFile::check_unchanged() const {
  if (is_taken()) return {};
  struct stat info {};
  if (::fstat(descriptor_.value(), &info) != 0) return tl::unexpected(file_error(errno, name_, "read"));
  const bool same = static_cast<std::uint64_t>(info.st_size) == begin_ + size_ && info.st_mtim.tv_sec == seconds_ &&
                    info.st_mtim.tv_nsec == nanoseconds_;
  return same ? Result<void>{} : tl::unexpected(changed());
}

Result<FileContent> read_whole_file(const std::filesystem::path& file, const Monitor& monitor) {
  auto input = InputFile::open(file, monitor);
  if (!input) return tl::unexpected(std::move(input.error()));
  if (input->is_taken()) return FileContent(std::move(input->taken()));
  const auto size = static_cast<std::size_t>(input->size());
  auto block = std::make_unique_for_overwrite<char[]>(size);
  for (std::size_t at = 0; at < size; at += kPieceBytes) {
    const std::size_t count = std::min(kPieceBytes, size - at);
    prepare(block.get() + at, count);
    auto read = input->read(at, block.get() + at, count);
    if (!read) return tl::unexpected(std::move(read.error()));
    monitor.report(static_cast<double>(at) / static_cast<double>(size));
  }
  if (auto same = input->check_unchanged(); !same) return tl::unexpected(std::move(same.error()));
  return FileContent(std::move(block), size);
}

}  // namespace toolpace
