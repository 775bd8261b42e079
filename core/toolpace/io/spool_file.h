#pragma once
/// Scratch space on disk for what would not fit into bounded memory.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "toolpace/base/result.h"

namespace toolpace {

/// A nameless temporary file: it vanishes with the object, or with the process.
class SpoolFile {
 public:
  static Result<SpoolFile> create(const std::filesystem::path& directory);
  /// In the system's temporary directory.
  static Result<SpoolFile> create_anywhere();

  SpoolFile(SpoolFile&& other) noexcept;
  SpoolFile& operator=(SpoolFile&&) = delete;
  ~SpoolFile();

  Result<void> write(std::string_view bytes);
  Result<void> overwrite(std::uint64_t offset, std::string_view bytes);

  std::uint64_t size() const { return size_ + buffer_.size(); }

  /// Reads what was written before. @return how many bytes; 0 = there are no more
  Result<std::size_t> read(std::uint64_t offset, char* out, std::size_t count);

  /// Hands over all that was written, in order, in pieces of bounded size.
  Result<void> replay(const std::function<Result<void>(std::string_view)>& sink);

 private:
  explicit SpoolFile(std::filesystem::path directory) : directory_(std::move(directory)) {}
  Result<void> flush();

  std::filesystem::path directory_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;  ///< of what stands in the file
  std::string buffer_;
};

}  // namespace toolpace
