#pragma once
/// A plan with look-up by time, by NC line and by block.

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "models/instant.h"

namespace toolpace::ui {

/// What the program asked of a line and what the plan made of it.
struct LineStats {
  double length = 0;      ///< [mm; deg where only rotary axes move]
  double time = 0;        ///< as planned, without dwells [s]
  double asked_time = 0;  ///< at the programmed feed all along [s]; equals `time` where no feed was programmed
  double rest = 0;        ///< stands still for it: dwell, tool change [s]
  double begin = -1;      ///< when the line begins [s]; < 0: it neither moves nor rests

  double loss() const { return time - asked_time; }
  double mean_speed() const { return time > 0 ? length / time : 0; }
  double asked_speed() const { return asked_time > 0 ? length / asked_time : 0; }
};

/// Immutable; built by a worker, shared with the window.
class Timeline {
 public:
  explicit Timeline(std::shared_ptr<const Outcome> outcome);

  const std::shared_ptr<const Outcome>& outcome() const { return outcome_; }
  double duration() const { return outcome_->plan.cycle_time(); }

  Instant at(double time) const { return instant_at(*outcome_, time).value_or(Instant{}); }
  /// When a line begins to move or to rest, or the next line that does; nothing after the last.
  std::optional<double> time_of_line(std::uint32_t line) const;
  /// Begin of the next (or previous) NC line that moves or rests, as seen from `time`.
  double next_line(double time) const;
  double previous_line(double time) const;

  /// Indexed by NC line, counted from 1 (entry 0 is unused).
  const std::vector<LineStats>& lines() const { return lines_; }
  /// What all lines lose together [s], how many do, and the most that one loses [s].
  double total_loss() const { return total_loss_; }
  std::size_t losing_lines() const { return losing_lines_; }
  double worst_loss() const { return worst_loss_; }
  /// The lines that lose most, worst first: at most kWorstLines. Sorted when first asked for, from any thread.
  static constexpr std::size_t kWorstLines = 10'000;
  const std::vector<std::uint32_t>& worst_lines() const;

 private:
  struct Begin {
    double time;
    std::uint32_t line;
  };
  std::uint32_t line_of_row(std::uint32_t row) const;
  std::vector<Begin> begins_at(std::size_t node) const;
  void collect_rests();
  void collect_lines();
  void sum_losses();

  std::shared_ptr<const Outcome> outcome_;
  std::vector<LineStats> lines_;
  double total_loss_ = 0, worst_loss_ = 0;
  std::size_t losing_lines_ = 0;
  mutable std::once_flag sorted_;
  mutable std::vector<std::uint32_t> worst_lines_;
};

}  // namespace toolpace::ui
