#include "preview/scene_builder.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "preview/motion_state.h"

namespace toolpace::ui {
namespace {

constexpr double kFineParts = 2000;  ///< a block below this part of the whole is not cut further
constexpr double kMostPieces = 1e6;  ///< beyond the blocks themselves
constexpr int kColourSteps = 48;     ///< cuts where the speed crosses its whole range
constexpr int kMostCuts = 256;       ///< of one phase in one block

constexpr auto index(ColourBy by) { return static_cast<std::size_t>(by); }

/// Pieces that keep a curve's chord error below a 16 000th of the whole: not seen before the view is enlarged 20 times.
int curve_cuts(const Path& path, std::size_t block, double share, double size) {
  if (path.kind[block] == SegmentKind::line) return 1;
  if (path.kind[block] != SegmentKind::arc) return std::max(1, static_cast<int>(std::ceil(16 * share)));
  const auto& arc = path.arcs[path.detail[block]];
  const double radius = std::max({arc.start_radius, arc.end_radius, 1e-300});
  const double step = 2 * std::acos(std::clamp(1 - size / 16000 / radius, 0.5, 1 - 1e-6));
  return std::max(1, static_cast<int>(std::min(std::ceil(arc.sweep * share / step), 4096.0)));
}

}  // namespace

SceneBuilder::SceneBuilder(const Outcome& outcome, ContourScene& scene)
    : outcome_(outcome), path_(*outcome.path), scene_(scene) {
  measure();
}

void SceneBuilder::measure() {
  Box box;
  for (const auto& node : path_.node) box.add(node.head<3>());
  for (const auto& arc : path_.arcs) {
    const double radius = std::max(arc.start_radius, arc.end_radius);
    box.add(arc.centre.array() - radius);
    box.add(arc.centre.array() + radius);
  }
  size_ = box.diagonal();
  scene_.centre = box.centre();
  const double length = std::accumulate(path_.length.begin(), path_.length.end(), 0.0);
  coarse_ = std::max(size_ / kFineParts, length / kMostPieces);

  style_of_block_.assign(path_.size(), static_cast<std::uint8_t>(PieceStyle::feed));
  if (!outcome_.job || !outcome_.job->program) return;
  const auto& kinds = outcome_.job->program->moves.kind;
  for (std::size_t i = 0; i < path_.size(); ++i) {
    if (path_.move[i] < kinds.size() && kinds[path_.move[i]] == MoveKind::rapid) {
      style_of_block_[i] = static_cast<std::uint8_t>(PieceStyle::rapid);
    }
  }
}

void SceneBuilder::begin_at(std::size_t node) {
  const Eigen::Vector3d point = path_.node[node].head<3>();
  scene_.line.vertex.push_back((point - scene_.centre).cast<float>());
  scene_.time.push_back(outcome_.node_time.empty() ? 0.0 : outcome_.node_time[node]);
  scene_.box.add(point);
}

void SceneBuilder::build_bare() {
  begin_at(0);
  for (std::size_t i = 0; i < path_.size(); ++i) {
    const int count = curve_cuts(path_, i, 1.0, size_);
    for (int k = 1; k <= count; ++k) {
      const Eigen::Vector3d point = k == count
                                        ? Eigen::Vector3d(path_.node[i + 1].head<3>())
                                        : Eigen::Vector3d(point_at(path_, i, path_.length[i] * k / count).head<3>());
      scene_.line.vertex.push_back((point - scene_.centre).cast<float>());
      scene_.line.style.push_back(style_of_block_[i]);
      scene_.time.push_back(0.0);
      scene_.block.push_back(static_cast<std::uint32_t>(i));
      scene_.box.add(point);
    }
  }
}

// Rapids are drawn without colour, so the scale belongs to the feeds; a program of rapids alone has it for itself.
void SceneBuilder::find_ranges() {
  auto& range = scene_.range;
  double speed = 0, acceleration = 0, jerk = 0;
  const auto rapid = static_cast<std::uint8_t>(PieceStyle::rapid);
  const bool only_rapids = std::find_if(style_of_block_.begin(), style_of_block_.end(),
                                        [&](std::uint8_t s) { return s != rapid; }) == style_of_block_.end();
  std::size_t block = 0;
  for (std::size_t i = 0; i < outcome_.plan.phases.size(); ++i) {
    const Phase& phase = outcome_.plan.phases[i];
    const double middle = phase.begin + phase.duration / 2;
    while (block + 1 < path_.size() && outcome_.node_time[block + 1] < middle) ++block;
    if (!only_rapids && style_of_block_[block] == rapid) continue;
    const PhaseBounds b = motion_bounds(outcome_.plan, i);
    speed = std::max(speed, b.speed.high);
    acceleration = std::max({acceleration, -b.acceleration.low, b.acceleration.high});
    jerk = std::max({jerk, -b.jerk.low, b.jerk.high});
  }
  range[index(ColourBy::speed)] = {0, speed};
  range[index(ColourBy::acceleration)] = {-acceleration, acceleration};
  range[index(ColourBy::jerk)] = {-jerk, jerk};
  range[index(ColourBy::limit)] = {0, 255};
  if (scene_.trace) {
    const auto& errors = scene_.trace->error;
    range[index(ColourBy::contour_error)] = {0, errors.empty() ? 0.0 : *std::max_element(errors.begin(), errors.end())};
  }
}

void SceneBuilder::build_planned() {
  find_ranges();
  scene_.line.categorical = index(ColourBy::limit);
  scene_.line.vertex.reserve(path_.size() + 1);
  scene_.time.reserve(path_.size() + 1);
  begin_at(0);
  const auto& phases = outcome_.plan.phases;
  for (std::size_t i = 0; i < path_.size(); ++i) {
    double departure = outcome_.node_time[i];
    // Pauses at the node come first: phases that go nowhere.
    while (phase_ + 1 < phases.size()) {
      const Phase& p = phases[phase_];
      const bool rests = p.speed == 0 && p.acceleration == 0 && p.rate == 0;
      if (!rests && p.begin + p.duration > departure) break;
      departure = std::max(departure, std::min(p.begin + p.duration, outcome_.node_time[i + 1]));
      ++phase_;
    }
    path_.length[i] <= coarse_ ? add_small_block(i, departure) : add_block(i, departure);
    distance_ += path_.length[i];
  }
  finish();
}

PhaseState SceneBuilder::state_at(const Phase& phase, double time) const {
  if (!outcome_.plan.splines.empty()) return motion_at(outcome_.plan, time);
  return evaluate(phase, std::clamp(time - phase.begin, 0.0, phase.duration));
}

void SceneBuilder::add_small_block(std::size_t block, double departure) {
  const auto& phases = outcome_.plan.phases;
  const double arrival = outcome_.node_time[block + 1], duration = arrival - departure;
  const Stretch whole{block, departure, arrival, distance_, distance_ + path_.length[block]};
  const auto advance = [&](double time) {
    while (phase_ + 1 < phases.size() && phases[phase_ + 1].begin <= time) ++phase_;
    return state_at(phases[phase_], time);
  };
  const PhaseState begin = advance(departure), middle = advance((departure + arrival) / 2), end = advance(arrival);
  PhaseState mean = middle;
  if (duration > 0) {
    mean.speed = path_.length[block] / duration;
    mean.acceleration = (end.speed - begin.speed) / duration;
  }
  add_piece(whole, path_.node[block + 1].head<3>(), mean);
}

void SceneBuilder::add_block(std::size_t block, double departure) {
  const auto& phases = outcome_.plan.phases;
  const double arrival = outcome_.node_time[block + 1];
  const double exit = distance_ + path_.length[block];
  double time = departure, distance = distance_;
  while (time < arrival) {
    while (phase_ + 1 < phases.size() && phases[phase_].begin + phases[phase_].duration <= time) ++phase_;
    const Phase& p = phases[phase_];
    double until = std::min(p.begin + p.duration, arrival);
    if (phase_ + 1 >= phases.size() || until <= time) until = arrival;
    const double reached =
        until >= arrival ? exit : std::clamp(evaluate(p, std::max(until - p.begin, 0.0)).distance, distance, exit);
    if (reached > distance || until >= arrival) add_stretch(p, {block, time, until, distance, reached});
    time = until;
    distance = reached;
  }
  if (distance < exit) add_piece({block, time, arrival, distance, exit}, path_.node[block + 1].head<3>(), {});
}

int SceneBuilder::cuts(const Phase& phase, const Stretch& s) const {
  const double length = s.exit - s.entry;
  const double share = path_.length[s.block] > 0 ? length / path_.length[s.block] : 1.0;
  int count = curve_cuts(path_, s.block, share, size_);
  if (phase.rate != 0 || phase.acceleration != 0) {
    const double top = scene_.range[index(ColourBy::speed)].high;
    const double v0 = evaluate(phase, std::clamp(s.begin - phase.begin, 0.0, phase.duration)).speed;
    const double v1 = evaluate(phase, std::clamp(s.end - phase.begin, 0.0, phase.duration)).speed;
    const int by_colour = top > 0 ? static_cast<int>(std::ceil(std::abs(v1 - v0) / top * kColourSteps)) : 1;
    const int by_length = static_cast<int>(std::min(std::ceil(length / coarse_), double{kMostCuts}));
    count = std::max(count, std::clamp(std::max(by_colour, 6), 1, std::max(by_length, 1)));
  }
  return std::max(count, 1);
}

void SceneBuilder::add_stretch(const Phase& phase, const Stretch& s) {
  const int count = cuts(phase, s);
  const double start = distance_;
  Stretch piece{s.block, s.begin, s.begin, s.entry, s.entry};
  const auto state = [&](double time) { return evaluate(phase, std::clamp(time - phase.begin, 0.0, phase.duration)); };
  for (int k = 1; k <= count; ++k) {
    piece.begin = piece.end;
    piece.entry = piece.exit;
    const bool last = k == count;
    piece.end = last ? s.end : s.begin + (s.end - s.begin) * k / count;
    piece.exit = last ? s.exit : std::clamp(state(piece.end).distance, piece.entry, s.exit);
    const double along = piece.exit - start;
    const bool at_node = along >= path_.length[s.block];
    const Eigen::Vector3d to = at_node ? Eigen::Vector3d(path_.node[s.block + 1].head<3>())
                                       : Eigen::Vector3d(point_at(path_, s.block, along).head<3>());
    add_piece(piece, to, state_at(phase, (piece.begin + piece.end) / 2));
  }
}

void SceneBuilder::add_piece(const Stretch& s, const Eigen::Vector3d& on_path, const PhaseState& mean) {
  Eigen::Vector3d to = on_path;
  if (const TimeSpline* spline = spline_at(outcome_.plan, s.end)) {
    to = evaluate(*spline, std::clamp(s.end - spline->begin, 0.0, spline->duration())).position.head<3>();
  }
  scene_.line.vertex.push_back((to - scene_.centre).cast<float>());
  scene_.box.add(to);
  scene_.time.push_back(s.end);
  scene_.block.push_back(static_cast<std::uint32_t>(s.block));
  scene_.line.style.push_back(style_of_block_[s.block]);
  auto& level = scene_.line.level;
  level[index(ColourBy::speed)].push_back(level_of(ColourBy::speed, mean.speed));
  level[index(ColourBy::acceleration)].push_back(level_of(ColourBy::acceleration, mean.acceleration));
  level[index(ColourBy::jerk)].push_back(level_of(ColourBy::jerk, mean.jerk));
  if (!outcome_.restraints.empty()) level[index(ColourBy::limit)].push_back(cause_at((s.begin + s.end) / 2));
  if (scene_.trace) {
    level[index(ColourBy::contour_error)].push_back(level_of(ColourBy::contour_error, error_over(s.begin, s.end)));
  }
}

std::uint8_t SceneBuilder::level_of(ColourBy by, double value) const {
  const Interval& range = scene_.range[index(by)];
  const double width = range.high - range.low;
  if (!(width > 0) || !std::isfinite(width)) return by == ColourBy::speed ? 255 : 128;
  return static_cast<std::uint8_t>(std::lround(std::clamp((value - range.low) / width, 0.0, 1.0) * 255));
}

std::uint8_t SceneBuilder::cause_at(double time) {
  const auto& list = outcome_.restraints;
  while (restraint_ + 1 < list.size() && list[restraint_].end <= time) ++restraint_;
  return static_cast<std::uint8_t>(list[restraint_].cause);
}

// The worst one inside a piece: a mean would hide the peak at a corner.
double SceneBuilder::error_over(double begin, double end) {
  const auto& trace = *scene_.trace;
  while (sample_ + 1 < trace.time.size() && trace.time[sample_ + 1] <= begin) ++sample_;
  double worst = trace.error[sample_];
  for (std::size_t i = sample_ + 1; i < trace.time.size() && trace.time[i] <= end; ++i) {
    worst = std::max<double>(worst, trace.error[i]);
  }
  return worst;
}

void SceneBuilder::finish() {
  for (std::size_t i = 1; i < scene_.time.size(); ++i) scene_.time[i] = std::max(scene_.time[i], scene_.time[i - 1]);
}

}  // namespace toolpace::ui
