#pragma once
/// Archives, read by libzip: entry by entry, in bounded memory, their checksums judged. For use inside verify/ alone.

#include <memory>
#include <string>

#include "toolpace/verify/byte_stream.h"

struct zip;

namespace toolpace::detail {

class ZipReader : public std::enable_shared_from_this<ZipReader> {
 public:
  /// Errors: io, cancelled; input: setpoints-broken, for what is no whole archive.
  static Result<std::shared_ptr<ZipReader>> open(InputFile file);

  ZipReader(const ZipReader&) = delete;
  ZipReader& operator=(const ZipReader&) = delete;
  ~ZipReader();

  /// The content of an entry; nothing where there is no such entry. Errors as open().
  Result<std::unique_ptr<ByteStream>> entry(const std::string& name);

 private:
  struct Source;
  class Entry;
  ZipReader() = default;
  Error error(const std::string& what, const std::string& why) const;

  std::unique_ptr<Source> source_;
  zip* archive_ = nullptr;
};

}  // namespace toolpace::detail
