#pragma once
/// Files that are read. None is mapped into memory: one that shrinks while it is read is an error and no crash.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

#include "toolpace/base/descriptor.h"
#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"

namespace toolpace {

/// An open file of known size, to be read piece by piece in any order. What has no size of its own (pipe, terminal,
/// device) is taken into memory when it is opened.
class InputFile {
 public:
  /// "-" = standard input, from where it stands. Errors: io (of file_error(); "stream-too-long" for a pipe or device that
  /// does not end within 1 GiB), cancelled.
  static Result<InputFile> open(const std::filesystem::path& file, const Monitor& monitor = {});

  std::uint64_t size() const { return size_; }
  const std::filesystem::path& name() const { return name_; }

  /// Fills `out` with the bytes from `offset` on; all of them lie within size().
  /// Errors: io (of file_error(); "file-changed" where the file has become shorter), cancelled.
  Result<void> read(std::uint64_t offset, char* out, std::size_t count) const;

  /// To be asked when all was read. Errors: io ("file-changed": it is not what it was when it was opened).
  Result<void> check_unchanged() const;

  /// The bytes of what was taken into memory; nothing for a regular file. They may be moved away.
  std::string& taken() { return taken_; }
  bool is_taken() const { return descriptor_.value() < 0; }

 private:
  InputFile() = default;
  Error changed() const;

  std::filesystem::path name_;
  std::stop_token stop_;
  Descriptor descriptor_;    ///< of a regular file
  std::string taken_;        ///< of anything else
  std::uint64_t begin_ = 0;  ///< place in the regular file where it starts for us
  std::uint64_t size_ = 0;
  std::int64_t seconds_ = 0, nanoseconds_ = 0;  ///< of the last change, when it was opened
};

/// The whole content of a file, in memory.
class FileContent {
 public:
  explicit FileContent(std::string bytes) : text_(std::move(bytes)) {}
  FileContent(std::unique_ptr<char[]> bytes, std::size_t size) : block_(std::move(bytes)), size_(size) {}

  std::string_view bytes() const { return block_ ? std::string_view(block_.get(), size_) : std::string_view(text_); }

 private:
  std::string text_;
  std::unique_ptr<char[]> block_;
  std::size_t size_ = 0;
};

/// Reads a whole file; "-" = standard input. Errors: those of InputFile.
Result<FileContent> read_whole_file(const std::filesystem::path& file, const Monitor& monitor = {});

}  // namespace toolpace
