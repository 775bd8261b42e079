#pragma once
/// The worst acceleration and jerk along the path, by columns and by positions.

#include <algorithm>

#include "toolpace/limits/machine.h"
#include "toolpace/verify/worst.h"

namespace toolpace {

struct PathWorst {
  explicit PathWorst(const PathLimits& limits)
      : acceleration(limits.acceleration),
        deceleration(limits.deceleration),
        jerk(std::max(limits.jerk, limits.jerk_deceleration)) {}

  void report(VerifyReport& report) const {
    report.checks.push_back(acceleration.named(CheckKind::path_acceleration));
    report.checks.push_back(deceleration.named(CheckKind::path_deceleration));
    report.checks.push_back(jerk.named(CheckKind::path_jerk));
  }

  Worst acceleration, deceleration, jerk;
};

}  // namespace toolpace
