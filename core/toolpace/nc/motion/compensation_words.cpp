/// G40 … G42.1: which tool, which side.

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "toolpace/nc/motion/compensation.h"
#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/scaling.h"
#include "toolpace/nc/text/whole_number.h"
#include "toolpace/nc/tool_table.h"

namespace toolpace::nc {
namespace {

// The side that a lathe tool cuts on moves its controlled point to the corner of the square around its round nose.
Compensation::Origin origin_of(int orientation, double radius) {
  constexpr std::array<int, kHighestOrientation + 1> kOfX = {0, -1, -1, 1, 1, 0, -1, 0, 1, 0};
  constexpr std::array<int, kHighestOrientation + 1> kOfZ = {0, 1, -1, -1, 1, 1, 0, -1, 0, 0};
  const auto side = static_cast<std::size_t>(orientation);
  return {kOfX[side] * radius, kOfZ[side] * radius};
}

bool find_radius(Context& context, const Block& block, double& radius, int& orientation) {
  State& state = context.state;
  const Code code = block.code(GGroup::compensation);
  orientation = 0;
  if (code == 411 || code == 421) {
    if (!block.has('d')) {
      return context.faults.fail("compensation-without-d", fmt::format("{} without a diameter", code_text('G', code)),
                                 "give the diameter with D", block.column_of(GGroup::compensation));
    }
    if (block.of('l', 0.0) != 0.0 && state.modal.plane != 180) {
      return context.faults.fail("compensation-orientation", "a tool orientation L outside the XZ plane", "use G18",
                                 block.column_of('l'));
    }
    radius = length_of(state, block, 'd') / 2.0;
    const auto side = whole_number(block.of('l', 0.0), 0, kHighestOrientation);
    if (!side) {
      return context.faults.fail("compensation-orientation", fmt::format("L{:g} is no tool orientation", block.of('l')),
                                 "orientations go from 0 to 9", block.column_of('l'));
    }
    orientation = *side;
    return true;
  }
  Tool tool = state.loaded;
  if (block.has('d') && block.of('d') != 0.0) {
    const double number = block.of('d');
    const auto whole = whole_number(number, 0, kHighestTool);
    if (!whole && !context.rules.refuses_doubtful) {
      context.faults.warn("tool-number", fmt::format("D{:g} is no tool number; it is taken as the diameter", number),
                          "", block.column_of('d'));
      radius = length_of(state, block, 'd') / 2.0;
      return true;
    }
    if (!whole) {
      return context.faults.fail("tool-number", fmt::format("D{:g} is no tool number", number), "D takes a tool number",
                                 block.column_of('d'));
    }
    if (!find_tool(context, *whole, block.column_of('d'), tool)) return false;
  }
  miss_tool_table(context, tool.number, block.column_of(GGroup::compensation));
  radius = tool.diameter / 2.0;
  orientation = tool.orientation;
  return true;
}

void end_compensation(State& state) {
  Compensation& c = state.compensation;
  const bool moved = c.radius > 0.0 && !c.first_move_pending;
  const Position programmed = c.programmed;
  c = Compensation{};
  if (!moved) return;
  state.position = programmed;  // the next move starts beside it and ends on the contour
  c.arc_forbidden = true;
}

}  // namespace

bool set_compensation(Context& context, const Block& block) {
  State& state = context.state;
  const Code code = block.code(GGroup::compensation);
  const std::size_t column = block.column_of(GGroup::compensation);
  if (code == 400) {
    end_compensation(state);
    state.modal.compensation = 400;
    return true;
  }
  if (state.modal.compensation == code && !context.rules.refuses_doubtful) return true;
  if (state.modal.compensation != 400 && (context.rules.refuses_doubtful || state.compensation.radius > 0.0)) {
    return context.faults.fail("compensation-already-on", "cutter radius compensation is on already",
                               "end it with G40 first", column);
  }
  if (state.modal.plane == 190) {
    return context.faults.fail("compensation-plane", "cutter radius compensation in the YZ plane", "use G17 or G18",
                               column);
  }
  double radius = 0.0;
  int orientation = 0;
  if (!find_radius(context, block, radius, orientation)) return false;
  const PlaneAxes plane = plane_axes(state.modal.plane);
  if (!scales_evenly(state.offsets, plane)) {
    return context.faults.fail(
        "arc-scaled-unevenly",
        "cutter radius compensation in a plane that is scaled along one axis more than along the other",
        "scale both axes alike", column);
  }
  radius /= scale_of(state.offsets, plane.first);  // the tool does not grow
  const bool left = code == 410 || code == 411;
  const bool on_left = radius >= 0.0 ? left : !left;  // a negative radius changes sides
  state.modal.compensation = on_left ? 410 : 420;
  state.compensation = Compensation{};
  state.compensation.radius = std::fabs(radius);
  state.compensation.first_move_pending = state.compensation.radius > 0.0;
  if (state.modal.plane == 180) state.compensation.origin = origin_of(orientation, std::fabs(radius));
  return true;
}

}  // namespace toolpace::nc
