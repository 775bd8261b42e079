/// Predicting a million blocks.

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "toolpace/controller/prediction.h"
#include "toolpace/nc/reader.h"

namespace toolpace {
namespace {

constexpr int kBlocks = 1'000'000;

/// Short lines along a curve that bends more and less, as CAM gives them.
std::string long_program() {
  std::string text = "G21 G90\nG1 F6000\n";
  double x = 0, y = 0;
  for (int i = 0; i < kBlocks; ++i) {
    const double angle = 3.0 * std::sin(1e-3 * i) + 0.4 * std::sin(0.37 * i);
    x += 0.2 * std::cos(angle);
    y += 0.2 * std::sin(angle);
    text += "X" + std::to_string(x) + " Y" + std::to_string(y) + "\n";
  }
  return text + "M2\n";
}

void predict_blocks(benchmark::State& state, const char* settings, Controller controller) {
  static const std::string text = long_program();
  const ControllerSettings parsed = *parse_controller_settings(settings, "settings", controller);
  ReadOptions options;
  options.dialect = dialect_of(controller);
  const Reading reading = *read_text(text, "long.nc", options);
  const ProgramText program = scan_program(text);
  for (auto _ : state) {
    auto prediction = predict(reading, program, parsed);
    benchmark::DoNotOptimize(prediction);
  }
  state.SetItemsProcessed(state.iterations() * kBlocks);
  state.SetLabel("blocks");
}

constexpr const char* kGrbl = "$11=0.01\n$100=80\n$101=80\n$110=6000\n$111=6000\n$120=500\n$121=500\n";
constexpr const char* kKlipper = "[printer]\nmax_velocity: 300\nmax_accel: 3000\n";
constexpr const char* kMarlin = "echo: M203 X300 Y300 Z5\n";
constexpr const char* kLinuxcnc =
    "[TRAJ]\n[AXIS_X]\nMAX_VELOCITY = 100\nMAX_ACCELERATION = 1000\n[AXIS_Y]\nMAX_VELOCITY = 100\nMAX_ACCELERATION = "
    "1000\n";

BENCHMARK_CAPTURE(predict_blocks, grbl, kGrbl, Controller::grbl)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(predict_blocks, grblhal, kGrbl, Controller::grblhal)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(predict_blocks, klipper, kKlipper, Controller::klipper)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(predict_blocks, marlin, kMarlin, Controller::marlin)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(predict_blocks, linuxcnc, kLinuxcnc, Controller::linuxcnc)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace toolpace
