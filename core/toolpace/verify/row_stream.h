#pragma once
/// A setpoint file as a sliding window of rows, so that differences can look a few rows back and ahead.

#include <algorithm>
#include <cstdint>

#include "toolpace/verify/setpoint_file.h"

namespace toolpace {

/// Rows that a check may look back and ahead of the row it judges.
inline constexpr std::size_t kReach = 6;

/// The machine rests before the first row and after the last one: kReach copies of these rows stand there, with speed,
/// acceleration and jerk 0, so that starts and ends are judged like everything else.
class RowStream {
 public:
  explicit RowStream(SetpointFile& file) : file_(file) {}

  /// Moves on. @return false when every row has been judged
  Result<bool> next();

  const SetpointRows& rows() const { return rows_; }
  /// Local indices of the rows to be judged now; kReach rows stand on either side.
  std::size_t begin() const { return begin_; }
  std::size_t end() const { return end_; }
  /// Row of the file at a local index; negative and beyond the last row for the copies.
  std::int64_t row(std::size_t local) const { return offset_ + static_cast<std::int64_t>(local); }
  /// The same in the file: the rest before it counts as the first row, that behind it as the last.
  std::int64_t row_in_file(std::size_t local) const {
    return std::max<std::int64_t>(0, std::min(row(local), read_ - 1));
  }
  /// Whether a local index is a row of the file, not a copy.
  bool is_real(std::size_t local) const { return row(local) >= 0 && row(local) < read_; }
  std::int64_t rows_read() const { return read_; }

 private:
  void drop_judged();
  void append_copies(bool in_front);

  SetpointFile& file_;
  SetpointRows rows_;
  std::size_t begin_ = 0, end_ = 0;
  std::int64_t offset_ = -static_cast<std::int64_t>(kReach);
  std::int64_t read_ = 0;
  bool ended_ = false;
};

}  // namespace toolpace
