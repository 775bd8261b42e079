#include "toolpace/verify/position_corners.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "toolpace/base/metric.h"
#include "toolpace/verify/chord.h"
#include "toolpace/verify/curve_corners.h"

namespace toolpace {
namespace {

constexpr double kParallel = 1e-7;  // sine of the angle between chords of one line, beyond what rounding explains

/// As lengths along a path count [mm; deg where only rotary axes move].
double length_of(const AxisVector& chord) { return Metric::along(chord.head<3>().isZero(0.0)).norm(chord); }

/// What is left of b beside direction a, relative to b.
bool is_parallel(const AxisVector& a, const AxisVector& b, double noise) {
  const double length = a.norm(), other = b.norm();
  if (length <= 0 || other <= 0) return false;
  if (a.dot(b) <= 0) return false;
  const double beside = (b - a * (a.dot(b) / (length * length))).norm();
  return beside <= kParallel * other + 4 * noise * (1 + other / length);
}

/// A chord that cuts one corner is α·u + β·w, with unit vectors along the two runs and α, β ≥ 0.
struct Cut {
  double alpha, beta;
};
std::optional<Cut> cut_of(const AxisVector& before, const AxisVector& between, const AxisVector& after, double noise) {
  const AxisVector u = before.normalized(), w = after.normalized();
  const double c = u.dot(w), s = 1 - c * c;
  if (s < kParallel * kParallel) return std::nullopt;
  const Cut cut{(between.dot(u) - c * between.dot(w)) / s, (between.dot(w) - c * between.dot(u)) / s};
  const double least = -8 * noise / std::sqrt(s);
  if (cut.alpha < least || cut.beta < least) return std::nullopt;
  const bool fits = (between - cut.alpha * u - cut.beta * w).norm() <= kParallel * between.norm() + 8 * noise;
  return fits ? std::optional(cut) : std::nullopt;
}

/// The chords around one that may cut a corner.
struct Surroundings {
  AxisVector before, here, after;
  bool are_straight;  ///< both runs, of two chords each
};

/// Whether the turn of a way back over itself is in the middle chord, or at its first row: of the last chord there and the first
/// one back, the shorter has it.
bool turns_inside(const Surroundings& s, double noise) {
  if (!is_parallel(s.before, -s.after, noise)) return false;
  if (s.here.norm() <= 4 * noise) return true;
  if (is_parallel(s.before, -s.here, noise)) return s.here.norm() <= s.before.norm() * (1 + kParallel);
  return is_parallel(s.before, s.here, noise) && s.here.norm() < s.after.norm() * (1 - kParallel);
}

Surroundings around(const RowStream& stream, std::size_t local, double noise) {
  const auto chord = [&](std::size_t i) { return chord_to(stream, i).way; };
  Surroundings s{chord(local - 1), chord(local), chord(local + 1), false};
  s.are_straight = is_parallel(chord(local - 2), s.before, noise) && is_parallel(s.after, chord(local + 2), noise);
  return s;
}

bool has_surroundings(const RowStream& stream, std::size_t local) {
  return local >= 3 && local + 2 < stream.rows().count;
}

}  // namespace

CornerEvent corner_between_straights(const RowStream& stream, std::size_t local, const CornerSight& sight) {
  CornerEvent event;
  event.interval = event.corner = stream.row(local);
  if (!has_surroundings(stream, local)) return event;
  const Surroundings surroundings = around(stream, local, sight.noise);
  const auto& [before, here, after, are_straight] = surroundings;
  if (!are_straight) return event;
  const bool at_row = is_parallel(before, here, sight.noise) && !is_parallel(here, after, sight.noise) &&
                      !is_parallel(here, -after, sight.noise);
  if (!at_row && !turns_inside(surroundings, sight.noise) && !cut_of(before, here, after, sight.noise)) return event;
  const double from = length_of(before), to = length_of(after);
  const AxisVector arriving = before / from, leaving = after / to, turn = (leaving - arriving).cwiseAbs();
  const CornerPassage passage =
      sight.limit.passage({arriving, leaving, from, to, true}, sight.period, sight.limit.rule());
  event.speed_step = event.place_step = passage.speed * turn;
  event.acceleration_step = passage.acceleration * turn;
  return event;
}

bool is_none(const CornerEvent& event) { return event.speed_step.isZero(0.0) && event.acceleration_step.isZero(0.0); }

CornerEvent corner_beside_curve(const RowStream& stream, std::size_t local, const CornerSight& sight) {
  CornerEvent event;
  event.interval = event.corner = stream.row(local);
  const auto corner = corner_between_curves(stream, local, sight.noise);
  if (!corner) return event;
  const CornerRun run{corner->arriving, corner->leaving, chord_to(stream, local - 1).length(),
                      chord_to(stream, local + 1).length(), true};
  const CornerPassage passage = sight.limit.passage(run, sight.period, sight.limit.rule());
  const AxisVector turn = (corner->leaving - corner->arriving).cwiseAbs();
  event.speed_step = event.place_step = passage.speed * turn;
  event.acceleration_step = passage.acceleration * turn + passage.speed * passage.speed * corner->bend;
  return event;
}

double detour_between_straights(const RowStream& stream, std::size_t local, double noise) {
  if (!has_surroundings(stream, local)) return 0.0;
  const auto [before, here, after, are_straight] = around(stream, local, noise);
  if (!are_straight) return 0.0;
  const auto cut = cut_of(before, here, after, noise);
  if (!cut) return 0.0;
  const double way = cut->alpha * length_of(before.normalized()) + cut->beta * length_of(after.normalized());
  return std::max(0.0, way - length_of(here));
}

double detour_beside_curve(const RowStream& stream, std::size_t local, double noise) {
  const auto corner = corner_between_curves(stream, local, noise);
  return corner ? std::max(0.0, corner->before + corner->after - length_of(chord_to(stream, local).way)) : 0.0;
}

}  // namespace toolpace
