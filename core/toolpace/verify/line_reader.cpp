#include "toolpace/verify/line_reader.h"

#include <algorithm>

#include "toolpace/verify/setpoint_readers.h"

namespace toolpace {
namespace {

constexpr std::size_t kPieceBytes = std::size_t{1} << 18;   // stays in the second-level cache
constexpr std::size_t kLongestLine = std::size_t{1} << 20;  // bytes; no row of numbers comes near

}  // namespace

/// Drops what was given and appends a piece.
Result<void> LineReader::fill() {
  buffer_.erase(0, begin_);
  buffer_at_ += begin_;
  begin_ = 0;
  const std::size_t had = buffer_.size();
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(kPieceBytes, file_.size() - (buffer_at_ + had)));
  buffer_.resize(had + count);
  return file_.read(buffer_at_ + had, buffer_.data() + had, count);
}

Result<std::optional<std::string_view>> LineReader::next() {
  std::size_t searched = begin_;
  for (;;) {
    const std::size_t end = buffer_.find('\n', searched);
    const bool is_last = buffer_at_ + buffer_.size() == file_.size();
    if (end != std::string::npos || is_last) {
      if (end == std::string::npos && begin_ == buffer_.size()) {
        if (auto same = file_.check_unchanged(); !same) return tl::unexpected(std::move(same.error()));
        return std::nullopt;
      }
      std::string_view line = std::string_view(buffer_).substr(begin_, std::min(end, buffer_.size()) - begin_);
      while (line.ends_with('\r')) line.remove_suffix(1);
      begin_ = std::min(end, buffer_.size() - 1) + 1;
      ++line_;
      return line;
    }
    if (buffer_.size() - begin_ > kLongestLine) {
      return tl::unexpected(detail::setpoints_error("setpoints-broken", "a line is longer than 1 MiB",
                                                    {file_.name().string(), line_ + 1, 0}));
    }
    searched = buffer_.size() - begin_;
    if (auto filled = fill(); !filled) return tl::unexpected(std::move(filled.error()));
  }
}

void LineReader::seek(std::uint64_t offset, std::size_t line) {
  buffer_.clear();
  buffer_at_ = offset;
  begin_ = 0;
  line_ = line;
}

}  // namespace toolpace
