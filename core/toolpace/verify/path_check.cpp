#include "toolpace/verify/path_check.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

constexpr double kFinest = 2e-7, kCoarsest = 1e-5;  // [mm] sagitta of the chords that stand for curves
constexpr double kNegligibleStep = 1e-9;            // change of a direction that is rounding
constexpr double kSmoothing = 2 * kOnPath;          // a tolerance that lets corners be smoothed
constexpr double kNearNode = 1e-3;  // of the chord: a node this near to a row counts on both sides of it
constexpr double kCircular = 1e-4;  // relative change of radius up to which its square does not matter
constexpr int kNewtonSteps = 3;     // from a chord that is within 1e-5 mm of the curve

bool has_rotary(const RowStream& stream) {
  return std::any_of(stream.rows().position.begin() + 3, stream.rows().position.end(),
                     [](const auto& p) { return !p.empty(); });
}

AxisVector point_of(const RowStream& stream, std::size_t local) {
  AxisVector point = AxisVector::Zero();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto& p = stream.rows().position[axis];
    if (!p.empty()) point[static_cast<Eigen::Index>(axis)] = p[local];
  }
  return weighted(point);
}

bool path_has_rotary(const Path& path) {
  return std::any_of(path.node.begin(), path.node.end(), [](const AxisVector& n) { return !n.tail<3>().isZero(0); });
}

/// Which part of its sweep an arc has made after a part u of its length. The length grows with √(r² + (rise/sweep)²) a
/// radian, by κ over the whole arc: u = (p + κp²/2)/(1 + κ/2), so p = u + κ/2·u(1 − u) up to κ².
double part_of_sweep(const ArcCurve& arc, double u) {
  const double r = arc.start_radius, slope = arc.rise / arc.sweep;
  const double kappa = r * (arc.end_radius - r) / (r * r + slope * slope);
  return u + kappa / 2 * u * (1 - u);
}

void place(Check& check, const RowStream& stream, std::size_t local) {
  check.row = stream.row(local);
  if (!stream.rows().time.empty()) check.time = stream.rows().time[local];
  if (!stream.rows().line.empty()) check.line = stream.rows().line[local];
}

}  // namespace

PathCheck::PathCheck(const Path& path, const Moves& moves, std::optional<double> tolerance, double reach, double period)
    : path_(path),
      moves_(moves),
      period_(period),
      reach_(reach),
      sagitta_(std::clamp(reach / 5, kFinest, kCoarsest)),
      rotary_(path_has_rotary(path)),
      tolerance_(tolerance),
      vertices_(path, sagitta_),
      follower_(vertices_, reach + sagitta_, rotary_),
      deviation_(tolerance.value_or(std::numeric_limits<double>::infinity())) {
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

/// The path may bulge from the chord between two setpoints by what acceleration does within a period: a vertex passed
/// in between is at most a second difference away.
double PathCheck::slack(const RowStream& stream, std::size_t local) const {
  double square[2] = {0, 0}, chord = 0;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto& p = stream.rows().position[axis];
    if (p.empty()) continue;
    const double unit = is_rotary(axis) ? 1 / kRadiansPerDegree : 1.0;
    const double before = (p[local] - 2 * p[local - 1] + p[local - 2]) * unit;
    const double after = (p[local + 1] - 2 * p[local] + p[local - 1]) * unit;
    chord += (p[local] - p[local - 1]) * unit * (p[local] - p[local - 1]) * unit;
    square[0] += before * before;
    square[1] += after * after;
  }
  const auto& rows = stream.rows();
  double ellipse = 0;
  if (!rows.speed.empty()) {
    // At most: the corrected trapezoidal rule, and what a change of jerk in between may add.
    const double change = std::abs(rows.acceleration[local] - rows.acceleration[local - 1]);
    const double way = period_ / 2 * (rows.speed[local - 1] + rows.speed[local]) + period_ * period_ / 6 * change;
    ellipse = std::max(0.0, way * way - chord);
  }
  return std::max(std::sqrt(std::max(square[0], square[1])), std::sqrt(ellipse) / 2);
}

bool PathCheck::take_row(const RowStream& stream, std::size_t local) {
  const AxisVector to = point_of(stream, local);
  if (path_.size() == 0) {  // a program without motion: everything stays where it is
    const double off = path_.node.empty() ? 0.0 : (to - weighted(path_.node.front())).norm();
    deviation_.take(off, 0.0, stream, local);
    return off <= reach_;
  }
  const PathMatch before = follower_.match();
  if (stream.row(local) == 0) {
    if (!follower_.start(to)) return false;
  } else if (!follower_.advance(point_of(stream, local - 1), to, slack(stream, local))) {
    return false;
  }
  const double distance = exact_distance(to);
  deviation_.take(distance, 0.0, stream, local);
  const bool on_path = distance <= kOnPath;
  if (stream.row(local) > 0) take_crossings(stream, local, before, on_path && was_on_path_);
  was_on_path_ = on_path;
  if (!stream.rows().line.empty()) take_line(stream, local);
  end_.value = (to - weighted(path_.node.back())).norm();
  end_.limit = kOnPath;
  place(end_, stream, local);
  return true;
}

/// @source for circles: distance in the plane to the circle and along the normal to the height due at that angle
double PathCheck::exact_distance(const AxisVector& point) {
  const PathMatch& match = follower_.match();
  if (vertices_.at(match.cell + 1) == nullptr) return match.distance;
  const PathVertex end = *vertices_.at(match.cell + 1), begin = *vertices_.at(match.cell);
  const std::uint32_t segment = end.segment;
  if (path_.kind[segment] == SegmentKind::line) return match.distance;
  const double s0 = begin.is_node ? 0.0 : begin.s;
  double s = s0 + match.t * (end.s - s0);
  if (s <= 0 || s >= path_.length[segment]) return match.distance;  // to the node itself
  if (path_.kind[segment] == SegmentKind::arc && !rotary_) {
    const ArcCurve& arc = path_.arcs[path_.detail[segment]];
    const double widening = arc.end_radius - arc.start_radius;
    if (std::abs(widening) <= kCircular * arc.start_radius) {
      const double part = part_of_sweep(arc, s / path_.length[segment]);
      const Eigen::Vector3d from = point.head<3>() - arc.centre;
      const double height = from.dot(arc.normal);
      const double radius = (from - height * arc.normal).norm();
      const double sine = arc.rise / path_.length[segment];  // of the helix' slope
      const double across = (height - arc.rise * part) * std::sqrt(std::max(0.0, 1 - sine * sine));
      return std::hypot(radius - (arc.start_radius + widening * part), across);
    }
  }
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

void PathCheck::take_crossings(const RowStream& stream, std::size_t local, const PathMatch& before, bool on_path) {
  const AxisVector from = point_of(stream, local - 1), to = point_of(stream, local);
  const AxisVector chord = to - from;
  const double square = chord.squaredNorm();
  for (std::size_t v = before.cell + 1; v <= follower_.match().cell; ++v) {
    const PathVertex vertex = *vertices_.at(v);
    const double t = square > 0 ? std::clamp((vertex.point - from).dot(chord) / square, 0.0, 1.0) : 0.0;
    const double off = (vertex.point - from - t * chord).norm();
    if (chord_.would_take(off, 0.0)) chord_.take(off, 0.0, stream, local);
    // Where a path runs back over itself, the row before may have been past the node already, or this one not yet.
    const Doubt doubt{before.last_cell >= v, follower_.match().first_cell < v};
    if (!vertex.is_node || vertex.segment + 1 >= path_.size()) continue;
    if (on_path || is_passed_exactly(vertex.segment)) log_corner(stream, local, vertex, doubt);
  }
}

/// Nothing smooths a corner at which G61 or G61.1 begins or ends, however near beside it a blend may lie.
bool PathCheck::is_passed_exactly(std::size_t left) const {
  const auto is_exact = [this](std::size_t segment) {
    const PathControl control = moves_.modes[moves_.mode[path_.move[segment]]].control;
    return control == PathControl::exact_path || control == PathControl::exact_stop;
  };
  return is_exact(left) || is_exact(left + 1);
}

void PathCheck::log_corner(const RowStream& stream, std::size_t local, const PathVertex& node, Doubt doubt) {
  const std::size_t left = node.segment, right = left + 1;
  const Frame in = frame_at(path_, left, path_.length[left]), out = frame_at(path_, right, 0.0);
  double longest = 0.0, shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = local - 1; i <= local + 1; ++i) {
    const AxisVector step = point_of(stream, i) - point_of(stream, i - 1);
    const double length =
        is_rotary_only(path_, left) && is_rotary_only(path_, right) ? step.norm() : step.head<3>().norm();
    longest = std::max(longest, length);
    if (i != local) shortest = std::min(shortest, length);
  }
  // The speed at the node is between the mean speeds around it, but for what one period changes.
  const double speed = (longest + (longest - shortest)) / period_;
  const AxisVector turn = (out.first - in.first).cwiseAbs();
  CornerEvent event;
  event.speed_step = turn.maxCoeff() > kNegligibleStep ? AxisVector(speed * turn) : AxisVector::Zero();
  const double tangential = (longest - shortest) / (period_ * period_);
  event.acceleration_step = speed * speed * (out.second - in.second).cwiseAbs() + tangential * turn;
  const double step = event.speed_step.norm();
  if (step == 0 && event.acceleration_step.norm() <= kNegligibleStep * speed * speed) return;
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
  // those of both legs.
  const PathVertex* const last = vertices_.at(match.last_cell + 1);
  const std::size_t spread = match.distance > kOnPath || tolerance_.value_or(0) > kSmoothing ? 1 : 0;
  const std::size_t end_segment = path_.size() - 1;
  const std::size_t high = std::min((last != nullptr ? last->segment : end_segment) + spread, end_segment);
  const std::size_t first = vertices_.at(match.first_cell + 1)->segment;
  const std::size_t low = first - std::min(first, spread);
  const std::size_t begin = low == 0 ? 0 : path_.move[low];
  const std::size_t end = high == end_segment ? moves_.size() : path_.move[high] + std::size_t{1};
  const auto from = moves_.line.begin();
  const auto stop = from + static_cast<std::ptrdiff_t>(end);
  if (std::find(from + static_cast<std::ptrdiff_t>(begin), stop, line) != stop) return;
  if (line_mismatches_++ == 0) place(line_, stream, local);
}

bool PathCheck::has_followed() { return path_.size() == 0 || follower_.reaches_end(); }

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
