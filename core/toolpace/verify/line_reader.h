#pragma once
/// The lines of a file one after the other, in bounded memory.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "toolpace/base/input_file.h"

namespace toolpace {

/// Reads the file forward in pieces. A line ends with "\n", "\r\n" or the file; what it is given as has no such end.
class LineReader {
 public:
  explicit LineReader(InputFile file) : file_(std::move(file)) {}

  /// The next line, valid until the next call; nothing at the end of the file.
  /// Errors: those of InputFile ("file-changed" is found at the end); input: setpoints-broken for a line without end.
  Result<std::optional<std::string_view>> next();

  /// Goes to a place that at() told before.
  void seek(std::uint64_t offset, std::size_t line);

  /// Where the next line begins.
  std::uint64_t at() const { return buffer_at_ + begin_; }
  /// Number of the line given last, from 1.
  std::size_t line() const { return line_; }
  const InputFile& file() const { return file_; }

 private:
  Result<void> fill();

  InputFile file_;
  std::string buffer_;           ///< a piece of the file
  std::uint64_t buffer_at_ = 0;  ///< its place in it
  std::size_t begin_ = 0;        ///< of the next line in the buffer
  std::size_t line_ = 0;
};

}  // namespace toolpace
