/// Rows per second judged, from a file in TMPDIR.

#include "toolpace/verify/verify.h"

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cmath>

#include "toolpace/io/setpoint_reader.h"
#include "toolpace/io/setpoint_writer.h"
#include "toolpace/path/build_path.h"

namespace {

using namespace toolpace;

constexpr std::size_t kRows = 500000;
constexpr double kRadius = 25, kSpeed = 100;  // [mm, mm/s]

/// A circle run round and round at constant speed.
Setpoints circle() {
  Setpoints s;
  for (std::size_t k = 0; k < kRows; ++k) {
    const double angle = kSpeed / kRadius * static_cast<double>(k) * s.period;
    s.position[0].push_back(kRadius * std::cos(angle));
    s.position[1].push_back(kRadius * std::sin(angle));
    s.position[2].push_back(0);
    s.speed.push_back(kSpeed);
    s.acceleration.push_back(0);
    s.jerk.push_back(0);
    s.line.push_back(1);
  }
  return s;
}

Moves circle_moves() {
  Moves moves;
  const double sweep = kSpeed / kRadius * static_cast<double>(kRows - 1) * 0.001;
  moves.start << kRadius, 0, 0, 0, 0, 0;
  AxisVector end = AxisVector::Zero();
  end.head<2>() << kRadius * std::cos(sweep), kRadius * std::sin(sweep);
  moves.arcs.push_back({Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), sweep});
  moves.kind = {MoveKind::arc};
  moves.line = {1};
  moves.file = {0};
  moves.mode = {0};
  moves.detail = {0};
  moves.end = {end};
  moves.feed = {kSpeed};
  return moves;
}

void judge(benchmark::State& state, const char* extension, bool with_program) {
  const auto name =
      std::filesystem::temp_directory_path() / ("toolpace-verify-" + std::to_string(::getpid()) + extension);
  auto writer = open_setpoint_writer(name);
  if (!writer || !(*writer)->write(circle()) || !(*writer)->finish()) return state.SkipWithError("cannot write");
  const Moves moves = circle_moves();
  const Path path = build_path(moves, 0).value();
  const ProgrammedPath program{path, moves, 1e-6};
  Machine machine;
  for (auto& axis : machine.axes) axis.speed = 200, axis.acceleration = 1e9, axis.jerk = 1e12;
  for (auto _ : state) {
    auto file = open_setpoint_file(name);
    auto report = verify(**file, machine, with_program ? &program : nullptr);
    if (!report) return state.SkipWithError("not verified");
    benchmark::DoNotOptimize(report);
  }
  std::filesystem::remove(name);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kRows));
}

BENCHMARK_CAPTURE(judge, npy, ".npy", false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(judge, csv, ".csv", false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(judge, npy_on_arc, ".npy", true)->Unit(benchmark::kMillisecond);

}  // namespace
