#include "models/pulse_preview.h"

#include <algorithm>

namespace toolpace::ui {
namespace {

constexpr std::uint64_t kWholeEnd = 256;  // pulses at either end that are all shown: there the rate changes most

void append(const PulseTable& table, std::uint64_t pulse, PulsePreview& preview) {
  const auto ticks = static_cast<double>(table.ticks_at(pulse) - table.ticks_at(pulse - 1));
  preview.pulse.push_back(static_cast<double>(pulse));
  preview.interval.push_back(ticks);
  preview.rate.push_back(table.move().timer_hz / ticks);
}

}  // namespace

PulsePreview preview_pulses(const PulseTable& table, std::size_t most) {
  PulsePreview preview;
  const std::uint64_t steps = table.move().steps;
  const std::uint64_t stride = std::max<std::uint64_t>(1, steps / std::max<std::size_t>(most, 1));
  for (std::uint64_t pulse = 1; pulse <= steps;) {
    append(table, pulse, preview);
    const bool is_near_end = pulse < kWholeEnd || pulse + kWholeEnd >= steps;
    const std::uint64_t next = pulse + (is_near_end ? 1 : stride);
    // Not over the start of the last stretch.
    pulse = is_near_end || next + kWholeEnd <= steps ? next : std::max(pulse + 1, steps - kWholeEnd);
  }
  return preview;
}

}  // namespace toolpace::ui
