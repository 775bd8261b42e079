/// Writes examples/nc/rosette.ngc: an engraving of three interlaced rosettes in micro-segments, as CAM posts emit them.
///
///   10_rosette > rosette.ngc

#include <cmath>
#include <cstdio>
#include <numbers>

namespace {

struct Ring {
  double radius;     // [mm]
  double amplitude;  // [mm] of the lobes
  int lobes;
  double depth;  // [mm] below the surface
};

constexpr Ring kRings[] = {{18.0, 4.0, 12, 0.15}, {12.0, 3.0, 9, 0.20}, {6.0, 2.0, 5, 0.25}};
constexpr double kSegment = 0.12;      // [mm], the length that the post aims at
constexpr double kSafeHeight = 2.0;    // [mm]
constexpr double kPlungeFeed = 200;    // [mm/min]
constexpr double kCuttingFeed = 1800;  // [mm/min]

double radius_at(const Ring& ring, double angle) { return ring.radius + ring.amplitude * std::cos(ring.lobes * angle); }

/// Angle that advances the tool by about one segment.
double angle_step(const Ring& ring, double angle) {
  const double slope = -ring.amplitude * ring.lobes * std::sin(ring.lobes * angle);
  return kSegment / std::hypot(radius_at(ring, angle), slope);
}

void engrave(const Ring& ring) {
  std::printf("G0 X%.4f Y0 Z%.3f\n", radius_at(ring, 0.0), kSafeHeight);
  std::printf("G1 Z%.3f F%g\nG1 F%g\n", -ring.depth, kPlungeFeed, kCuttingFeed);
  constexpr double kTurn = 2 * std::numbers::pi;
  for (double angle = angle_step(ring, 0.0); angle < kTurn; angle += angle_step(ring, angle)) {
    const double r = radius_at(ring, angle);
    std::printf("X%.4f Y%.4f\n", r * std::cos(angle), r * std::sin(angle));
  }
  std::printf("X%.4f Y0\nG0 Z%.3f\n", radius_at(ring, 0.0), kSafeHeight);
}

}  // namespace

int main() {
  std::puts("(Three rosettes in micro-segments; made by 10_rosette)");
  std::puts("G21 G90 G17 G94\nT1 M6 (60 degree engraving bit)\nS18000 M3\nG0 Z2");
  for (const auto& ring : kRings) engrave(ring);
  std::puts("M5\nM2");
}
