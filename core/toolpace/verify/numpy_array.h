#pragma once
/// The header of an array in NumPy's format, and its values. For use inside verify/ alone.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "toolpace/verify/byte_stream.h"

namespace toolpace::detail {

/// An array whose values are read one after the other.
struct NumpyArray {
  std::string type;  ///< "<f8"
  std::vector<std::uint64_t> shape;
  std::uint64_t bytes = 0;  ///< of the values, as many as there are
  std::unique_ptr<ByteStream> stream;

  /// Goes to the first value. Errors of the stream.
  Result<void> seek_values();
  /// Whether there are exactly so many values of 8 bytes: "" or what is wrong.
  std::string size_fault(std::uint64_t rows, std::uint64_t columns) const;

  std::size_t header_bytes = 0;
};

/// Reads the header. Errors of the stream; input: setpoints-shape.
/// @param name  of the file, for errors
Result<NumpyArray> open_array(std::unique_ptr<ByteStream> stream, const std::string& name);

/// "setpoints-shape", with the way to save an array that is fine.
Error shape_error(std::string what, const std::string& name);

}  // namespace toolpace::detail
