/// Writes examples/nc/butterfly.ngc: the NURBS butterfly of the interpolation literature as chords of a known error.
///
///   09_butterfly > butterfly.ngc
///
/// Control points, weights and knots as printed by Hu, Jiang, Huo et al., Int J Adv Manuf Technol 129 (2023)
/// 2843–2860, doi 10.1007/s00170-023-12427-5. At 0.398 of its size and with chords that stay within 1.56 µm of the
/// curve (and no longer than 0.75 mm) it has 588 blocks, like the butterfly on which Ning et al. (2014) measure
/// look-ahead.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace {

struct Point {
  double x, y;
};

constexpr int kDegree = 3;
constexpr double kScale = 0.398;
constexpr double kChordError = 0.001554;  // [mm]
constexpr double kLongestChord = 0.75;    // [mm]
constexpr double kFeed = 3000;            // [mm/min]

constexpr std::array<Point, 51> kControl = {{
    {54.493, 52.139}, {55.507, 52.139},  {56.082, 49.615}, {56.78, 44.971},  {69.575, 51.358}, {77.786, 58.573},
    {90.526, 67.081}, {105.973, 63.801}, {100.4, 47.326},  {94.567, 39.913}, {92.369, 30.485}, {83.44, 33.757},
    {91.892, 28.509}, {89.444, 20.393},  {83.218, 15.446}, {87.621, 4.83},   {80.945, 9.267},  {79.834, 14.535},
    {76.074, 8.522},  {70.183, 12.55},   {64.171, 16.865}, {59.993, 22.122}, {55.68, 36.359},  {56.925, 24.995},
    {59.765, 19.828}, {54.493, 14.94},   {49.22, 19.828},  {52.06, 24.994},  {53.305, 36.359}, {48.992, 22.122},
    {44.814, 16.865}, {38.802, 12.551},  {32.911, 8.521},  {29.152, 14.535}, {28.04, 9.267},   {21.364, 4.83},
    {25.768, 15.447}, {19.539, 20.391},  {17.097, 28.512}, {25.537, 33.75},  {16.602, 30.496}, {14.199, 39.803},
    {8.668, 47.408},  {3, 63.794},       {18.465, 67.084}, {31.197, 58.572}, {39.411, 51.358}, {52.204, 44.971},
    {52.904, 49.614}, {53.478, 52.139},  {54.492, 52.139},
}};

/// All weights are 1 but these.
struct Weight {
  std::size_t index;
  double value;
};
constexpr Weight kWeights[] = {{3, 1.2},  {11, 2}, {14, 5}, {15, 3}, {17, 1.1},
                               {33, 1.1}, {35, 3}, {36, 5}, {39, 2}, {47, 1.2}};

constexpr std::array<double, kControl.size() + kDegree + 1> kKnots = {
    0,      0,      0,      0,      0.0083, 0.015,  0.0361, 0.0855, 0.1293, 0.1509, 0.1931, 0.2273, 0.2435, 0.2561,
    0.2692, 0.2889, 0.317,  0.3316, 0.3482, 0.3553, 0.3649, 0.3837, 0.4005, 0.4269, 0.451,  0.466,  0.4891, 0.5,
    0.5109, 0.534,  0.5489, 0.5731, 0.5994, 0.6163, 0.6351, 0.6447, 0.6518, 0.6683, 0.683,  0.7111, 0.7307, 0.7439,
    0.7565, 0.7729, 0.8069, 0.8491, 0.8707, 0.9145, 0.9639, 0.985,  0.9917, 1,      1,      1,      1};

double weight(std::size_t index) {
  for (const auto& w : kWeights) {
    if (w.index == index) return w.value;
  }
  return 1.0;
}

/// Point of the curve at parameter u in [0, 1], by de Boor's recursion in homogeneous coordinates.
Point evaluate(double u) {
  const auto after = std::upper_bound(kKnots.begin() + kDegree, kKnots.end() - kDegree - 2, u);
  const auto span = static_cast<std::size_t>(after - kKnots.begin()) - 1;
  std::array<std::array<double, 3>, kDegree + 1> d;
  for (std::size_t j = 0; j <= kDegree; ++j) {
    const std::size_t i = span - kDegree + j;
    d[j] = {kControl[i].x * weight(i), kControl[i].y * weight(i), weight(i)};
  }
  for (std::size_t r = 1; r <= kDegree; ++r) {
    for (std::size_t j = kDegree; j >= r; --j) {
      const double left = kKnots[j + span - kDegree], right = kKnots[j + 1 + span - r];
      const double t = (u - left) / (right - left);
      for (std::size_t k = 0; k < 3; ++k) d[j][k] = (1 - t) * d[j - 1][k] + t * d[j][k];
    }
  }
  const auto& [x, y, w] = d[kDegree];
  return {kScale * x / w, kScale * y / w};
}

/// True when the chord from parameter u to v is short enough and stays close enough to the curve.
bool is_good_chord(double u, double v) {
  const Point a = evaluate(u), b = evaluate(v);
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (length > kLongestChord) return false;
  constexpr int kSamples = 32;
  for (int i = 1; i < kSamples; ++i) {
    const Point p = evaluate(u + (v - u) * i / kSamples);
    const double distance = length > 0 ? std::abs((p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x)) / length
                                       : std::hypot(p.x - a.x, p.y - a.y);
    if (distance > kChordError) return false;
  }
  return true;
}

/// The farthest parameter that one good chord from u reaches.
double next_parameter(double u) {
  if (constexpr double kNear = 0.01; u + kNear > 1.0 && is_good_chord(u, 1.0)) return 1.0;
  double good = u, bad = std::min(1.0, u + 0.01);
  for (int i = 0; i < 50; ++i) {
    const double middle = (good + bad) / 2;
    (is_good_chord(u, middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace

int main() {
  std::puts("(The NURBS butterfly at 0.398 of its size, in chords within 1.554 um of the curve; made by 09_butterfly)");
  std::puts("G21 G90 G17 G94");
  const Point start = evaluate(0.0);
  std::printf("G0 X%.5f Y%.5f\nG1 F%g\n", start.x, start.y, kFeed);
  for (double u = 0.0; u < 1.0;) {
    u = next_parameter(u);
    const Point p = evaluate(u);
    std::printf("X%.5f Y%.5f\n", p.x, p.y);
  }
  std::puts("M2");
}
