#include "toolpace/io/setpoint_table.h"

#include <algorithm>
#include <cmath>

#include "toolpace/base/axis_unit.h"

namespace toolpace {
namespace {

constexpr double kNanosecondsPerSecond = 1e9;
constexpr double kWholeTolerance = 1e-9;  // of a nanosecond count: far above the rounding of ms -> s, far below one
constexpr double kExactIntegers = 9007199254740992.0;  // 2^53

constexpr std::array<char, kAxisCount> kLetters = {'x', 'y', 'z', 'a', 'b', 'c'};

Error table_error(const char* code, std::string message) {
  return {ErrorKind::input, code, std::move(message), "", {}, {}};
}

bool all_finite(const double* values, std::size_t count) {
  // A sum of products with zero is NaN exactly where a value is not finite; it vectorises, isfinite in a loop does not.
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) sum += values[k] * 0.0;
  return sum == 0.0;
}

}  // namespace

RowClock::RowClock(double period) : period_(period), nanoseconds_(0) {
  const double count = period * kNanosecondsPerSecond;
  const double whole = std::round(count);
  if (whole >= 1 && whole < kExactIntegers && std::abs(count - whole) <= kWholeTolerance * whole) {
    nanoseconds_ = static_cast<std::uint64_t>(whole);
  }
}

double RowClock::time(std::uint64_t row) const {
  const double exact = static_cast<double>(row) * static_cast<double>(nanoseconds_);
  if (nanoseconds_ != 0 && exact < kExactIntegers) return exact / kNanosecondsPerSecond;
  return static_cast<double>(row) * period_;
}

Result<void> SetpointTable::load(const Setpoints& chunk) {
  if (!started_) {
    decide_columns(chunk);
    next_row_ = chunk.first_row;
    period_ = chunk.period;
    started_ = true;
  }
  if (auto fine = check(chunk); !fine) return fine;
  fill(chunk);
  // Asked of what the file shows: degrees and derivatives of finite positions may be none.
  if (!std::all_of(columns_.begin(), columns_.end(), [this](const double* c) { return all_finite(c, rows_); })) {
    return tl::unexpected(table_error("setpoint-not-finite", "a setpoint is not a finite number"));
  }
  next_row_ += chunk.size();
  return {};
}

void SetpointTable::decide_columns(const Setpoints& chunk) {
  bool rotary = false;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    given_[axis] = !chunk.position[axis].empty();
    rotary |= is_rotary(axis) && given_[axis];
  }
  const std::size_t count = rotary ? kAxisCount : 3;
  names_ = {"t_s"};
  for (std::size_t axis = 0; axis < count; ++axis) {
    axes_.push_back(axis);
    names_.push_back(std::string(1, kLetters[axis]) + "_" + axis_unit(axis).key[0]);
  }
  names_.insert(names_.end(), {"v_mm_s", "a_mm_s2", "j_mm_s3"});
  rotary_.resize(count);
  for (std::size_t order = 0; axis_derivatives_ && order < 3; ++order) {
    derivatives_[order].resize(count);
    for (const std::size_t axis : axes_) {
      names_.push_back(std::string(1, "vaj"[order]) + "_" + kLetters[axis] + "_" + axis_unit(axis).key[order + 1]);
    }
  }
  if (tip_of_) names_.insert(names_.end(), {"tip_x_mm", "tip_y_mm", "tip_z_mm"});
}

Result<void> SetpointTable::check(const Setpoints& chunk) const {
  const std::size_t n = chunk.size();
  bool fits = chunk.acceleration.size() == n && chunk.jerk.size() == n && chunk.line.size() == n;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    fits &= given_[axis] ? chunk.position[axis].size() == n : chunk.position[axis].empty();
  }
  if (!fits) return tl::unexpected(table_error("setpoint-columns", "the columns of a chunk of setpoints do not match"));
  if (chunk.first_row != next_row_ || chunk.period != period_) {
    return tl::unexpected(table_error("setpoint-rows", "a chunk of setpoints does not follow the one before"));
  }
  return {};
}

void SetpointTable::fill(const Setpoints& chunk) {
  rows_ = chunk.size();
  lines_ = chunk.line.data();
  columns_.clear();
  const RowClock clock(period_);
  time_.resize(rows_);
  for (std::size_t k = 0; k < rows_; ++k) time_[k] = clock.time(next_row_ + k);
  columns_.push_back(time_.data());
  for (std::size_t slot = 0; slot < axes_.size(); ++slot) {
    const std::size_t axis = axes_[slot];
    const auto& position = chunk.position[axis];
    if (!is_rotary(axis) && given_[axis]) {
      columns_.push_back(position.data());
      continue;
    }
    rotary_[slot].assign(rows_, 0.0);
    if (given_[axis]) {
      std::transform(position.begin(), position.end(), rotary_[slot].begin(),
                     [](double p) { return p / kRadiansPerDegree; });
    }
    columns_.push_back(rotary_[slot].data());
  }
  columns_.insert(columns_.end(), {chunk.speed.data(), chunk.acceleration.data(), chunk.jerk.data()});
  for (std::size_t slot = 0; axis_derivatives_ && slot < axes_.size(); ++slot) differentiate(slot, columns_[1 + slot]);
  for (const auto& order : derivatives_) {
    for (const auto& column : order) columns_.push_back(column.data());
  }
  if (tip_of_) find_tip(chunk);
}

void SetpointTable::find_tip(const Setpoints& chunk) {
  for (auto& column : tip_) column.resize(rows_);
  Chain chain = *tip_of_;
  for (std::size_t k = 0; k < rows_; ++k) {
    AxisVector axes = AxisVector::Zero();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (given_[axis]) axes[static_cast<Eigen::Index>(axis)] = chunk.position[axis][k];
    }
    if (!chunk.tool_length.empty()) chain.tool_length = chunk.tool_length[k];
    const Eigen::Vector3d tip = forward(chain, axes).tip;
    for (std::size_t i = 0; i < tip_.size(); ++i) tip_[i][k] = tip[static_cast<Eigen::Index>(i)];
  }
  for (const auto& column : tip_) columns_.push_back(column.data());
}

void SetpointTable::differentiate(std::size_t slot, const double* position) {
  for (auto& order : derivatives_) order[slot].resize(rows_);
  if (rows_ == 0) return;
  if (last_.size() <= slot) last_.push_back({position[0], 0.0, 0.0});
  auto [p, v, a] = last_[slot];
  for (std::size_t k = 0; k < rows_; ++k) {
    const double speed = (position[k] - p) / period_;
    const double acceleration = (speed - v) / period_;
    derivatives_[0][slot][k] = speed;
    derivatives_[1][slot][k] = acceleration;
    derivatives_[2][slot][k] = (acceleration - a) / period_;
    p = position[k];
    v = speed;
    a = acceleration;
  }
  last_[slot] = {p, v, a};
}

}  // namespace toolpace
