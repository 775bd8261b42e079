#pragma once
/// The bytes of an array, one after the other, wherever they stand. For use inside verify/ alone.

#include <cstdint>
#include <memory>
#include <string>

#include "toolpace/base/input_file.h"
#include "toolpace/base/result.h"

namespace toolpace::detail {

class ByteStream {
 public:
  virtual ~ByteStream() = default;
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;

  virtual std::uint64_t size() const = 0;
  /// Takes the next `count` bytes, all of which lie within size(). Errors: io, cancelled; input: setpoints-broken.
  virtual Result<void> read(char* out, std::size_t count) = 0;
  /// To be asked behind the last byte: was all of it what it should be? Errors as read().
  virtual Result<void> finish() = 0;
  /// Goes back to the first byte.
  virtual void rewind() = 0;

 protected:
  ByteStream() = default;
};

/// The whole of a file.
std::unique_ptr<ByteStream> stream_of_file(InputFile file);

}  // namespace toolpace::detail
