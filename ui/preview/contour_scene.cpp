#include "preview/contour_scene.h"

#include <algorithm>
#include <cmath>

#include "preview/motion_state.h"
#include "toolpace/path/path.h"

namespace toolpace::ui {
namespace {

std::optional<Box> travel_box(const Machine& machine) {
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& limits = machine.axes[static_cast<std::size_t>(axis)];
    if (!std::isfinite(limits.travel_min) || !std::isfinite(limits.travel_max)) return std::nullopt;
    box.low[axis] = limits.travel_min;
    box.high[axis] = limits.travel_max;
  }
  return box;
}

bool has_plan(const Outcome& outcome) {
  return outcome.path && outcome.path->size() > 0 && !outcome.plan.phases.empty() &&
         outcome.node_time.size() == outcome.path->node.size();
}

}  // namespace

std::shared_ptr<const ContourScene> make_contour_scene(std::shared_ptr<const Outcome> outcome,
                                                       std::shared_ptr<const ErrorTrace> trace,
                                                       std::shared_ptr<const SceneGeometry> known) {
  auto scene = std::make_shared<ContourScene>();
  if (trace && trace->time.empty()) trace = nullptr;
  scene->outcome = outcome;
  scene->trace = trace;
  if (!outcome) return scene;
  if (outcome->job) scene->travel = travel_box(outcome->job->machine);
  if (!outcome->path || outcome->path->node.empty()) return scene;
  scene->geometry = known && fits(*known, *outcome) ? std::move(known) : make_scene_geometry(*outcome);
  if (has_plan(*outcome)) {
    scene->colours = std::make_unique<const SceneColours>(*outcome, *scene->geometry, scene->trace.get());
  }
  return scene;
}

std::optional<PathPlace> place_at(const Outcome& outcome, double time) {
  if (!has_plan(outcome)) return std::nullopt;
  PathPlace place;
  place.time = std::clamp(std::isfinite(time) ? time : 0.0, 0.0, outcome.plan.cycle_time());
  place.state = motion_at(outcome.plan, place.time);
  const auto& arrival = outcome.node_time;
  place.block = block_at(outcome, place.time);
  const Path& path = *outcome.path;
  // Distance from the block's start: the plan knows how far it had come when it arrived there.
  const double start_distance = motion_at(outcome.plan, arrival[place.block]).distance;
  place.along = std::clamp(place.state.distance - start_distance, 0.0, path.length[place.block]);
  place.point = point_at(path, place.block, place.along).head<3>();
  if (const TimeSpline* spline = spline_at(outcome.plan, place.time)) {
    place.point = evaluate(*spline, std::clamp(place.time - spline->begin, 0.0, spline->duration())).position.head<3>();
  }
  if (outcome.job && outcome.job->program) {
    const Moves& moves = outcome.job->program->moves;
    if (path.move[place.block] < moves.line.size()) place.line = moves.line[path.move[place.block]];
  }
  return place;
}

std::optional<Cause> cause_at(const Outcome& outcome, double time) {
  const auto& list = outcome.restraints;
  const auto after =
      std::upper_bound(list.begin(), list.end(), time, [](double t, const Restraint& r) { return t < r.begin; });
  if (after == list.begin()) return std::nullopt;
  return std::prev(after)->cause;
}

std::optional<std::pair<double, double>> time_of_line(const Outcome& outcome, std::uint32_t line, double time) {
  if (!has_plan(outcome) || !outcome.job || !outcome.job->program) return std::nullopt;
  const Moves& moves = outcome.job->program->moves;
  const Path& path = *outcome.path;
  const auto belongs = [&](std::size_t block) {
    const std::uint32_t row = path.move[block];
    return row < moves.line.size() && moves.line[row] == line && (row >= moves.file.size() || moves.file[row] == 0);
  };
  std::size_t first = block_at(outcome, time);
  if (belongs(first)) {
    while (first > 0 && path.move[first - 1] == path.move[first]) --first;
  } else {
    for (first = 0; first < path.size() && !belongs(first);) ++first;
  }
  if (first == path.size()) return std::nullopt;
  std::size_t last = first;
  while (last + 1 < path.size() && path.move[last + 1] == path.move[first]) ++last;
  return std::pair{outcome.node_time[first], outcome.node_time[last + 1]};
}

}  // namespace toolpace::ui
