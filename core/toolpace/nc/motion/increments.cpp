#include "toolpace/nc/motion/increments.h"

#include <cmath>

#include "toolpace/nc/block_words.h"

namespace toolpace::nc {
namespace {

constexpr double kLeastIncrement = 0.001;       // [mm]
constexpr double kLeastIncrementInch = 0.0001;  // [in]

}  // namespace

double least_increment(const State& state) {
  return state.modal.units == 200 ? kLeastIncrementInch * kMmPerInch : kLeastIncrement;
}

double increments_of(const State& state, const Block& block, char letter, double from) {
  const double value = block.of(letter);
  const bool counts = !block.has_point(letter) && std::fabs(value) >= from && value == std::floor(value);
  return value * (counts ? least_increment(state) : state.modal.unit());
}

void count_increments(Block& block, const State& state) {
  if (block.has(GGroup::macro)) return;  // arguments are numbers
  const Code motion = block.has(GGroup::motion) ? block.code(GGroup::motion) : state.modal.motion;
  if (is_cycle(motion)) block.counted &= ~word_bit('k');  // repeats
  const bool inch = (block.has(GGroup::units) ? block.code(GGroup::units) : state.modal.units) == 200;
  for (std::size_t i = 0; i < kWordCount; ++i) {
    if ((block.counted & (1u << i)) == 0) continue;
    const bool is_angle = ((1u << i) & kRotaryBits) != 0;
    block.value[i] *= inch && !is_angle ? kLeastIncrementInch : kLeastIncrement;
  }
  block.pointed |= block.counted;
}

}  // namespace toolpace::nc
