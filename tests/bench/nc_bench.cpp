/// Lines per second that the interpreter reads, and bytes that a motion block takes.

#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <random>
#include <string>

#include "toolpace/nc/reader.h"

namespace {

using namespace toolpace;

constexpr std::size_t kLines = 200000;

std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", value);
  return text;
}

/// Plain G1 lines with X, Y, Z of four decimals, as CAM systems post them.
std::string plain_lines(bool with_numbers) {
  std::mt19937 engine(20140401);
  std::uniform_real_distribution<double> step(-1.0, 1.0);
  std::string text = "G21 G90 F3000\n";
  double x = 0.0, y = 0.0, z = 0.0;
  for (std::size_t i = 0; i < kLines; ++i) {
    x += step(engine);
    y += step(engine);
    z += 0.1 * step(engine);
    if (with_numbers) text += "N" + std::to_string(10 * i) + " ";
    text += "G1 X" + short_text(x) + " Y" + short_text(y) + " Z" + short_text(z) + "\n";
  }
  return text + "M2\n";
}

std::string arc_lines() {
  std::string text = "G21 G90 F3000\nG0 X0 Y0\n";
  for (std::size_t i = 0; i < kLines / 2; ++i) text += "G2 X10.5 Y0 I5.25 J0\nG3 X0 Y0 I-5.25 J0\n";
  return text + "M2\n";
}

std::string expression_lines() {
  std::string text = "G21 G90 F3000\n#1=0\n";
  text += "o1 repeat [" + std::to_string(kLines / 2) +
          "]\n  #1 = [#1 + 0.01]\n  G1 X[10*COS[#1]] Y[10*SIN[#1]]\no1 endrepeat\nM2\n";
  return text;
}

std::string polyline_rows() {
  std::mt19937 engine(20140401);
  std::uniform_real_distribution<double> step(-1.0, 1.0);
  std::string text = "x_mm,y_mm,z_mm,feed_mm_min\n";
  for (std::size_t i = 0; i < kLines; ++i)
    text += short_text(step(engine)) + "," + short_text(step(engine)) + ",0,6000\n";
  return text;
}

/// Without splines, which have as many points as they have.
std::size_t bytes_of(const Moves& moves) {
  return moves.size() * (sizeof(MoveKind) + sizeof(AxisVector) + sizeof(double) + 2 * sizeof(std::uint32_t) +
                         2 * sizeof(std::uint16_t)) +
         moves.arcs.size() * sizeof(ArcDetail);
}

void read(benchmark::State& state, const std::string& text, const char* name) {
  std::size_t blocks = 0, bytes = 0;
  for (auto _ : state) {
    const auto reading = read_text(text, name);
    if (!reading || reading->refused) {
      state.SkipWithError("the program was refused");
      return;
    }
    blocks = reading->moves.size();
    bytes = bytes_of(reading->moves);
    benchmark::DoNotOptimize(reading->moves.end.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kLines));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
  state.counters["B/block"] = static_cast<double>(bytes) / static_cast<double>(blocks);
  state.SetLabel("lines");
}

void read_file_from_disk(benchmark::State& state) {
  const auto file = std::filesystem::temp_directory_path() / "toolpace_nc_bench.ngc";
  const std::string text = plain_lines(false);
  if (std::FILE* out = std::fopen(file.c_str(), "wb")) {
    std::fwrite(text.data(), 1, text.size(), out);
    std::fclose(out);
  }
  for (auto _ : state) {
    const auto reading = read_file(file);
    if (!reading || reading->refused) {
      state.SkipWithError("the program was refused");
      break;
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kLines));
  state.SetLabel("lines");
  std::filesystem::remove(file);
}

BENCHMARK_CAPTURE(read, nc_plain_g1, plain_lines(false), "plain.ngc")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read, nc_numbered_g1, plain_lines(true), "numbered.ngc")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read, nc_arcs, arc_lines(), "arcs.ngc")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read, nc_expressions_in_a_loop, expression_lines(), "loop.ngc")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read, csv_polyline, polyline_rows(), "polyline.csv")->Unit(benchmark::kMillisecond);
BENCHMARK(read_file_from_disk)->Unit(benchmark::kMillisecond);

}  // namespace
