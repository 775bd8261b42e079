#pragma once
/// Sums of a prediction, while blocks are run one after the other.

#include "toolpace/controller/prediction.h"
#include "toolpace/controller/trapezoid.h"

namespace toolpace::detail::controller {

/// What one block adds to a prediction.
class Tally {
 public:
  Tally(std::size_t rows, const PredictOptions& options) : keeps_motion_(options.keeps_motion) {
    if (options.keeps_blocks) result_.row_time.assign(rows, 0.0);
  }

  /// @param cruise  what holds the nominal speed down
  /// @param end     what the block slows down for
  void add_block(const Trapezoid& t, std::size_t row, bool is_rapid, TimeLimit cruise, TimeLimit end) {
    ++result_.blocks;
    row_ = row;
    add_stage(TimeLimit::acceleration, t.up, t.entry, t.peak);
    add_stage(cruise, t.cruise, t.peak, t.peak);
    add_stage(end, t.down, t.peak, t.exit);
    (is_rapid ? result_.rapid_time : result_.feed_time) += t.total();
    if (!result_.row_time.empty()) result_.row_time[row] += t.total();
  }

  void add_dwell(double time, std::size_t row) {
    row_ = row;
    add(TimeLimit::dwell, time);
    result_.dwell_time += time;
    if (!result_.row_time.empty()) result_.row_time[row] += time;
  }

  /// Time of a block that is counted apart.
  void add_time(TimeLimit limit, double time, std::size_t row, bool is_rapid) {
    count(limit, time);
    (is_rapid ? result_.rapid_time : result_.feed_time) += time;
    if (!result_.row_time.empty()) result_.row_time[row] += time;
  }
  void count_block() { ++result_.blocks; }

  /// Time at rest that belongs to no block.
  void add(TimeLimit limit, double time) { add_stage(limit, time, 0.0, 0.0); }

  /// What the last of the motion does not need after all.
  void take_back(double time) {
    count(TimeLimit::stops, -time);
    auto& stages = result_.stages;
    for (; !stages.empty() && time > 0; stages.pop_back()) {
      Stage& last = stages.back();
      if (last.duration > time) {
        last.to -= (last.to - last.from) * time / last.duration;
        last.duration -= time;
        return;
      }
      time -= last.duration;
    }
  }
  void take_back(double time, bool was_rapid) {
    (was_rapid ? result_.rapid_time : result_.feed_time) -= time;
    take_back(time);
  }

  void warn(Diagnostic diagnostic) { result_.warnings.push_back(std::move(diagnostic)); }

  Prediction finish(Controller controller) {
    result_.controller = controller;
    result_.cycle_time = 0;
    for (const double time : result_.time_by_limit) result_.cycle_time += time;
    return std::move(result_);
  }

 private:
  void count(TimeLimit limit, double time) { result_.time_by_limit[static_cast<std::size_t>(limit)] += time; }

  void add_stage(TimeLimit limit, double time, double from, double to) {
    count(limit, time);
    if (keeps_motion_ && time > 0) result_.stages.push_back({time, from, to, static_cast<std::uint32_t>(row_), limit});
  }

  Prediction result_;
  bool keeps_motion_;
  std::size_t row_ = 0;  // of the last block
};

}  // namespace toolpace::detail::controller
