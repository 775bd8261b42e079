#include "toolpace/trace/coarse_offset.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

namespace toolpace::detail {
namespace {

constexpr double kLongestStep = 0.02;   // [s] short enough for any motion of a machine
constexpr double kWantedSteps = 16384;  // of the longer of the two
constexpr double kLeastCovered = 0.5;   // of the motion of one of them, that has to overlap
constexpr double kStill = 1e-6;         // [mm, rad] an axis that moves less does not move
constexpr double kAsGood = 0.98;        // of the best score
constexpr double kAll = 0.9999;         // of the motion of both
constexpr double kElsewhere = 0.25;     // [s] from the best place

using Signal = std::vector<double>;

/// Differences from step to step of a column that stands at `time`.
Signal differences(const Signal& time, const Signal& value, double step) {
  const auto count = static_cast<std::size_t>((time.back() - time.front()) / step);
  Signal out(count);
  double before = value.front();
  std::size_t i = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = time.front() + static_cast<double>(k + 1) * step;
    while (i + 2 < time.size() && time[i + 1] < t) ++i;
    const double here = value[i] + (value[i + 1] - value[i]) * (t - time[i]) / (time[i + 1] - time[i]);
    out[k] = here - before;
    before = here;
  }
  return out;
}

Signal differences(const CommandedRows& commanded, const Signal& value, double step) {
  const auto count = static_cast<std::size_t>(commanded.duration() / step);
  Signal out(count);
  double before = value.front();
  for (std::size_t k = 0; k < count; ++k) {
    const double here = commanded_at(value, commanded.period, static_cast<double>(k + 1) * step).position;
    out[k] = here - before;
    before = here;
  }
  return out;
}

double energy(const Signal& s) {
  double sum = 0;
  for (const double v : s) sum += v * v;
  return sum;
}

/// Energies summed from the begin, so that those of any stretch are a difference.
struct Energies {
  Signal sums{0.0};
  void add(const Signal& s, double weight) {
    if (sums.size() == 1) sums.resize(s.size() + 1, 0.0);
    double sum = 0;
    for (std::size_t i = 0; i < s.size(); ++i) sums[i + 1] += (sum += weight * s[i] * s[i]);
  }
  double between(std::ptrdiff_t begin, std::ptrdiff_t end) const {
    const auto last = static_cast<std::ptrdiff_t>(sums.size()) - 1;
    return sums[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(end, 0, last))] -
           sums[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(begin, 0, last))];
  }
};

/// Correlations of all axes at all offsets: c[l] = Σ r[j + l]·y[j].
class Correlator {
 public:
  Correlator(std::size_t r, std::size_t y) {
    while (size_ < r + y + 1) size_ *= 2;
    product_.assign(size_, 0.0);
  }
  void add(const Signal& r, const Signal& y, double weight) {
    Spectrum a = transform(r), b = transform(y);
    for (std::size_t i = 0; i < size_; ++i) product_[i] += weight * a[i] * std::conj(b[i]);
  }
  Signal correlations() {
    Spectrum back;
    fft_.inv(back, product_);
    Signal out(size_);
    for (std::size_t i = 0; i < size_; ++i) out[i] = back[i].real();
    return out;
  }
  std::size_t size() const { return size_; }

 private:
  using Spectrum = std::vector<std::complex<double>>;
  Spectrum transform(const Signal& s) {
    Spectrum in(size_, 0.0), out;
    std::copy(s.begin(), s.end(), in.begin());
    fft_.fwd(out, in);
    return out;
  }
  std::size_t size_ = 1;
  Spectrum product_;
  Eigen::FFT<double> fft_;
};

/// The vertex of the parabola through three neighbours, −0.5 … 0.5.
double vertex(double before, double here, double after) {
  const double bend = before - 2 * here + after;
  return bend < 0 ? std::clamp((before - after) / (2 * bend), -0.5, 0.5) : 0.0;
}

}  // namespace

std::optional<CoarseOffset> coarse_offset(const CommandedRows& commanded, const Trace& trace,
                                          const std::array<std::vector<double>, kAxisCount>& measured,
                                          const std::array<bool, kAxisCount>& axes) {
  const auto& time = trace.rows.time;
  const double longest = std::max(commanded.duration(), time.back() - time.front());
  const double step =
      std::min(std::max({commanded.period, trace.step, longest / kWantedSteps}), std::max(kLongestStep, trace.step));
  const auto nr = static_cast<std::ptrdiff_t>(commanded.duration() / step);
  const auto ny = static_cast<std::ptrdiff_t>((time.back() - time.front()) / step);
  if (nr < 2 || ny < 2) return {};
  Correlator correlator(static_cast<std::size_t>(nr), static_cast<std::size_t>(ny));
  Energies er, ey;
  bool moves = false;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!axes[axis]) continue;
    const Signal r = differences(commanded, commanded.position[axis], step),
                 y = differences(time, measured[axis], step);
    const double of_r = energy(r), of_y = energy(y);
    if (of_r < kStill * kStill || of_y < kStill * kStill) continue;
    // Axes count by how they move, not by how far, so that the unit of one does not matter.
    correlator.add(r, y, 1 / std::sqrt(of_r * of_y));
    er.add(r, 1 / of_r);
    ey.add(y, 1 / of_y);
    moves = true;
  }
  if (!moves) return {};
  const Signal c = correlator.correlations();
  const auto size = static_cast<std::ptrdiff_t>(correlator.size());
  const auto at = [&](std::ptrdiff_t l) { return c[static_cast<std::size_t>((l + size) % size)]; };
  const double all_r = er.between(0, nr), all_y = ey.between(0, ny);
  const auto score = [&](std::ptrdiff_t l, double& rho) {
    const double r = er.between(l, l + ny), y = ey.between(-l, nr - l);
    const double covered = std::max(r / all_r, y / all_y);
    rho = covered >= kLeastCovered && r > 0 && y > 0 ? at(l) / std::sqrt(r * y) : 0.0;
    return rho * std::sqrt(covered);
  };
  std::ptrdiff_t best = 0;
  double best_score = -2, correlation = 0, rho = 0;
  for (std::ptrdiff_t l = 1 - ny; l < nr; ++l) {
    const double here = score(l, rho);
    if (here > best_score) best = l, best_score = here, correlation = rho;
  }
  // What covers all of both fits nowhere else, however often the program repeats itself.
  const double covers = std::min(er.between(best, best + ny) / all_r, ey.between(-best, nr - best) / all_y);
  bool is_ambiguous = false;
  const auto apart = static_cast<std::ptrdiff_t>(kElsewhere / step) + 2;
  for (std::ptrdiff_t l = 1 - ny; l < nr && covers < kAll && !is_ambiguous; ++l) {
    is_ambiguous = std::abs(l - best) > apart && score(l, rho) > kAsGood * best_score;
  }
  const double fine = vertex(at(best - 1), at(best), at(best + 1));
  return CoarseOffset{(static_cast<double>(best) + fine) * step, step, correlation, is_ambiguous};
}

}  // namespace toolpace::detail
