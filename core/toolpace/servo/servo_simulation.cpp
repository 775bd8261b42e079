#include "toolpace/servo/servo_simulation.h"

#include <algorithm>
#include <cmath>

#include "toolpace/base/metric.h"

namespace toolpace {
namespace {

constexpr double kSettled = 1e-3;        // [mm, deg]
constexpr double kLongestSettling = 10;  // [s]

}  // namespace

Result<ServoSimulation> ServoSimulation::create(const ServoMachine& machine, double period) {
  ServoSimulation simulation;
  simulation.period_ = period;
  for (const ServoAxis& axis : machine) {
    auto servo = AxisServo::create(axis, period);
    if (!servo) return tl::unexpected(servo.error());
    simulation.servos_.push_back(*servo);
    simulation.play_.push_back(axis.backlash);
  }
  return simulation;
}

void ServoSimulation::take(const Setpoints& chunk, ServoTrace& trace) {
  if (chunk.size() == 0) return;
  std::array<std::size_t, kAxisCount> begin = {};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto& commanded = chunk.position[axis];
    if (commanded.empty()) continue;
    if (!started_) {
      used_[axis] = true;
      servos_[axis].reset(commanded.front());
      last_[axis] = before_last_[axis] = commanded.front();
    }
    begin[axis] = trace.actual[axis].size();
    step_axis(axis, commanded, trace.actual[axis]);
  }
  started_ = true;
  for (std::size_t k = 0; k < chunk.size(); ++k) {
    AxisVector commanded = AxisVector::Zero(), actual = AxisVector::Zero();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (!used_[axis]) continue;
      const auto i = static_cast<Eigen::Index>(axis);
      commanded[i] = counted(axis, chunk.position[axis][k]);
      actual[i] = counted(axis, trace.actual[axis][begin[axis] + k]);
    }
    meter_.take(commanded, actual);
  }
  lines_.insert(lines_.end(), chunk.line.begin(), chunk.line.end());
  hand_out(false, trace);
}

void ServoSimulation::step_axis(std::size_t axis, const std::vector<double>& commanded, std::vector<double>& actual) {
  AxisServo& servo = servos_[axis];
  double before = before_last_[axis], last = last_[axis];
  for (const double next : commanded) {
    actual.push_back(servo.step(before, last, next));
    before = last;
    last = next;
  }
  before_last_[axis] = before;
  last_[axis] = last;
}

void ServoSimulation::hand_out(bool all, ServoTrace& trace) {
  rows_.clear();
  meter_.measure(all, rows_);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const auto [lag, contour] = rows_[k];
    trace.lag.push_back(lag);
    trace.contour_error.push_back(contour);
    sum_lag_ += lag * lag;
    sum_contour_ += contour * contour;
    summary_.max_lag = std::max(summary_.max_lag, lag);
    if (contour > summary_.max_contour_error) {
      summary_.max_contour_error = contour;
      summary_.worst_row = summary_.rows;
      if (k < lines_.size()) summary_.worst_line = lines_[k];
    }
    ++summary_.rows;
  }
  lines_.erase(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(std::min(rows_.size(), lines_.size())));
}

ServoSummary ServoSimulation::finish(ServoTrace& trace) {
  hand_out(true, trace);
  const double rows = std::max<double>(1.0, static_cast<double>(summary_.rows));
  summary_.rms_lag = std::sqrt(sum_lag_ / rows);
  summary_.rms_contour_error = std::sqrt(sum_contour_ / rows);
  summary_.worst_time = static_cast<double>(summary_.worst_row) * period_;
  summary_.settling_time = settle();
  return summary_;
}

double ServoSimulation::settle() {
  const auto periods = static_cast<std::size_t>(kLongestSettling / period_);
  std::size_t unsettled = 0;
  double play = 0.0;  // which the slide may keep for ever
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) play += used_[axis] ? counted(axis, play_[axis]) : 0.0;
  for (std::size_t k = 1; k <= periods; ++k) {
    double square = 0.0;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (!used_[axis]) continue;
      const double off = counted(axis, servos_[axis].step(before_last_[axis], last_[axis], last_[axis]) - last_[axis]);
      before_last_[axis] = last_[axis];
      square += off * off;
    }
    if (std::sqrt(square) > kSettled + play) unsettled = k;
  }
  return static_cast<double>(unsettled) * period_;
}

Result<ServoResult> simulate_servo(const Setpoints& setpoints, const ServoMachine& machine) {
  auto simulation = ServoSimulation::create(machine, setpoints.period);
  if (!simulation) return tl::unexpected(simulation.error());
  ServoResult result;
  simulation->take(setpoints, result.trace);
  result.summary = simulation->finish(result.trace);
  return result;
}

}  // namespace toolpace
