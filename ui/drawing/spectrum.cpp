#include "drawing/spectrum.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>

#include "toolpace/plan/restraint.h"
#include "toolpace/sample/motion.h"

namespace toolpace::ui {
namespace {

constexpr std::size_t kLongest = std::size_t{1} << 20;  // samples that are transformed at once
constexpr std::size_t kMostSamples = 20'000'000;        // 160 MB; a longer stretch is cut to it
constexpr int kBins = 48;
constexpr std::size_t kAsk = 4096;  // samples between two looks at the monitor

/// FFTW plans into shared tables of its own, so one thread at a time may plan.
std::mutex& planning() {
  static std::mutex mutex;
  return mutex;
}

/// A transform of real numbers of one length, with its memory.
class Transform {
 public:
  explicit Transform(std::size_t count)
      : in_(fftw_alloc_real(count), fftw_free), out_(fftw_alloc_complex(count / 2 + 1), fftw_free) {
    const std::scoped_lock lock(planning());
    plan_ = fftw_plan_dft_r2c_1d(static_cast<int>(count), in_.get(), out_.get(), FFTW_ESTIMATE);
  }
  Transform(const Transform&) = delete;
  Transform& operator=(const Transform&) = delete;
  ~Transform() {
    const std::scoped_lock lock(planning());
    fftw_destroy_plan(plan_);
  }

  double* in() { return in_.get(); }
  void run() { fftw_execute(plan_); }
  double magnitude(std::size_t k) const { return std::hypot(out_.get()[k][0], out_.get()[k][1]); }

 private:
  std::unique_ptr<double, void (*)(void*)> in_;
  std::unique_ptr<fftw_complex, void (*)(void*)> out_;
  fftw_plan plan_ = nullptr;
};

/// What lies on both sides of 0 in the transform counts twice; the mean and half the rate stand there once.
double sides(std::size_t k, std::size_t count) { return k == 0 || 2 * k == count ? 1.0 : 2.0; }

double acceleration_of(Motion& motion, const std::optional<std::size_t>& axis) {
  return axis ? motion.axes().acceleration[static_cast<Eigen::Index>(*axis)] : motion.along().acceleration;
}

Error too_few() {
  return {ErrorKind::input,
          "too-few-setpoints",
          "the time is too short for a spectrum",
          "look at more of the program, or choose a shorter interpolation period",
          {},
          {}};
}

}  // namespace

double SpeedHistogram::total() const {
  double sum = 0;
  for (const auto& row : time) {
    for (const double t : row) sum += t;
  }
  return sum;
}

Spectrum amplitude_spectrum(const std::vector<double>& samples, double period) {
  const std::size_t count = std::min(samples.size(), kLongest), stretches = samples.size() / count;
  Transform transform(count);
  std::vector<double> window(count);
  double weight = 0;
  for (std::size_t i = 0; i < count; ++i) {
    window[i] = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count));
    weight += window[i];
  }
  Spectrum spectrum;
  spectrum.resolution = 1 / (period * static_cast<double>(count));
  spectrum.frequency.resize(count / 2 + 1);
  spectrum.amplitude.assign(count / 2 + 1, 0.0);
  for (std::size_t s = 0; s < stretches; ++s) {
    for (std::size_t i = 0; i < count; ++i) transform.in()[i] = samples[s * count + i] * window[i];
    transform.run();
    for (std::size_t k = 0; k < spectrum.amplitude.size(); ++k) {
      const double amplitude = sides(k, count) * transform.magnitude(k) / weight;
      spectrum.amplitude[k] += amplitude * amplitude;
    }
  }
  for (std::size_t k = 0; k < spectrum.amplitude.size(); ++k) {
    spectrum.frequency[k] = spectrum.resolution * static_cast<double>(k);
    spectrum.amplitude[k] = std::sqrt(spectrum.amplitude[k] / static_cast<double>(stretches));
  }
  return spectrum;
}

Result<MotionAnalysis> analyse_motion(const AnalysisRequest& request, const Monitor& monitor) {
  const Outcome& outcome = *request.outcome;
  Motion motion(*outcome.path, outcome.plan);
  const double period = outcome.job->machine.period;
  const double begin = std::max(request.begin, 0.0), end = std::min(request.end, motion.duration());
  if (!((end - begin) / period >= static_cast<double>(kLeastSamples))) return tl::unexpected(too_few());
  const auto count = static_cast<std::size_t>(std::min((end - begin) / period, static_cast<double>(kMostSamples)));
  std::vector<double> samples(count), speeds(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % kAsk == 0) {
      if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
      monitor.report(static_cast<double>(i) / static_cast<double>(count));
    }
    motion.at(begin + static_cast<double>(i) * period);
    samples[i] = acceleration_of(motion, request.axis);
    speeds[i] = std::abs(motion.along().speed);
  }
  MotionAnalysis analysis;
  analysis.spectrum = amplitude_spectrum(samples, period);
  SpeedHistogram& histogram = analysis.histogram;
  const double top = *std::max_element(speeds.begin(), speeds.end());
  histogram.bin = top > 0 ? top / kBins * (1 + 1e-12) : 1.0;
  histogram.time.resize(kBins);
  for (std::size_t i = 0; i < count; ++i) {
    const Restraint* restraint = restraint_at(outcome.restraints, begin + static_cast<double>(i) * period);
    if (!restraint || restraint->cause == Cause::dwell) continue;
    const auto bin = std::min(static_cast<std::size_t>(speeds[i] / histogram.bin), histogram.time.size() - 1);
    histogram.time[bin][index_of(restraint->cause)] += period;
  }
  return analysis;
}

}  // namespace toolpace::ui
