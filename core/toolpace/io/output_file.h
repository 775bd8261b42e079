#pragma once
/// A file that appears whole or not at all.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "toolpace/base/descriptor.h"
#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/io/spool_file.h"

namespace toolpace {

/// Bytes that are collected before the system is asked to write them.
inline constexpr std::size_t kBufferBytes = std::size_t{1} << 18;

/// Writes to a temporary file beside the target and renames it on commit(), so that readers see the old file or the new
/// one and never a part. The temporary is removed when the object dies uncommitted. Written directly are: a target that
/// exists and is no regular file (pipe, device), "-" (standard output), and what names an open descriptor (/dev/stdout,
/// /dev/fd/3). A symbolic link is followed.
///
/// A closed pipe is reported as an error only where the process ignores SIGPIPE, a file size limit only where it ignores
/// SIGXFSZ, as the command line does.
class OutputFile {
 public:
  enum class Access { forward, patched };  ///< patched: overwrite() will be used; unseekable targets are spooled first

  /// Nothing of an old file is touched. A FIFO waits for its reader.
  /// @param monitor  its stop token ends every wait of this and the later calls
  /// Errors: io (no such directory, a directory, no right to write), cancelled.
  static Result<OutputFile> create(const std::filesystem::path& target, Access access = Access::forward,
                                   const Monitor& monitor = {});

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  /// Appends bytes (buffered). Errors: io (disk full, closed pipe, …), cancelled.
  Result<void> write(std::string_view bytes);

  /// Replaces bytes that were written before. Needs Access::patched.
  Result<void> overwrite(std::uint64_t offset, std::string_view bytes);

  /// Makes the file durable (fsync) and puts it in place of the target. To be called once, as the last call.
  Result<void> commit();

  std::uint64_t size() const { return size_; }
  const std::filesystem::path& target() const { return target_; }
  /// False where the target is written directly.
  bool is_renamed() const { return !temporary_.empty(); }

 private:
  OutputFile() = default;
  Result<void> open_direct(Access access);
  Result<void> open_beside(const std::filesystem::path& real);
  Result<void> flush();
  Result<void> put_in_place();
  Error error(int number, std::string_view action) const;

  std::filesystem::path target_;     ///< what the caller named
  std::filesystem::path real_;       ///< the file behind links
  std::filesystem::path temporary_;  ///< empty when written directly
  std::optional<SpoolFile> spool_;   ///< for patched access to what cannot seek
  std::stop_token stop_;
  Descriptor descriptor_;
  std::uint64_t size_ = 0;
  std::string buffer_;
};

/// Writes the whole of `bytes` as one file, or nothing.
Result<void> write_whole_file(const std::filesystem::path& target, std::string_view bytes, const Monitor& monitor = {});

}  // namespace toolpace
