#include "toolpace/nc/tool_tip.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "toolpace/base/axis_unit.h"
#include "toolpace/kinematics/inverse.h"
#include "toolpace/nc/text/whole_number.h"
#include "toolpace/nc/tool_table.h"

namespace toolpace::nc {
namespace {

constexpr double kHalfTurn = std::numbers::pi * (1 + 1e-9);

Position in_mm_and_degrees(const AxisVector& v) {
  Position p;
  for (std::size_t i = 0; i < kAxisCount; ++i) p[i] = v[static_cast<Eigen::Index>(i)] / axis_unit(i).size;
  return p;
}

/// From here on about another chain. The machine stays where it is, and so does what the program knows of it.
void change_chain(Context& context, const Chain& chain) {
  State& state = context.state;
  const AxisVector before = machine_vector(state.offsets, state.position);
  const AxisVector now = told_about(chain, state.tip.chain, before);
  state.offsets.tool_length = Position{};
  state.tip.chain = chain;
  state.position = to_work(state.offsets, in_mm_and_degrees(now));
  context.out.set_chain(chain);
}

bool has_chain(Context& context, const std::string& what, std::size_t column) {
  if (!context.state.tip.kinematics.chain.is_identity()) return true;
  return context.faults.fail("kinematics-missing",
                             what + " is about the tool's tip, but how the rotary axes carry it is not known",
                             "name a machine file with [kinematics] by --machine", column);
}

bool tell_missing_length(Context& context, const std::string& what, std::size_t column) {
  return context.faults.fail("tool-length-missing", what + " needs the length of the tool, which a head swings",
                             "add tool_mm to [kinematics]", column);
}

/// The length by H, or of the tool in the spindle. @return false (with a fault)
bool find_length(Context& context, const Block& block, double& length) {
  State& state = context.state;
  const Kinematics& kinematics = state.tip.kinematics;
  int number = state.loaded.number;
  Tool tool = state.loaded;
  if (block.has('h')) {
    const auto given = whole_number(block.of('h'), 0, kHighestTool);
    if (!given) {
      return context.faults.fail("tool-number", fmt::format("H{:g} is no tool", block.of('h')),
                                 "H is a whole number from 0", block.column_of('h'));
    }
    number = *given;
    if (!kinematics.tells_tool_length && number != 0 && !find_tool(context, number, block.column_of('h'), tool))
      return false;
  }
  length = kinematics.chain.tool_length;
  if (kinematics.tells_tool_length) return true;
  length = tool.offset[2];
  const bool is_known = state.has_tool_table || state.tools.count(number) > 0;
  if (is_known || !kinematics.chain.swings_tool()) return true;
  const std::size_t column = block.column_of(GGroup::tool_length);
  return tell_missing_length(context, code_text('G', block.code(GGroup::tool_length)), column);
}

}  // namespace

bool begin_tip(Context& context, const Block& block) {
  State& state = context.state;
  const Code code = block.code(GGroup::tool_length);
  Chain chain = state.tip.kinematics.chain;
  if (!has_chain(context, code_text('G', code), block.column_of(GGroup::tool_length))) return false;
  if (!find_length(context, block, chain.tool_length)) return false;
  change_chain(context, chain);
  state.tip.by_vector = code == kTipByVector;
  state.modal.tool_length = code;
  return true;
}

void end_tip(Context& context) {
  TipState& tip = context.state.tip;
  tip.by_vector = false;
  if (!tip.is_on() || tip.everywhere) return;
  change_chain(context, {});
}

bool begin_tip_everywhere(Context& context) {
  TipState& tip = context.state.tip;
  if (!has_chain(context, "--tcp", 0)) return false;
  if (!tip.kinematics.tells_tool_length && tip.kinematics.chain.swings_tool() && !context.state.has_tool_table)
    return tell_missing_length(context, "--tcp", 0);
  tip.everywhere = true;
  change_chain(context, tip.kinematics.chain);
  context.out.set_mode(context.state.modal);
  return true;
}

void take_tip_length(Context& context, double length) {
  TipState& tip = context.state.tip;
  tip.by_vector = false;
  if (tip.kinematics.tells_tool_length || tip.chain.tool_length == length) return;
  Chain chain = tip.chain;
  chain.tool_length = length;
  change_chain(context, chain);
}

bool points_tool(const Context& context, const Block& block) {
  return context.state.tip.by_vector && block.has_any(kCentreBits);
}

bool point_tool(Context& context, const Block& block, Position& end) {
  const State& state = context.state;
  constexpr std::array<char, 3> kLetters = {'i', 'j', 'k'};
  Eigen::Vector3d tool = Eigen::Vector3d::Zero();
  std::size_t column = 0;
  for (std::size_t i = 0; i < kLetters.size(); ++i) {
    if (!block.has(kLetters[i])) continue;
    tool[static_cast<Eigen::Index>(i)] = block.of(kLetters[i]);
    if (column == 0) column = block.column_of(kLetters[i]);
  }
  if (block.has_any(kRotaryBits)) {
    return context.faults.fail("tool-vector-with-angles", "I J K of G43.5 beside rotary axes",
                               "give the tool's direction or the axes, not both", column);
  }
  if (!(tool.norm() > 0)) {
    return context.faults.fail("tool-vector-zero", "I J K of G43.5 give the tool no direction",
                               "give the direction from its tip to the spindle, such as K1", column);
  }
  const AxisVector near = machine_vector(state.offsets, state.position);
  const auto ways = rotary_solutions(state.tip.chain, tool, near, state.tip.travel);
  if (!ways) {
    const bool by_travel = ways.error().code == "rotary-travel";
    return context.faults.fail(by_travel ? "rotary-travel" : "tool-direction-unreachable", ways.error().message,
                               ways.error().remedy, column);
  }
  AxisVector machine = machine_vector(state.offsets, end);
  machine.tail<3>() = ways->front().tail<3>();
  const Position there = to_work(state.offsets, in_mm_and_degrees(machine));
  for (std::size_t i = 3; i < kAxisCount; ++i) {
    const double turn = ways->front()[static_cast<Eigen::Index>(i)] - near[static_cast<Eigen::Index>(i)];
    if (turn != 0) end[i] = there[i];
    if (std::fabs(turn) <= kHalfTurn) continue;
    context.faults.warn("rotary-unwinds",
                        fmt::format("{} turns by {:.6g} deg in this block: the nearer way lies beyond its travel",
                                    kAxisNames[i], turn / kRadiansPerDegree),
                        "retract before, or give the axis more travel", column);
  }
  return true;
}

bool refuse_under_tip(Context& context, const Block& block) {
  const TipState& tip = context.state.tip;
  const Code code = block.code(GGroup::once);
  const bool is_of_machine =
      code == 530 || code == 280 || code == 300 || code == kToReference || code == kFromReference;
  if (!tip.is_on() || tip.everywhere || !is_of_machine) return true;
  return context.faults.fail("machine-coordinates-under-tip",
                             fmt::format("{} while the program is about the tool's tip", code_text('G', code)),
                             "end G43.4 or G43.5 with G49 first", block.column_of(GGroup::once));
}

}  // namespace toolpace::nc
