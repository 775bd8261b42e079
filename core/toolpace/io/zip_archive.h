#pragma once
/// A zip archive of stored (uncompressed) entries, of any size.
/// @source PKWARE APPNOTE.TXT 6.3.10, sections 4.3.7, 4.3.12, 4.3.14–4.3.16, 4.5.3

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "toolpace/io/output_file.h"

namespace toolpace {

/// One entry after the other: begin_entry, write…, end_entry; then finish.
class ZipArchive {
 public:
  /// @param file  opened with Access::patched
  explicit ZipArchive(OutputFile file) : file_(std::move(file)) {}

  /// @param head_bytes  bytes at the beginning of the entry that replace_head() may give anew
  Result<void> begin_entry(std::string_view name, std::size_t head_bytes = 0);
  Result<void> write(std::string_view bytes);
  /// Replaces the first head_bytes of the present entry. They are to be written by write() first, as one piece.
  Result<void> replace_head(std::string_view head);
  Result<void> end_entry();

  /// Writes the directory and puts the file in place.
  Result<void> finish();

 private:
  struct Entry {
    std::string name;
    std::uint64_t offset = 0;  ///< of the local header
    std::uint64_t size = 0;
    std::uint64_t head_bytes = 0;
    std::uint32_t head_crc = 0;
    std::uint32_t body_crc = 0;  ///< of what follows the head
  };
  std::uint32_t crc(const Entry& entry) const;
  std::string local_header(const Entry& entry) const;
  std::string directory_header(const Entry& entry) const;

  OutputFile file_;
  std::vector<Entry> entries_;
};

}  // namespace toolpace
