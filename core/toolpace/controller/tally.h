#pragma once
/// Sums of a prediction, while blocks are run one after the other.

#include "toolpace/controller/prediction.h"
#include "toolpace/controller/trapezoid.h"

namespace toolpace::detail::controller {

/// What one block adds to a prediction.
class Tally {
 public:
  Tally(std::size_t rows, const PredictOptions& options) {
    if (options.keeps_blocks) result_.row_time.assign(rows, 0.0);
  }

  /// @param cruise  what holds the nominal speed down
  /// @param end     what the block slows down for
  void add_block(const Trapezoid& t, std::size_t row, bool is_rapid, TimeLimit cruise, TimeLimit end) {
    ++result_.blocks;
    add(TimeLimit::acceleration, t.up);
    add(cruise, t.cruise);
    add(end, t.down);
    (is_rapid ? result_.rapid_time : result_.feed_time) += t.total();
    if (!result_.row_time.empty()) result_.row_time[row] += t.total();
  }

  void add_dwell(double time, std::size_t row) {
    add(TimeLimit::dwell, time);
    result_.dwell_time += time;
    if (!result_.row_time.empty()) result_.row_time[row] += time;
  }

  /// Time of a block that is counted apart.
  void add_time(TimeLimit limit, double time, std::size_t row, bool is_rapid) {
    add(limit, time);
    (is_rapid ? result_.rapid_time : result_.feed_time) += time;
    if (!result_.row_time.empty()) result_.row_time[row] += time;
  }
  void count_block() { ++result_.blocks; }

  /// Time that belongs to no block.
  void add(TimeLimit limit, double time) { result_.time_by_limit[static_cast<std::size_t>(limit)] += time; }

  /// What the last block does not need after all.
  void take_back(double time, bool was_rapid) {
    (was_rapid ? result_.rapid_time : result_.feed_time) -= time;
    add(TimeLimit::stops, -time);
  }

  void warn(Diagnostic diagnostic) { result_.warnings.push_back(std::move(diagnostic)); }

  Prediction finish(Controller controller) {
    result_.controller = controller;
    result_.cycle_time = 0;
    for (const double time : result_.time_by_limit) result_.cycle_time += time;
    return std::move(result_);
  }

 private:
  Prediction result_;
};

}  // namespace toolpace::detail::controller
