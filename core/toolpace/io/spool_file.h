#pragma once
/// Scratch space on disk for what would not fit into bounded memory.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "toolpace/base/result.h"

namespace toolpace {

/// Writes all of `bytes` to a descriptor, whatever the system takes at a time. @return 0 or errno
int write_fully(int descriptor, std::string_view bytes);

/// The same at a place in the file.
int write_fully_at(int descriptor, std::string_view bytes, std::uint64_t offset);

/// A nameless temporary file: it vanishes with the object, or with the process.
class SpoolFile {
 public:
  static Result<SpoolFile> create(const std::filesystem::path& directory);

  SpoolFile(SpoolFile&& other) noexcept;
  SpoolFile& operator=(SpoolFile&&) = delete;
  ~SpoolFile();

  Result<void> write(std::string_view bytes);
  Result<void> overwrite(std::uint64_t offset, std::string_view bytes);

  /// Hands over all that was written, in order, in pieces of bounded size.
  Result<void> replay(const std::function<Result<void>(std::string_view)>& sink);

 private:
  explicit SpoolFile(std::filesystem::path directory) : directory_(std::move(directory)) {}
  Result<void> flush();

  std::filesystem::path directory_;
  int descriptor_ = -1;
  std::string buffer_;
};

}  // namespace toolpace
