#pragma once
/// The bytes of a file, memory-mapped where the system can, read otherwise.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"

namespace toolpace {

class MappedFile {
 public:
  /// "-" = standard input. Errors: io (of file_error(); "stream-too-long" for a pipe or device that does not end within
  /// 1 GiB), cancelled.
  static Result<MappedFile> open(const std::filesystem::path& file, const Monitor& monitor = {});

  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&&) = delete;
  ~MappedFile();

  /// Tells the system that the bytes before this offset are not needed soon; they can still be read.
  void release_before(std::size_t offset) const;

  std::string_view bytes() const {
    return mapping_ != nullptr ? std::string_view(mapping_, size_) : std::string_view(copy_);
  }

 private:
  MappedFile() = default;
  char* mapping_ = nullptr;
  std::size_t size_ = 0;
  std::string copy_;  ///< of what cannot be mapped
};

}  // namespace toolpace
