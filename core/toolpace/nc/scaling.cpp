#include "toolpace/nc/scaling.h"

#include <fmt/format.h>

#include <cmath>

#include "toolpace/nc/coordinates.h"
#include "toolpace/nc/motion/motion.h"

namespace toolpace::nc {
namespace {

constexpr double kThousandth = 0.001;
constexpr double kSmallestThousandths = 10.0;  // less without a point is a factor
constexpr double kSameScale = 1e-9;
constexpr double kMostScale = 1e4;

double place_of(const State& state, const Block& block, std::size_t axis) {
  const char letter = kAxisLetters[axis];
  return is_rotary(axis) ? block.of(letter) : length_of(state, block, letter);
}

// On Fanuc's controllers P2000 is twice.
double factor_of(const Context& context, const Block& block, char letter) {
  const double value = block.of(letter);
  const bool counts = context.rules.scales_in_thousandths && !block.has_point(letter) &&
                      std::fabs(value) >= kSmallestThousandths && value == std::floor(value);
  return counts ? value * kThousandth : value;
}

bool check_factor(Context& context, const Block& block, char letter, double factor) {
  if (std::fabs(factor) >= 1.0 / kMostScale && std::fabs(factor) <= kMostScale) return true;
  return context.faults.fail("scale-factor", fmt::format("a scale of {:g}", factor), "give a scale of 0.0001 to 10000",
                             block.column_of(letter));
}

void use(State& state) {
  Offsets offsets = state.offsets;
  offsets.is_scaled = false;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const double factor = state.scale.factor[i] * state.mirror.factor[i];
    const double offset = state.scale.factor[i] * state.mirror.offset[i] + state.scale.offset[i];
    offsets.scaling.factor[i] = factor;
    offsets.scaling.offset[i] = offset;
    offsets.is_scaled = offsets.is_scaled || factor != 1.0 || offset != 0.0;
  }
  change_offsets(state, offsets);
}

bool refuse_with_compensation(Context& context, const Block& block, GGroup group) {
  if (context.state.compensation.radius <= 0.0) return true;
  return context.faults.fail("offset-with-compensation", "a change of the scale while cutter radius compensation is on",
                             "end it with G40 first", block.column_of(group));
}

}  // namespace

bool set_scale(Context& context, const Block& block) {
  State& state = context.state;
  if (!refuse_with_compensation(context, block, GGroup::scale)) return false;
  state.scale = Scaling{};
  if (block.code(GGroup::scale) == 500) {
    use(state);
    return true;
  }
  constexpr std::array<char, 3> kFactorLetters = {'i', 'j', 'k'};
  const bool by_axes = context.rules.scales_by_axis_words;
  const Position here = state.position;
  for (std::size_t i = 0; i < kFactorLetters.size(); ++i) {
    const char letter = by_axes ? kAxisLetters[i] : block.has('p') ? 'p' : kFactorLetters[i];
    if (!block.has(letter)) continue;
    const double factor = factor_of(context, block, letter);
    if (!check_factor(context, block, letter, factor)) return false;
    const double centre = by_axes ? 0.0 : block.has(kAxisLetters[i]) ? place_of(state, block, i) : here[i];
    state.scale.factor[i] = factor;
    state.scale.offset[i] = centre * (1.0 - factor);
  }
  if (!by_axes && !block.has_any(word_bit('p') | kCentreBits)) {
    context.faults.warn("scale-missing", "G51 without P, I, J or K scales by 1", "give the scale with P",
                        block.column_of(GGroup::scale));
  }
  use(state);
  return true;
}

bool set_mirror(Context& context, const Block& block) {
  State& state = context.state;
  if (!refuse_with_compensation(context, block, GGroup::mirror)) return false;
  const bool on = block.code(GGroup::mirror) == 511;
  if (!on && !block.has_any(kLinearBits | kRotaryBits)) state.mirror = Scaling{};
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (!block.has(kAxisLetters[i])) continue;
    state.mirror.factor[i] = on ? -1.0 : 1.0;
    state.mirror.offset[i] = on ? 2.0 * place_of(state, block, i) : 0.0;
  }
  use(state);
  return true;
}

double scale_of(const Offsets& offsets, std::size_t axis) {
  return offsets.is_scaled ? std::fabs(offsets.scaling.factor[axis]) : 1.0;
}

bool scales_evenly(const Offsets& offsets, const PlaneAxes& plane) {
  return std::fabs(scale_of(offsets, plane.first) - scale_of(offsets, plane.second)) <= kSameScale;
}

double turn_of(const Offsets& offsets, const PlaneAxes& plane) {
  if (!offsets.is_scaled) return 1.0;
  return offsets.scaling.factor[plane.first] * offsets.scaling.factor[plane.second] < 0.0 ? -1.0 : 1.0;
}

}  // namespace toolpace::nc
