#include "toolpace/trace/commanded_rows.h"

#include <algorithm>
#include <cmath>

#include "toolpace/io/setpoint_reader.h"
#include "toolpace/sample/cubic_between.h"
#include "toolpace/verify/setpoint_readers.h"

namespace toolpace {
namespace {

constexpr std::size_t kRowsAtATime = 65536;
constexpr double kUneven = 0.02;  // of a period, that a time may be off

template <class T>
void append_column(std::vector<T>& column, const std::vector<T>& more) {
  column.insert(column.end(), more.begin(), more.end());
}

/// The period that times follow each other in; they are kept nowhere.
class PeriodMeter {
 public:
  /// @return false at the first time that is not where it is due
  bool take(const std::vector<double>& times) {
    for (const double t : times) {
      if (count_ == 0) first_ = t;
      if (count_ == 1) period_ = t - first_;
      if (count_ > 0 && !(period_ > 0)) return false;
      if (count_ > 1) {
        const double due = first_ + static_cast<double>(count_) * period_;
        if (std::abs(t - due) > kUneven * period_) return false;
        period_ = (t - first_) / static_cast<double>(count_);  // better with every row
      }
      ++count_;
    }
    return true;
  }
  std::size_t count() const { return count_; }
  double period() const { return period_; }

 private:
  std::size_t count_ = 0;
  double first_ = 0, period_ = 0;
};

}  // namespace

std::size_t CommandedRows::size() const {
  std::size_t most = 0;
  for (const auto& column : position) most = std::max(most, column.size());
  return most;
}

void CommandedRows::append(const Setpoints& chunk) {
  period = chunk.period;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) append_column(position[axis], chunk.position[axis]);
  append_column(line, chunk.line);
}

CommandedPoint commanded_at(const std::vector<double>& position, double period, double time) {
  const CubicPoint point = cubic_between(position, time / period);
  return {point.value, point.slope / period};
}

Result<CommandedRows> read_commanded(const std::filesystem::path& file, double period, const Monitor& monitor) {
  auto open = open_setpoint_file(file, monitor);
  if (!open) return tl::unexpected(open.error());
  const std::string name = file.string();
  CommandedRows commanded;
  PeriodMeter meter;
  SetpointRows rows;
  for (;;) {
    rows.clear();
    const auto taken = (*open)->read(rows, kRowsAtATime);
    if (!taken) return tl::unexpected(taken.error());
    if (*taken == 0) break;
    if (!meter.take(rows.time)) {
      return tl::unexpected(
          detail::setpoints_error("setpoints-time", "the times of the setpoints are no multiples of a period",
                                  {name, meter.count() + 2, 1}, "give setpoints as they were commanded"));
    }
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) append_column(commanded.position[axis], rows.position[axis]);
    append_column(commanded.line, rows.line);
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    monitor.report((*open)->progress());
  }
  commanded.period = meter.count() > 1 ? meter.period() : period;
  if (commanded.size() < 2) {
    return tl::unexpected(
        detail::setpoints_error("setpoints-empty", "there are fewer than two setpoints", {name, 0, 0}));
  }
  return commanded;
}

}  // namespace toolpace
