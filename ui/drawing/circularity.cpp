#include "drawing/circularity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "toolpace/path/arc.h"
#include "toolpace/plan/plan.h"

namespace toolpace::ui {
namespace {

constexpr double kSame = 1e-6;        // of the radius: centres and radii of neighbouring arcs that make one circle
constexpr double kLongestLag = 0.5;   // [s] the drives may be late
constexpr double kOneSpeed = 1e-3;    // relative
constexpr double kTimeConstants = 7;  // until less than a thousandth is left of how the drives came onto the circle

ArcCurve arc_of(const Moves& moves, std::size_t row) {
  return make_arc(moves.begin_of(row), moves.end[row], moves.arcs[moves.detail[row]]);
}

bool is_arc(const Moves& moves, std::size_t row) { return moves.kind[row] == MoveKind::arc; }

/// Whether `next` goes on where `arc` ends, about the same axis.
bool continues(const ArcCurve& arc, const ArcCurve& next) {
  const double slack = kSame * arc.end_radius;
  const Eigen::Vector3d apart = next.centre - arc.centre;
  return (apart - apart.dot(arc.normal) * arc.normal).norm() <= slack && arc.normal.dot(next.normal) > 1 - kSame &&
         std::abs(next.start_radius - arc.end_radius) <= slack;
}

std::array<int, 2> plane_of(const Eigen::Vector3d& normal) {
  Eigen::Index largest = 2;
  normal.cwiseAbs().maxCoeff(&largest);
  return largest == 2 ? std::array{0, 1} : largest == 1 ? std::array{0, 2} : std::array{1, 2};
}

/// Blocks of the path that belong to rows of the program.
std::pair<std::size_t, std::size_t> blocks_of(const Path& path, std::size_t block, std::size_t first_row,
                                              std::size_t last_row) {
  const auto belongs = [&](std::size_t i) { return path.move[i] >= first_row && path.move[i] <= last_row; };
  std::size_t first = block, last = block;
  while (first > 0 && belongs(first - 1)) --first;
  while (last + 1 < path.size() && belongs(last + 1)) ++last;
  return {first, last};
}

std::size_t row_at(const ErrorTrace& trace, double time) {
  return static_cast<std::size_t>(std::lower_bound(trace.time.begin(), trace.time.end(), time) - trace.time.begin());
}

Eigen::Vector3d actual(const ErrorTrace& trace, std::size_t row) {
  return trace.commanded[row].cast<double>() + trace.offset[row].cast<double>();
}

/// The row between two times at which the actual path is nearest to a point.
std::size_t passing(const ErrorTrace& trace, const Eigen::Vector3d& point, double from, double to) {
  std::size_t best = row_at(trace, from);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t row = best; row < trace.time.size() && trace.time[row] <= to; ++row) {
    const double distance = (actual(trace, row) - point).squaredNorm();
    if (distance < least) (least = distance, best = row);
  }
  return best;
}

/// How long the slowest of the drives takes to settle [s].
double settling_time(const Machine& machine, const std::array<int, 2>& axes) {
  double slowest = 0;
  for (const int axis : axes) {
    const ServoAxis& servo = machine.servo[static_cast<std::size_t>(axis)];
    slowest = std::max(slowest, 1 / servo.position_gain + 1 / (2 * std::numbers::pi * servo.bandwidth * servo.damping));
  }
  return kTimeConstants * slowest;
}

/// The longest time between two others in which the speed does not change.
std::pair<double, double> time_at_one_speed(const MotionPlan& plan, double begin, double end) {
  std::pair<double, double> best{begin, begin};
  auto phase = std::partition_point(plan.phases.begin(), plan.phases.end(),
                                    [&](const Phase& p) { return p.begin + p.duration <= begin; });
  double since = begin, speed = 0;
  for (; phase != plan.phases.end() && phase->begin < end; ++phase) {
    const PhaseExtrema e = extrema(*phase);
    const double from = std::max(phase->begin, begin), to = std::min(phase->begin + phase->duration, end);
    const bool is_even = e.max_speed - e.min_speed <= kOneSpeed * e.max_speed;
    const bool goes_on = is_even && std::abs(e.max_speed - speed) <= kOneSpeed * speed;
    if (!goes_on) (since = is_even ? from : to, speed = is_even ? e.max_speed : 0);
    if (to - since > best.second - best.first) best = {since, to};
  }
  return best;
}

double unwrapped(double angle, double near) {
  constexpr double kTurn = 2 * std::numbers::pi;
  return angle + kTurn * std::round((near - angle) / kTurn);
}

/// Extremes and mean of the points in the steady time, or of all.
void summarise(Roundness& roundness) {
  const auto& points = roundness.points;
  const auto index_at = [&](double time) {
    return std::partition_point(points.begin(), points.end(), [&](const auto& p) { return p.time < time; });
  };
  auto first = index_at(roundness.circle.steady_begin), last = index_at(roundness.circle.steady_end);
  roundness.is_steady = first < last;
  if (!roundness.is_steady) (first = points.begin(), last = points.end());
  if (first == last) return;
  const auto [lowest, highest] =
      std::minmax_element(first, last, [](const auto& a, const auto& b) { return a.error < b.error; });
  roundness.first = static_cast<std::size_t>(first - points.begin());
  roundness.last = static_cast<std::size_t>(last - points.begin());
  roundness.lowest = static_cast<std::size_t>(lowest - points.begin());
  roundness.highest = static_cast<std::size_t>(highest - points.begin());
  for (auto p = first; p != last; ++p) roundness.mean += p->error;
  roundness.mean /= static_cast<double>(last - first);
}

}  // namespace

std::optional<Circle> circle_at(const Outcome& outcome, std::size_t block) {
  const Moves& moves = outcome.job->program->moves;
  const Path& path = *outcome.path;
  if (block >= path.size() || !is_arc(moves, path.move[block])) return std::nullopt;
  Circle circle;
  circle.first_row = circle.last_row = path.move[block];
  const auto joins = [&](std::size_t row) {
    return is_arc(moves, row) && is_arc(moves, row + 1) && continues(arc_of(moves, row), arc_of(moves, row + 1));
  };
  while (circle.first_row > 0 && joins(circle.first_row - 1)) --circle.first_row;
  while (circle.last_row + 1 < moves.size() && joins(circle.last_row)) ++circle.last_row;
  for (std::size_t row = circle.first_row; row <= circle.last_row; ++row) circle.sweep += arc_of(moves, row).sweep;
  const ArcCurve first = arc_of(moves, circle.first_row), last = arc_of(moves, circle.last_row);
  circle.line = moves.line[circle.first_row];
  circle.centre = first.centre;
  circle.radial = first.radial;
  circle.lateral = first.lateral;
  circle.start_radius = first.start_radius;
  circle.end_radius = last.end_radius;
  circle.first_point = moves.begin_of(circle.first_row).head<3>();
  circle.last_point = moves.end[circle.last_row].head<3>();
  circle.axes = plane_of(first.normal);
  const auto [from, to] = blocks_of(path, block, circle.first_row, circle.last_row);
  circle.begin = outcome.node_time[from];
  circle.end = outcome.node_time[to + 1];
  const auto [even_begin, even_end] = time_at_one_speed(outcome.plan, circle.begin, circle.end);
  circle.steady_end = even_end;
  circle.steady_begin = std::min(even_begin + settling_time(outcome.job->machine, circle.axes), even_end);
  return circle;
}

std::optional<std::size_t> longest_arc(const Outcome& outcome) {
  const Moves& moves = outcome.job->program->moves;
  const Path& path = *outcome.path;
  const auto goes_on = [&](std::size_t row, std::size_t next) {
    return next == row || (next == row + 1 && is_arc(moves, row) && continues(arc_of(moves, row), arc_of(moves, next)));
  };
  std::optional<std::size_t> best;
  double most = 0, length = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!is_arc(moves, path.move[i])) continue;
    length = i > 0 && goes_on(path.move[i - 1], path.move[i]) ? length + path.length[i] : path.length[i];
    if (best && !(length > most)) continue;
    best = i;
    most = length;
  }
  return best;
}

std::optional<std::size_t> next_circle(const Outcome& outcome, double time, int direction) {
  const Moves& moves = outcome.job->program->moves;
  const Path& path = *outcome.path;
  if (path.size() == 0) return std::nullopt;
  const auto count = static_cast<std::ptrdiff_t>(path.size());
  auto at = static_cast<std::ptrdiff_t>(segment_at(outcome.node_time, time));
  const auto here = circle_at(outcome, static_cast<std::size_t>(at));
  for (at += direction; at >= 0 && at < count; at += direction) {
    const auto row = path.move[static_cast<std::size_t>(at)];
    if (is_arc(moves, row) && (!here || row < here->first_row || row > here->last_row)) {
      return static_cast<std::size_t>(at);
    }
  }
  return std::nullopt;
}

Roundness measure_roundness(const ErrorTrace& trace, const Circle& circle) {
  Roundness result;
  result.circle = circle;
  const double lag = std::min(kLongestLag, (circle.end - circle.begin) / 2);
  const std::size_t first = passing(trace, circle.first_point, circle.begin, circle.begin + lag);
  const std::size_t last =
      passing(trace, circle.last_point, std::max(circle.end - lag, circle.begin), circle.end + lag);
  double turned = 0;
  for (std::size_t row = first; row <= last && row < trace.time.size(); ++row) {
    const Eigen::Vector3d from_centre = actual(trace, row) - circle.centre;
    const double x = from_centre.dot(circle.radial), y = from_centre.dot(circle.lateral);
    turned = unwrapped(std::atan2(y, x), turned);
    const double share = circle.sweep > 0 ? std::clamp(turned / circle.sweep, 0.0, 1.0) : 0.0;
    const double radius = circle.start_radius + share * (circle.end_radius - circle.start_radius);
    const Eigen::Vector3d in_plane = x * circle.radial + y * circle.lateral;
    const double angle = std::atan2(in_plane[circle.axes[1]], in_plane[circle.axes[0]]);
    result.points.push_back({trace.time[row], angle, std::hypot(x, y) - radius});
  }
  summarise(result);
  return result;
}

}  // namespace toolpace::ui
