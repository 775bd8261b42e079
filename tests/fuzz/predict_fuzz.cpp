/// Settings of a controller and a program for it: whatever both, an error or times that add up, also where the motion is laid on the
/// program's path. The settings end at a line "---"; the first byte chooses the controller, whose own they need not be.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <string_view>

#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/run_on_controller.h"

namespace {

using namespace toolpace;

constexpr std::size_t kMostRows = 200;
constexpr double kLongest = 3600;  // [s] LinuxCNC is run cycle by cycle

void check(bool holds) {
  if (!holds) std::abort();
}

/// Whether a program is short enough for its lines to be run one by one.
bool is_short(const Reading& reading) {
  if (reading.moves.size() > kMostRows) return false;
  double time = 0;
  AxisVector from = reading.moves.start;
  for (std::size_t i = 0; i < reading.moves.size(); ++i) {
    if (reading.moves.feed[i] > 0) time += (reading.moves.end[i] - from).norm() / reading.moves.feed[i];
    from = reading.moves.end[i];
  }
  return time < kLongest;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  constexpr std::string_view kBetween = "\n---\n";
  const std::size_t at = text.find(kBetween);
  if (at == std::string_view::npos) return 0;
  const auto controllers = all_controllers();
  const Controller controller = controllers[data[0] % controllers.size()];
  auto settings = parse_controller_settings(text.substr(0, at), "settings", controller);
  if (!settings) return 0;
  const std::string_view program = text.substr(at + kBetween.size());
  ReadOptions options;
  options.dialect = dialect_of(controller);
  auto reading = read_text(program, "fuzz.nc", options);
  if (!reading || !is_short(*reading)) return 0;
  ControllerRun run;
  run.program = std::make_shared<const Reading>(std::move(*reading));
  run.program_name = "fuzz.nc";
  run.text = scan_program(program);
  run.settings = std::move(*settings);
  if (const auto p = predict(*run.program, run.text, run.settings, run.options)) {
    check(std::isfinite(p->cycle_time) && p->cycle_time >= -1e-9);
    const double sum = std::accumulate(p->time_by_limit.begin(), p->time_by_limit.end(), 0.0);
    check(std::abs(sum - p->cycle_time) <= 1e-6 * (1 + p->cycle_time));
  }
  const auto driven = run_on_controller(run);
  if (!driven) return 0;
  const double time = driven->prediction.cycle_time;
  check(std::abs(driven->outcome.plan.cycle_time() - time) <= 1e-6 * (1 + time));
  check(driven->outcome.node_time.size() == driven->outcome.path->size() + 1);
  check(axes_over_limits(driven->outcome).has_value());
  return 0;
}
