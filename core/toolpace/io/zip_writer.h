#pragma once
/// Archives of stored (uncompressed) entries, written by libzip. For use inside io/ alone.

#include <string>
#include <vector>

#include "toolpace/io/output_file.h"
#include "toolpace/io/spool_file.h"

namespace toolpace::detail {

/// An entry: its head, and behind it what waits in a file.
struct ZipEntry {
  std::string name;
  std::string head;
  SpoolFile* body = nullptr;  ///< none = the head is all
};

/// Writes the archive and puts the file in place. The same entries give the same bytes: they bear no time.
/// @param file  opened with Access::patched
/// Errors: those of OutputFile and SpoolFile.
Result<void> write_zip(OutputFile& file, const std::vector<ZipEntry>& entries);

}  // namespace toolpace::detail
