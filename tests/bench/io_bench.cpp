/// Rows per second into each setpoint format. TMPDIR says where; the file is durable (fsync) at the end of each run.

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "toolpace/io/setpoint_writer.h"

namespace {

using namespace toolpace;

constexpr std::size_t kChunkRows = 8192;
constexpr std::size_t kChunks = 64;

/// A curved cruise in X and Y: every digit of every double is needed.
std::vector<Setpoints> curve() {
  std::vector<Setpoints> chunks(kChunks);
  for (std::size_t c = 0; c < kChunks; ++c) {
    Setpoints& s = chunks[c];
    s.first_row = c * kChunkRows;
    for (std::size_t k = 0; k < kChunkRows; ++k) {
      const double t = static_cast<double>(s.first_row + k) * s.period;
      s.position[0].push_back(50 * std::cos(2 * t));
      s.position[1].push_back(50 * std::sin(2 * t));
      s.position[2].push_back(-5);
      s.speed.push_back(100 + std::sin(t));
      s.acceleration.push_back(std::cos(t));
      s.jerk.push_back(-std::sin(t));
      s.line.push_back(static_cast<std::uint32_t>(10 + k / 3));
    }
  }
  return chunks;
}

void write_setpoints(benchmark::State& state, const char* extension) {
  const auto chunks = curve();
  const auto file =
      std::filesystem::temp_directory_path() / ("toolpace-bench-" + std::to_string(::getpid()) + extension);
  for (auto _ : state) {
    auto writer = open_setpoint_writer(file);
    if (!writer) return state.SkipWithError(writer.error().message.c_str());
    for (const auto& chunk : chunks) {
      if (auto done = (*writer)->write(chunk); !done) return state.SkipWithError(done.error().message.c_str());
    }
    if (auto done = (*writer)->finish(); !done) return state.SkipWithError(done.error().message.c_str());
  }
  std::filesystem::remove(file);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kChunkRows * kChunks));
  state.SetLabel("setpoints");
}

BENCHMARK_CAPTURE(write_setpoints, csv, ".csv")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write_setpoints, npy, ".npy")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write_setpoints, npz, ".npz")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write_setpoints, halstream, ".halstream")->Unit(benchmark::kMillisecond);

}  // namespace
