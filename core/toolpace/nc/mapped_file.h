#pragma once
/// A file's bytes, memory-mapped where the system can, read otherwise ("-" = standard input).

#include <filesystem>
#include <string>
#include <string_view>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"

namespace toolpace::nc {

class MappedFile {
 public:
  /// Errors: io (missing, a directory, unreadable, a pipe or device that does not end within 1 GiB), cancelled.
  static Result<MappedFile> open(const std::filesystem::path& path, const Monitor& monitor = {});

  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&& other) noexcept;
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  ~MappedFile();

  std::string_view text() const { return mapping_ ? std::string_view(mapping_, size_) : std::string_view(storage_); }

 private:
  MappedFile() = default;
  void release();

  const char* mapping_ = nullptr;
  std::size_t size_ = 0;
  std::string storage_;
};

}  // namespace toolpace::nc
