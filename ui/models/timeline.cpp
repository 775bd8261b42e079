#include "models/timeline.h"

#include <algorithm>
#include <cmath>

#include "toolpace/plan/plan.h"

namespace toolpace::ui {
Timeline::Timeline(std::shared_ptr<const Outcome> outcome) : outcome_(std::move(outcome)) {
  collect_lines();
  collect_rests();
  sum_losses();
}

/// 0 where it stands in another file.
std::uint32_t Timeline::line_of_row(std::uint32_t row) const {
  const auto& moves = outcome_->job->program->moves;
  return moves.file[row] == 0 ? moves.line[row] : 0;
}

/// What begins where the path comes to a node, in order: what it rests for there, then the block behind it.
std::vector<Timeline::Begin> Timeline::begins_at(std::size_t node) const {
  const auto& o = *outcome_;
  std::vector<Begin> begins;
  double time = o.node_time[node];
  auto pause = std::lower_bound(o.path->pauses.begin(), o.path->pauses.end(), node,
                                [](const Path::Pause& p, std::size_t n) { return p.node < n; });
  for (; pause != o.path->pauses.end() && pause->node == node; ++pause) {
    if (pause->duration > 0) begins.push_back({time, line_of_row(pause->move)});
    time += pause->duration;
  }
  if (node < o.path->size()) begins.push_back({time, line_of_row(o.path->move[node])});
  return begins;
}

void Timeline::collect_lines() {
  const auto& o = *outcome_;
  if (o.path->size() > 0) lines_.reserve(line_of_row(o.path->move.back()) + std::size_t{1});
  auto pause = o.path->pauses.begin();
  for (std::size_t i = 0; i < o.path->size(); ++i) {
    double departure = o.node_time[i];
    for (; pause != o.path->pauses.end() && pause->node <= i; ++pause) departure += pause->duration;
    const std::uint32_t line = line_of_row(o.path->move[i]);
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

void Timeline::collect_rests() {
  const auto& o = *outcome_;
  if (o.path->size() == 0) return;
  double begin = 0;
  std::size_t node = o.node_time.size();
  for (const Path::Pause& pause : o.path->pauses) {
    if (pause.node != node) begin = o.node_time[node = pause.node];
    const std::uint32_t line = line_of_row(pause.move);
    if (line > 0 && pause.duration > 0) {
      if (line >= lines_.size()) lines_.resize(line + 1);
      LineStats& stats = lines_[line];
      stats.begin = stats.begin < 0 ? begin : std::min(stats.begin, begin);
      stats.rest += pause.duration;
    }
    begin += pause.duration;
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
  std::optional<std::uint32_t> now;  // the line that runs
  for (std::size_t node = segment_at(outcome_->node_time, time); node <= outcome_->path->size(); ++node) {
    for (const Begin& begin : begins_at(node)) {
      if (now && begin.time > time && begin.line != *now) return begin.time;
      if (begin.time <= time || !now) now = begin.line;
    }
  }
  return duration();
}

double Timeline::previous_line(double time) const {
  if (outcome_->path->size() == 0) return 0;
  constexpr double kJustArrived = 1e-9;  // standing on a line's begin means: go to the one before
  std::optional<Begin> run;              // the beginning, as far as is known, of a line that was gone back through
  for (std::size_t node = segment_at(outcome_->node_time, time) + 2; node-- > 0;) {
    const auto begins = begins_at(node);
    for (auto begin = begins.rbegin(); begin != begins.rend(); ++begin) {
      if (begin->time > time + kJustArrived) continue;
      if (run && begin->line != run->line && run->time < time - kJustArrived) return run->time;
      run = *begin;
    }
  }
  return run ? run->time : 0;
}

}  // namespace toolpace::ui
