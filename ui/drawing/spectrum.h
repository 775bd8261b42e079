#pragma once
/// What a plan asks of a machine's frame: the amplitudes of an axis' commanded acceleration over frequency, and how long the
/// tool runs at which speed, and why no faster.

#include <array>
#include <optional>
#include <vector>

#include "drawing/cause_style.h"
#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

/// Of a sine of amplitude A at frequency f, A stands at f.
struct Spectrum {
  std::vector<double> frequency;  ///< [Hz], ascending from 0 to half the setpoints' rate
  std::vector<double> amplitude;  ///< [mm/s² or rad/s²] ≥ 0
  double resolution = 0;          ///< [Hz] between two of them
};

/// Time at speeds of [i·bin, (i + 1)·bin), by what holds the speed down; while it rests for a dwell it does not run.
struct SpeedHistogram {
  double bin = 0;                                     ///< [mm/s]
  std::vector<std::array<double, kCauseCount>> time;  ///< [s]
  double total() const;                               ///< [s]
};

struct AnalysisRequest {
  std::shared_ptr<const Outcome> outcome;
  std::optional<std::size_t> axis;  ///< nothing = along the path
  double begin = 0, end = 0;        ///< [s]; held inside the plan
};

struct MotionAnalysis {
  Spectrum spectrum;
  SpeedHistogram histogram;
};

inline constexpr std::size_t kLeastSamples = 16;

/// Samples each interpolation period, Hann window, amplitude 2·|X|/Σw; beyond 2²⁰ samples the mean power of stretches as long.
/// Call it on a worker. Errors: cancelled; "too-few-setpoints" for less than kLeastSamples periods.
Result<MotionAnalysis> analyse_motion(const AnalysisRequest& request, const Monitor& monitor = {});

/// The same of samples `period` apart. @pre at least kLeastSamples
Spectrum amplitude_spectrum(const std::vector<double>& samples, double period);

}  // namespace toolpace::ui
