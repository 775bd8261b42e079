#pragma once
/// A ring of blocks in which each may speed up as far as the rest of the ring lets it stop: grbl, grblHAL, Marlin.

#include <array>
#include <optional>
#include <vector>

#include "toolpace/controller/link.h"
#include "toolpace/controller/step_timer.h"
#include "toolpace/controller/tally.h"

namespace toolpace::detail::controller {

/// A straight block, ready to be planned.
struct Block {
  double length;        ///< [mm] > 0
  double nominal2;      ///< square of the nominal speed [mm²/s²]
  double acceleration;  ///< [mm/s²] > 0
  double start2;        ///< square of the highest speed at its start [mm²/s²]
  std::uint32_t row;
  bool is_rapid;
  bool starts_at_corner;  ///< start2 is a corner's, and not a lower nominal speed's
  TimeLimit cruise;       ///< what holds the nominal speed down
  double steps_a_mm = 0;  ///< of the axis with the most steps, for the timer of steps
  double rest2 = 0;       ///< square of the speed with which it may begin from rest and end there [mm²/s²]
  double arrival = 0;     ///< [s]
};

/// How the last block of a motion was run.
struct LastBlock {
  Block block;
  double entry2 = 0;
  Trapezoid times;
};

class WindowPlanner {
 public:
  /// @param depth  blocks that the ring holds, the running one among them
  /// @param clock  [Hz] of the timer of steps; 0 = one that does not round
  WindowPlanner(std::size_t depth, Tally& tally, const PredictOptions& options, std::size_t receive_room,
                double clock = 0)
      : ring_(depth), tally_(tally), timer_(clock), block_time_(options.block_time.value_or(0.0)) {
    if (options.baud) link_.emplace(*options.baud / 10.0, receive_room);
  }

  /// A line of the program comes.
  void receive(std::size_t bytes) {
    if (!link_) return;
    read_ = std::max({link_->receive(bytes), read_, freed_});
    link_->set_read(read_);
  }

  /// Takes a block into the ring, and runs what has to leave it for that.
  void add(Block block) {
    while (count_ == ring_.size()) run_first(false);
    if (link_ || block_time_ > 0) {
      read_ = std::max(read_, freed_) + block_time_;
      block.arrival = read_;
      if (link_) link_->set_read(read_);
    }
    at(count_++) = block;
    if (count_ == ring_.size()) run_first(false);
  }

  bool is_empty() const { return count_ == 0; }

  /// Runs all that is there, to rest. What was read meanwhile waited.
  void finish() {
    while (count_ > 0) run_first(true);
    entry2_ = 0;
  }

  /// Rest that belongs to no block.
  void wait(double time) {
    now_ += time;
    freed_ = now_;
    segments_.fill(now_);
  }

  bool has_moved() const { return has_moved_; }
  const LastBlock& last() const { return last_; }

 private:
  static constexpr double kSegmentTime = 0.01;      // [s]
  static constexpr std::size_t kSegmentsAhead = 4;  // prepared besides the one that runs

  struct Exit {
    double speed2;
    TimeLimit why;
  };

  std::size_t place(std::size_t k) const {
    const std::size_t i = first_ + k;
    return i < ring_.size() ? i : i - ring_.size();
  }
  Block& at(std::size_t k) { return ring_[place(k)]; }
  const Block& at(std::size_t k) const { return ring_[place(k)]; }

  /// How many blocks have come at a time; the first one has.
  std::size_t arrived(double time) {
    std::size_t n = 1;
    while (n < count_ && at(n).arrival <= time) ++n;
    return n;
  }

  /// The speed at the end of the first block from which the first `n` can be brought to rest.
  Exit exit_of(std::size_t n, TimeLimit end) {
    if (n == 1) return {at(0).rest2, end};
    Exit exit{at(1).start2, corner_or_not(at(1))};
    double way = 0;
    for (std::size_t k = 1; k < n; ++k) {
      const Block& block = at(k);
      way += 2.0 * block.acceleration * block.length;
      const bool is_end = k + 1 == n;
      const double bound = way + (is_end ? block.rest2 : at(k + 1).start2);
      if (bound < exit.speed2) exit = {bound, is_end ? end : corner_or_not(at(k + 1))};
      if (way >= exit.speed2) break;
    }
    return exit;
  }

  static TimeLimit corner_or_not(const Block& block) {
    return block.starts_at_corner ? TimeLimit::corner : TimeLimit::acceleration;
  }

  void run_first(bool to_rest) {
    const Block block = at(0);
    entry2_ = std::max(entry2_, block.rest2);
    if (block.arrival > now_) {
      if (has_moved_) tally_.add(TimeLimit::link, block.arrival - now_);
      now_ = block.arrival;
    }
    const TimeLimit end = to_rest ? TimeLimit::stops : TimeLimit::buffer;
    const bool may_starve = link_ || block_time_ > 0;
    std::size_t n = may_starve ? arrived(prepared_at(0, kSegmentTime)) : count_;
    Exit exit = exit_of(n, n < count_ ? TimeLimit::link : end);
    Trapezoid t = times(block, exit);
    // A block that comes before the steps of slowing down were prepared lets the running one go on.
    while (n < count_) {
      const std::size_t later = std::max(n, arrived(prepared_at(t.up + t.cruise, segment_time(block, t))));
      if (later == n) break;
      n = later;
      exit = exit_of(n, n < count_ ? TimeLimit::link : end);
      t = times(block, exit);
    }
    last_ = {block, entry2_, t};
    timer_.stretch(t, std::sqrt(entry2_), std::sqrt(exit.speed2), block.steps_a_mm);
    if (may_starve) note_segments(t.total(), segment_time(block, t));
    tally_.add_block(t, block.row, block.is_rapid, block.cruise, exit.why);
    now_ += t.total();
    entry2_ = exit.speed2;
    has_moved_ = true;
    first_ = first_ + 1 == ring_.size() ? 0 : first_ + 1;
    --count_;
  }

  /// A segment of steps lasts 10 ms, or as long as its least number of steps takes. @source grbl 1.1, st_prep_buffer()
  static double segment_time(const Block& block, const Trapezoid& t) {
    constexpr double kLeastSteps = 1.25;
    const double most = std::max(1.0, std::ceil(block.length * block.steps_a_mm / kLeastSteps) - 1.0);
    return std::max(kSegmentTime, t.total() / most);
  }

  /// When the steps of the first block were prepared that are made `time` after its start: steppers hold a few segments, each
  /// of one block.
  double prepared_at(double time, double segment) const {
    const auto k = static_cast<std::size_t>(time / segment);
    if (k >= kSegmentsAhead) return now_ + static_cast<double>(k - kSegmentsAhead) * segment;
    return std::max(at(0).arrival, segments_[k]);
  }

  void note_segments(double time, double segment) {
    const auto count = static_cast<std::size_t>(std::ceil(time / segment * (1.0 - 1e-9)));
    freed_ = std::max(freed_, prepared_at(time, segment));
    for (std::size_t k = count > kSegmentsAhead ? count - kSegmentsAhead : 0; k < count; ++k) {
      for (std::size_t i = 1; i < kSegmentsAhead; ++i) segments_[i - 1] = segments_[i];
      segments_.back() = now_ + static_cast<double>(k) * segment;
    }
  }

  Trapezoid times(const Block& block, Exit& exit) const {
    const double reach2 = entry2_ + 2.0 * block.acceleration * block.length;
    if (exit.speed2 > reach2) exit = {reach2, TimeLimit::acceleration};
    exit.speed2 = std::min(exit.speed2, block.nominal2);
    return trapezoid(std::min(entry2_, block.nominal2), exit.speed2, block.nominal2, block.acceleration, block.length);
  }

  std::vector<Block> ring_;
  std::size_t first_ = 0, count_ = 0;
  Tally& tally_;
  StepTimer timer_;
  std::optional<Link> link_;
  double block_time_;
  double now_ = 0;   ///< [s] when the first block of the ring can begin
  double read_ = 0;  ///< [s] when the line before was read
  double entry2_ = 0;
  double freed_ = 0;  ///< [s] when the last block left the ring: its steps were prepared
  std::array<double, kSegmentsAhead> segments_ = {};  ///< [s] starts of the last segments
  bool has_moved_ = false;
  LastBlock last_ = {};
};

}  // namespace toolpace::detail::controller
