#include "drawing/contour_scene.h"

#include <algorithm>
#include <cmath>

#include "drawing/tube_trace.h"
#include "models/instant.h"
#include "toolpace/pipeline/prove.h"
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

/// Of the job, or of G64 P in the program; none where moves differ in it.
std::optional<double> common_tolerance(const Outcome& outcome) {
  if (!leaves_programmed_path(outcome)) return 0.0;
  const Moves& moves = outcome.job->program->moves;
  std::optional<double> common;
  std::optional<std::uint16_t> mode;  // rows that follow each other nearly always share it
  for (std::uint32_t row = 0; row < moves.size(); ++row) {
    if (!is_motion(moves.kind[row]) || moves.mode[row] == mode) continue;
    mode = moves.mode[row];
    const double tolerance = corner_tolerance(moves, row, outcome.job->options.corner);
    if (common && *common != tolerance) return std::nullopt;
    common = tolerance;
  }
  return common;
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
  if (outcome->job && outcome->job->program) scene->tolerance = common_tolerance(*outcome);
  if (outcome->job) scene->travel = travel_box(outcome->job->machine);
  if (!outcome->path || outcome->path->node.empty()) return scene;
  scene->geometry = known && fits(*known, *outcome) ? std::move(known) : make_scene_geometry(*outcome);
  if (has_motion(*outcome)) {
    scene->colours = std::make_unique<const SceneColours>(*outcome, *scene->geometry, scene->trace.get());
  }
  return scene;
}

View opening_view(const ContourScene& scene, View wanted) {
  const View suited = suited_view(wanted, scene.geometry->box);
  if (!scene.outcome || !scene.outcome->job || !scene.outcome->job->program) return suited;
  const Reading& program = *scene.outcome->job->program;
  const bool for_lathes = program.dialect == Dialect::fanuc_lathe || program.dialect == Dialect::fanuc_lathe_b;
  const bool in_their_plane = std::all_of(program.moves.mode.begin(), program.moves.mode.end(),
                                          [&](std::uint16_t mode) { return program.moves.modes[mode].plane == 18; });
  return for_lathes || (suited == View::xz && in_their_plane && !program.moves.empty()) ? View::zx : suited;
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
