#include "toolpace/nc/motion/corners.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "toolpace/nc/motion/corner_geometry.h"
#include "toolpace/nc/motion/motion.h"

namespace toolpace::nc {
namespace {

constexpr double kOffPlane = 1e-9;  // [mm, deg]

Point in_plane(const PlaneAxes& plane, const Position& p) { return {p[plane.first], p[plane.second]}; }

OffsetElement element_of(const PlaneAxes& plane, const Position& start, const WaitingMove& move) {
  return {in_plane(plane, start), in_plane(plane, move.end), {move.centre[0], move.centre[1]}, move.turns};
}

bool stays_in_plane(const PlaneAxes& plane, const Position& start, const Position& end) {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (i != plane.first && i != plane.second && std::fabs(end[i] - start[i]) > kOffPlane) return false;
  }
  return true;
}

bool run_as_it_is(Context& context, const WaitingMove& move) {
  if (move.code != 20 && move.code != 30) return go_straight(context, move.block, move.code, move.end);
  const PlaneAxes plane = plane_axes(context.state.modal.plane);
  const Position& from = programmed_position(context.state);
  const PlaneArc arc{{from[plane.first], from[plane.second]},
                     {move.end[plane.first], move.end[plane.second]},
                     move.centre,
                     move.turns};
  return go_around(context, move.block, arc, move.end);
}

// Moves that have waited run under the feed and the line that they were read with.
class AsRead {
 public:
  AsRead(Context& context, const WaitingMove& move)
      : context_(context),
        feed_(context.state.modal.feed),
        feed_linear_(context.state.modal.feed_linear),
        line_(context.out.line_number()),
        file_(context.out.file()) {
    context.state.modal.feed = move.feed;
    context.state.modal.feed_linear = move.feed_linear;
    context.out.set_place(move.line, move.file);
  }
  ~AsRead() {
    context_.state.modal.feed = feed_;
    context_.state.modal.feed_linear = feed_linear_;
    context_.out.set_place(line_, file_);
  }
  AsRead(const AsRead&) = delete;
  AsRead& operator=(const AsRead&) = delete;

 private:
  Context& context_;
  double feed_, feed_linear_;
  std::size_t line_, file_;
};

// Runs `before` up to the corner and the corner itself; the tool then stands where `after` begins.
bool run_corner(Context& context, WaitingMove before, const WaitingMove& after) {
  const PlaneAxes plane = plane_axes(context.state.modal.plane);
  const Position start = programmed_position(context.state);
  const AsRead as_read(context, before);
  const bool is_chamfer = before.block.has_any(1u << kChamferWord);
  const double size = before.block.has_any(kCornerBits)
                          ? before.block.value[is_chamfer ? kChamferWord : kFilletWord] * context.state.modal.unit()
                          : 0.0;
  const auto fail = [&](const char* code, std::string what, const char* remedy) {
    return context.faults.fail(code, std::move(what), remedy);
  };
  if (!(size >= 0.0))
    return fail("corner-size", fmt::format("a corner of {:g} in line {}", size, before.line),
                "the size of a corner is not below 0");
  if (!stays_in_plane(plane, start, before.end) || !stays_in_plane(plane, before.end, after.end)) {
    return fail("corner-off-plane", fmt::format("the corner of line {} lies outside the plane", before.line),
                "corners are made in the plane of G17, G18 or G19 alone");
  }
  OffsetElement a = element_of(plane, start, before), b = element_of(plane, before.end, after), between;
  const bool moves = norm(a.end - a.start) > kOffPlane && norm(b.end - b.start) > kOffPlane;
  if (size == 0.0 || !moves || !is_corner(a, b)) return run_as_it_is(context, before);
  if (!(is_chamfer ? break_corner(a, b, size, between) : round_corner(a, b, size, between))) {
    return fail(
        "corner-too-large",
        fmt::format("a corner of {:g} mm does not fit between the moves beside it in line {}", size, before.line),
        "give a smaller ,C or ,R");
  }
  const auto at = [&](Point p) {
    Position position = before.end;
    position[plane.first] = p.x;
    position[plane.second] = p.y;
    return position;
  };
  WaitingMove corner = before;
  before.end = at(a.end);
  corner.end = at(between.end);
  corner.code = between.turn == 0 ? 10 : between.turn > 0 ? 30 : 20;
  corner.centre = {between.centre.x, between.centre.y};
  corner.turns = between.turn;
  return run_as_it_is(context, before) && run_as_it_is(context, corner);
}

bool fail_open(Context& context, const WaitingMove& move) {
  return context.faults.fail("line-angle-open", fmt::format("the line of line {} has an angle, but no end", move.line),
                             "give one of its coordinates, or in the next block both coordinates and an angle");
}

// The end of a line that has an angle alone: where the next one, which has both ends and an angle, meets it.
bool find_open_end(Context& context, WaitingMove& move, const WaitingMove& next) {
  const PlaneAxes plane = plane_axes(context.state.modal.plane);
  const bool names_both = names_axis(context, next.block, plane.first) && names_axis(context, next.block, plane.second);
  if (next.code != 10 || !next.block.has_any(kLineAngleBit) || !names_both) return fail_open(context, move);
  Point meeting;
  if (!find_meeting_of_lines(in_plane(plane, move.end), move.block.value[kLineAngleWord], in_plane(plane, next.end),
                             next.block.value[kLineAngleWord], meeting)) {
    return context.faults.fail("line-angle", fmt::format("the line of line {} and the next one do not meet", move.line),
                               "check the angles", next.block.column[kLineAngleWord]);
  }
  move.end[plane.first] = meeting.x;
  move.end[plane.second] = meeting.y;
  return true;
}

bool run_cornered(Context& context, WaitingMove move) {
  State& state = context.state;
  const PlaneAxes plane = plane_axes(state.modal.plane);
  if (state.waiting) {
    WaitingMove before = std::move(*state.waiting);
    state.waiting.reset();
    if (before.is_open && !find_open_end(context, before, move)) return false;
    if (!run_corner(context, before, move)) return false;
  }
  move.is_open = move.block.has_any(kLineAngleBit) && !names_axis(context, move.block, plane.first) &&
                 !names_axis(context, move.block, plane.second);
  if (!move.is_open && !move.block.has_any(kCornerBits)) return run_as_it_is(context, move);
  state.waiting = std::move(move);
  return true;
}

WaitingMove waiting_move(const Context& context, const Block& block, Code code, const Position& end) {
  WaitingMove move;
  move.block = block;
  move.code = code;
  move.end = end;
  move.feed = context.state.modal.feed;
  move.feed_linear = context.state.modal.feed_linear;
  move.line = context.out.line_number();
  move.file = context.out.file();
  return move;
}

}  // namespace

Block with_corner_words(Context& context, const Block& block, Code motion) {
  State& state = context.state;
  Block plain = block;
  if (motion != 10) {
    state.turns_c = state.turns_c || block.has('c');
    return plain;
  }
  const auto replace = [&](char letter, std::size_t word) {
    const std::size_t from = word_index(letter);
    plain.words &= ~word_bit(letter);
    if ((plain.words & (1u << word)) != 0) return;
    plain.words |= 1u << word;
    plain.value[word] = word == kLineAngleWord ? block.value[from] : std::fabs(block.value[from]);
    plain.column[word] = block.column[from];
  };
  const bool x = names_axis(context, block, 0), z = names_axis(context, block, 2);
  if (block.has('a')) replace('a', kLineAngleWord);
  if (block.has('r')) replace('r', kFilletWord);
  if (block.has('i') && z && !x) replace('i', kChamferWord);
  if (block.has('k') && x && !z) replace('k', kChamferWord);
  if (!block.has('c')) return plain;
  if (state.turns_c || (!x && !z)) {
    state.turns_c = true;
    return plain;
  }
  replace('c', kChamferWord);
  if (!std::exchange(state.chamfer_told, true)) {
    context.faults.warn("lathe-chamfer", "C of a straight move is read as a chamfer, not as the axis C",
                        "write ,C for a chamfer; the axis C is known by a G0 with it", block.column_of('c'));
  }
  return plain;
}

bool run_cornered_line(Context& context, const Block& block, Code code, const Position& end) {
  return run_cornered(context, waiting_move(context, block, code, end));
}

bool run_cornered_arc(Context& context, const Block& block, const PlaneArc& arc, const Position& end) {
  WaitingMove move = waiting_move(context, block, arc.turns > 0 ? Code{30} : Code{20}, end);
  move.centre = arc.centre;
  move.turns = arc.turns;
  return run_cornered(context, std::move(move));
}

bool release_corner(Context& context) {
  if (!context.state.waiting) return true;
  const WaitingMove move = std::move(*context.state.waiting);
  context.state.waiting.reset();
  if (move.is_open) return fail_open(context, move);
  context.faults.warn("corner-without-move",
                      fmt::format("no move in the plane follows the corner of line {}; it stays sharp", move.line),
                      "give the move that the corner leads to in the next block");
  const AsRead as_read(context, move);
  return run_as_it_is(context, move);
}

}  // namespace toolpace::nc
