#include "toolpace/nc/motion/hole_patterns.h"

#include <fmt/format.h>

#include <cmath>

#include "toolpace/nc/block_words.h"
#include "toolpace/nc/motion/cycle_fault.h"
#include "toolpace/nc/motion/cycles.h"
#include "toolpace/nc/motion/end_point.h"
#include "toolpace/nc/text/whole_number.h"

namespace toolpace::nc {
namespace {

constexpr int kMostHoles = 100000;

}  // namespace

bool run_hole_pattern(Context& context, const Block& block, Code code) {
  const State& state = context.state;
  const auto refuse = [&](const char* fault, std::string what, const char* remedy) {
    return context.faults.fail(fault, std::move(what), remedy, block.column_of(GGroup::once));
  };
  if (!is_cycle(state.modal.motion)) {
    return refuse("pattern-without-cycle", code_text('G', code) + " while no cycle is on",
                  "give the cycle before, with L0 where it shall not drill, such as G81 Z-5. R1. F50. L0");
  }
  const auto count = whole_number(block.of('l', 0.0), 1, kMostHoles);
  if (!count || !block.has('i') || (code == kHolesOnArc && !block.has('k'))) {
    return refuse("pattern-words", fmt::format("{} without its words", code_text('G', code)),
                  "G70 I J L: circle; G71 I J K L: arc; G72 I J L: line; I radius or distance, J angle, L holes");
  }
  Position centre;
  if (!find_end(context, block, centre)) return false;
  const PlaneAxes plane = plane_axes(state.modal.plane);
  const double size = length_of(state, block, 'i'), first = block.of('j', 0.0);
  const double step = code == kHolesOnArc ? block.of('k') : 360.0 / *count;
  std::vector<Position> places;
  for (int i = 0; i < *count; ++i) {
    const bool on_line = code == kHolesOnLine;
    const double angle = (on_line ? first : first + i * step) * kRadiansPerDegree;
    const double away = on_line ? size * i : size;
    Position& place = places.emplace_back(centre);
    place[plane.first] += away * std::cos(angle);
    place[plane.second] += away * std::sin(angle);
  }
  return run_cycle_at(context, state.modal.motion, places);
}

}  // namespace toolpace::nc
