#include "drawing/scene_colours.h"

#include <algorithm>
#include <cmath>

#include "drawing/cause_style.h"
#include "toolpace/plan/restraint.h"
#include "toolpace/sample/motion.h"

namespace toolpace::ui {
namespace {

constexpr auto index(ColourBy by) { return static_cast<std::size_t>(by); }

}  // namespace

SceneColours::SceneColours(const Outcome& outcome, const SceneGeometry& geometry, const ErrorTrace* trace)
    : outcome_(outcome), geometry_(geometry), trace_(trace) {}

bool SceneColours::has(ColourBy by) const {
  if (outcome_.plan.phases.empty() || outcome_.node_time.size() != outcome_.path->node.size()) return false;
  if (by == ColourBy::limit) return !outcome_.restraints.empty();
  return by != ColourBy::contour_error || trace_ != nullptr;
}

std::array<Interval, kColourings> SceneColours::find_ranges() const {
  std::array<Interval, kColourings> range = {};
  range[index(ColourBy::limit)] = {0, 255};
  if (!has(ColourBy::speed)) return range;
  double speed = 0, acceleration = 0, jerk = 0;
  const auto& moves = outcome_.path->move;
  const auto* kinds = outcome_.job && outcome_.job->program ? &outcome_.job->program->moves.kind : nullptr;
  const auto is_rapid = [&](std::size_t block) { return kinds && (*kinds)[moves[block]] == MoveKind::rapid; };
  std::size_t feeds = 0;
  while (feeds < moves.size() && is_rapid(feeds)) ++feeds;
  const bool only_rapids = feeds == moves.size();
  Motion motion(*outcome_.path, outcome_.plan);
  for (std::size_t block = 0; block < moves.size(); ++block) {
    if (!only_rapids && is_rapid(block)) continue;
    const PhaseBounds b = motion.bounds(outcome_.node_time[block], outcome_.node_time[block + 1]);
    speed = std::max(speed, b.speed.high);
    acceleration = std::max({acceleration, -b.acceleration.low, b.acceleration.high});
    jerk = std::max({jerk, -b.jerk.low, b.jerk.high});
  }
  range[index(ColourBy::speed)] = {0, speed};
  range[index(ColourBy::acceleration)] = {-acceleration, acceleration};
  range[index(ColourBy::jerk)] = {-jerk, jerk};
  if (trace_ && !trace_->error.empty()) {
    range[index(ColourBy::contour_error)] = {0, *std::max_element(trace_->error.begin(), trace_->error.end())};
  }
  return range;
}

Interval SceneColours::range(ColourBy by) const {
  const std::scoped_lock lock(mutex_);
  if (!ranges_) ranges_ = find_ranges();
  return (*ranges_)[index(by)];
}

std::uint8_t SceneColours::scaled(ColourBy by, double value) const {
  const Interval& range = (*ranges_)[index(by)];
  const double width = range.high - range.low;
  if (!(width > 0) || !std::isfinite(width)) return by == ColourBy::speed ? 255 : 128;
  return static_cast<std::uint8_t>(std::clamp((value - range.low) / width, 0.0, 1.0) * 255 + 0.5);
}

const std::vector<std::uint8_t>& SceneColours::shades(ColourBy by, std::size_t level) const {
  const std::scoped_lock lock(mutex_);
  auto& made = shades_[index(by)];
  if (const auto found = made.find(level); found != made.end()) return found->second;
  (void)range(by);
  const LodLevel& lod = geometry_.lod.levels[level];
  if (lod.is_full()) return made[level] = make_full(by);
  const Shades& full = shades(by);
  return made[level] = by == ColourBy::limit ? merged_majorities(geometry_.line, lod, full)
                                             : merged_means(geometry_.line, lod, full);
}

double SceneColours::time_at(std::size_t block, double share) const {
  const double arrival = outcome_.node_time[block + 1];
  if (share >= 1) return arrival;
  const double position = outcome_.path->position[block] + share * outcome_.path->length[block];
  const double time = Motion(*outcome_.path, outcome_.plan).time_at(position);
  return std::clamp(time, outcome_.node_time[block], arrival);
}

Stretch SceneColours::stretch(std::size_t piece, double from, double to) const {
  const std::size_t block = geometry_.block_of(piece);
  const double before = geometry_.share_before(piece), after = geometry_.share_after(piece);
  const double length = outcome_.path->length[block] * (after - before) * (to - from);
  if (!geometry_.time.empty()) {
    const double begin = geometry_.time[piece], lasting = geometry_.time[piece + 1] - begin;
    return {begin + from * lasting, begin + to * lasting, length};
  }
  return {time_at(block, before + (after - before) * from), time_at(block, before + (after - before) * to), length};
}

std::uint8_t SceneColours::shade(ColourBy by, const Stretch& s) const {
  const std::scoped_lock lock(mutex_);
  (void)range(by);
  const double middle = (s.begin + s.end) / 2;
  const PhaseState state = Motion(*outcome_.path, outcome_.plan).at(middle).along();
  switch (by) {
    case ColourBy::speed: return scaled(by, state.speed);
    case ColourBy::acceleration: return scaled(by, state.acceleration);
    case ColourBy::jerk: return scaled(by, state.jerk);
    case ColourBy::contour_error: return scaled(by, worst_error(s.begin, s.end));
    case ColourBy::limit: break;
  }
  const Restraint* restraint = restraint_at(outcome_.restraints, middle);
  return static_cast<std::uint8_t>(index_of(restraint ? restraint->cause : outcome_.restraints.front().cause));
}

double SceneColours::worst_error(double begin, double end) const {
  const auto& time = trace_->time;
  auto i = static_cast<std::size_t>(
      std::max<std::ptrdiff_t>(std::upper_bound(time.begin(), time.end(), begin) - time.begin() - 1, 0));
  double worst = trace_->error[i];
  for (++i; i < time.size() && time[i] <= end; ++i) worst = std::max<double>(worst, trace_->error[i]);
  return worst;
}

SceneColours::Shades SceneColours::make_full(ColourBy by) const {
  Shades shades(geometry_.line.pieces());
  Motion motion(*outcome_.path, outcome_.plan);
  const auto& list = outcome_.restraints;
  const auto& pauses = outcome_.path->pauses;
  std::size_t restraint = 0, pause = 0;
  double begin = outcome_.node_time.front(), speed = 0;
  const bool on_path = geometry_.time.empty();
  const auto end_of = [&](std::size_t piece, std::size_t block) {
    if (!on_path) return geometry_.time[piece + 1];
    const double share = geometry_.share_after(piece), arrival = outcome_.node_time[block + 1];
    if (share >= 1) return arrival;
    return std::clamp(motion.time_at(outcome_.path->position[block] + share * outcome_.path->length[block]),
                      outcome_.node_time[block], arrival);
  };
  for (std::size_t i = 0; i < shades.size(); ++i) {
    const std::size_t block = geometry_.block_of(i);
    for (; on_path && pause < pauses.size() && pauses[pause].node <= block; ++pause) begin += pauses[pause].duration;
    const double end = end_of(i, block), lasting = end - begin, length = outcome_.path->length[block];
    switch (by) {
      case ColourBy::speed: {
        const double way = length * (geometry_.share_after(i) - geometry_.share_before(i));
        shades[i] = scaled(by, on_path && lasting > 0 ? way / lasting : motion.at((begin + end) / 2).along().speed);
        break;
      }
      case ColourBy::acceleration: {
        const double exit = motion.at(end).along().speed;
        shades[i] = scaled(by, lasting > 0 ? (exit - speed) / lasting : 0.0);
        speed = exit;
        break;
      }
      case ColourBy::jerk: shades[i] = scaled(by, motion.at((begin + end) / 2).along().jerk); break;
      case ColourBy::limit:
        while (restraint + 1 < list.size() && list[restraint].end <= (begin + end) / 2) ++restraint;
        shades[i] = static_cast<std::uint8_t>(index_of(list[restraint].cause));
        break;
      case ColourBy::contour_error: shades[i] = scaled(by, worst_error(begin, end)); break;
    }
    begin = std::max(begin, end);
  }
  return shades;
}

}  // namespace toolpace::ui
