#include "toolpace/verify/row_stream.h"

namespace toolpace {
namespace {

constexpr std::size_t kRowsAtATime = 4096;  // all columns of them stay in the second-level cache

template <class T>
void drop_front(std::vector<T>& column, std::size_t count) {
  if (!column.empty()) column.erase(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(count));
}

template <class T>
void pad(std::vector<T>& column, bool in_front, T value) {
  if (column.empty()) return;
  column.insert(in_front ? column.begin() : column.end(), kReach, value);
}

}  // namespace

void RowStream::drop_judged() {
  const std::size_t gone = end_ - kReach;
  for (auto* column : {&rows_.time, &rows_.speed, &rows_.acceleration, &rows_.jerk}) drop_front(*column, gone);
  for (auto& column : rows_.position) drop_front(column, gone);
  for (auto* columns : {&rows_.tip, &rows_.tip_from}) {
    for (auto& column : *columns) drop_front(column, gone);
  }
  for (auto& order : rows_.derivative) {
    for (auto& column : order) drop_front(column, gone);
  }
  drop_front(rows_.line, gone);
  rows_.count -= gone;
  offset_ += static_cast<std::int64_t>(gone);
}

void RowStream::append_copies(bool in_front) {
  const auto end_of = [in_front](const auto& column) { return in_front ? column.front() : column.back(); };
  if (!rows_.time.empty()) pad(rows_.time, in_front, end_of(rows_.time));
  for (auto& column : rows_.position) {
    if (!column.empty()) pad(column, in_front, end_of(column));
  }
  for (std::size_t k = 0; k < rows_.tip.size() && !rows_.tip[k].empty(); ++k) {
    const double rests = end_of(rows_.tip[k]);
    pad(rows_.tip[k], in_front, rests);
    // From the copies in front the first row is no way.
    pad(rows_.tip_from[k], in_front, rests);
  }
  for (auto* column : {&rows_.speed, &rows_.acceleration, &rows_.jerk}) pad(*column, in_front, 0.0);
  for (auto& order : rows_.derivative) {
    for (auto& column : order) pad(column, in_front, 0.0);
  }
  if (!rows_.line.empty()) pad(rows_.line, in_front, end_of(rows_.line));
  rows_.count += kReach;
}

Result<bool> RowStream::next() {
  if (ended_) return false;
  if (end_ > kReach) drop_judged();
  const auto read = file_.read(rows_, kRowsAtATime);
  if (!read) return tl::unexpected(read.error());
  const bool starts = read_ == 0;
  read_ += static_cast<std::int64_t>(*read);
  if (starts && *read > 0) append_copies(true);
  if (*read < kRowsAtATime) {
    ended_ = true;
    if (read_ == 0) return false;
    append_copies(false);
  }
  begin_ = kReach;
  end_ = rows_.count - kReach;
  // Differences that reach from the first or the last row into the copies belong to no row of the file by their index.
  if (starts) begin_ -= 3;
  if (ended_) end_ += 3;
  return end_ > begin_;
}

}  // namespace toolpace
