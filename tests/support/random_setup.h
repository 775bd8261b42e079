#pragma once
/// Random changes of a machine that a machine file can hold.

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "toolpace/law/law_table.h"
#include "toolpace/machine/setup_keys.h"

namespace toolpace::test {

class RandomSetup {
 public:
  explicit RandomSetup(std::uint64_t seed) : random_(seed) {}

  /// 0 … count − 1
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  bool one_in(std::size_t count) { return below(count) == 0; }

  /// Between the bounds, evenly over their orders of magnitude, with few digits as people write.
  double number(const NumberRange& range) {
    if (range.may_be_infinite && one_in(5)) return std::numeric_limits<double>::infinity();
    if (range.may_be_zero && one_in(5)) return 0.0;
    const double low = range.least > 0 ? range.least : range.most * 1e-6;
    const double share = static_cast<double>(below(1001)) / 1000;
    return static_cast<double>(static_cast<float>(low * std::pow(range.most / low, 0.001 + 0.998 * share)));
  }

  /// Changes about `count` values.
  void change(Setup& setup, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto sections = setup_sections(setup);
      change(sections[below(sections.size())], setup);
    }
  }

 private:
  void change(const SetupSection& section, Setup& setup) {
    const std::size_t k = below(section.numbers.size() + section.ranges.size() + section.words.size());
    if (k < section.numbers.size()) {
      const NumberKey& key = section.numbers[k];
      *key.value = number(key.range) * key.unit;
    } else if (k < section.numbers.size() + section.ranges.size()) {
      const RangeKey& key = section.ranges[k - section.numbers.size()];
      *key.low = one_in(4) ? -std::numeric_limits<double>::infinity() : -static_cast<double>(below(1000)) * key.unit;
      *key.high = one_in(4) ? std::numeric_limits<double>::infinity() : static_cast<double>(below(999) + 1) * key.unit;
    } else {
      const std::string& word = section.words[k - section.numbers.size() - section.ranges.size()];
      word == kModesKey ? change_modes(setup.machine.servo[axis_of_section(section.name)]) : change_word(word, setup);
    }
  }

  void change_word(const std::string& key, Setup& setup) {
    constexpr const char* kNames[] = {"", "Mill", "a \"b\" \\", "line\nbreak", "Fr\u00e4se", "# no comment", "x]\t'y'"};
    PlanOptions& options = setup.options;
    if (key == "name") setup.machine.name = kNames[below(std::size(kNames))];
    if (key == "kind") options.law = law_table()[below(law_table().size())].kind;
    if (key == "blocks") options.lookahead.reset();
    if (key == "blocks" && !one_in(3)) options.lookahead = below(1000) + 1;
    if (key == "ramps") options.ramps = ramps_names()[below(ramps_names().size())].value;
    if (key == "shaper") options.shaper = shaper_names()[below(shaper_names().size())].value;
    if (key == "corner") options.corner.rule = corner_names()[below(corner_names().size())].value;
  }

  /// One more, one less, or another value.
  void change_modes(ServoAxis& servo) {
    if (servo.modes.empty() || one_in(3)) {
      AxisMode mode;
      for (const NumberKey& key : mode_keys(mode)) *key.value = number(key.range);
      if (servo.modes.size() < 4) servo.modes.push_back(mode);
    } else if (one_in(3)) {
      servo.modes.erase(servo.modes.begin() + static_cast<std::ptrdiff_t>(below(servo.modes.size())));
    } else {
      const NumberKey key = mode_keys(servo.modes[below(servo.modes.size())])[below(3)];
      *key.value = number(key.range);
    }
  }

  std::mt19937_64 random_;
};

}  // namespace toolpace::test
