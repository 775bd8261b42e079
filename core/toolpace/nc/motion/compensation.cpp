#include "toolpace/nc/motion/compensation.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/motion/offset_geometry.h"
#include "toolpace/nc/scaling.h"

namespace toolpace::nc {
namespace {

constexpr double kSamePoint = 1e-9;  // [mm]
constexpr double kFlat =
    0.05;  // [rad] corners flatter than this, and reversals nearer than this to a half turn, as LinuxCNC

struct Frame {
  PlaneAxes plane;
  double side;  // +1: the tool is on the left

  Point of(const Position& p) const { return {p[plane.first], p[plane.second]}; }
  Position at(Position p, const Point& q) const {
    p[plane.first] = q.x;
    p[plane.second] = q.y;
    return p;
  }
};

// Where the controlled point of a lathe tool lies, as its centre goes to `p`.
Position controlled(const State& state, Position p) {
  p[0] += state.compensation.origin.x;
  p[2] += state.compensation.origin.z;
  return p;
}

void write_line(Context& context, MoveKind kind, const Position& centre, const Feedrate& feed) {
  context.out.line(kind, context.state.offsets, controlled(context.state, centre), feed);
}

void write_round(Context& context, const Frame& frame, PlaneArc arc, const Position& centre, const Feedrate& feed) {
  const State& state = context.state;
  const Point shift = frame.of(controlled(state, Position{}));
  for (auto* p : {&arc.start, &arc.end, &arc.centre}) *p = {(*p)[0] + shift.x, (*p)[1] + shift.y};
  write_arc(context, arc, state.position, controlled(state, centre), feed.linear);
}

Frame frame_of(const State& state) {
  const bool left = state.modal.compensation == 410 || state.modal.compensation == 411;
  return {plane_axes(state.modal.plane), left ? 1.0 : -1.0};
}

bool fail_gouge(Context& context, std::string what) {
  return context.faults.fail("compensation-gouge", std::move(what), "use a smaller tool or a rounder corner");
}

bool runs_outside(const Frame& frame, const OffsetElement& element) {
  return element.turn != 0 && frame.side * element.turn < 0.0;
}

void keep_open(State& state, const MoveWriter& out, const OffsetElement& element) {
  Compensation& c = state.compensation;
  c.has_open = true;
  c.open_row = out.is_enabled() ? std::optional(out.size() - 1) : std::nullopt;
  c.open = element;
  c.open_is_entry = c.first_move_pending;
  c.open_is_reversed = std::exchange(c.next_is_reversed, false);
}

// Moves the end of the open row, and of the rows without motion in the plane after it, to `corner`.
bool move_open_end(Context& context, const Frame& frame, const Point& corner) {
  State& state = context.state;
  Compensation& c = state.compensation;
  OffsetElement& open = c.open;
  if (!c.open_is_entry && !lies_on(open, corner))
    return fail_gouge(context, "the tool cannot reach this inside corner without gouging");
  open.end = corner;
  state.position = frame.at(state.position, corner);
  if (!c.open_row) return true;
  Moves& moves = context.out.moves();
  for (std::size_t row = *c.open_row; row < moves.size(); ++row) {
    const AxisVector at = machine_vector(state.offsets, controlled(state, state.position));
    for (const std::size_t axis : {frame.plane.first, frame.plane.second}) {
      const auto i = static_cast<Eigen::Index>(axis);
      moves.end[row][i] = at[i];
    }
  }
  if (open.turn != 0) {
    const PlaneArc arc{{open.start.x, open.start.y}, {corner.x, corner.y}, {open.centre.x, open.centre.y}, open.turn};
    moves.arcs[moves.detail[*c.open_row]].sweep = sweep_of(arc) * turn_of(state.offsets, frame.plane);
  }
  return true;
}

// Joins the element that begins at contour point `corner` to the row before: an arc about the corner where the tool runs
// outside, a shortened row where it runs inside. Afterwards the tool stands at element.start.
bool join(Context& context, const Frame& frame, OffsetElement& element, const Feedrate& feed) {
  State& state = context.state;
  Compensation& c = state.compensation;
  if (std::exchange(c.open_is_reversed, false))
    return fail_gouge(context, "the corner before cuts off more of this move than it is long");
  const Point corner = frame.of(c.programmed);
  const Point tool = frame.of(state.position);
  // The direction of the motion so far, as the tool's place beside the corner tells it.
  const Point before = turned(tool - corner, -frame.side);
  const Point after = direction_at_start(element);
  double outside = -frame.side * angle_between(before, after);
  if (std::fabs(outside) > std::numbers::pi - kFlat) {
    // Straight back: once around the corner, unless that would cut into an arc that the tool runs outside of.
    const bool cuts = element.turn != 0 ? runs_outside(frame, element) : c.has_open && runs_outside(frame, c.open);
    if (cuts)
      outside = -std::numbers::pi;
    else if (outside < 0.0)
      outside += 2.0 * std::numbers::pi;
  }
  if (outside < -kFlat && c.has_open) {
    const auto meeting = intersect(c.open, element, corner);
    if (!meeting) return fail_gouge(context, "the tool does not fit into this inside corner");
    if (!move_open_end(context, frame, *meeting)) return false;
    c.next_is_reversed = element.turn == 0 && dot(element.end - element.start, element.end - *meeting) <= 0.0;
    element.start = *meeting;
    return true;
  }
  if (outside > kFlat) {
    PlaneArc around;
    around.start = {tool.x, tool.y};
    around.end = {element.start.x, element.start.y};
    around.centre = {corner.x, corner.y};
    around.turns = frame.side > 0.0 ? -1 : 1;
    const Position end = frame.at(state.position, element.start);
    write_round(context, frame, around, end, feed);
    state.position = end;
  } else if (element.turn != 0) {
    element.start = tool;  // nearly tangent: the arc begins where the tool stands
  }
  return true;
}

bool enter_by_line(Context& context, const Frame& frame, MoveKind kind, const Position& end, const Feedrate& feed) {
  State& state = context.state;
  Compensation& c = state.compensation;
  const Point from = frame.of(state.position);
  const Point contour = frame.of(end);
  const double distance = norm(from - contour);
  if (distance <= c.radius) {
    return context.faults.fail(
        "compensation-entry-short",
        fmt::format("the entry move of {:.4f} mm is not longer than the tool radius {:.4f} mm", distance, c.radius),
        "start cutter radius compensation farther away from the contour");
  }
  const Point beside = turned((contour - from) * (c.radius / distance), frame.side);
  const Point tool = contour + beside;
  const Position target = frame.at(end, tool);
  write_line(context, kind, target, feed);
  // For the corner that follows, the entry counts as a row beside its programmed line.
  keep_open(state, context.out, OffsetElement{from + beside, tool, {}, 0});
  state.position = target;
  c.programmed = end;
  c.first_move_pending = false;
  return true;
}

// The entry arc ends beside the contour's end point, tangent to the contour there.
bool enter_by_arc(Context& context, const Frame& frame, const PlaneArc& contour, const Position& end,
                  const Feedrate& feed) {
  State& state = context.state;
  Compensation& c = state.compensation;
  const double turn = contour.turns > 0 ? 1.0 : -1.0;
  const Point centre{contour.centre[0], contour.centre[1]};
  const Point last{contour.end[0], contour.end[1]};
  const double radius = norm(last - centre);
  if (radius <= c.radius && frame.side == turn) {
    return context.faults.fail(
        "compensation-arc-too-small",
        fmt::format("the tool radius {:.4f} mm is not less than the arc's {:.4f} mm", c.radius, radius),
        "use a smaller tool");
  }
  const Point outward = (last - centre) * (1.0 / radius);
  const Point tool = last - outward * (frame.side * turn * c.radius);
  const Point from = frame.of(state.position);
  // Centre on the line through the end and the old centre, as far from the start as from the end.
  const Point chord = from - tool;
  const Point inward = outward * -1.0;
  const double along = dot(chord, inward);
  if (std::fabs(along) < 1e-4 * norm(chord))
    return fail_gouge(context, "the entry arc cannot be tangent to the contour");
  const double new_radius = dot(chord, chord) / (2.0 * along);
  const Point new_centre = tool + inward * new_radius;
  PlaneArc arc = contour;
  arc.start = {from.x, from.y};
  arc.end = {tool.x, tool.y};
  arc.centre = {new_centre.x, new_centre.y};
  const Position target = frame.at(end, tool);
  write_round(context, frame, arc, target, feed);
  keep_open(state, context.out, OffsetElement{from, tool, new_centre, arc.turns});
  state.position = target;
  c.programmed = end;
  c.first_move_pending = false;
  return true;
}

}  // namespace

bool compensate_line(Context& context, MoveKind kind, const Position& end, const Feedrate& feed) {
  State& state = context.state;
  Compensation& c = state.compensation;
  const Frame frame = frame_of(state);
  if (c.first_move_pending) return enter_by_line(context, frame, kind, end, feed);
  const Point start = frame.of(c.programmed);
  const Point finish = frame.of(end);
  const Point step = finish - start;
  if (norm(step) < kSamePoint) {  // outside the plane only
    const Position target = frame.at(end, frame.of(state.position));
    write_line(context, kind, target, feed);
    state.position = target;
    c.programmed = end;
    return true;
  }
  const Point beside = turned(step * (c.radius / norm(step)), frame.side);
  OffsetElement element{start + beside, finish + beside, {}, 0};
  if (!join(context, frame, element, feed)) return false;
  const Position target = frame.at(end, element.end);
  write_line(context, kind, target, feed);
  keep_open(state, context.out, element);
  state.position = target;
  c.programmed = end;
  return true;
}

bool compensate_arc(Context& context, const PlaneArc& contour, const Position& end, const Feedrate& feed) {
  State& state = context.state;
  Compensation& c = state.compensation;
  const Frame frame = frame_of(state);
  if (c.first_move_pending) return enter_by_arc(context, frame, contour, end, feed);
  const double turn = contour.turns > 0 ? 1.0 : -1.0;
  const Point centre{contour.centre[0], contour.centre[1]};
  const Point start{contour.start[0], contour.start[1]};
  const Point finish{contour.end[0], contour.end[1]};
  const double inward = frame.side * turn * c.radius;  // > 0: the tool runs inside the arc
  const double radius = norm(finish - centre);
  if (inward > 0.0 && radius <= c.radius) {
    return context.faults.fail(
        "compensation-arc-too-small",
        fmt::format("the tool radius {:.4f} mm is not less than the arc's {:.4f} mm", c.radius, radius),
        "use a smaller tool");
  }
  OffsetElement element{start + (centre - start) * (inward / norm(centre - start)),
                        finish + (centre - finish) * (inward / radius), centre, contour.turns};
  if (!join(context, frame, element, feed)) return false;
  const Position target = frame.at(end, element.end);
  const PlaneArc arc{{element.start.x, element.start.y}, {element.end.x, element.end.y}, contour.centre, contour.turns};
  write_round(context, frame, arc, target, feed);
  keep_open(state, context.out, element);
  state.position = target;
  c.programmed = end;
  return true;
}

}  // namespace toolpace::nc
