#include "toolpace/verify/curve_corners.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "toolpace/verify/chord.h"

namespace toolpace {
namespace {

constexpr double kSameTurn = 0.02;   // of the turn by length between chords of one curve
constexpr double kParallel = 1e-7;   // sine of the angle between chords of one line, beyond what rounding explains
constexpr double kLeastTurn = 1e-4;  // [rad] of a corner
constexpr double kNoise = 8;         // roundings of a position in what is computed from a few
constexpr double kInside = 1e-6;     // of the interval: a corner that near to its end is at the row there
constexpr double kBulge = 0.75;      // of κ·s², what a curve of way s leaves its tangent by, half as much again

/// A smooth run up to a row, as seen when going towards it.
struct Run {
  AxisVector direction, bend;  ///< at the row; the change of direction by length
};

/// @param chords  in the order of distance from the row, towards it
std::optional<Run> run_of(const std::array<Chord, 3>& chords, double noise) {
  std::array<double, 3> length;
  std::array<AxisVector, 3> along;
  for (std::size_t k = 0; k < 3; ++k) {
    length[k] = chords[k].length();
    if (length[k] <= kNoise * noise || !(chords[k].metric == chords[0].metric)) return std::nullopt;
    along[k] = chords[k].way / length[k];
  }
  const AxisVector bend = (along[0] - along[1]) / ((length[0] + length[1]) / 2);
  const AxisVector farther = (along[1] - along[2]) / ((length[1] + length[2]) / 2);
  const double shortest = *std::min_element(length.begin(), length.end());
  const double rounding = (kParallel + kNoise * noise / shortest) / shortest;
  if ((bend - farther).norm() > kSameTurn * bend.norm() + rounding) return std::nullopt;
  return Run{along[0] + bend * (length[0] / 2), bend};
}

}  // namespace

std::optional<CurveCorner> corner_between_curves(const RowStream& stream, std::size_t local, double noise) {
  if (local < 4 || local + 3 >= stream.rows().count) return std::nullopt;
  const Chord here = chord_to(stream, local);
  const auto turned = [](Chord chord) {
    chord.way = -chord.way;
    return chord;
  };
  const auto arriving =
      run_of({chord_to(stream, local - 1), chord_to(stream, local - 2), chord_to(stream, local - 3)}, noise);
  const auto back = run_of(
      {turned(chord_to(stream, local + 1)), turned(chord_to(stream, local + 2)), turned(chord_to(stream, local + 3))},
      noise);
  if (!arriving || !back || !(here.metric == chord_to(stream, local - 1).metric) ||
      !(here.metric == chord_to(stream, local + 1).metric))
    return std::nullopt;
  // The way is α·u + β·w but for what the curves bulge.
  const AxisVector& u = arriving->direction;
  const AxisVector w = -back->direction;
  const double uu = u.squaredNorm(), ww = w.squaredNorm(), uw = u.dot(w), determinant = uu * ww - uw * uw;
  if (determinant < kLeastTurn * kLeastTurn * uu * ww) return std::nullopt;
  const double u_way = u.dot(here.way), w_way = w.dot(here.way);
  const double alpha = (ww * u_way - uw * w_way) / determinant, beta = (uu * w_way - uw * u_way) / determinant;
  const double bulge = kBulge * (arriving->bend.norm() * alpha * alpha + back->bend.norm() * beta * beta);
  const double off = bulge + kParallel * here.way.norm() + kNoise * noise;
  const double least = -off / std::sqrt(determinant / (uu * ww));
  if (alpha < least || beta < kInside * here.length() || (here.way - alpha * u - beta * w).norm() > off)
    return std::nullopt;
  CurveCorner corner;
  corner.before = std::max(alpha, 0.0);
  corner.after = beta;
  corner.arriving = u + arriving->bend * corner.before;
  corner.leaving = w - back->bend * corner.after;
  corner.bend = (arriving->bend - back->bend).cwiseAbs();
  return corner;
}

}  // namespace toolpace
