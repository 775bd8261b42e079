#include "toolpace/nc/motion/lathe_cycles.h"

#include <fmt/format.h>

#include <cmath>

#include "toolpace/nc/motion/arcs.h"
#include "toolpace/nc/motion/cycle_fault.h"
#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/text/whole_number.h"

namespace toolpace::nc {
namespace {

constexpr int kHighestContour = 999'999'999;
constexpr int kMostFinishingPasses = 1000;

bool check_modes(Context& context, const Block& block, const std::string& name) {
  const Modal& modal = context.state.modal;
  if (modal.plane != 180) return fail(context, block, "lathe-plane", name + " outside the XZ plane", "use G18");
  if (modal.compensation != 400 && block.code(GGroup::motion) != 700) {
    return fail(context, block, "lathe-compensation", name + " while cutter radius compensation is on",
                "end it with G40; G70 alone finishes with it");
  }
  if (block.code(GGroup::once) == 530)
    return fail(context, block, "g53-with-cycle", "G53 with " + name, "go there before with G53 G0");
  return true;
}

bool read_contour_number(Context& context, const Block& block, LatheCycle& cycle, const std::string& name) {
  const auto number = block.has('q') ? whole_number(block.of('q'), 0, kHighestContour) : std::nullopt;
  if (!number) {
    return fail(context, block, "lathe-words", name + " without the number of a contour",
                "name the sub-program of the contour with Q: Q100 for O100 sub", 'q');
  }
  cycle.contour = *number;
  return true;
}

bool read_roughing(Context& context, const Block& block, LatheCycle& cycle, const std::string& name) {
  const double unit = context.state.modal.unit();
  Roughing& roughing = cycle.roughing;
  roughing.part = static_cast<RoughingPart>(cycle.code % 10);
  roughing.step = block.of('i', 1.0) * unit;
  roughing.retract = block.of('r', 0.5) * unit;
  cycle.shift = Point{block.of('w', 0.0), block.of('u', 0.0)} * unit;
  if (!(roughing.step > 0.0))
    return fail(context, block, "lathe-words", name + " without a positive I", "I is the depth of a pass", 'i');
  if (!(roughing.retract >= 0.0))
    return fail(context, block, "lathe-words", "R of " + name + " is below 0", "R is the way back from the work", 'r');
  return true;
}

bool read_finishing(Context& context, const Block& block, LatheCycle& cycle) {
  cycle.last_allowance = block.of('e', 0.0) * context.state.modal.unit();
  const auto passes = whole_number(block.of('p', 1.0), 1, kMostFinishingPasses);
  if (!passes)
    return fail(context, block, "lathe-words", "P of G70 is no number of passes", "P is a whole number from 1 to 1000",
                'p');
  cycle.passes = *passes;
  return true;
}

// Writes the moves of a cycle.
class LatheRun {
 public:
  LatheRun(Context& context, const Block& block, const LatheProfile& profile)
      : context_(context), block_(block), profile_(profile) {}

  bool go(Code code, Point to) {
    context_.state.modal.motion = code;
    return go_straight(context_, block_, code, at(profile_.in_machine(to)));
  }

  bool go_along(const OffsetElement& e) {
    return follow({e.turn == 0 ? MoveKind::feed : MoveKind::arc, e.end, e.centre, e.turn});
  }

  bool follow(const LatheMove& move) {
    if (move.kind != MoveKind::arc) return go(move.kind == MoveKind::rapid ? Code{0} : Code{10}, move.end);
    const Position& from = programmed_position(context_.state);
    const Point end = profile_.in_machine(move.end), centre = profile_.in_machine(move.centre);
    const PlaneArc arc{{from[2], from[0]}, {end.x, end.y}, {centre.x, centre.y}, profile_.turn_in_machine(move.turn)};
    context_.state.modal.motion = arc.turns > 0 ? 30 : 20;
    return go_around(context_, block_, arc, at(end));
  }

  /// A rapid beside compensation, which begins anew behind it.
  bool approach(Point to) {
    Compensation& c = context_.state.compensation;
    const double radius = std::exchange(c.radius, 0.0);
    const bool good = go(0, to);
    c.radius = radius;
    c.first_move_pending = radius > 0.0;
    c.has_open = false;
    c.open_row.reset();
    return good;
  }

 private:
  Position at(Point p) const {
    Position position = programmed_position(context_.state);
    position[2] = p.x;
    position[0] = p.y;
    return position;
  }

  Context& context_;
  const Block& block_;
  const LatheProfile& profile_;
};

bool check_direction(Context& context, const Block& block, const LatheProfile& profile, const char* remedy) {
  const ContourElement* const back = profile.find_turning_back();
  if (back == nullptr) return true;
  return fail(context, block, "lathe-contour-turns-back",
              fmt::format("the contour in line {} turns back on its way, or an arc of it does", back->line), remedy);
}

bool rough_contour(Context& context, const Block& block, const LatheCycle& cycle, std::vector<ContourElement> contour,
                   WorkBudget& budget) {
  const bool facing = cycle.code >= 720;
  LatheProfile profile(std::move(contour), facing, context.state.modal.unit());
  profile.start_above();
  const char* const remedy =
      facing ? "the contour of G72 goes one way in X, its arcs no further than a quarter either side"
             : "the contour of G71 goes one way in Z, its arcs no further than a quarter either side";
  if (!check_direction(context, block, profile, remedy)) return false;
  if (!profile.widen(cycle.allowance, budget, context.faults)) return false;
  profile.shift(cycle.shift);
  profile.close();
  std::vector<LatheMove> moves;
  if (!rough(profile, cycle.roughing, moves, budget, context.faults)) return false;
  LatheRun run(context, block, profile);
  if (!run.go(0, profile.elements().front().start)) return false;
  for (const auto& move : moves) {
    if (context.out.is_full()) return true;
    if (!run.follow(move)) return false;
  }
  return true;
}

bool finish_contour(Context& context, const Block& block, const LatheCycle& cycle,
                    const std::vector<ContourElement>& contour, WorkBudget& budget) {
  const double unit = context.state.modal.unit();
  LatheProfile profile(contour, false, unit);
  if (profile.find_turning_back() != nullptr) profile = LatheProfile(contour, true, unit);
  if (!check_direction(context, block, profile, "the contour of G70 goes one way, in Z or in X")) return false;
  profile.start_above();
  for (int pass = cycle.passes; pass > 0; --pass) {
    LatheProfile widened = profile;
    const double allowance =
        (pass - 1) * (cycle.allowance - cycle.last_allowance) / cycle.passes + cycle.last_allowance;
    if (!widened.widen(allowance, budget, context.faults)) return false;
    LatheRun run(context, block, widened);
    const auto& elements = widened.elements();
    if (!run.approach(elements.front().start) || !run.go(0, elements.front().end)) return false;
    for (std::size_t i = 1; i < elements.size() && !context.out.is_full(); ++i) {
      if (!run.go_along(elements[i])) return false;
    }
  }
  return true;
}

}  // namespace

bool begin_lathe_cycle(Context& context, const Block& block, Code code, LatheCycle& cycle) {
  const std::string name = code_text('G', code);
  cycle.code = code;
  if (!check_modes(context, block, name) || !read_contour_number(context, block, cycle, name)) return false;
  cycle.allowance = block.of('d', 0.0) * context.state.modal.unit();
  if (!(code == 700 ? read_finishing(context, block, cycle) : read_roughing(context, block, cycle, name))) return false;
  State& state = context.state;
  state.compensation.first_move_pending = state.compensation.radius > 0.0;  // the start is no point of the contour
  if (!find_end(context, block, cycle.start)) return false;
  context.out.line(MoveKind::rapid, state.offsets, cycle.start);
  state.position = cycle.start;
  state.compensation.arc_forbidden = false;
  return true;
}

bool run_lathe_cycle(Context& context, const Block& block, const LatheCycle& cycle, std::vector<ContourElement> contour,
                     WorkBudget& budget) {
  if (contour.size() < 2) {
    context.faults.warn("lathe-contour-empty", fmt::format("O{} describes no contour; nothing is cut", cycle.contour),
                        "a contour has two moves at least: one to its start and one along it", block.column_of('q'));
    return true;
  }
  if (cycle.code == 700) return finish_contour(context, block, cycle, contour, budget);
  return rough_contour(context, block, cycle, std::move(contour), budget);
}

}  // namespace toolpace::nc
