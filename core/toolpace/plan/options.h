#pragma once
/// How a job is planned.

#include <cstddef>
#include <cstdint>
#include <optional>

#include "toolpace/law/law.h"
#include "toolpace/limits/corner_rule.h"

namespace toolpace {

enum class Ramps : std::uint8_t { block, span };

/// How setpoints are shaped (sample/shaper.h).
enum class ShaperKind : std::uint8_t { none, zv, zvd, mzv, ei, two_hump };

struct PlanOptions {
  LawKind law = LawKind::quintic;
  double t_acc = 0.05;                        ///< [s] five-phase-time
  double t_dec = 0.05;                        ///< [s] five-phase-time
  std::optional<std::size_t> lookahead = {};  ///< blocks, ≥ 1; none = all
  Ramps ramps = Ramps::block;
  CornerOptions corner = {};
  double feed_override = 1.0;          ///< 0 … 2
  double rapid_override = 1.0;         ///< 0 … 1
  std::optional<double> hold_at = {};  ///< [s] feed hold
  /// For the resonances of the machine's drives. Changes the setpoints, not the plan.
  ShaperKind shaper = ShaperKind::none;
};

}  // namespace toolpace
