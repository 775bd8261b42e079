#pragma once
/// What a law is whose ramps are one form each (speed_form.h): all follows from how steep and how sharp the form is.

#include <algorithm>
#include <cmath>

#include "toolpace/base/cubic.h"
#include "toolpace/law/law.h"
#include "toolpace/law/ramp_phases.h"

namespace toolpace {

/// T = max(steepest·Δ/A, √(sharpest·Δ/J)); either limit may be infinite. reach() solves (2v+Δ)/2·T(Δ) = L, a quadratic in Δ
/// where acceleration decides, a cubic in √Δ where jerk does; 1e-14 relative.
template <class Law, class Form>
struct FormLaw : LawBase<Law> {
  static constexpr double kSteepest = Form::kSteepest, kSharpest = Form::kSharpest;

  static double duration(double dv, const RampLimits& limits) {
    return std::max(kSteepest * dv / limits.acceleration, std::sqrt(kSharpest * dv / limits.jerk));
  }

  static DurationTerms terms(const RampLimits& limits) {
    return detail::larger_of(kSteepest, limits.acceleration, std::sqrt(kSharpest), limits.jerk);
  }

  static double reach(double v, double length, const RampLimits& limits) {
    // Both limits decide at once for a ramp of T* = sharpest·A/(steepest·J).
    const double slope = limits.acceleration / kSteepest;
    const double time = kSharpest * slope / limits.jerk;
    const double change = time * slope;
    if (!(length < (v + change / 2) * time)) {
      return std::isinf(slope) ? slope : std::sqrt(v * v + 2 * slope * length);
    }
    const double root = depressed_cubic_root(2 * v, 2 * length * std::sqrt(limits.jerk / kSharpest));
    return v + root * root;
  }

  static RampPeaks peaks(double dv, double time, const RampLimits&) {
    return detail::shape_peaks(kSteepest, kSharpest, dv, time);
  }

  template <class Phases>
  static void write_ramp(const SpeedChange& ramp, const RampLimits&, Phases& phases) {
    if (!(ramp.time > 0)) return;
    const detail::RampCursor cursor = detail::end_of(phases);
    phases.push_back({cursor.begin, ramp.time, cursor.distance, ramp.from, 0.0, ramp.to - ramp.from, Form::kShape});
  }
};

}  // namespace toolpace
