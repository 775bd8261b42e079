#include "toolpace/nc/motion/circular_pocket.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "toolpace/nc/motion/arcs.h"
#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/text/whole_number.h"
#include "toolpace/nc/tool_table.h"

namespace toolpace::nc {
namespace {

constexpr int kMostPocketPasses = 10000;
constexpr double kMostCircles = 10000.0;
constexpr double kNoRadius = 1e-6;  // [mm]

struct Pocket {
  double first = 0.0, last = 0.0, step = 0.0;  // radii of the tool's centre [mm]
  int turn = 1;                                // + counter-clockwise
  int passes = 1;
};

class PocketMill {
 public:
  PocketMill(Context& context, const Block& block, const Pocket& pocket, const Position& centre)
      : context_(context), block_(block), pocket_(pocket), centre_(centre) {}

  // Out to the first circle, round, out by steps, and back to the middle.
  bool mill_level() {
    double radius = pocket_.first;
    if (!go_out(radius) || !go_round(radius)) return false;
    while (radius < pocket_.last - kNoRadius && !context_.out.is_full()) {
      radius = std::min(radius + pocket_.step, pocket_.last);
      if (!go_straight(context_, block_, 10, at(radius, 0.0)) || !go_round(radius)) return false;
    }
    return go_back(radius);
  }

 private:
  Position at(double x, double y) const {
    Position p = context_.state.position;
    p[0] = centre_[0] + x;
    p[1] = centre_[1] + y;
    return p;
  }
  bool go_along_arc(const Position& end, double centre_x) {
    const Position& from = context_.state.position;
    const PlaneArc arc{{from[0], from[1]}, {end[0], end[1]}, {centre_[0] + centre_x, centre_[1]}, pocket_.turn};
    return go_around(context_, block_, arc, end);
  }
  bool go_round(double radius) { return go_along_arc(at(radius, 0.0), 0.0); }
  bool go_out(double radius) {
    return context_.rules.pockets_straight ? go_straight(context_, block_, 10, at(radius, 0.0))
                                           : go_along_arc(at(radius, 0.0), radius / 2.0);
  }
  bool go_back(double radius) {
    return context_.rules.pockets_straight ? go_straight(context_, block_, 10, at(0.0, 0.0))
                                           : go_along_arc(at(0.0, 0.0), radius / 2.0);
  }

  Context& context_;
  const Block& block_;
  const Pocket& pocket_;
  Position centre_;
};

bool find_tool_radius(Context& context, const Block& block, double& radius) {
  radius = 0.0;
  const double number = block.of('d', 0.0);
  if (number == 0.0) return true;
  const auto whole = whole_number(number, 1, kHighestTool);
  const auto tool = whole ? context.state.tools.find(*whole) : context.state.tools.end();
  if (tool == context.state.tools.end() && std::exchange(context.state.pocket_told, true)) return true;
  if (tool == context.state.tools.end()) {
    context.faults.warn(
        "pocket-tool-unknown",
        fmt::format("the radius of tool D{:g} is not known: its centre goes round the pocket itself", number),
        "give a tool table with --tools", block.column_of('d'));
    return true;
  }
  radius = tool->second.diameter / 2.0;
  return true;
}

bool read_pocket(Context& context, const Block& block, Code code, Pocket& pocket) {
  const State& state = context.state;
  const auto refuse = [&](const char* fault, std::string what, const char* remedy, char letter) {
    return context.faults.fail(
        fault, std::move(what), remedy,
        letter != '\0' && block.has(letter) ? block.column_of(letter) : block.column_of(GGroup::once));
  };
  const std::string name = code_text('G', code);
  if (state.modal.plane != 170) return refuse("pocket-plane", name + " outside the XY plane", "use G17", '\0');
  if (state.compensation.radius > 0.0)
    return refuse("cycle-with-compensation", name + " while cutter radius compensation is on", "end it with G40 first",
                  '\0');
  double tool = 0.0;
  if (!find_tool_radius(context, block, tool)) return false;
  const bool grows = block.has('k') && block.has('q');
  pocket.turn = code == kPocketLeft ? 1 : -1;
  pocket.first = std::fabs(length_of(state, block, block.has('i') ? 'i' : 'k')) - tool;
  pocket.last = block.has('k') ? std::fabs(length_of(state, block, 'k')) - tool : pocket.first;
  pocket.step = grows ? std::fabs(length_of(state, block, 'q')) : pocket.last - pocket.first;
  if (!block.has_any(word_bit('i') | word_bit('k')) || !(pocket.first > kNoRadius) || pocket.last < pocket.first ||
      (pocket.last > pocket.first && !((pocket.last - pocket.first) / pocket.step <= kMostCircles))) {
    return refuse(
        "pocket-words", name + " without a circle that the tool fits into",
        "give its radius with I; of growing circles the first radius with I, the last with K, the step with Q", 'i');
  }
  const auto passes = whole_number(block.of('l', 1.0), 1, kMostPocketPasses);
  if (!passes)
    return refuse("cycle-repeats", fmt::format("{:g} passes of a pocket", block.of('l')),
                  "L is a whole number from 1 to 10000", 'l');
  pocket.passes = *passes;
  return true;
}

}  // namespace

bool mill_circular_pocket(Context& context, const Block& block, Code code) {
  State& state = context.state;
  Pocket pocket;
  Position end;
  if (!read_pocket(context, block, code, pocket) || !find_end(context, block, end)) return false;
  Position centre = end;
  centre[2] = state.position[2];
  if (block.has_any(word_bit('x') | word_bit('y')) && !go_straight(context, block, 0, centre)) return false;
  const double deeper = state.modal.incremental() ? end[2] - state.position[2] : 0.0;
  for (int pass = 0; pass < pocket.passes && !context.out.is_full(); ++pass) {
    Position down = state.position;
    down[2] = end[2] + pass * deeper;
    if (block.has('z') && !go_straight(context, block, 10, down)) return false;
    if (!PocketMill(context, block, pocket, centre).mill_level()) return false;
  }
  return true;
}

}  // namespace toolpace::nc
