#include "toolpace/verify/path_check.h"

#include <algorithm>
#include <cmath>

#include "toolpace/limits/corner_between.h"
#include "toolpace/path/commanded.h"
#include "toolpace/verify/chord.h"
#include "toolpace/verify/own_kinematics.h"

namespace toolpace {
namespace {

constexpr double kFinest = 2e-7, kCoarsest = 1e-5;  // [mm] sagitta of the chords that stand for curves
constexpr double kNegligibleStep = 1e-9;            // change of a direction that is rounding
constexpr double kSmoothing = 2 * kOnPath;          // a tolerance that lets corners be smoothed
constexpr double kSame = 1e-5;      // relative difference of chord errors that is not worth a closer look
constexpr double kNearNode = 1e-3;  // of the chord: a node this near to a row counts on both sides of it

bool has_rotary(const RowStream& stream) {
  return std::any_of(stream.rows().position.begin() + 3, stream.rows().position.end(),
                     [](const auto& p) { return !p.empty(); });
}

/// Weighted.
AxisVector point_of(const RowStream& stream, std::size_t local) {
  AxisVector point = AxisVector::Zero();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto& p = stream.rows().told(axis);
    if (!p.empty()) point[static_cast<Eigen::Index>(axis)] = counted(axis, p[local]);
  }
  return point;
}

bool path_has_rotary(const Path& path) {
  return std::any_of(path.node.begin(), path.node.end(), [](const AxisVector& n) { return !n.tail<3>().isZero(0); });
}

PathControl control_of(const Moves& moves, std::uint32_t row) { return moves.modes[moves.mode[row]].control; }

std::vector<SegmentRule> rules_of(const ProgrammedPath& program) {
  std::vector<SegmentRule> rules(program.path.size());
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (!program.segment_tolerance.empty()) rules[i].tolerance = program.segment_tolerance[i];
    rules[i].is_exact = is_exact(control_of(program.moves, program.path.move[i])) || rules[i].tolerance <= kSmoothing;
  }
  return rules;
}

double distance_to_line(const AxisVector& point, const AxisVector& from, const AxisVector& to) {
  const AxisVector along = to - from, off = point - from;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp(off.dot(along) / square, 0.0, 1.0) : 0.0;
  return (off - t * along).norm();
}

/// From row i − 1 to row i.
AxisVector axes_way(const RowStream& stream, std::size_t i) {
  AxisVector way = AxisVector::Zero();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto& p = stream.rows().position[axis];
    if (!p.empty()) way[static_cast<Eigen::Index>(axis)] = p[i] - p[i - 1];
  }
  return way;
}

void place(Check& check, const RowStream& stream, std::size_t local) {
  check.row = stream.row(local);
  if (!stream.rows().time.empty()) check.time = stream.rows().time[local];
  if (!stream.rows().line.empty()) check.line = stream.rows().line[local];
}

}  // namespace

PathCheck::PathCheck(const ProgrammedPath& program, const Machine& machine, const CornerLimit& corners, double reach,
                     double period)
    : path_(program.path),
      moves_(program.moves),
      period_(period),
      reach_(reach),
      sagitta_(std::clamp(reach / 5, kFinest, kCoarsest)),
      rotary_(path_has_rotary(program.path)),
      corner_limit_(corners),
      slack_(program.path, machine, period),
      tolerance_(program.tolerance),
      vertices_(program.path, sagitta_, rules_of(program)),
      follower_(vertices_, reach + kFinest, rotary_),
      deviation_(tolerance_.value_or(std::numeric_limits<double>::infinity())) {
  left_.kind = CheckKind::follows_path;
  end_.kind = CheckKind::end_point;
  line_.kind = CheckKind::line_column;
}

double PathCheck::extent() const {
  double extent = 0;
  for (const ArcCurve& arc : path_.arcs) {
    extent = std::max(extent, arc.centre.cwiseAbs().maxCoeff() + std::max(arc.start_radius, arc.end_radius));
  }
  for (const AxisVector& node : path_.node) extent = std::max(extent, weighted(node).cwiseAbs().maxCoeff());
  return extent;
}

bool PathCheck::take(const RowStream& stream) {
  rotary_ |= has_rotary(stream);
  corners_.forget_before(stream.row(stream.begin()) - static_cast<std::int64_t>(kReach));
  for (std::size_t local = stream.begin(); local < std::min(stream.end() + 3, stream.rows().count - 1); ++local) {
    if (!stream.is_real(local) || stream.row(local) != next_row_) continue;
    ++next_row_;
    if (take_row(stream, local)) continue;
    place(left_, stream, local);
    return false;
  }
  return true;
}

bool PathCheck::take_row(const RowStream& stream, std::size_t local) {
  const AxisVector to = point_of(stream, local);
  if (path_.size() == 0) {  // a program without motion: everything stays where it is
    const double off = path_.node.empty() ? 0.0 : (to - weighted(path_.node.front())).norm();
    deviation_.take(off, 0.0, stream, local);
    last_ = to;
    return off <= reach_;
  }
  const PathMatch before = follower_.match();
  if (stream.row(local) == 0) {
    if (!follower_.start(to)) return false;
  } else if (!follower_.advance(last_, to, slack_.at(stream, local, last_distance_ <= kOnPath))) {
    return false;
  }
  const double distance = exact_distance(to);
  if (!path_.tellings.empty()) take_tool(stream, local);
  if (deviation_.would_take(distance, 0.0) || stream.row(local) == 0) deviation_.take(distance, 0.0, stream, local);
  if (stream.row(local) > 0) take_crossings(stream, local, to, before, std::max(distance, last_distance_) <= kOnPath);
  last_ = to;
  last_distance_ = distance;
  if (!stream.rows().line.empty()) take_line(stream, local);
  place(end_, stream, local);
  return true;
}

double PathCheck::exact_distance(const AxisVector& point) {
  const PathMatch& match = follower_.match();
  if (vertices_.at(match.cell + 1) == nullptr) return match.distance;
  if (vertices_.at(match.cell + 1)->sagitta == 0.0) return match.distance;  // lines and sectors of arcs are exact
  const PathVertex end = *vertices_.at(match.cell + 1), begin = *vertices_.at(match.cell);
  const std::uint32_t segment = end.segment;
  const double s0 = begin.is_node ? 0.0 : begin.s;
  double s = s0 + match.t * (end.s - s0);
  if (s <= 0 || s >= path_.length[segment]) return match.distance;  // to the node itself
  // Other curves: exact arc lengths cost more than they tell while the chord says that the setpoint is on the path.
  if (match.distance + sagitta_ <= kOnPath / 2) return match.distance + sagitta_;
  double distance = match.distance + sagitta_;
  for (int step = 0; step < kNewtonSteps; ++step) {
    const Frame frame = frame_at(path_, segment, s);
    const AxisVector off = point - weighted(frame.point), first = weighted(frame.first);
    distance = std::min(distance, off.norm());
    const double slope = first.squaredNorm() - off.dot(weighted(frame.second));
    if (slope <= 0) break;
    s = std::clamp(s + off.dot(first) / slope, 0.0, path_.length[segment]);
  }
  return distance;
}

/// Distance of the middle of a stretch of an arc, where it stands out farthest, to the straight line between two setpoints.
double PathCheck::chord_error(std::size_t cell, double low, double high, const AxisVector& to) {
  const ArcSector* const sector = vertices_.sector(*vertices_.at(cell + 1));
  if (sector == nullptr || high <= low) return 0.0;
  const double most = sector->bulge(low, high) + std::max(last_distance_, follower_.match().distance);
  if (!chord_.would_take(most * (1 - kSame), 0.0)) return 0.0;
  return distance_to_line(vertices_.point(cell, (low + high) / 2), last_, to);
}

/// Where the tool is due; where it turns in a plane, by a great circle of verification's own. Where only the tool turns, how far along
/// it is due is not told: then what is due is the plane.
Eigen::Vector3d PathCheck::programmed_tool(const Chain& chain, const PathVertex& end, const Eigen::Vector3d& run) {
  const PathMatch& match = follower_.match();
  if (path_.turn_of(end.segment) == nullptr) {
    AxisVector place = vertices_.point(match.cell, match.t);
    place.tail<3>() *= kRadiansPerDegree;
    return seen_tool(chain, place).tool;
  }
  std::size_t first = end.segment, last = end.segment;
  while (first > 0 && path_.move[first - 1] == path_.move[first] && path_.turn_of(first - 1) != nullptr) --first;
  while (last + 1 < path_.size() && path_.move[last + 1] == path_.move[last] && path_.turn_of(last + 1) != nullptr)
    ++last;
  const Eigen::Vector3d from = seen_tool(chain, path_.node[first]).tool, to = seen_tool(chain, path_.end_of(last)).tool;
  const Eigen::Vector3d normal = from.cross(to).normalized();
  if (is_rotary_only(path_, end.segment)) return (run - normal * normal.dot(run)).normalized();
  const PathVertex begin = *vertices_.at(match.cell);
  const double s0 = begin.is_node ? 0.0 : begin.s, s = s0 + match.t * (end.s - s0);
  const double share = (path_.position.between(first, end.segment) + s) / path_.position.between(first, last + 1);
  const double angle = share * std::atan2(from.cross(to).norm(), from.dot(to));
  return std::cos(angle) * from + std::sin(angle) * normal.cross(from);
}

/// The angle between the tool and where the path has it.
void PathCheck::take_tool(const RowStream& stream, std::size_t local) {
  const PathMatch& match = follower_.match();
  const PathVertex* const end = vertices_.at(match.cell + 1);
  const Chain* const chain = end == nullptr ? nullptr : path_.chain_of(end->segment);
  if (chain == nullptr) return;
  AxisVector run = point_of(stream, local);
  run.tail<3>() *= kRadiansPerDegree;
  const Eigen::Vector3d b = seen_tool(*chain, run).tool, a = programmed_tool(*chain, *end, b);
  const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
  if (tool_.would_take(angle, 0.0)) tool_.take(angle, 0.0, stream, local);
}

void PathCheck::take_crossings(const RowStream& stream, std::size_t local, const AxisVector& to,
                               const PathMatch& before, bool on_path) {
  const PathMatch& match = follower_.match();
  double off = chord_error(before.cell, before.t, match.cell > before.cell ? 1.0 : match.t, to);
  for (std::size_t v = before.cell + 1; v <= match.cell; ++v) {
    const PathVertex vertex = *vertices_.at(v);
    off = std::max(
        {off, distance_to_line(vertex.point, last_, to), chord_error(v, 0.0, v < match.cell ? 1.0 : match.t, to)});
    // Where a path runs back over itself, the row before may have been past the node already, or this one not yet.
    const Doubt doubt{before.last_cell >= v, match.first_cell < v};
    if (!vertex.is_node || vertex.segment + 1 >= path_.size()) continue;
    if (on_path || is_passed_exactly(vertex.segment)) log_corner(stream, local, vertex, doubt);
  }
  if (chord_.would_take(off, 0.0)) chord_.take(off, 0.0, stream, local);
  if (on_path && match.cell > before.cell) log_detour(stream, local, to, {before.cell + 1, match.cell});
}

/// By the chords between the vertices that are crossed.
void PathCheck::log_detour(const RowStream& stream, std::size_t local, const AxisVector& to,
                           std::pair<std::size_t, std::size_t> crossed) {
  AxisVector from = last_;
  double way = 0.0;
  for (std::size_t v = crossed.first; v <= crossed.second; ++v) {
    const AxisVector at = vertices_.at(v)->point;
    way += (at - from).head<3>().norm();
    from = at;
  }
  way += (to - from).head<3>().norm();
  const double detour = way - (to - last_).head<3>().norm();
  if (detour > 0) corners_.add(Detour{stream.row(local), detour});
}

/// Nothing smooths a corner at which G61 or G61.1 or a rule that stays on the path begins or ends, however near beside it a
/// blend may lie.
bool PathCheck::is_passed_exactly(std::size_t left) const {
  return vertices_.rule(left).is_exact || vertices_.rule(left + 1).is_exact;
}

/// The rule of the corner behind a segment; none where it is not known, or where a motion may smooth or merge blocks beside the
/// corner, and so not pass it in their directions.
std::optional<CornerOptions> PathCheck::rule_behind(std::size_t left) const {
  if (!corner_limit_.rule()) return std::nullopt;
  const CornerOptions rule = corner_between(*corner_limit_.rule(), control_of(moves_, path_.move[left]),
                                            control_of(moves_, path_.move[left + 1]));
  const bool is_exact = vertices_.rule(left).is_exact && vertices_.rule(left + 1).is_exact;
  return rule.step || is_exact ? std::optional(rule) : std::nullopt;
}

CornerEvent PathCheck::step_at(const CornerRun& run, const Joint& joint) const {
  const auto [speed, tangential] = corner_limit_.passage(run, period_, rule_behind(joint.left));
  const AxisVector turn = (run.leaving - run.arriving).cwiseAbs();
  CornerEvent event;
  if (turn.maxCoeff() > kNegligibleStep) event.speed_step = speed * turn;
  event.place_step = joint.tip_turn ? AxisVector(speed * *joint.tip_turn) : event.speed_step;
  event.acceleration_step = speed * speed * joint.bend + tangential * turn;
  if (event.acceleration_step.norm() <= kNegligibleStep * speed * speed) event.acceleration_step.setZero();
  return event;
}

bool PathCheck::lies_on_line(std::size_t segment, const AxisVector& point) const {
  return is_even_line(path_, segment) &&
         distance_to_line(point, weighted(path_.node[segment]), weighted(path_.end_of(segment))) <= kOnPath;
}

/// What the axes do at an end of a segment.
Frame PathCheck::axes_at_node(std::size_t segment, double s) const {
  const Frame frame = frame_at(path_, segment, s);
  const Chain* const chain = path_.chain_of(segment);
  return chain == nullptr ? frame : axes_frame(*chain, frame);
}

void PathCheck::log_corner(const RowStream& stream, std::size_t local, const PathVertex& node, Doubt doubt) {
  const std::size_t left = node.segment, right = left + 1;
  const Frame in = axes_at_node(left, path_.length[left]), out = axes_at_node(right, 0.0);
  const Chord before = chord_to(stream, local - 1), here = chord_to(stream, local), after = chord_to(stream, local + 1);
  CornerRun run{in.first, out.first, before.length(), after.length()};
  run.is_straight = lies_on_line(left, point_of(stream, local - 2)) && lies_on_line(right, point_of(stream, local + 1));
  const double longest = std::max({run.before, run.after, here.length()});
  (run.before < run.after ? run.after : run.before) = longest;
  Joint joint{left, (out.second - in.second).cwiseAbs(), {}};
  if (path_.chain_of(left) != nullptr || path_.chain_of(right) != nullptr)
    joint.tip_turn = (frame_at(path_, right, 0.0).first - frame_at(path_, left, path_.length[left]).first).cwiseAbs();
  CornerEvent event = step_at(run, joint);
  if (!vertices_.rule(left).is_exact && before.length() > 0)
    run.arriving = axes_way(stream, local - 1) / before.length();
  if (!vertices_.rule(right).is_exact && after.length() > 0) run.leaving = axes_way(stream, local + 1) / after.length();
  const CornerEvent as_run = step_at(run, joint);
  event.speed_step = event.speed_step.cwiseMax(as_run.speed_step);
  event.place_step = event.place_step.cwiseMax(as_run.place_step);
  event.acceleration_step = event.acceleration_step.cwiseMax(as_run.acceleration_step);
  if (event.speed_step.isZero(0.0) && event.place_step.isZero(0.0) && event.acceleration_step.isZero(0.0)) return;
  event.corner = static_cast<std::int64_t>(left);
  const double near = kNearNode * longest;
  const std::int64_t row = stream.row(local);
  const bool begins = doubt.earlier || (point_of(stream, local - 1) - node.point).norm() <= near;
  const bool ends = doubt.later || (point_of(stream, local) - node.point).norm() <= near;
  for (std::int64_t interval = row - begins; interval <= row + ends; ++interval) {
    event.interval = interval;
    corners_.add(event);
  }
}

void PathCheck::take_line(const RowStream& stream, std::size_t local) {
  const std::uint32_t line = stream.rows().line[local];
  const PathMatch& match = follower_.match();
  const PathVertex* const vertex = vertices_.at(match.cell + 1);
  if (vertex == nullptr || moves_.line[path_.move[vertex->segment]] == line) return;
  // At a node, on a pause or where strokes lie over each other, the lines around it are as good; on a smoothed corner
  // those of both legs, and of all that lies between them inside the tolerance.
  const PathVertex* const last_vertex = vertices_.at(match.last_cell + 1);
  const double tolerance = tolerance_.value_or(0);
  const bool is_smoothed = match.distance > kOnPath || tolerance > kSmoothing;
  const std::size_t end_segment = path_.size() - 1;
  const std::size_t first = vertices_.at(match.first_cell + 1)->segment;
  const std::size_t last = last_vertex != nullptr ? last_vertex->segment : end_segment;
  std::size_t low = first, high = last;
  while (is_smoothed && low > 0 && path_.position[first] - path_.position[low] <= tolerance) --low;
  while (is_smoothed && high < end_segment && path_.position[high + 1] - path_.position[last + 1] <= tolerance) ++high;
  const std::size_t begin = low == 0 ? 0 : path_.move[low];
  const std::size_t end = high == end_segment ? moves_.size() : path_.move[high] + std::size_t{1};
  const auto from = moves_.line.begin();
  const auto stop = from + static_cast<std::ptrdiff_t>(end);
  if (std::find(from + static_cast<std::ptrdiff_t>(begin), stop, line) != stop) return;
  if (line_mismatches_++ == 0) place(line_, stream, local);
}

bool PathCheck::has_followed() {
  end_.value = path_.node.empty() ? 0.0 : (last_ - weighted(path_.node.back())).norm();
  end_.limit = kOnPath;
  return path_.size() == 0 || follower_.reaches_end();
}

void PathCheck::report(VerifyReport& report, bool followed) const {
  Check follows = left_;
  follows.value = reach_;
  follows.limit = tolerance_.value_or(std::numeric_limits<double>::infinity());
  follows.broken = tolerance_ && (!followed || reach_ > *tolerance_ * (1 + kLimitSlack));
  report.checks.push_back(follows);
  if (!followed) {
    report.notes.push_back("the setpoints do not follow the program's path within " + std::to_string(reach_) + " mm");
    return;
  }
  report.checks.push_back(deviation_.named(CheckKind::deviation));
  if (!path_.tellings.empty()) report.checks.push_back(tool_.named(CheckKind::tool_angle));
  Check end = end_;
  end.broken = end.value > end.limit;
  report.checks.push_back(end);
  Check line = line_;
  line.value = static_cast<double>(line_mismatches_);
  line.limit = 0;
  line.broken = line_mismatches_ > 0;
  report.checks.push_back(line);
  report.chord_error = chord_.check().value;
}

}  // namespace toolpace
