#include "models/timeline.h"

#include <algorithm>
#include <cmath>

#include "toolpace/plan/plan.h"

namespace toolpace::ui {
Timeline::Timeline(std::shared_ptr<const Outcome> outcome) : outcome_(std::move(outcome)) {
  collect_lines();
  sum_losses();
}

std::uint32_t Timeline::line_of_block(std::size_t block) const {
  const auto& moves = outcome_->job->program->moves;
  const std::uint32_t row = outcome_->path->move[block];
  return moves.file[row] == 0 ? moves.line[row] : 0;
}

void Timeline::collect_lines() {
  const auto& o = *outcome_;
  if (o.path->size() > 0) lines_.reserve(line_of_block(o.path->size() - 1) + std::size_t{1});
  auto pause = o.path->pauses.begin();
  for (std::size_t i = 0; i < o.path->size(); ++i) {
    double departure = o.node_time[i];
    for (; pause != o.path->pauses.end() && pause->node <= i; ++pause) departure += pause->duration;
    const std::uint32_t line = line_of_block(i);
    if (line == 0) continue;
    if (line >= lines_.size()) lines_.resize(line + 1);
    auto& stats = lines_[line];
    const double time = std::max(o.node_time[i + 1] - departure, 0.0);
    if (stats.begin < 0) stats.begin = departure;
    stats.length += o.path->length[i];
    const double feed = (*o.commands)[i].feed;
    const bool asked = feed > 0 && std::isfinite(feed);
    stats.time += time;
    stats.asked_time += asked ? std::min(time, o.path->length[i] / feed) : time;
  }
}

void Timeline::sum_losses() {
  for (const LineStats& stats : lines_) {
    const double loss = stats.loss();
    if (!(loss > 0)) continue;
    ++losing_lines_;
    total_loss_ += loss;
    worst_loss_ = std::max(worst_loss_, loss);
  }
}

const std::vector<std::uint32_t>& Timeline::worst_lines() const {
  std::call_once(sorted_, [this] {
    worst_lines_.reserve(losing_lines_);
    for (std::uint32_t line = 1; line < lines_.size(); ++line) {
      if (lines_[line].loss() > 0) worst_lines_.push_back(line);
    }
    const auto count = static_cast<std::ptrdiff_t>(std::min(worst_lines_.size(), kWorstLines));
    std::partial_sort(worst_lines_.begin(), worst_lines_.begin() + count, worst_lines_.end(), [this](auto a, auto b) {
      const double first = lines_[a].loss(), second = lines_[b].loss();
      return first > second || (first == second && a < b);
    });
    worst_lines_.resize(static_cast<std::size_t>(count));
    worst_lines_.shrink_to_fit();
  });
  return worst_lines_;
}

std::optional<double> Timeline::time_of_line(std::uint32_t line) const {
  for (std::size_t i = std::max(line, 1u); i < lines_.size(); ++i) {
    if (lines_[i].begin >= 0) return lines_[i].begin;
  }
  return std::nullopt;
}

double Timeline::next_line(double time) const {
  if (outcome_->path->size() == 0) return 0;
  const std::size_t block = segment_at(outcome_->node_time, time);
  const std::uint32_t line = line_of_block(block);
  for (std::size_t i = block + 1; i < outcome_->path->size(); ++i) {
    if (line_of_block(i) != line) return outcome_->node_time[i];
  }
  return duration();
}

double Timeline::previous_line(double time) const {
  if (outcome_->path->size() == 0) return 0;
  std::size_t block = segment_at(outcome_->node_time, time);
  const auto begin_of = [this](std::size_t i) {
    const std::uint32_t line = line_of_block(i);
    while (i > 0 && line_of_block(i - 1) == line) --i;
    return i;
  };
  block = begin_of(block);
  constexpr double kJustArrived = 1e-9;  // standing on a line's begin means: go to the one before
  if (time <= outcome_->node_time[block] + kJustArrived && block > 0) block = begin_of(block - 1);
  return outcome_->node_time[block];
}

}  // namespace toolpace::ui
