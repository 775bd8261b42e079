#include "polylines.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "places.h"

namespace toolpace::test {
namespace {

constexpr std::size_t kBlocks = 5000;
constexpr double kFeed = 100;   // [mm/s]
constexpr double kUnit = 1e-6;  // [mm] of a CAM system's last digit

template <class Place>
Polyline made(const Place& place) {
  Polyline line;
  for (std::size_t i = 0; i <= kBlocks; ++i) {
    std::array<double, 3> point = place(static_cast<double>(i));
    for (double& x : point) x = std::round(x / kUnit) * kUnit;
    line.points.push_back(point);
    line.feed.push_back(kFeed);
  }
  return line;
}

Polyline read(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string row;
  if (!std::getline(in, row)) throw std::runtime_error("cannot read " + file.string());
  Polyline line;
  while (std::getline(in, row)) {
    std::array<double, 3> x{};
    double feed = 0;
    if (std::sscanf(row.c_str(), "%lf,%lf,%lf,%lf", &x[0], &x[1], &x[2], &feed) != 4) {
      throw std::runtime_error(file.string() + ": " + row);
    }
    line.points.push_back(x);
    line.feed.push_back(feed / 60);
  }
  return line;
}

}  // namespace

Polyline polyline(const std::string& name) {
  if (name == "line") return made([](double i) { return std::array{0.02 * i, 0.0, 0.0}; });
  if (name == "circle") {
    constexpr double kRadius = 25, kChord = 0.1;
    return made([](double i) {
      const double angle = i * kChord / kRadius;
      return std::array{kRadius * (std::cos(angle) - 1), kRadius * std::sin(angle), 0.0};
    });
  }
  return read(source_dir() / "tests/data" / (name + ".csv"));
}

}  // namespace toolpace::test
