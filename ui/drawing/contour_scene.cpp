#include "drawing/contour_scene.h"

#include <algorithm>
#include <cmath>

#include "models/instant.h"
#include "toolpace/plan/plan.h"

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
  if (has_motion(*outcome)) {
    scene->colours = std::make_unique<const SceneColours>(*outcome, *scene->geometry, scene->trace.get());
  }
  return scene;
}

std::optional<std::pair<double, double>> time_of_line(const Outcome& outcome, std::uint32_t line, double time) {
  if (!has_motion(outcome) || !outcome.job || !outcome.job->program) return std::nullopt;
  const Moves& moves = outcome.job->program->moves;
  const Path& path = *outcome.path;
  const auto belongs = [&](std::size_t block) {
    const std::uint32_t row = path.move[block];
    return row < moves.line.size() && moves.line[row] == line && (row >= moves.file.size() || moves.file[row] == 0);
  };
  std::size_t first = segment_at(outcome.node_time, time);
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
