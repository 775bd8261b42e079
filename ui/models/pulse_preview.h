#pragma once
/// A pulse table as curves to draw.

#include <vector>

#include "toolpace/sample/pulse_table.h"

namespace toolpace::ui {

struct PulsePreview {
  std::vector<double> pulse;  ///< numbers of the pulses shown: all of a short table, the ends and a part of a long one
  std::vector<double> interval;  ///< before that pulse [timer ticks]
  std::vector<double> rate;      ///< [step/s], timer clock over interval
};

/// At most about `most` pulses.
PulsePreview preview_pulses(const PulseTable& table, std::size_t most = 4000);

}  // namespace toolpace::ui
