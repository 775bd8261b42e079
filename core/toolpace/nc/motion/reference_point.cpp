#include "toolpace/nc/motion/reference_point.h"

#include "toolpace/nc/motion/end_point.h"
#include "toolpace/nc/tool_table.h"

namespace toolpace::nc {
namespace {

bool may_leave_contour(Context& context, const Block& block) {
  if (context.state.compensation.radius <= 0.0) return true;
  return context.faults.fail("offset-with-compensation", "going home while cutter radius compensation is on",
                             "end it with G40 first", block.column_of(GGroup::once));
}

void go_fast(Context& context, const Position& to) {
  context.out.line(MoveKind::rapid, context.state.offsets, to);
  context.state.position = to;
}

}  // namespace

bool go_home(Context& context, const Block& block, int stored) {
  State& state = context.state;
  if (!may_leave_contour(context, block)) return false;
  Position way;
  if (!find_end(context, block, way)) return false;
  state.way_home = way;
  const Position home = load_position(context.parameters, stored);
  Position machine = to_machine(state.offsets, way);
  bool names_axes = false;
  for (std::size_t i = 0; i < kAxisCount; ++i) names_axes = names_axes || names_axis(context, block, i);
  if (names_axes) context.out.line(MoveKind::rapid, state.offsets, way);
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (!names_axes || names_axis(context, block, i)) machine[i] = home[i];
  }
  go_fast(context, to_work(state.offsets, machine));
  return true;
}

void store_home(Context& context, int stored) {
  store_position(context.parameters, stored, to_machine(context.state.offsets, context.state.position));
}

bool go_to_reference(Context& context, const Block& block) {
  Position end;
  if (!may_leave_contour(context, block) || !find_end(context, block, end)) return false;
  go_fast(context, end);
  return true;
}

bool leave_reference(Context& context, const Block& block) {
  State& state = context.state;
  if (!may_leave_contour(context, block)) return false;
  // G91 counts from the point on the way.
  Position way = state.position;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (state.way_home && names_axis(context, block, i)) way[i] = (*state.way_home)[i];
  }
  go_fast(context, way);
  Position end;
  if (!find_end(context, block, end)) return false;
  go_fast(context, end);
  return true;
}

bool change_tool_on_the_way(Context& context, const Block& block) {
  if (!block.has('t')) {
    context.faults.warn("g-code-machine", "G100 is defined by the machine; it is taken to move nothing", "",
                        block.column_of(GGroup::once));
    return true;
  }
  Position end;
  if (!may_leave_contour(context, block) || !change_tool(context, block) || !find_end(context, block, end))
    return false;
  Position above = end;
  above[2] = context.state.position[2];
  go_fast(context, above);
  go_fast(context, end);
  return true;
}

}  // namespace toolpace::nc
