#include "toolpace/nc/motion/arcs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "toolpace/nc/motion/compensation.h"
#include "toolpace/nc/motion/corners.h"
#include "toolpace/nc/motion/end_point.h"
#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/scaling.h"
#include "toolpace/nc/text/whole_number.h"

namespace toolpace::nc {
namespace {

// By how much a radius may be too short to reach the end, as LinuxCNC allows it.
constexpr double kShortRadius = 0.005;  // [mm]
constexpr double kShortRadiusInch = 0.0005 * kMmPerInch;
constexpr double kSemicircle = 1e-12;  // of the radius: half the chord is as long as the radius but for rounding

// What is mended is told: less is the rounding of numbers with three decimals, or of large radii.
constexpr double kRounding = 0.005;  // [mm]
constexpr double kRoundingRelative = 0.001;

double short_radius(const Modal& modal) { return modal.units == 200 ? kShortRadiusInch : kShortRadius; }

void remember_mended(Context& context, double difference, double radius) {
  if (difference <= kRounding || difference <= kRoundingRelative * radius) return;
  MendedArcs& mended = context.state.mended;
  ++mended.count;
  if (difference <= mended.worst) return;
  mended.worst = difference;
  mended.line = context.out.line_number();
  mended.file = context.out.file();
}

struct Radii {
  double at_start, at_end;
};

Radii radii_about(const PlaneArc& arc, const std::array<double, 2>& centre) {
  return {std::hypot(arc.start[0] - centre[0], arc.start[1] - centre[1]),
          std::hypot(arc.end[0] - centre[0], arc.end[1] - centre[1])};
}

bool fits(const Context& context, const Radii& r) {
  const ArcTolerance& arc = context.arc;
  if (r.at_start < arc.least_radius || r.at_end < arc.least_radius) return false;
  const double difference = std::fabs(r.at_start - r.at_end);
  const double tolerance = context.state.modal.units == 200 ? arc.inch : arc.metric;
  const double relative = arc.relative * std::max(r.at_start, r.at_end);
  return difference <= tolerance || (difference <= relative && difference <= arc.most * tolerance);
}

bool find_centre_by_offset(Context& context, const Block& block, PlaneArc& arc) {
  Modal& modal = context.state.modal;
  const PlaneAxes plane = plane_axes(modal.plane);
  const char first = static_cast<char>('i' + plane.first);
  const char second = static_cast<char>('i' + plane.second);
  const bool absolute = modal.arc_distance == 901, names_both = block.has(first) && block.has(second);
  if (absolute && !names_both) {
    return context.faults.fail(
        "arc-centre-incomplete", "an arc with absolute centre (G90.1) needs both centre words",
        fmt::format("give {} and {}", static_cast<char>(first - 32), static_cast<char>(second - 32)),
        block.column_of(GGroup::motion));
  }
  const std::array<double, 2> words = {block.of(first, 0.0) * modal.unit(), block.of(second, 0.0) * modal.unit()};
  const std::array<double, 2> beside_start = {arc.start[0] + words[0], arc.start[1] + words[1]};
  arc.centre = absolute ? words : beside_start;
  const bool may_be_absolute = context.rules.centres_may_be_absolute && !absolute && names_both;
  if (may_be_absolute && !fits(context, radii_about(arc, arc.centre)) && fits(context, radii_about(arc, words))) {
    arc.centre = words;
    modal.arc_distance = 901;
    context.faults.warn("arc-centre-absolute",
                        "the centres of arcs are read as places from here on, as under G90.1: none fits as a distance",
                        "write G90.1, or G91.1 and distances from the start", block.column_of(first));
  }
  const Radii radii = radii_about(arc, arc.centre);
  return check_radii(context, radii.at_start, radii.at_end, block.column_of(first));
}

bool find_centre_by_radius(Context& context, const Block& block, bool clockwise, PlaneArc& arc) {
  const double radius = length_of(context.state, block, 'r');
  const double dx = arc.end[0] - arc.start[0];
  const double dy = arc.end[1] - arc.start[1];
  const double chord = std::hypot(dx, dy);
  if (chord == 0.0) {
    return context.faults.fail("arc-same-point", "an arc given by its radius ends where it starts",
                               "give a full circle by its centre (I J K)", block.column_of('r'));
  }
  const double half = chord / 2.0;
  double size = std::fabs(radius);
  if (half - size > short_radius(context.state.modal)) {
    return context.faults.fail("arc-radius-too-small",
                               fmt::format("radius {:.4f} mm cannot reach the end point {:.4f} mm away", size, chord),
                               fmt::format("the radius must be at least {:.4f} mm", half), block.column_of('r'));
  }
  if (half / size > 1.0 - kSemicircle) size = half;
  // The centre lies beside the middle of the chord; short arcs that go clockwise have it on the right.
  const double beside = std::sqrt(std::max(0.0, size * size - half * half));
  const double side = clockwise == (radius > 0.0) ? -1.0 : 1.0;
  arc.centre = {arc.start[0] + dx / 2.0 - side * beside * dy / chord,
                arc.start[1] + dy / 2.0 + side * beside * dx / chord};
  return true;
}

constexpr int kMostTurns = 1'000'000;

bool find_turns(Context& context, const Block& block, bool clockwise, int& turns) {
  turns = 1;
  if (block.has('p')) {
    const double p = block.of('p');
    const auto number = whole_number(p, 1, kMostTurns);
    if (!number) {
      return context.faults.fail("arc-turns", fmt::format("P{:g} is no number of turns", p),
                                 "P of an arc is a whole number from 1 to 1000000", block.column_of('p'));
    }
    turns = *number;
  }
  if (clockwise) turns = -turns;
  return true;
}

double length_of_arc(const State& state, const PlaneArc& arc, const PlaneAxes& plane, double rise) {
  const double r = std::hypot(arc.start[0] - arc.centre[0], arc.start[1] - arc.centre[1]);
  return std::hypot(r * sweep_of(arc) * scale_of(state.offsets, plane.first),
                    rise * scale_of(state.offsets, plane.normal));
}

bool check_words(Context& context, const Block& block, const PlaneAxes& plane) {
  const char normal = static_cast<char>('i' + plane.normal);
  const auto fail = [&](const char* code, std::string what, const char* remedy) {
    return context.faults.fail(code, std::move(what), remedy, block.column_of(GGroup::motion));
  };
  const bool by_radius = block.has('r');
  if (by_radius && block.has_any(kCentreBits) && context.rules.refuses_doubtful) {
    return fail("arc-radius-and-centre", "an arc with both a radius and a centre", "give R, or I J K, not both");
  }
  if (!by_radius && block.has(normal) && !context.rules.ignores_centre_off_plane) {
    return fail("arc-centre-off-plane",
                fmt::format("{} does not belong to the plane of this arc", static_cast<char>(normal - 32)),
                "check G17 G18 G19; --dialect grbl and others leave the word out");
  }
  const bool in_plane =
      names_axis(context, block, plane.first) || names_axis(context, block, plane.second) || block.has_any(kPolarBits);
  if (!by_radius && !block.has_any(kCentreBits)) {
    return fail("arc-incomplete", "an arc without radius and centre", "give R, or I J K");
  }
  if (by_radius && !in_plane)
    return fail("arc-incomplete", "an arc given by its radius without an end point", "give the end point");
  return true;
}

}  // namespace

double sweep_of(const PlaneArc& arc) {
  const double x0 = arc.start[0] - arc.centre[0], y0 = arc.start[1] - arc.centre[1];
  const double x1 = arc.end[0] - arc.centre[0], y1 = arc.end[1] - arc.centre[1];
  double sweep = std::atan2(x0 * y1 - y0 * x1, x0 * x1 + y0 * y1);  // −π … π
  // Below this angle the end counts as the start, and the arc as a full turn.
  const double same = 1e-7 / std::max(std::hypot(x0, y0), 1e-3);
  const int more = std::abs(arc.turns) - 1;
  if (arc.turns > 0) {
    if (sweep <= same) sweep += kTwoPi;
    return sweep + kTwoPi * more;
  }
  if (sweep >= -same) sweep -= kTwoPi;
  return sweep - kTwoPi * more;
}

void write_arc(Context& context, const PlaneArc& arc, const Position& from, const Position& end, double feed_mm_min) {
  const Offsets& offsets = context.state.offsets;
  const PlaneAxes plane = plane_axes(context.state.modal.plane);
  Position centre = from;
  centre[plane.first] = arc.centre[0];
  centre[plane.second] = arc.centre[1];
  ArcDetail detail;
  detail.centre = machine_vector(offsets, centre).head<3>();
  Eigen::Vector3d normal = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(plane.normal));
  if (offsets.rotation != 0.0 && plane.normal != 2) {
    const double angle = offsets.rotation * kRadiansPerDegree;
    const double x = normal.x(), y = normal.y();
    normal = {x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle), 0.0};
  }
  detail.normal = normal;
  detail.sweep = sweep_of(arc) * turn_of(offsets, plane);
  context.out.arc(offsets, end, detail, feed_mm_min);
}

bool check_radii(Context& context, double at_start, double at_end, std::size_t column) {
  const ArcTolerance& arc = context.arc;
  if (at_start < arc.least_radius || at_end < arc.least_radius) {
    return context.faults.fail("arc-radius-zero", "an arc with its centre at its start or end",
                               "check the centre words I J K", column);
  }
  const double difference = std::fabs(at_start - at_end);
  if (!fits(context, {at_start, at_end})) {
    return context.faults.fail(
        "arc-radius-differs",
        fmt::format("the end of the arc lies {:.4f} mm off its radius: {:.4f} mm at the start, {:.4f} mm at the end",
                    difference, at_start, at_end),
        "check the centre words I J K, G90.1/G91.1, and the plane; --arc-tolerance-mm lets more pass");
  }
  remember_mended(context, difference, at_start);
  return true;
}

bool run_arc(Context& context, const Block& block, Code code) {
  const State& state = context.state;
  const PlaneAxes plane = plane_axes(state.modal.plane);
  if (!check_words(context, block, plane)) return false;
  if (block.code(GGroup::once) == 530) {
    return context.faults.fail("g53-with-arc", "G53 with an arc", "use G53 with G0 or G1",
                               block.column_of(GGroup::once));
  }
  const Position& from = programmed_position(state);
  Position end;
  if (!find_end(context, block, end)) return false;
  const bool clockwise = code == 20;
  PlaneArc arc;
  arc.start = {from[plane.first], from[plane.second]};
  arc.end = {end[plane.first], end[plane.second]};
  if (!find_turns(context, block, clockwise, arc.turns)) return false;
  const bool found = block.has('r') ? find_centre_by_radius(context, block, clockwise, arc)
                                    : find_centre_by_offset(context, block, arc);
  if (!found) return false;
  return meets_corner(context, block) ? run_cornered_arc(context, block, arc, end)
                                      : go_around(context, block, arc, end);
}

bool go_around(Context& context, const Block& block, const PlaneArc& arc, const Position& end) {
  State& state = context.state;
  const PlaneAxes plane = plane_axes(state.modal.plane);
  const Position& from = programmed_position(state);
  if (!(std::hypot(arc.start[0] - arc.centre[0], arc.start[1] - arc.centre[1]) <= kFarthest)) {
    return context.faults.fail("arc-radius-too-large",
                               fmt::format("an arc with a radius of more than {:g} mm", kFarthest), "check I J K or R",
                               block.column_of(GGroup::motion));
  }
  if (!scales_evenly(state.offsets, plane)) {
    return context.faults.fail("arc-scaled-unevenly",
                               "an arc whose plane is scaled along one axis more than along the other",
                               "scale both axes alike, or give the curve as lines", block.column_of(GGroup::motion));
  }
  Feedrate feed;
  const double length = length_of_arc(state, arc, plane, end[plane.normal] - from[plane.normal]);
  if (!find_feedrate(context, block, {length, 0.0, from[0], end[0]}, feed)) return false;
  if (state.compensation.radius > 0.0) return compensate_arc(context, arc, end, feed);
  if (state.compensation.arc_forbidden) {
    return context.faults.fail("compensation-exit-arc",
                               "the move after the end of cutter radius compensation is an arc",
                               "leave compensation on a straight move", block.column_of(GGroup::motion));
  }
  write_arc(context, arc, state.position, end, feed.linear);
  state.position = end;
  return true;
}

}  // namespace toolpace::nc
