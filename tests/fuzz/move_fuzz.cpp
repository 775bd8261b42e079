/// Single moves under every law, and pulse tables, of any numbers: an error, or a move that is finite and as long as asked.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "toolpace/law/single_move.h"
#include "toolpace/sample/pulse_table.h"

namespace {

using namespace toolpace;

constexpr std::uint64_t kMostPulses = 2000;

void check(const MoveRequest& request, const SingleMove& move) {
  double end = 0.0;
  for (const Phase& phase : move.phases) {
    const PhaseState last = evaluate(phase, phase.duration);
    if (!(phase.duration >= 0) || !std::isfinite(last.distance) || !std::isfinite(last.speed)) std::abort();
    end = last.distance;
  }
  constexpr double kRounding = 1e-9;
  if (!std::isfinite(move.total_time()) || move.peak > request.feed) std::abort();
  if (std::abs(end - request.length) > kRounding * request.length) std::abort();
}

void check(const PulseTable& table) {
  const std::uint64_t steps = std::min(table.move().steps, kMostPulses);
  std::vector<std::uint32_t> ticks(steps);
  table.read(0, ticks);
  std::uint64_t sum = 0;
  for (const std::uint32_t t : ticks) {
    if (t == 0) std::abort();
    sum += t;
  }
  if (sum != table.ticks_at(steps)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  double number[10] = {};
  if (size < 1 + sizeof(number)) return 0;
  std::memcpy(number, data + 1, sizeof(number));
  const MoveRequest request{.length = number[0], .feed = number[1], .start = number[2], .end = number[3]};
  const Dynamics dynamics{{number[4], number[5], number[6]}, {number[7], number[8], number[9]}};
  if (const auto move = single_move(static_cast<LawKind>(data[0] % 6), request, dynamics)) check(request, *move);
  StepperMove stepper{.speed = number[1], .t_acc = number[4], .t_dec = number[5], .timer_hz = number[6]};
  std::memcpy(&stepper.steps, &number[0], sizeof(stepper.steps));
  if (const auto table = PulseTable::create(stepper)) check(*table);
  return 0;
}
